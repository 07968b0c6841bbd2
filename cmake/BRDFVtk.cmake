# The VTK module BRDF::vtkfilters and its Python package `brdflab`.
#
# Components are always named: without the list VTK 9.1 demands Qt 5.
set(brdf_vtk_components ChartsCore CommonComputationalGeometry CommonCore CommonDataModel CommonExecutionModel
  FiltersCore FiltersGeneral FiltersSources IOCore IOGeometry IOImage IOPLY IOXML RenderingContext2D
  RenderingContextOpenGL2 RenderingCore RenderingFreeType RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2)
if (BRDF_BUILD_PYTHON)
  list(APPEND brdf_vtk_components Python WrappingPythonCore WrappingTools)
endif ()
# ParallelMPI shares a batch of fits among processes; without it a batch is one process.
find_package(VTK 9.1 REQUIRED COMPONENTS ${brdf_vtk_components} OPTIONAL_COMPONENTS ParallelMPI)
find_package(OpenGL REQUIRED COMPONENTS EGL)

vtk_module_find_modules(brdf_module_files "${CMAKE_SOURCE_DIR}/vtkfilters")
vtk_module_scan(
  MODULE_FILES ${brdf_module_files}
  PROVIDES_MODULES brdf_vtk_modules
  REQUIRES_MODULES brdf_vtk_required
  UNRECOGNIZED_MODULES brdf_vtk_unknown
  WANT_BY_DEFAULT ON
  HIDE_MODULES_FROM_CACHE ON
  ENABLE_TESTS OFF)
vtk_module_build(
  MODULES ${brdf_vtk_modules}
  PACKAGE brdfvtk
  VERSION ${PROJECT_VERSION}
  SOVERSION 1  # 0 counts as false and would make the soname the whole version
  INSTALL_EXPORT brdfvtk
  TEST_DIRECTORY_NAME NONE
  HEADERS_DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/brdfvtk
  CMAKE_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/brdfvtk
  HIERARCHY_DESTINATION ${CMAKE_INSTALL_LIBDIR}/vtk/hierarchy/brdfvtk
  ENABLE_WRAPPING ${BRDF_BUILD_PYTHON})

include(CMakePackageConfigHelpers)
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/brdfvtk-config.cmake.in"
  "${CMAKE_BINARY_DIR}/brdfvtk-config.cmake"
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/brdfvtk)
write_basic_package_version_file("${CMAKE_BINARY_DIR}/brdfvtk-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/brdfvtk-config.cmake" "${CMAKE_BINARY_DIR}/brdfvtk-config-version.cmake"
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/brdfvtk)

# BRDF_PYTHON_PATH is what PYTHONPATH has to name for `import brdflab` from the build tree.
if (BRDF_BUILD_PYTHON)
  vtk_module_python_default_destination(BRDF_PYTHON_DIR)
  set(BRDF_PYTHON_PATH "${CMAKE_BINARY_DIR}/${BRDF_PYTHON_DIR}")
  vtk_module_wrap_python(
    MODULES ${brdf_vtk_modules}
    TARGET BRDF::pythonwrapped
    INSTALL_EXPORT brdfvtk
    PYTHON_PACKAGE brdflab
    MODULE_DESTINATION "${BRDF_PYTHON_DIR}"
    CMAKE_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/brdfvtk
    LIBRARY_DESTINATION ${CMAKE_INSTALL_LIBDIR})
  foreach (file IN ITEMS __init__.py notebook.py shorthands.py)
    configure_file("${CMAKE_SOURCE_DIR}/python/${file}" "${BRDF_PYTHON_PATH}/brdflab/${file}" COPYONLY)
    install(FILES "${CMAKE_SOURCE_DIR}/python/${file}" DESTINATION "${BRDF_PYTHON_DIR}/brdflab")
  endforeach ()
endif ()
