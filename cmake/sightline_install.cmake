# sightline::sightline is the whole library; `find_package(sightline)` finds what is installed here.
add_library(sightline INTERFACE)
add_library(sightline::sightline ALIAS sightline)
get_property(folders GLOBAL PROPERTY sightline_folders)
foreach(folder IN LISTS folders)
  target_link_libraries(sightline INTERFACE sightline_${folder})
endforeach()

if(SIGHTLINE_INSTALL)
  include(CMakePackageConfigHelpers)
  set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/sightline)
  install(TARGETS sightline EXPORT sightline)
  install(FILES ${PROJECT_SOURCE_DIR}/sightline.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sightline)
  install(EXPORT sightline NAMESPACE sightline:: FILE sightlineTargets.cmake DESTINATION ${package_dir})
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/sightlineConfig.cmake.in
    ${PROJECT_BINARY_DIR}/sightlineConfig.cmake INSTALL_DESTINATION ${package_dir})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/sightlineConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/sightlineConfig.cmake ${PROJECT_BINARY_DIR}/sightlineConfigVersion.cmake
          ${PROJECT_SOURCE_DIR}/cmake/FindGMP.cmake DESTINATION ${package_dir})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()
