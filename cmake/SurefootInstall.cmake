# cmake --install: libraries, headers, the program, and what find_package(surefoot) and pkg-config need.
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/surefoot")
file(RELATIVE_PATH SUREFOOT_BIN_TO_LIB "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")

# install_component(name targets...): one export file a component, so that the core can be found without the importer.
function(install_component component)
  install(TARGETS ${ARGN} EXPORT surefoot-${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(EXPORT surefoot-${component} NAMESPACE surefoot:: DESTINATION ${package_dir}
    FILE surefoot-${component}-targets.cmake)
endfunction()

install_component(core surefoot)
# A static library leaves it to whoever links it to link Highway too.
set(SUREFOOT_CORE_STATIC FALSE)
get_target_property(type surefoot TYPE)
if(type STREQUAL STATIC_LIBRARY)
  set(SUREFOOT_CORE_STATIC TRUE)
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/surefoot" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.hpp")

set(SUREFOOT_IMPORT_STATIC FALSE)
if(TARGET surefoot_import)
  set_target_properties(surefoot_import PROPERTIES INSTALL_RPATH "$ORIGIN")
  install_component(import surefoot_import)
  # A static library leaves it to whoever links it to link minizip too.
  get_target_property(type surefoot_import TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    set(SUREFOOT_IMPORT_STATIC TRUE)
    install(FILES "${PROJECT_SOURCE_DIR}/cmake/FindMinizip.cmake" DESTINATION ${package_dir})
  endif()
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/import/include/surefoot" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.hpp")
endif()

set(SUREFOOT_NAVIGATION_STATIC FALSE)
if(TARGET surefoot_navigation)
  set_target_properties(surefoot_navigation PROPERTIES INSTALL_RPATH "$ORIGIN")
  install_component(navigation surefoot_navigation)
  # A static library leaves it to whoever links it to link Recast and Detour too.
  get_target_property(type surefoot_navigation TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    set(SUREFOOT_NAVIGATION_STATIC TRUE)
    install(FILES "${PROJECT_SOURCE_DIR}/cmake/FindRecast.cmake" DESTINATION ${package_dir})
  endif()
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/navigation/include/surefoot" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.hpp")
endif()
if(TARGET surefoot_importer)
  install(TARGETS surefoot_importer RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/surefoot)
endif()
if(TARGET surefoot_program)
  set_target_properties(surefoot_program PROPERTIES INSTALL_RPATH "$ORIGIN/${SUREFOOT_BIN_TO_LIB}")
  install(TARGETS surefoot_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
if(TARGET surefoot_playground)
  set_target_properties(surefoot_playground PROPERTIES INSTALL_RPATH "$ORIGIN/${SUREFOOT_BIN_TO_LIB}")
  install(TARGETS surefoot_playground RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/surefoot-config.cmake.in"
  "${PROJECT_BINARY_DIR}/surefoot-config.cmake" INSTALL_DESTINATION ${package_dir})
# While the major number is 0, a new minor number may change the API.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/surefoot-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/surefoot-config.cmake" "${PROJECT_BINARY_DIR}/surefoot-config-version.cmake"
  DESTINATION ${package_dir})

# The .pc file finds its folders from where it lies, so that an installed tree can be moved.
file(RELATIVE_PATH SUREFOOT_PC_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
# A static library leaves it to whoever links it to bring what it stands on.
set(SUREFOOT_PC_REQUIRES "Requires")
if(BUILD_SHARED_LIBS)
  set(SUREFOOT_PC_REQUIRES "Requires.private")
endif()
configure_file("${PROJECT_SOURCE_DIR}/cmake/surefoot.pc.in" "${PROJECT_BINARY_DIR}/surefoot.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/surefoot.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/NOTICE" DESTINATION ${CMAKE_INSTALL_DOCDIR})
