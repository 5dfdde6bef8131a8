# GLM and tl::expected are headers only, so the build machine's copies serve every target. But they live beside the
# build machine's C library, whose headers a cross compiler must not see: the two find_package() calls of the core are
# answered from here, with folders that hold nothing else.
set(glm_DIR "${CMAKE_CURRENT_LIST_DIR}" CACHE PATH "" FORCE)
set(tl-expected_DIR "${CMAKE_CURRENT_LIST_DIR}" CACHE PATH "" FORCE)
