# What is built, and with which flags. Every target of the project calls surefoot_target(name).
include(GNUInstallDirs)

option(SUREFOOT_BUILD_IMPORT "Build surefoot::import (needs Assimp)" ${PROJECT_IS_TOP_LEVEL})
option(SUREFOOT_BUILD_TOOLS "Build the surefoot program and the judge (needs CLI11, nlohmann-json, fmt, GMP)" ${PROJECT_IS_TOP_LEVEL})
option(SUREFOOT_BUILD_TESTS "Build the tests (needs GoogleTest)" ${PROJECT_IS_TOP_LEVEL})
option(SUREFOOT_BUILD_EXAMPLES "Build the examples" ${PROJECT_IS_TOP_LEVEL})
option(SUREFOOT_BUILD_FUZZ "Build the fuzz targets (needs clang)" OFF)
option(SUREFOOT_INSTALL "Make install rules" ${PROJECT_IS_TOP_LEVEL})
option(SUREFOOT_WERROR "Treat warnings as errors" OFF)
set(SUREFOOT_SANITIZE "" CACHE STRING "Sanitizers for everything, such as address,undefined or thread")

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()

function(surefoot_target name)
  target_compile_features(${name} PUBLIC cxx_std_20)
  set_target_properties(${name} PROPERTIES
    CXX_EXTENSIONS OFF CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON POSITION_INDEPENDENT_CODE ON)
  if(MSVC)
    target_compile_options(${name} PRIVATE /W4 /fp:precise)
  else()
    # The same bits everywhere: no contraction into fused multiply-add, whatever the target machine has.
    target_compile_options(${name} PRIVATE -ffp-contract=off -fno-fast-math
      -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
    if(SUREFOOT_WERROR)
      target_compile_options(${name} PRIVATE -Werror)
    endif()
  endif()
  if(SUREFOOT_SANITIZE)
    target_compile_options(${name} PRIVATE -fsanitize=${SUREFOOT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(${name} PUBLIC -fsanitize=${SUREFOOT_SANITIZE})
  endif()
endfunction()
