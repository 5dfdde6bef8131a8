# What is built, and with which flags. Every target of the project calls surefoot_target(name).
include(GNUInstallDirs)

set(top ${PROJECT_IS_TOP_LEVEL})
option(SUREFOOT_BUILD_IMPORT "Build surefoot::import (needs Assimp and minizip)" ${top})
option(SUREFOOT_BUILD_NAVIGATION "Build surefoot::navigation (needs Recast and Detour)" ${top})
option(SUREFOOT_BUILD_TOOLS "Build the surefoot program and the judge (needs surefoot::import, CLI11, nlohmann-json, fmt, GMP)" ${top})
option(SUREFOOT_BUILD_APPS "Build the playground, a program with a window (needs the surefoot program's parts, GLFW, epoxy, EGL, Dear ImGui)" ${top})
option(SUREFOOT_BUILD_TESTS "Build the unit tests (needs GoogleTest)" ${top})
option(SUREFOOT_BUILD_GOLDEN "Build the golden hash tests (they need nothing but the core)" ${top})
option(SUREFOOT_BUILD_CHECKS "Check the house: format, floors, headers, README, symbols, installing (needs Python 3)" OFF)
option(SUREFOOT_BUILD_EXAMPLES "Build the examples" ${top})
option(SUREFOOT_BUILD_FUZZ "Build the fuzz targets (needs clang)" OFF)
option(SUREFOOT_INSTALL "Make install rules" ${top})
option(SUREFOOT_WERROR "Treat warnings as errors" OFF)
set(SUREFOOT_SANITIZE "" CACHE STRING "Sanitizers for everything, such as address,undefined or thread")
set(SUREFOOT_TEST_PREFIX "" CACHE STRING "Put before every test name, to tell builds apart when ctest runs several of them")
unset(top)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()

function(surefoot_target name)
  target_compile_features(${name} PUBLIC cxx_std_20)
  set_target_properties(${name} PROPERTIES
    CXX_EXTENSIONS OFF CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON POSITION_INDEPENDENT_CODE ON
    # Nothing asks for the macro that says "being exported", and without it a shared library is compiled by the very
    # commands of the static one, so that ccache has done it already.
    DEFINE_SYMBOL "")
  if(MSVC)
    target_compile_options(${name} PRIVATE /W4 /fp:precise)
  else()
    # The same bits everywhere: no contraction into fused multiply-add, whatever the target machine has.
    target_compile_options(${name} PRIVATE -ffp-contract=off -fno-fast-math
      -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # g++ 12 drops the rounding of double -> float -> double where its SLP vectoriser puts two of them side by side.
      target_compile_options(${name} PRIVATE -fno-tree-slp-vectorize)
    endif()
    if(SUREFOOT_WERROR)
      target_compile_options(${name} PRIVATE -Werror)
    endif()
  endif()
  if(SUREFOOT_SANITIZE)
    target_compile_options(${name} PRIVATE -fsanitize=${SUREFOOT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(${name} PUBLIC -fsanitize=${SUREFOOT_SANITIZE})
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
      # Instrumented code hides from g++ what it sees in plain code, and it then warns of what cannot be.
      target_compile_options(${name} PRIVATE -Wno-maybe-uninitialized)
    endif()
  endif()
  get_target_property(type ${name} TYPE)
  if(type STREQUAL SHARED_LIBRARY AND UNIX AND NOT APPLE)
    set(exports "${PROJECT_SOURCE_DIR}/cmake/exports.map")
    target_link_options(${name} PRIVATE "LINKER:--version-script=${exports}")
    set_property(TARGET ${name} APPEND PROPERTY LINK_DEPENDS "${exports}")
  endif()
endfunction()

# For code that is written once and run once, as that of most tests: half the time to compile it at -O3 is the optimiser's.
function(surefoot_quick_to_build name)
  if(NOT MSVC)
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# With SUREFOOT_UNITY the files of each folder below the target's own are compiled as one, which takes half the time from
# nothing; a change of one takes longer. Names in their anonymous namespaces then have to differ within a folder, and seem
# to shadow those of the next file, so that this warning is left to builds without it.
option(SUREFOOT_UNITY "Compile the files of a folder as one: quicker from nothing, slower after a change" OFF)
function(surefoot_compiled_together name)
  if(SUREFOOT_UNITY)
    get_target_property(files ${name} SOURCES)
    foreach(file IN LISTS files)
      get_filename_component(folder "${file}" DIRECTORY)
      if(folder)
        set_source_files_properties("${file}" PROPERTIES UNITY_GROUP "${folder}")
      endif()
    endforeach()
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    if(NOT MSVC)
      target_compile_options(${name} PRIVATE -Wno-shadow)
    endif()
  endif()
endfunction()
