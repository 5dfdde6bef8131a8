# header_only_package(target folder): an imported target for /usr/include/<folder>, or wherever the build machine has it.
function(header_only_package target folder)
  find_path(SUREFOOT_HEADERS_OF_${folder} NAMES ${folder} PATHS /usr/include /usr/local/include
    NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  set(staged "${CMAKE_BINARY_DIR}/headers")
  file(MAKE_DIRECTORY "${staged}")
  file(CREATE_LINK "${SUREFOOT_HEADERS_OF_${folder}}/${folder}" "${staged}/${folder}" SYMBOLIC)
  if(NOT TARGET ${target})
    add_library(${target} INTERFACE IMPORTED)
    set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${staged}")
  endif()
endfunction()
