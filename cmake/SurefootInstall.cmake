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

# install_wing(component NAME finder): a wing, if it is built. A static library leaves it to whoever links it to link too
# what it stands on, which `finder` finds.
macro(install_wing component name finder)
  set(SUREFOOT_${name}_STATIC FALSE)
  if(TARGET surefoot_${component})
    set_target_properties(surefoot_${component} PROPERTIES INSTALL_RPATH "$ORIGIN")
    install_component(${component} surefoot_${component})
    get_target_property(type surefoot_${component} TYPE)
    if(type STREQUAL STATIC_LIBRARY)
      set(SUREFOOT_${name}_STATIC TRUE)
      install(FILES "${PROJECT_SOURCE_DIR}/cmake/${finder}.cmake" DESTINATION ${package_dir})
    endif()
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/${component}/include/surefoot" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
      FILES_MATCHING PATTERN "*.hpp")
  endif()
endmacro()
install_wing(import IMPORT FindMinizip)
install_wing(navigation NAVIGATION FindRecast)
if(TARGET surefoot_importer)
  install(TARGETS surefoot_importer RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/surefoot)
endif()
if(TARGET surefoot_program)
  set_target_properties(surefoot_program PROPERTIES INSTALL_RPATH "$ORIGIN/${SUREFOOT_BIN_TO_LIB}")
  install(TARGETS surefoot_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
if(TARGET surefoot_playground)
  set_target_properties(surefoot_playground PROPERTIES INSTALL_RPATH "$ORIGIN/${SUREFOOT_BIN_TO_LIB}")
  set_target_properties(surefoot_platformer_program PROPERTIES INSTALL_RPATH "$ORIGIN/${SUREFOOT_BIN_TO_LIB}")
  install(TARGETS surefoot_playground surefoot_platformer_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  # Where the programs look for them: apps/playground/CMakeLists.txt.
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/levels/platformer/" DESTINATION ${CMAKE_INSTALL_DATADIR}/surefoot/levels/platformer
    FILES_MATCHING PATTERN "*.glb" PATTERN "campaign.txt" PATTERN "kit" EXCLUDE PATTERN "__pycache__" EXCLUDE)
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
