# cmake --install: the headers, in a folder of their own so that a prefix shared with CGAL keeps CGAL's header, and what
# find_package(Jet_fitting_3 CONFIG) needs.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Jet_fitting_3")
set(config_build_dir "${CMAKE_CURRENT_BINARY_DIR}/cmake")

# An imported target is searched as a system folder, after CGAL's if that came first; EXPORT_NO_SYSTEM keeps ours before.
set_target_properties(Jet_fitting_3_core Jet_fitting_3 PROPERTIES EXPORT_NO_SYSTEM ON)

install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/CGAL" DESTINATION include/Jet_fitting_3 FILES_MATCHING PATTERN "*.h")
install(TARGETS Jet_fitting_3_core Jet_fitting_3 EXPORT Jet_fitting_3Targets)
install(EXPORT Jet_fitting_3Targets NAMESPACE CGAL:: DESTINATION "${config_dir}")

configure_package_config_file(cmake/Jet_fitting_3Config.cmake.in "${config_build_dir}/Jet_fitting_3Config.cmake"
  INSTALL_DESTINATION "${config_dir}")
write_basic_package_version_file("${config_build_dir}/Jet_fitting_3ConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES "${config_build_dir}/Jet_fitting_3Config.cmake" "${config_build_dir}/Jet_fitting_3ConfigVersion.cmake"
  cmake/FindLAPACKE.cmake cmake/Jet_fitting_3_levels.cmake DESTINATION "${config_dir}")
