option(SIGHTLINE_APP "Build the sightline command" ${PROJECT_IS_TOP_LEVEL})
option(SIGHTLINE_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(SIGHTLINE_BENCH "Build the benchmarks" OFF)
option(SIGHTLINE_EXAMPLES "Build the examples" OFF)
option(SIGHTLINE_INSTALL "Make install rules" ${PROJECT_IS_TOP_LEVEL})
option(SIGHTLINE_WERROR "Treat warnings as errors" OFF)
option(SIGHTLINE_SANITIZE "Build with address and undefined-behaviour sanitizers" OFF)

include(GNUInstallDirs)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(SIGHTLINE_CCACHE ccache)
  mark_as_advanced(SIGHTLINE_CCACHE)
  if(SIGHTLINE_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${SIGHTLINE_CCACHE})
  endif()
endif()

# Filters are derived for plain IEEE arithmetic: no contraction, no fast-math.
add_library(sightline_flags INTERFACE)
target_compile_options(sightline_flags INTERFACE -ffp-contract=off -fno-fast-math -Wall -Wextra -Wshadow -Wconversion
                       $<$<BOOL:${SIGHTLINE_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns of overlap in std::string's own operator+ (GCC bug 105329).
  target_compile_options(sightline_flags INTERFACE -Wno-restrict)
endif()
if(SIGHTLINE_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
