include("${CMAKE_CURRENT_LIST_DIR}/header_only_package.cmake")
header_only_package(tl::expected tl)
