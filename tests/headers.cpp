// Its headers are compiled beforehand for all tests (CMakeLists.txt).
