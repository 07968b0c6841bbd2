// JSON of the BiRD project (EMPIR 16NRM08; schema data_json_schema_v1.0 in its repository): {"metadata": {...}, "data":
// {theta_i, phi_i, theta_r, phi_r, wavelength_i, polarization_i, BRDF, uBRDF, ...}}, each variable {"unit", "values",
// "uncertainty"} with one number a point. Points that differ in wavelength alone are the channels of one sample.
#include <brdf/base/Error.h>
#include <brdf/base/JsonText.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/SampleRows.h>
#include <brdf/measured/ScatteredText.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace brdf {
namespace {

constexpr std::array<const char*, 4> kAngles{"theta_i", "phi_i", "theta_r", "phi_r"};
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// One file's "data", and where to say that something is wrong with it.
class Data {
 public:
  Data(const Json& data, std::string where) : data_(data), where_(std::move(where)) {}

  [[noreturn]] void fail(std::string what, const std::string& variable, std::string found, std::string allowed) const {
    throw Error(Error::Kind::Format,
                {std::move(what), where_ + ", data." + variable, std::move(found), std::move(allowed)});
  }
  bool has(const std::string& variable) const { return data_.contains(variable) && data_[variable].is_object(); }
  std::string unit(const std::string& variable) const {
    const Json& entry = data_[variable];
    return entry.contains("unit") && entry["unit"].is_string() ? entry["unit"].get<std::string>() : std::string();
  }
  const Json& entry(const std::string& variable) const { return data_[variable]; }
  const Json& values(const std::string& variable) const {
    if (!has(variable)) fail("a variable is missing", variable, {}, "theta_i, phi_i, theta_r, phi_r, BRDF");
    const Json& entry = data_[variable];
    if (!entry.contains("values") || !entry["values"].is_array())
      fail("no array of values", variable, {}, "\"values\": [...]");
    return entry["values"];
  }
  /// `count` numbers (one stands for all; null is NaN).
  std::vector<double> numbers(const std::string& variable, const Json& list, std::size_t count) const {
    if (list.size() != count && list.size() != 1)
      fail("arrays of different lengths", variable, std::to_string(list.size()) + " values", std::to_string(count));
    std::vector<double> result;
    for (const Json& item : list) {
      if (!item.is_number() && !item.is_null()) fail("no number", variable, shortened(item), {});
      result.push_back(item.is_null() ? kNothing : item.get<double>());
    }
    result.resize(count, result.empty() ? kNothing : result.front());
    return result;
  }
  std::vector<double> numbers(const std::string& variable, std::size_t count) const {
    return numbers(variable, values(variable), count);
  }

 private:
  const Json& data_;
  std::string where_;
};

/// The factor that a unit has; `allowed` lists unit and factor.
double factor(const Data& data, const std::string& variable, const std::string& unit,
              const std::vector<std::pair<std::string, double>>& allowed) {
  std::vector<std::string> names;
  for (const auto& [name, value] : allowed) {
    if (name == unit) return value;
    names.push_back(name);
  }
  data.fail("unknown unit", variable, "\"" + unit.substr(0, 20) + "\"", joined(names));
}

/// Uncertainty of each point in 1/sr; empty when the file gives none.
std::vector<double> uncertainties(const Data& data, const std::vector<double>& brdf) {
  std::vector<double> result;
  std::string unit;
  if (data.has("uBRDF")) {
    result = data.numbers("uBRDF", brdf.size());
    unit = data.unit("uBRDF");
  } else if (const Json& entry = data.entry("BRDF"); entry.contains("uncertainty")) {
    const Json& stated = entry["uncertainty"];
    const Json* list = &stated;
    if (stated.is_object()) {
      if (stated.contains("unit") && stated["unit"].is_string()) unit = stated["unit"].get<std::string>();
      list = stated.contains("values") ? &stated["values"] : stated.contains("value") ? &stated["value"] : nullptr;
    }
    if (!list) data.fail("no value", "BRDF.uncertainty", {}, "\"value\" or \"values\"");
    result = data.numbers("BRDF.uncertainty", list->is_array() ? *list : Json::array({*list}), brdf.size());
  } else {
    return {};
  }
  const double absolute = factor(data, "uBRDF", unit, {{"1/sr", 1}, {"sr^-1", 1}, {"", 1}, {"%", 0}});
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = absolute > 0 ? result[i] : result[i] / 100 * std::abs(brdf[i]);
  return result;
}

/// Number of the state of polarisation of each point; throws when they do not average to unpolarised light.
std::vector<std::size_t> polarisations(const Data& data, std::size_t count, ReadReport& report) {
  std::vector<std::size_t> number(count, 0);
  if (!data.has("polarization_i")) return number;
  const Json& list = data.values("polarization_i");
  if (list.size() != count && list.size() != 1)
    data.fail("arrays of different lengths", "polarization_i", std::to_string(list.size()) + " values",
              std::to_string(count));
  std::map<std::string, std::size_t> states;
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Json& state = list[i];
    std::array<double, 3> stokes{};  // Q, U, V of intensity 1
    if (state.is_string()) {
      const auto name = state.get<std::string>();
      if (name != "s" && name != "p" && name != "u")
        data.fail("unknown state of polarisation", "polarization_i", name.substr(0, 20), "s, p, u or a Stokes vector");
      stokes[0] = name == "s" ? 1 : name == "p" ? -1 : 0;
    } else if (state.is_array() && state.size() == 4) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!state[k + 1].is_number()) data.fail("no number", "polarization_i", shortened(state), {});
        stokes[k] = state[k + 1].get<double>();
      }
    } else {
      data.fail("unknown state of polarisation", "polarization_i", shortened(state), "s, p, u or a Stokes vector");
    }
    const auto [place, added] = states.emplace(state.dump(), states.size());
    if (added)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += stokes[k];
    number[i] = place->second;
  }
  if (list.size() == 1) return number;
  if (states.size() == 1) {
    report.metadata["polarisation"] = "light " + states.begin()->first.substr(0, 40);
  } else {
    for (const double component : sum)
      if (!(std::abs(component) < 1e-6))
        data.fail("states of polarisation that do not average to unpolarised light", "polarization_i",
                  std::to_string(states.size()) + " states", "one, or a pair such as s and p");
    report.assumptions.push_back("unpolarised: the mean over the " + std::to_string(states.size()) +
                                 " states of polarisation of the light");
  }
  return number;
}

/// The value of one sample and wavelength while its points are added up.
struct Cell {
  double sum = 0, uncertainty = 0;
  std::size_t points = 0;
};

struct Points {
  std::array<std::vector<double>, 4> angles;  ///< radians
  std::vector<double> wavelengths;            ///< nm; empty: none given
  std::vector<double> brdf, uncertainty;
  std::vector<std::size_t> polarisation;
};

Points readPoints(const Data& data, const ReadOptions& options, ReadReport& report) {
  Points points;
  const std::size_t count = data.values("BRDF").size();
  if (count == 0) data.fail("the file holds no sample", "BRDF", {}, {});
  points.brdf = data.numbers("BRDF", count);
  factor(data, "BRDF", data.unit("BRDF"), {{"sr^-1", 1}, {"1/sr", 1}});
  for (std::size_t k = 0; k < 4; ++k) {
    if (!data.has(kAngles[k]) && k % 2 == 1) {  // no azimuth: 0
      points.angles[k].assign(count, 0);
      continue;
    }
    points.angles[k] = data.numbers(kAngles[k], count);
    double toRadians =
        factor(data, kAngles[k], data.unit(kAngles[k]), {{"deg", radians(1)}, {"\u00b0", radians(1)}, {"rad", 1}});
    if (options.angles) toRadians = *options.angles == AngleUnit::Degrees ? radians(1) : 1;
    for (double& angle : points.angles[k]) angle *= toRadians;
  }
  choose(options, data.unit(kAngles[0]) == "rad" ? AngleUnit::Radians : AngleUnit::Degrees, "the unit in the file",
         report);
  for (const char* variable : {"wavelength_i", "wavelength_r"}) {
    if (!data.has(variable) || !points.wavelengths.empty()) continue;
    points.wavelengths = data.numbers(variable, count);
    const double toNanometres =
        factor(data, variable, data.unit(variable), {{"nm", 1}, {"\u03bcm", 1000}, {"\u00b5m", 1000}, {"um", 1000}});
    for (double& wavelength : points.wavelengths) wavelength *= toNanometres;
  }
  points.uncertainty = uncertainties(data, points.brdf);
  points.polarisation = polarisations(data, count, report);
  return points;
}

ScatteredSamples gather(const Points& points, const std::string& where, ReadReport& report) {
  const std::size_t count = points.brdf.size();
  std::vector<double> distinct = points.wavelengths;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (!distinct.empty()) distinct = orderWavelengths(distinct, where + ", data.wavelength_i").wavelengths;
  const std::size_t channels = std::max<std::size_t>(distinct.size(), 1);

  // A point that repeats directions, wavelength and polarisation belongs to the next sample of those directions.
  using Key = std::array<double, 5>;  // the angles, and the number of the repetition
  std::map<std::array<double, 6>, std::size_t> repetitions;
  std::map<Key, std::size_t> places;
  std::vector<Key> keys;
  std::vector<std::pair<std::size_t, std::size_t>> cellOf(count);  // sample and channel of each point
  for (std::size_t i = 0; i < count; ++i) {
    Key key{};
    for (std::size_t k = 0; k < 4; ++k) {
      key[k] = points.angles[k][i];
      if (!std::isfinite(key[k])) throw Error(Error::Kind::Format, {"an angle is not finite", where, {}, "a number"});
    }
    const double wavelength = points.wavelengths.empty() ? 0 : points.wavelengths[i];
    key[4] = static_cast<double>(
        repetitions[{key[0], key[1], key[2], key[3], wavelength, static_cast<double>(points.polarisation[i])}]++);
    const auto [place, added] = places.emplace(key, keys.size());
    if (added) keys.push_back(key);
    const auto channel = std::lower_bound(distinct.begin(), distinct.end(), wavelength) - distinct.begin();
    cellOf[i] = {place->second, distinct.empty() ? 0 : static_cast<std::size_t>(channel)};
  }
  constexpr std::size_t spare = 16, small = 4096;  // a sparse table may have this many cells a point
  if (keys.size() > (spare * count + small) / channels)
    throw Error(Error::Kind::Format, {"the directions do not share their wavelengths", where,
                                      std::to_string(keys.size()) + " directions, " + std::to_string(channels) +
                                          " wavelengths, " + std::to_string(count) + " points",
                                      "every direction at every wavelength"});
  std::vector<Cell> cells(keys.size() * channels);
  for (std::size_t i = 0; i < count; ++i) {
    Cell& cell = cells[cellOf[i].first * channels + cellOf[i].second];
    cell.sum += points.brdf[i];
    if (!points.uncertainty.empty()) cell.uncertainty += points.uncertainty[i] * points.uncertainty[i];
    ++cell.points;
  }
  SampleRows rows(channels);
  std::vector<double> values(channels), uncertainty(points.uncertainty.empty() ? 0 : channels);
  std::size_t incomplete = 0;
  for (std::size_t s = 0; s < keys.size(); ++s) {
    bool complete = true;
    for (std::size_t c = 0; c < channels; ++c) {
      const Cell& cell = cells[s * channels + c];
      const auto n = static_cast<double>(cell.points);
      complete = complete && cell.points > 0;
      values[c] = cell.points > 0 ? cell.sum / n : kNothing;
      if (!uncertainty.empty()) uncertainty[c] = cell.points > 0 ? std::sqrt(cell.uncertainty) / n : kNothing;
    }
    incomplete += !complete;
    rows.add({fromSpherical(keys[s][0], keys[s][1]), fromSpherical(keys[s][2], keys[s][3])}, values, uncertainty);
  }
  if (incomplete > 0)
    report.warnings.push_back(std::to_string(incomplete) + " directions lack a wavelength and are invalid");
  return rows.samples(distinct.empty() ? Channels::monochrome() : Channels::spectral(distinct), true);
}

int recognise(std::string_view head, std::uint64_t) {
  head = withoutByteOrderMark(head);
  head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  if (!head.starts_with('{')) return 0;
  if (head.find("\"BRDF\"") != std::string_view::npos && head.find("\"theta_i\"") != std::string_view::npos) return 90;
  return head.find("\"metadata\"") != std::string_view::npos || head.find("\"data\"") != std::string_view::npos ? 50
                                                                                                                : 10;
}

void readMetadata(const Json& root, bool& isotropic, bool& stated, ReadReport& report) {
  if (!root.contains("metadata") || !root["metadata"].is_object()) return;
  const Json& metadata = root["metadata"];
  for (const char* key : {"type", "method", "timestamp", "description"})
    if (metadata.contains(key) && metadata[key].is_string())
      report.metadata[key] = metadata[key].get<std::string>().substr(0, 300);
  if (report.metadata.count("type") > 0 && report.metadata["type"] != "BRDF")
    report.warnings.push_back("metadata.type is \"" + report.metadata["type"] + "\": read as a BRDF");
  if (!metadata.contains("sample") || !metadata["sample"].is_object()) return;
  const Json& sample = metadata["sample"];
  if (sample.contains("name") && sample["name"].is_string())
    report.metadata["sample"] = sample["name"].get<std::string>().substr(0, 300);
  if (sample.contains("properties_symmetry") && sample["properties_symmetry"].is_string()) {
    stated = true;
    isotropic = sample["properties_symmetry"].get<std::string>() == "isotropic";
  }
}

ReadResult read(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  const std::string where = path.string();
  const Json root = parseJson(withoutByteOrderMark(bytes), where);
  if (!root.is_object() || !root.contains("data") || !root["data"].is_object())
    throw Error(Error::Kind::Format, {"no object \"data\"", where, {}, "{\"metadata\": {...}, \"data\": {...}}"});
  ReadReport report;
  const Data data(root["data"], where);
  bool isotropic = true, stated = false;
  readMetadata(root, isotropic, stated, report);
  const Points points = readPoints(data, options, report);
  ScatteredSamples samples = gather(points, where, report);
  samples.isotropic = stated ? isotropic : oneIncidentAzimuth(samples);
  const std::string_view evidence = stated ? "metadata.sample.properties_symmetry" : azimuthEvidence(samples.isotropic);
  if (!samples.uncertainty.empty())
    report.assumptions.push_back("uncertainties are the file's, with the coverage that its metadata state");
  return finishScattered(std::move(samples), path, std::move(report), options, Quantity::Brdf, "the unit in the file",
                         evidence);
}

WriteReport write(const Brdf& brdf, const std::filesystem::path& path) {
  WriteReport report;
  const ScatteredSamples samples = collectSamples(brdf, report);
  const std::size_t count = samples.pairs.size();
  SpectralColumns columns{{}, {0}};
  if (samples.channels.kind != Channels::Kind::Monochrome) columns = spectralColumns(samples.channels, report);
  const bool spectral = !columns.wavelengths.empty(), uncertain = !samples.uncertainty.empty();
  std::array<std::vector<double>, 4> angles;
  std::vector<double> wavelengths, values, uncertainty;
  std::size_t negative = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const SampleAngles sample = sampleAngles(samples, i);
    const auto full = [](double phi) { return phi < 0 ? phi + 2 * kPi : phi; };
    for (std::size_t c = 0; c < columns.channels.size(); ++c) {
      const double row[4] = {sample.thetaI, full(sample.phiI), sample.thetaO, full(sample.phiO)};
      for (std::size_t k = 0; k < 4; ++k) angles[k].push_back(row[k]);
      if (spectral) wavelengths.push_back(columns.wavelengths[c]);
      values.push_back(samples.values[columns.channels[c] * count + i]);
      negative += values.back() < 0;
      if (uncertain) uncertainty.push_back(samples.uncertainty[columns.channels[c] * count + i]);
    }
  }
  if (negative > 0)
    report.losses.push_back(std::to_string(negative) + " negative values, which the schema does not allow");
  Json root;
  root["metadata"] = {{"type", "BRDF"},
                      {"description", brdf.description()},
                      {"sample", {{"properties_symmetry", samples.isotropic ? "isotropic" : "anisotropic"}}}};
  for (std::size_t k = 0; k < 4; ++k) root["data"][kAngles[k]] = {{"unit", "rad"}, {"values", angles[k]}};
  if (spectral) root["data"]["wavelength_i"] = {{"unit", "nm"}, {"values", wavelengths}};
  root["data"]["BRDF"] = {{"unit", "sr^-1"}, {"values", values}};
  if (uncertain) root["data"]["uBRDF"] = {{"unit", "sr^-1"}, {"values", uncertainty}};
  writeBytes(path, root.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  return report;
}

}  // namespace

Format birdFormat() {
  Format format{"bird", "BiRD project, JSON with uncertainties", ".json", recognise, read, write, scatteredOptions()};
  format.takes.push_back("angles");
  return format;
}

}  // namespace brdf
