# Cross compiling for 64-bit Windows with Debian's mingw-w64. It shows that the core knows no operating system.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_CXX_FLAGS_INIT -Wno-attributes)  # gnu::visibility means nothing to Windows, and g++ says so at every header
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
include("${CMAKE_CURRENT_LIST_DIR}/header_only_packages.cmake")
