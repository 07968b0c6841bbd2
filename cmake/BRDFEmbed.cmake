# brdf_embed(<target> <namespace> <name> <file>...): compiles text files into <target>.
#
# Makes `<name>.h`, which declares, and `<name>.cpp`, which defines,
#   namespace <namespace> { std::span<const EmbeddedFile> <name>(); }
# with one EmbeddedFile {name, text} for each file, in the order given; `name` is the file's name without its folder.
function (brdf_embed target namespace name)
  set(header "${CMAKE_CURRENT_BINARY_DIR}/${name}.h")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  set(files "")
  foreach (file IN LISTS ARGN)
    get_filename_component(path "${file}" ABSOLUTE)
    list(APPEND files "${path}")
  endforeach ()
  add_custom_command(
    OUTPUT "${header}" "${source}"
    COMMAND ${CMAKE_COMMAND} "-DFILES=${files}" -DNAMESPACE=${namespace} -DNAME=${name} "-DHEADER=${header}"
            "-DSOURCE=${source}" -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/EmbedFiles.cmake"
    DEPENDS ${files} "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/EmbedFiles.cmake"
    VERBATIM)
  # The target may belong to a folder above: a custom command alone would be out of its sight.
  add_custom_target(${target}_${name} DEPENDS "${header}" "${source}")
  add_dependencies(${target} ${target}_${name})
  target_sources(${target} PRIVATE "${header}" "${source}")
  set_source_files_properties("${header}" "${source}" TARGET_DIRECTORY ${target} PROPERTIES GENERATED TRUE)
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
endfunction ()
