# Script behind brdf_embed(): writes HEADER and SOURCE from FILES. See BRDFEmbed.cmake.
file(WRITE "${HEADER}" "// Generated. See cmake/BRDFEmbed.cmake.
#pragma once
#include <brdf/base/EmbeddedFile.h>
#include <span>
namespace ${NAMESPACE} {
std::span<const brdf::EmbeddedFile> ${NAME}();
}
")
set(bodies "")
set(entries "")
set(index 0)
foreach (file IN LISTS FILES)
  get_filename_component(base "${file}" NAME)
  file(READ "${file}" hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  string(REGEX REPLACE "((0x..,){32})" "\\1\n" bytes "${bytes}")
  string(LENGTH "${hex}" length)
  math(EXPR length "${length} / 2")
  string(APPEND bodies "const unsigned char data${index}[] = {${bytes}0};\n")
  string(APPEND entries
    "  {\"${base}\", std::string_view(reinterpret_cast<const char*>(data${index}), ${length})},\n")
  math(EXPR index "${index} + 1")
endforeach ()
if (index EQUAL 0)
  message(FATAL_ERROR "brdf_embed(${NAME}): no files")
endif ()
file(WRITE "${SOURCE}" "// Generated. See cmake/BRDFEmbed.cmake.
#include \"${NAME}.h\"
namespace ${NAMESPACE} {
namespace {
${bodies}
const brdf::EmbeddedFile files[] = {
${entries}};
}
std::span<const brdf::EmbeddedFile> ${NAME}() { return files; }
}
")
