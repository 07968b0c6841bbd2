#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/color/CieTables.h>
#include <brdf/color/Illuminant.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

constexpr std::array<std::string_view, 9> kNames{"E", "A", "D50", "D55", "D65", "D75", "F2", "F7", "F11"};
constexpr double kFirst = 380, kLast = 780, kStep = 5;
constexpr std::uint64_t kLargestFile = std::uint64_t{16} << 20;

template <class Power>
Illuminant tabulated(std::string name, Power power) {
  Illuminant result{std::move(name), {}, {}};
  for (double w = kFirst; w <= kLast; w += kStep) {
    result.wavelengths.push_back(w);
    result.power.push_back(power(w));
  }
  return result;
}

double planckA(double nanometres) {
  constexpr double c2 = 1.435e7, temperature = 2848;  // nm K, K
  const auto inverse = [](double w) { return std::pow(w, 5) * std::expm1(c2 / (temperature * w)); };
  return 100 * inverse(560) / inverse(nanometres);
}

Illuminant fluorescent(std::string_view name, double FluorescentSample::*lamp) {
  Illuminant result{std::string(name), {}, {}, false};
  for (const FluorescentSample& line : fluorescentTable()) {
    result.wavelengths.push_back(line.wavelength);
    result.power.push_back(line.*lamp);
  }
  return result;
}

double rounded(double value) { return std::round(1000 * value) / 1000; }

/// Cuts `full` (ascending, any range) to the visible and fills gaps of more than kStep.
Illuminant visiblePart(const Illuminant& full) {
  Illuminant result{full.name, {}, {}, full.smooth};
  const auto add = [&](double w) {
    result.wavelengths.push_back(w);
    result.power.push_back(full.at(w));
  };
  const double first = std::max(kFirst, full.wavelengths.front()), last = std::min(kLast, full.wavelengths.back());
  if (!(first < last)) return result;
  add(first);
  const auto reach = [&](double next) {
    const double from = result.wavelengths.back();
    const double parts = std::ceil((next - from) / kStep);
    for (double part = 1; part < parts; ++part) add(from + (next - from) * part / parts);
    add(next);
  };
  for (const double w : full.wavelengths)
    if (w > first && w < last) reach(w);
  reach(last);
  return result;
}

}  // namespace

double Illuminant::at(double wavelength) const {
  if (wavelengths.empty() || !(wavelength >= wavelengths.front() && wavelength <= wavelengths.back())) return 0;
  const auto above = std::upper_bound(wavelengths.begin(), wavelengths.end(), wavelength);
  if (above == wavelengths.end()) return power.back();
  const auto i = static_cast<std::size_t>(above - wavelengths.begin());  // at least 1
  // So written, t in an evenly spaced table is the fraction of cieAt()'s position to the last bit.
  const double step = wavelengths[i] - wavelengths[i - 1];
  const double t = (wavelength - wavelengths.front()) / step - (wavelengths[i - 1] - wavelengths.front()) / step;
  return std::lerp(power[i - 1], power[i], t);
}

std::span<const std::string_view> illuminantNames() { return kNames; }

Illuminant daylight(double temperature) {
  if (!(temperature >= 4000 && temperature <= 25000))
    throw Error(Error::Kind::Value, {"no CIE daylight of this temperature", "daylight",
                                     formatNumber(temperature) + " K", "4000 to 25000 K"});
  const double t = 1000 / temperature;
  const double x = temperature <= 7000 ? 0.244063 + t * (0.09911 + t * (2.9678 - t * 4.6070))
                                       : 0.237040 + t * (0.24748 + t * (1.9018 - t * 2.0064));
  const double y = -3.000 * x * x + 2.870 * x - 0.275;
  const double m = 0.0241 + 0.2562 * x - 0.7341 * y;
  const double m1 = rounded((-1.3515 - 1.7703 * x + 5.9114 * y) / m);
  const double m2 = rounded((0.0300 - 31.4424 * x + 30.0717 * y) / m);
  Illuminant components{"daylight of " + formatNumber(temperature, 5) + " K", {}, {}};
  for (const DaylightSample& line : daylightTable()) {
    components.wavelengths.push_back(line.wavelength);
    components.power.push_back(line.s0 + m1 * line.s1 + m2 * line.s2);
  }
  return visiblePart(components);
}

Illuminant illuminantNamed(std::string_view name) {
  const auto renamed = [&](double nominal) {
    Illuminant result = daylight(nominal * 1.4388 / 1.4380);
    result.name = name;
    return result;
  };
  const std::string own(name);
  if (name == "E") return tabulated(own, [](double) { return 1.0; });
  if (name == "A") return tabulated(own, planckA);
  if (name == "D50") return renamed(5000);
  if (name == "D55") return renamed(5500);
  if (name == "D65") return tabulated(own, [](double w) { return cieAt(w).d65; });
  if (name == "D75") return renamed(7500);
  if (name == "F2") return fluorescent(name, &FluorescentSample::f2);
  if (name == "F7") return fluorescent(name, &FluorescentSample::f7);
  if (name == "F11") return fluorescent(name, &FluorescentSample::f11);
  throw Error(Error::Kind::Value, {"unknown illuminant", "illuminant", "'" + own + "'", joined(kNames)});
}

Illuminant parseIlluminant(std::string_view text, const std::string& where) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  Illuminant full{where, {}, {}, false};
  std::size_t number = 0;
  for (std::string_view line : split(text, '\n')) {
    ++number;
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    const auto fail = [&](const char* what, const char* allowed) {
      throw Error(Error::Kind::Format, {what, where + ", line " + std::to_string(number),
                                        "'" + std::string(line.substr(0, 40)) + "'", allowed});
    };
    const auto end = line.find_first_of(" \t,;");
    const auto next = end == std::string_view::npos ? end : line.find_first_not_of(" \t", end);
    std::string_view rest = next == std::string_view::npos ? std::string_view{} : line.substr(next);
    if (rest.starts_with(',') || rest.starts_with(';')) rest.remove_prefix(1);
    const auto wavelength = parseNumber(line.substr(0, end)), power = parseNumber(trimmed(rest));
    if (!wavelength || !power) fail("malformed line", "a wavelength in nm and a power");
    if (!(*wavelength > 0) || !std::isfinite(*wavelength) ||
        (!full.wavelengths.empty() && *wavelength <= full.wavelengths.back()))
      fail("wavelength out of order", "positive wavelengths in nm, ascending");
    if (!(*power >= 0) || !std::isfinite(*power)) fail("power out of range", "a number of at least 0");
    full.wavelengths.push_back(*wavelength);
    full.power.push_back(*power);
  }
  if (full.wavelengths.size() < 2)
    throw Error(Error::Kind::Format, {"too few lines for a spectrum", where,
                                      std::to_string(full.wavelengths.size()) + " wavelengths", "at least 2"});
  Illuminant result = visiblePart(full);
  if (std::ranges::none_of(result.power, [](double power) { return power > 0; }))
    throw Error(Error::Kind::Value,
                {"a light without visible power", where,
                 formatNumber(full.wavelengths.front()) + " to " + formatNumber(full.wavelengths.back()) + " nm",
                 "some power between 380 and 780 nm"});
  return result;
}

Illuminant readIlluminant(const std::filesystem::path& path) {
  return parseIlluminant(readFile(path, kLargestFile), path.string());
}

}  // namespace brdf
