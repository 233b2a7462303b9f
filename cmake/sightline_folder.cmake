# sightline_alone(FILE...): sources that are not compiled together with others where CMAKE_UNITY_BUILD is on (the presets
# with sanitizers), because they have a name of their own which another of the folder has too, or because another file
# may stand in their place (compare/plain).
function(sightline_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# sightline_folder(NAME [USES folder...] [LINKS target...] [PRIVATE_LINKS target...])
# One library a folder, made of the folder's own sources, linking exactly the folders it may include. LINKS is what its
# headers need too, PRIVATE_LINKS what only its sources need. Installed and exported with the rest of the library.
function(sightline_folder name)
  cmake_parse_arguments(arg "" "" "USES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(target sightline_${name})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(sources)
    add_library(${target} STATIC ${sources})
    set(visible PUBLIC)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:sightline_flags> ${arg_PRIVATE_LINKS})
  else()  # headers only
    add_library(${target} INTERFACE)
    set(visible INTERFACE)
  endif()
  add_library(sightline::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} ${visible} cxx_std_20)
  target_include_directories(${target} ${visible}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/sightline>)
  foreach(folder IN LISTS arg_USES)
    target_link_libraries(${target} ${visible} sightline_${folder})
  endforeach()
  target_link_libraries(${target} ${visible} glm::glm ${arg_LINKS})

  set_property(GLOBAL APPEND PROPERTY sightline_folders ${name})
  if(SIGHTLINE_INSTALL)
    install(TARGETS ${target} EXPORT sightline ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sightline/${name}
            FILES_MATCHING PATTERN "*.hpp")
  endif()
endfunction()

# sightline_test(NAME SOURCES file... [USES folder...] [LINKS target...] [LABELS label...])
function(sightline_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES;LINKS;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE sightline_flags GTest::gtest_main ${arg_LINKS})
  target_compile_options(${name} PRIVATE ${SIGHTLINE_TEST_OPTIMISATION})
  # Precompiled, the standard library's own false alarms are no longer passed over as those of system headers.
  target_compile_options(${name} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow>")
  target_precompile_headers(${name} REUSE_FROM sightline_test_headers)
  foreach(folder IN LISTS arg_USES)
    target_link_libraries(${name} PRIVATE sightline_${folder})
  endforeach()
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT 300)
endfunction()

# sightline_bench(NAME SOURCES file... [USES folder...] [LINKS target...])
function(sightline_bench name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES;LINKS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE sightline_flags benchmark::benchmark ${arg_LINKS})
  foreach(folder IN LISTS arg_USES)
    target_link_libraries(${name} PRIVATE sightline_${folder})
  endforeach()
endfunction()
