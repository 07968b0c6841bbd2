# brdf_add_plugin(<name> SOURCES <file>... [LOBES <folder>])
#
# A shared library <name>.so that BRDFLab finds in brdflab/plugins beside its library, or in a folder of
# BRDFLAB_PLUGIN_PATH. LOBES: a folder of formula files, put beside the plugin as <name>.lobes.
include(GNUInstallDirs)
function (brdf_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LOBES" "SOURCES")
  add_library(${name} MODULE ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE brdf::brdf)
  set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  set(destination "${CMAKE_INSTALL_LIBDIR}/brdflab/plugins")
  install(TARGETS ${name} LIBRARY DESTINATION "${destination}")
  if (arg_LOBES)
    get_filename_component(folder "${arg_LOBES}" ABSOLUTE)
    add_custom_command(TARGET ${name} POST_BUILD
      COMMAND "${CMAKE_COMMAND}" -E copy_directory "${folder}" "$<TARGET_FILE_DIR:${name}>/${name}.lobes")
    install(DIRECTORY "${folder}/" DESTINATION "${destination}/${name}.lobes")
  endif ()
endfunction ()
