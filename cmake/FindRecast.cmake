# Finds Recast and Detour, which Debian's librecast-dev brings without a CMake package: Recast::Recast, Recast::Detour and
# Recast::DetourCrowd.
find_path(RECAST_INCLUDE_DIR Recast.h PATH_SUFFIXES recastnavigation)
find_library(RECAST_LIBRARY Recast)
find_library(DETOUR_LIBRARY Detour)
find_library(DETOUR_CROWD_LIBRARY DetourCrowd)
mark_as_advanced(RECAST_INCLUDE_DIR RECAST_LIBRARY DETOUR_LIBRARY DETOUR_CROWD_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Recast
  REQUIRED_VARS RECAST_LIBRARY DETOUR_LIBRARY DETOUR_CROWD_LIBRARY RECAST_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "surefoot::navigation stands on Recast and Detour: install librecast-dev (Debian), or configure with -DSUREFOOT_BUILD_NAVIGATION=OFF.")
if(Recast_FOUND AND NOT TARGET Recast::Recast)
  foreach(part Recast Detour DetourCrowd)
    string(REPLACE DetourCrowd DETOUR_CROWD variable "${part}")
    string(TOUPPER "${variable}" variable)
    add_library(Recast::${part} UNKNOWN IMPORTED)
    set_target_properties(Recast::${part} PROPERTIES
      IMPORTED_LOCATION "${${variable}_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${RECAST_INCLUDE_DIR}")
  endforeach()
endif()
