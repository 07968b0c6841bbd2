#include "Output.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

void writeStandardOutput(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw Error(Error::Kind::File, {"cannot be written", "standard output", std::strerror(errno), ""});
}

}  // namespace

void Output::line(std::string_view text) const {
  if (textWanted()) writeStandardOutput(std::string(text) + "\n");
}

void Output::report(const nlohmann::ordered_json& json) const {
  if (jsonTarget.empty()) return;
  const std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  if (jsonTarget == "-")
    writeStandardOutput(text);
  else
    writeFile(jsonTarget, text);
}

std::string number(double value) { return formatNumber(value, 6); }

void checkWritable(const std::string& path) {
  if (!path.empty() && path != "-" && path != "/dev/null" && path != "/dev/stdout") AtomicFile probe(path);
}

}  // namespace brdf::app
