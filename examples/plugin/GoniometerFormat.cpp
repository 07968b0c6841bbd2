#include "Workshop.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/ScatteredBrdf.h>

namespace workshop {
namespace {

constexpr std::string_view kFirstLine = "workshop goniometer";

brdf::ReadResult read(std::string_view bytes, const std::filesystem::path& path, const brdf::ReadOptions&) {
  brdf::ScatteredSamples samples;
  samples.channels = brdf::Channels::monochrome();
  std::size_t number = 0;
  for (const std::string_view line : brdf::split(bytes, '\n')) {
    ++number;
    if (number == 1 || brdf::trimmed(line).empty()) continue;
    double column[4];
    std::size_t count = 0;
    for (const std::string_view word : brdf::split(brdf::trimmed(line), ' ')) {
      const auto value = brdf::parseNumber(word);
      if (!value || count == 4) {
        count = 0;
        break;
      }
      column[count++] = *value;
    }
    if (count != 4)
      throw brdf::Error(brdf::Error::Kind::Format,
                        {"malformed line", path.string() + ", line " + std::to_string(number),
                         "'" + std::string(brdf::trimmed(line)) + "'", "theta_i theta_o phi f"});
    samples.pairs.push(brdf::fromSpherical(brdf::radians(column[0]), 0),
                       brdf::fromSpherical(brdf::radians(column[1]), brdf::radians(column[2])));
    samples.values.push_back(column[3]);
  }
  brdf::ReadResult result;
  result.report.format = "goniometer";
  result.report.source = path.string();
  result.report.samples = samples.values.size();
  result.report.assumptions = {"values are f_r in 1/sr (the format's definition)", "isotropic (one azimuth a sample)"};
  result.brdf = std::make_shared<brdf::ScatteredBrdf>(std::move(samples), "goniometer " + path.filename().string());
  return result;
}

}  // namespace

brdf::Format goniometerFormat() {
  brdf::Format format;
  format.name = "goniometer";
  format.title = "our goniometer, text";
  format.extension = ".gonio";
  format.recognise = [](std::string_view head, std::uint64_t) { return head.starts_with(kFirstLine) ? 100 : 0; };
  format.read = read;
  return format;
}

}  // namespace workshop
