# Cross compiling for 64-bit ARM with Debian's cross compiler, and running what was built under qemu-user.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)  # so that qemu needs no ARM system to load libraries from
include("${CMAKE_CURRENT_LIST_DIR}/header_only_packages.cmake")
