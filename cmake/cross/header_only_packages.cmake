# GLM and tl::expected are headers only, so the build machine's copies serve every target. But they live beside the
# build machine's C library, whose headers a cross compiler must not see: the find_package() calls of the core are
# answered from here, with folders that hold nothing else.
set(glm_DIR "${CMAKE_CURRENT_LIST_DIR}" CACHE PATH "" FORCE)
set(tl-expected_DIR "${CMAKE_CURRENT_LIST_DIR}" CACHE PATH "" FORCE)
set(hwy_DIR "${CMAKE_CURRENT_LIST_DIR}" CACHE PATH "" FORCE)
# The same for xxHash, which is one header.
find_path(SUREFOOT_FOLDER_OF_XXHASH NAMES xxhash.h PATHS /usr/include /usr/local/include
  NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/headers")
file(CREATE_LINK "${SUREFOOT_FOLDER_OF_XXHASH}/xxhash.h" "${CMAKE_BINARY_DIR}/headers/xxhash.h" SYMBOLIC)
set(XXHASH_INCLUDE_DIR "${CMAKE_BINARY_DIR}/headers" CACHE PATH "")
