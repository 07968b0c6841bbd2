# Finds SCATMECH, NIST's library of light scattering: https://github.com/usnistgov/SCATMECH
#
#   SCATMECH_ROOT      where it is: its source folder `code` (or the one above) with scatmech.a made in it, or a prefix
#                      with include/ (or include/scatmech/) and lib/
#   SCATMECH_FOUND, SCATMECH_INCLUDE_DIR, SCATMECH_LIBRARY
#   SCATMECH::SCATMECH to link with
#
# The archive goes into a shared library of ours: its objects have to be compiled with -fPIC, which SCATMECH's own
# Makefile does not do by itself (make COMPILEFLAGS="-O2 -fPIC").
find_path(SCATMECH_INCLUDE_DIR NAMES scatmech.h PATH_SUFFIXES scatmech code)
find_library(SCATMECH_LIBRARY NAMES scatmech scatmech.a PATH_SUFFIXES code)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SCATMECH REQUIRED_VARS SCATMECH_LIBRARY SCATMECH_INCLUDE_DIR)
mark_as_advanced(SCATMECH_INCLUDE_DIR SCATMECH_LIBRARY)
if (SCATMECH_FOUND AND NOT TARGET SCATMECH::SCATMECH)
  add_library(SCATMECH::SCATMECH UNKNOWN IMPORTED)
  set_target_properties(SCATMECH::SCATMECH PROPERTIES
    IMPORTED_LOCATION "${SCATMECH_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${SCATMECH_INCLUDE_DIR}"
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${SCATMECH_INCLUDE_DIR}")
endif ()
