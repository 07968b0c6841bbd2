# The CMake package BRDFLab, and a Debian package by `cpack -G DEB`.
include(CMakePackageConfigHelpers)
set(destination "${CMAKE_INSTALL_LIBDIR}/cmake/BRDFLab")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/BRDFLabConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_LIST_DIR}/BRDFAddPlugin.cmake" "${CMAKE_CURRENT_LIST_DIR}/BRDFLabConfig.cmake"
  "${CMAKE_BINARY_DIR}/BRDFLabConfigVersion.cmake"
  DESTINATION "${destination}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/README.md" TYPE DOC)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples" TYPE DOC)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/datasets/environments" DESTINATION "${CMAKE_INSTALL_DATADIR}/brdflab")

set(CPACK_PACKAGE_NAME brdflab)
set(CPACK_PACKAGE_CONTACT "BRDFLab <brdflab@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Laboratory for the reflection of materials (BRDFs)")
set(CPACK_PACKAGE_DESCRIPTION
  "Reads measured BRDFs, evaluates and fits analytic ones, draws lobes, slices and error maps,\nrenders objects under environment light, and exports to other renderers: a program, C++\nlibraries with VTK filters, and a Python package.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-vtk9, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libvtk9-dev, mpi-default-bin")
include(CPack)
