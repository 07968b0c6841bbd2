# find_package(brdf): the target brdf::brdf. What it links is inside the library.
include("${CMAKE_CURRENT_LIST_DIR}/brdfTargets.cmake")
