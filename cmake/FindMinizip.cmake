# Finds minizip, which comes with zlib and brings no CMake package of its own: Minizip::minizip.
find_path(MINIZIP_INCLUDE_DIR minizip/unzip.h)
find_library(MINIZIP_LIBRARY minizip)
mark_as_advanced(MINIZIP_INCLUDE_DIR MINIZIP_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Minizip
  REQUIRED_VARS MINIZIP_LIBRARY MINIZIP_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "surefoot::import reads .pk3 files with minizip: install libminizip-dev (Debian), or configure with -DSUREFOOT_BUILD_IMPORT=OFF.")
if(Minizip_FOUND AND NOT TARGET Minizip::minizip)
  add_library(Minizip::minizip UNKNOWN IMPORTED)
  set_target_properties(Minizip::minizip PROPERTIES
    IMPORTED_LOCATION "${MINIZIP_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${MINIZIP_INCLUDE_DIR}")
endif()
