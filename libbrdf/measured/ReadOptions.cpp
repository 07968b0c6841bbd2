#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/measured/Format.h>
#include <brdf/measured/ReadOptions.h>

#include <algorithm>

namespace brdf {
namespace {

enum Key { kQuantity, kAngles, kIncident, kSymmetry, kColour, kInvalid, kSides };

/// The values stand in the order of their enumerations.
const std::vector<ReadOptionKey>& table() {
  static const std::vector<ReadOptionKey> keys{
      {"quantity", {"brdf", "brdf_cos", "reflectance_factor"}, "what the values are: f_r, f_r cos(theta_o), pi f_r"},
      {"angles", {"degrees", "radians"}, "unit of the file's angles"},
      {"incident", {"as_stated", "swapped"}, "which direction is the light's: the one called incident, or the other"},
      {"symmetry", {"isotropic", "bilateral", "anisotropic"}, "symmetry of the surface that completes the data"},
      {"colour", {"linear_srgb", "srgb", "xyz"}, "what three values a sample are; srgb is the encoded one"},
      {"invalid", {"not_finite", "negative", "not_positive"}, "which values mean not measured"},
      {"sides", {"as_stated", "swapped"}, "whether front and back change places"}};
  return keys;
}

/// Calls visit(member, key) for each option.
template <class Options, class Visit>
void forEach(Options& options, const Visit& visit) {
  visit(options.quantity, kQuantity);
  visit(options.angles, kAngles);
  visit(options.incident, kIncident);
  visit(options.symmetry, kSymmetry);
  visit(options.colour, kColour);
  visit(options.invalid, kInvalid);
  visit(options.sides, kSides);
}

template <class T>
T chosen(const std::optional<T>& given, Key key, T byFormat, std::string_view evidence, ReadReport& report) {
  const ReadOptionKey& entry = table()[key];
  const auto name = [&](T value) { return entry.values[static_cast<std::size_t>(value)]; };
  std::string sentence = entry.key + ": " + name(given.value_or(byFormat)) + " (";
  if (given) sentence += "given; ";
  sentence += evidence;
  if (given && *given != byFormat) sentence += ": " + name(byFormat);
  report.assumptions.push_back(sentence + ")");
  return given.value_or(byFormat);
}

}  // namespace

std::span<const ReadOptionKey> readOptionKeys() { return table(); }

std::vector<std::string> ReadOptions::keys() const {
  std::vector<std::string> names;
  forEach(*this, [&](const auto& member, Key key) {
    if (member) names.push_back(table()[key].key);
  });
  return names;
}

ReadOptions parseReadOptions(std::span<const std::string> items) {
  ReadOptions options;
  for (const std::string& item : items) {
    const std::size_t equals = std::min(item.find('='), item.size());
    const std::string_view name = trimmed(std::string_view(item).substr(0, equals));
    const std::string_view value = equals < item.size() ? trimmed(std::string_view(item).substr(equals + 1)) : "";
    std::vector<std::string> names;
    bool known = false;
    forEach(options, [&](auto& member, Key key) {
      const ReadOptionKey& entry = table()[key];
      names.push_back(entry.key);
      if (entry.key != name) return;
      known = true;
      const auto found = std::find(entry.values.begin(), entry.values.end(), value);
      if (found == entry.values.end())
        throw Error(Error::Kind::Usage,
                    {"unknown value", "assume " + entry.key, "'" + std::string(value) + "'", joined(entry.values)});
      using Enum = typename std::remove_reference_t<decltype(member)>::value_type;
      member = static_cast<Enum>(found - entry.values.begin());
    });
    if (!known)
      throw Error(Error::Kind::Usage,
                  {"unknown assumption", "assume", "'" + item + "'", joined(names) + ", as KEY=VALUE"});
  }
  return options;
}

Quantity choose(const ReadOptions& options, Quantity byFormat, std::string_view evidence, ReadReport& report) {
  return chosen(options.quantity, kQuantity, byFormat, evidence, report);
}
AngleUnit choose(const ReadOptions& options, AngleUnit byFormat, std::string_view evidence, ReadReport& report) {
  return chosen(options.angles, kAngles, byFormat, evidence, report);
}
Incident choose(const ReadOptions& options, Incident byFormat, std::string_view evidence, ReadReport& report) {
  return chosen(options.incident, kIncident, byFormat, evidence, report);
}
Symmetry choose(const ReadOptions& options, Symmetry byFormat, std::string_view evidence, ReadReport& report) {
  return chosen(options.symmetry, kSymmetry, byFormat, evidence, report);
}
ColourSpace choose(const ReadOptions& options, ColourSpace byFormat, std::string_view evidence, ReadReport& report) {
  return chosen(options.colour, kColour, byFormat, evidence, report);
}
InvalidRule choose(const ReadOptions& options, InvalidRule byFormat, std::string_view evidence, ReadReport& report) {
  return chosen(options.invalid, kInvalid, byFormat, evidence, report);
}
Sides choose(const ReadOptions& options, Sides byFormat, std::string_view evidence, ReadReport& report) {
  return chosen(options.sides, kSides, byFormat, evidence, report);
}

}  // namespace brdf
