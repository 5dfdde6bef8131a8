# Highway's headers, with the one target that the compiler is set to: run-time dispatch would need its library.
include("${CMAKE_CURRENT_LIST_DIR}/header_only_package.cmake")
header_only_package(hwy::hwy hwy)
set_property(TARGET hwy::hwy APPEND PROPERTY INTERFACE_COMPILE_DEFINITIONS HWY_COMPILE_ONLY_STATIC)
