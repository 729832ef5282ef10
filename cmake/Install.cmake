# Components: `program`; `development`, the C++ libraries and headers, for find_package(evenlift) and pkg-config; and
# `library`, for C and languages that call C. docs/packages.md is the manual.
include_guard()
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(EVENLIFT_PACKAGE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/evenlift")

if(TARGET evenlift)
  install(TARGETS evenlift RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)
endif()

# --- C++: evenlift::core and the libraries on top of it ---------------------------------------------------------------
set(libraries evenlift_core evenlift_output evenlift_optimum evenlift_experiment)
# If pugixml is not a library of the system, ours is installed with it, under a unique name.
set(pugixml_is_elsewhere OFF)
if(EVENLIFT_IMPORT)
  list(APPEND libraries evenlift_import evenlift_parts evenlift_request)
  get_target_property(pugixml_is_elsewhere pugixml::pugixml IMPORTED)
  if(NOT pugixml_is_elsewhere)
    list(APPEND libraries pugixml)
    set_target_properties(pugixml PROPERTIES OUTPUT_NAME evenlift_pugixml)
  endif()
endif()
install(TARGETS ${libraries} EXPORT evenlift_targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
install(
  EXPORT evenlift_targets
  NAMESPACE evenlift::
  FILE evenlift-targets.cmake
  DESTINATION "${EVENLIFT_PACKAGE_DIR}"
  COMPONENT development)
install(
  DIRECTORY "${PROJECT_SOURCE_DIR}/core/include/evenlift"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  COMPONENT development
  FILES_MATCHING
  PATTERN "*.h")

set(EVENLIFT_NEEDS_PUGIXML ${pugixml_is_elsewhere})
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/evenlift-config.cmake.in" "${PROJECT_BINARY_DIR}/package/evenlift-config.cmake"
  INSTALL_DESTINATION "${EVENLIFT_PACKAGE_DIR}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/package/evenlift-config-version.cmake" COMPATIBILITY SameMajorVersion)
install(
  FILES "${PROJECT_BINARY_DIR}/package/evenlift-config.cmake" "${PROJECT_BINARY_DIR}/package/evenlift-config-version.cmake"
  DESTINATION "${EVENLIFT_PACKAGE_DIR}"
  COMPONENT development)

# --- C, and what calls it --------------------------------------------------------------------------------------------------
install(
  TARGETS evenlift_c
  EXPORT evenlift_targets
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library NAMELINK_COMPONENT development
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT library
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
install(FILES "${PROJECT_SOURCE_DIR}/c/include/evenlift/evenlift.h" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/evenlift"
        COMPONENT development)

# --- pkg-config -------------------------------------------------------------------------------------------------------
# Paths are relative to the file, as the installed folder may be moved; a distribution's absolute folders stay absolute.
function(evenlift_pkg_config name component)
  cmake_path(IS_ABSOLUTE CMAKE_INSTALL_LIBDIR fixed)
  if(fixed)
    set(EVENLIFT_PREFIX "${CMAKE_INSTALL_PREFIX}")
  else()
    file(RELATIVE_PATH up "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
    set(EVENLIFT_PREFIX "\${pcfiledir}/${up}")
  endif()
  foreach(kind LIB INCLUDE)
    cmake_path(IS_ABSOLUTE CMAKE_INSTALL_${kind}DIR fixed)
    set(EVENLIFT_${kind}_DIR "\${prefix}/${CMAKE_INSTALL_${kind}DIR}")
    if(fixed)
      set(EVENLIFT_${kind}_DIR "${CMAKE_INSTALL_${kind}DIR}")
    endif()
  endforeach()
  configure_file("${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in" "${PROJECT_BINARY_DIR}/package/${name}.pc" @ONLY)
  install(
    FILES "${PROJECT_BINARY_DIR}/package/${name}.pc"
    DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
    COMPONENT ${component})
endfunction()
evenlift_pkg_config(evenlift development)
if(pugixml_is_elsewhere)
  set(EVENLIFT_PUGIXML_REQUIRES "pugixml >= 1.11")
  set(EVENLIFT_PUGIXML_LIBS "")
else()
  set(EVENLIFT_PUGIXML_REQUIRES "")
  set(EVENLIFT_PUGIXML_LIBS "-levenlift_pugixml")
endif()
if(EVENLIFT_IMPORT)
  evenlift_pkg_config(evenlift-import development)
  evenlift_pkg_config(evenlift-c development)
endif()

# --- The licence ----------------------------------------------------------------------------------------------------------
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT development)
