# find_package(BRDFLab [COMPONENTS core vtk]): the whole laboratory by one name.
#
#   core  brdf::brdf       the library without VTK
#   vtk   BRDF::vtkfilters sources, filters, mappers and views; needs VTK 9.1 or later, and a project whose languages
#                          include C (VTK's own packages look for MPI in C)
#
# Without COMPONENTS: core, and vtk where it was built.
include(CMakeFindDependencyMacro)
find_dependency(brdf CONFIG PATHS "${CMAKE_CURRENT_LIST_DIR}/../brdf" NO_DEFAULT_PATH)
set(BRDFLab_core_FOUND TRUE)

set(_brdflab_vtk "${CMAKE_CURRENT_LIST_DIR}/../brdfvtk/brdfvtk-config.cmake")
set(_brdflab_wanted ${BRDFLab_FIND_COMPONENTS})
if (NOT _brdflab_wanted AND EXISTS "${_brdflab_vtk}")
  set(_brdflab_wanted vtk)
endif ()
foreach (_component IN LISTS _brdflab_wanted)
  if (_component STREQUAL "vtk" AND EXISTS "${_brdflab_vtk}")
    find_dependency(brdfvtk CONFIG PATHS "${CMAKE_CURRENT_LIST_DIR}/../brdfvtk" NO_DEFAULT_PATH)
    set(BRDFLab_vtk_FOUND TRUE)
  elseif (NOT BRDFLab_${_component}_FOUND AND BRDFLab_FIND_REQUIRED_${_component})
    set(BRDFLab_FOUND FALSE)
    set(BRDFLab_NOT_FOUND_MESSAGE "BRDFLab has no component ${_component} here; there are: core, vtk (where built)")
  endif ()
endforeach ()
unset(_brdflab_vtk)
unset(_brdflab_wanted)

include("${CMAKE_CURRENT_LIST_DIR}/BRDFAddPlugin.cmake")
