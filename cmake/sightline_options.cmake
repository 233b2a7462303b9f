option(SIGHTLINE_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(SIGHTLINE_BENCH "Build the benchmarks" OFF)
option(SIGHTLINE_EXAMPLES "Build the examples" OFF)
option(SIGHTLINE_WERROR "Treat warnings as errors" OFF)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Filters are derived for plain IEEE arithmetic: no contraction, no fast-math.
add_library(sightline_flags INTERFACE)
target_compile_options(sightline_flags INTERFACE -ffp-contract=off -fno-fast-math -Wall -Wextra -Wshadow -Wconversion
                       $<$<BOOL:${SIGHTLINE_WERROR}>:-Werror>)
