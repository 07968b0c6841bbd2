#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/color/CieTables.h>
#include <brdf/color/ColourSettings.h>

#include <algorithm>
#include <cmath>

namespace brdf {

ColourSettings colourSettings(const ColourNames& names) {
  ColourSettings settings;
  const auto known = illuminantNames();
  if (std::ranges::find(known, names.illuminant) != known.end())
    settings.illuminant = illuminantNamed(names.illuminant);
  else if (names.illuminant.find_first_of("./\\") != std::string::npos)
    settings.illuminant = readIlluminant(names.illuminant);
  else if (!names.illuminant.empty())
    throw Error(Error::Kind::Usage, {"unknown illuminant", "illuminant", "'" + names.illuminant + "'",
                                     joined(known) + ", or a file of wavelengths and powers such as lamp.csv"});
  if (names.observer == "10")
    settings.observer = Observer::Cie1964;
  else if (names.observer != "2")
    throw Error(Error::Kind::Usage, {"unknown observer", "observer", "'" + names.observer + "'", "2, 10 (degrees)"});
  if (names.adaptation == "none")
    settings.adaptation = Adaptation::None;
  else if (names.adaptation != "bradford")
    throw Error(Error::Kind::Usage,
                {"unknown adaptation", "adaptation", "'" + names.adaptation + "'", "bradford, none"});
  return settings;
}

std::string describe(const ColourSettings& settings) {
  std::string text = settings.illuminant ? settings.illuminant->name : "D65";
  if (text == "D65" && settings.observer == Observer::Cie1931) return text;
  if (settings.observer == Observer::Cie1964) text += ", 10-degree observer";
  return text + (settings.adaptation == Adaptation::None ? ", not adapted" : ", adapted to D65 (Bradford)");
}

std::array<double, 3> colourMatching(Observer observer, double wavelength) {
  if (observer == Observer::Cie1931) {
    const CieSample line = cieAt(wavelength);
    return {line.xBar, line.yBar, line.zBar};
  }
  const auto lines = cie1964Table();
  if (!(wavelength >= lines.front().wavelength && wavelength <= lines.back().wavelength)) return {};
  const double position = (wavelength - lines.front().wavelength) / (lines[1].wavelength - lines[0].wavelength);
  const auto index = std::min(static_cast<std::size_t>(position), lines.size() - 2);
  const double t = position - static_cast<double>(index);
  const ObserverSample &a = lines[index], &b = lines[index + 1];
  return {std::lerp(a.xBar, b.xBar, t), std::lerp(a.yBar, b.yBar, t), std::lerp(a.zBar, b.zBar, t)};
}

}  // namespace brdf
