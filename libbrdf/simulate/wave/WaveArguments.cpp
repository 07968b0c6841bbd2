#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/wave/WaveArguments.h>

#include <algorithm>
#include <cmath>

namespace brdf::wave {
namespace {

const Parameter kEta =
    numberRecord("eta", "1", "Real part of the refractive index, or one a wavelength.", 1.5, 1e-6, 1e4, 0.1, 5, true);
const Parameter kK = numberRecord("k", "1",
                                  "Imaginary part of the refractive index (extinction coefficient), or one a "
                                  "wavelength.",
                                  0, 0, 1e9, 0, 10);
const Parameter kThickness = numberRecord("thickness", "um", "Of the film.", 0.1, 0, 1e6, 0.01, 2, true);
const Parameter kSlope = numberRecord("s", "1",
                                      "Slope at which the density of a Gaussian falls to 1/e, along x "
                                      "(Beckmann's alpha, the rms of the slope's length).",
                                      0.3, 1e-5, 100, 0.01, 1, true);
Parameter following(Parameter p, const std::string& name, const std::string& leader) {
  p.name = p.label = p.symbol = name;
  p.follows = leader;
  p.description = "The same along y; as along x where it is not given.";
  return p;
}
const Parameter kSlopeY = following(kSlope, "sy", "s");
const Parameter kRadius = numberRecord("radius", "um", "Of the sphere.", 0.05, 1e-9, 1e5, 0.01, 10, true);
const Parameter kSmith = numberRecord("w", "1", "One-dimensional rms slope: s / sqrt(2) of Gaussian slopes s.", 0.35,
                                      1e-5, 100, 0.01, 1, true);
const Parameter kOmega = numberRecord("omega", "rad", "Tilt of the facet that matters.", 0.7, 1e-6, 1e6, 0.1, 2, true);
const Parameter kTau =
    numberRecord("tau", "rad", "Fall-off with the angle between light and viewer.", 0.25, 1e-6, 1e6, 0.05, 2, true);
const Parameter kAsymmetry =
    numberRecord("g", "1", "Mean cosine of the scattering angle.", 0.3, -0.9999, 0.9999, -0.9, 0.9);
const Parameter kAsymmetryReynolds = numberRecord("g", "1", "Asymmetry.", 0.3, -0.99, 0.99, -0.9, 0.9);
const Parameter kAlpha = numberRecord("alpha", "1", "Peaking; 1/2 is Henyey and Greenstein's.", 0.5, 1e-3, 50, 0.1, 3);
const Parameter kHalfX = numberRecord("rx", "um", "Half axis along x.", 1, 1e-6, 1e6, 0.1, 100, true);
const Parameter kHalfY = following(kHalfX, "ry", "rx");
const Parameter kHalfZ = numberRecord("rz", "um", "Half axis along z.", 1, 1e-6, 1e6, 0.1, 100, true);
const Parameter kBumps = numberRecord("density", "1/um^2", "Bumps on a unit of surface.", 0.1, 0, 1e9, 1e-4, 1, true);
const Parameter kShare = numberRecord("share", "1", "Of the second distribution.", 0.5, 0, 1, 0, 1);
const Parameter kCauchyA = numberRecord("a", "1", "n = a + b/wavelength^2 + c/wavelength^4.", 1.5, 0, 100, 1, 3);
const Parameter kCauchyB = numberRecord("b", "um^2", "See a.", 0.004, -100, 100, 0, 0.02);
const Parameter kCauchyC = numberRecord("c", "um^4", "See a.", 0, -100, 100, 0, 0.001);

[[noreturn]] void unknown(const Call& call, const std::string& family, const std::vector<std::string>& names) {
  const std::string nearest = closestName(call.name, names);
  throw Error(Error::Kind::Value, {"unknown " + family, call.where(call.column), "'" + call.name + "'",
                                   joined(names) + (nearest.empty() ? "" : " (did you mean " + nearest + "?)")});
}

std::vector<std::string> namesOf(const std::string& family) {
  std::vector<std::string> names;
  for (const WaveKind& kind : waveKinds())
    if (kind.family == family) names.push_back(kind.name);
  return names;
}

/// Rows of wavelength (um), n, k, ascending; linear between them.
std::vector<Complex> tabulated(CallArguments& arguments, const std::vector<double>& wavelengths) {
  const std::string path = arguments.text("file").value_or("");
  if (path.empty()) arguments.fail("file", "table needs its file", {}, "file=NAME of rows: wavelength in um, n, k");
  const std::string text = readFile(path, std::uint64_t{16} << 20);
  std::vector<std::array<double, 3>> rows;
  std::size_t line = 0;
  for (std::string_view row : split(text, '\n')) {
    ++line;
    row = trimmed(row.substr(0, row.find('#')));
    if (row.empty()) continue;
    std::string blanks(row);
    std::ranges::replace_if(
        blanks, [](char c) { return c == ',' || c == ';' || c == '\t'; }, ' ');
    std::array<double, 3> numbers{};
    std::size_t count = 0;
    bool good = true;
    for (const std::string_view word : split(blanks, ' ')) {
      if (word.empty()) continue;
      const auto number = parseNumber(word);
      good = good && number && std::isfinite(*number) && count < 3;
      if (good) numbers[count++] = *number;
    }
    if (!good && rows.empty()) continue;  // a line of titles
    const bool ascending = rows.empty() || numbers[0] > rows.back()[0];
    if (!good || count < 2 || !(numbers[0] > 0) || !(numbers[1] >= 0) || !(numbers[2] >= 0) || !ascending)
      throw Error(Error::Kind::Format,
                  {"no row of an index", path + ", line " + std::to_string(line),
                   "'" + std::string(row.substr(0, 40)) + "'", "wavelength in um (ascending), n, k >= 0"});
    rows.push_back(numbers);
  }
  if (rows.empty()) throw Error(Error::Kind::Format, {"no rows", path, {}, "wavelength in um, n, k"});
  std::vector<Complex> indices;
  for (const double wavelength : wavelengths) {
    if (wavelength < rows.front()[0] || wavelength > rows.back()[0])
      arguments.fail("file", "the table of indices does not reach the wavelength", formatNumber(wavelength) + " um",
                     "[" + formatNumber(rows.front()[0]) + ", " + formatNumber(rows.back()[0]) + "] um");
    const auto above = std::ranges::lower_bound(rows, wavelength, {}, [](const auto& row) { return row[0]; });
    if (above == rows.begin()) {
      indices.emplace_back((*above)[1], (*above)[2]);
      continue;
    }
    const auto below = above - 1;
    const double t = (wavelength - (*below)[0]) / ((*above)[0] - (*below)[0]);
    indices.emplace_back((*below)[1] + t * ((*above)[1] - (*below)[1]), (*below)[2] + t * ((*above)[2] - (*below)[2]));
  }
  return indices;
}

std::vector<Complex> indicesOf(const Call& call, const std::vector<double>& wavelengths) {
  CallArguments arguments(call);
  std::vector<Complex> indices;
  if (call.name == "table") {
    indices = tabulated(arguments, wavelengths);
  } else if (call.name == "cauchy") {
    const double a = arguments.number(kCauchyA), b = arguments.number(kCauchyB), c = arguments.number(kCauchyC);
    for (const double wavelength : wavelengths) {
      const double w2 = wavelength * wavelength, n = a + b / w2 + c / (w2 * w2);
      if (!(n > 0)) arguments.fail("a", "no index at " + formatNumber(wavelength) + " um", formatNumber(n), "n > 0");
      indices.emplace_back(n, 0.0);
    }
  } else {
    unknown(call, "index", namesOf("index"));
  }
  arguments.finish();
  return indices;
}

SlopePointer slopesOf(const Call& call) {
  CallArguments arguments(call);
  SlopePointer slopes;
  if (call.name == "gaussian" || call.name == "exponential") {
    const double s = arguments.number(kSlope), given = arguments.number(kSlopeY);
    const double sy = arguments.given("sy") ? given : s;
    slopes = call.name == "gaussian" ? gaussianSlopes(s, sy) : exponentialSlopes(s, sy);
  } else if (call.name == "ellipsoid") {
    const double rx = arguments.number(kHalfX), ry = arguments.number(kHalfY), rz = arguments.number(kHalfZ);
    slopes = ellipsoidSlopes(rx, arguments.given("ry") ? ry : rx, rz, arguments.number(kBumps));
  } else if (call.name == "mixed") {
    const auto a = arguments.nested("first"), b = arguments.nested("second");
    if (!a || !b) arguments.fail(a ? "second" : "first", "mixed needs two distributions", {}, "first=..., second=...");
    slopes = mixedSlopes(slopesOf(*a), slopesOf(*b), arguments.number(kShare));
  } else {
    unknown(call, "slopes", namesOf("slopes"));
  }
  arguments.finish();
  return slopes;
}

}  // namespace

Parameter numberRecord(std::string name, std::string unit, std::string description, double standard, double minimum,
                       double maximum, double softMinimum, double softMaximum, bool logarithmic) {
  Parameter p;
  p.name = p.label = p.symbol = std::move(name);
  p.unit = std::move(unit);
  p.description = std::move(description);
  p.defaultValue = standard;
  p.minimum = minimum;
  p.maximum = maximum;
  p.softMinimum = softMinimum;
  p.softMaximum = softMaximum;
  p.scale = logarithmic ? Parameter::Scale::Logarithmic : Parameter::Scale::Linear;
  return p;
}

std::vector<Complex> WaveReader::indices(double eta, double k) {
  Parameter etaRecord = kEta, kRecord = kK;
  etaRecord.defaultValue = eta;
  kRecord.defaultValue = k;
  const bool numbers = arguments_.given("eta") || arguments_.given("k");
  const std::vector<double> etas = arguments_.numbers(etaRecord), ks = arguments_.numbers(kRecord);
  if (const auto call = arguments_.nested("index")) {
    if (numbers) arguments_.fail("index", "an index given twice", "index and eta or k", "one of them");
    return indicesOf(*call, wavelengths_);
  }
  std::vector<Complex> indices;
  for (const auto& [name, list] : {std::pair{"eta", &etas}, {"k", &ks}})
    if (list->size() != 1 && list->size() != wavelengths_.size())
      arguments_.fail(name, std::string(name) + " has one number, or one a wavelength", std::to_string(list->size()),
                      "1 or " + std::to_string(wavelengths_.size()));
  for (std::size_t c = 0; c < wavelengths_.size(); ++c)
    indices.emplace_back(etas[etas.size() == 1 ? 0 : c], ks[ks.size() == 1 ? 0 : c]);
  return indices;
}

std::vector<double> WaveReader::realIndices(const std::vector<Complex>& indices, const std::string& what) const {
  std::vector<double> real;
  for (const Complex& index : indices) {
    if (index.imag() != 0)
      arguments_.fail("k", what + " of " + arguments_.call().name + " must not absorb",
                      "k = " + formatNumber(index.imag()), "k = 0");
    if (!(index.real() >= 1))
      arguments_.fail("eta", what + " of " + arguments_.call().name + " must not reflect totally",
                      "eta = " + formatNumber(index.real()), "eta >= 1");
    real.push_back(index.real());
  }
  return real;
}

std::vector<FilmStack> WaveReader::stacks(const std::vector<Complex>& substrate) {
  std::vector<std::vector<FilmStack::Film>> films(wavelengths_.size());
  if (const auto call = arguments_.nested("films")) {
    if (call->name != "films") unknown(*call, "films", {"films"});
    CallArguments list(*call);
    for (const Call::Argument& argument : list.unnamed()) {
      const Call layer = parseCall(argument.text, call->what, argument.column);
      if (layer.name != "layer") unknown(layer, "film", {"layer"});
      CallArguments own(layer);
      WaveReader reader(own, wavelengths_);
      const std::vector<Complex> index = reader.indices(1.46, 0);
      const double thickness = own.number(kThickness);
      own.finish();
      for (std::size_t c = 0; c < wavelengths_.size(); ++c) films[c].push_back({thickness, index[c]});
      if (films[0].size() > 1000) arguments_.fail("films", "too many films", "more than 1000", "at most 1000");
    }
    list.finish();
  }
  std::vector<FilmStack> stacks;
  for (std::size_t c = 0; c < wavelengths_.size(); ++c)
    stacks.emplace_back(std::move(films[c]), substrate[c], wavelengths_[c]);
  return stacks;
}

SpectrumPointer WaveReader::spectrum() {
  if (const auto call = arguments_.nested("spectrum")) return makeSpectrum(*call);
  return makeSpectrum("gaussian()");
}

SlopePointer WaveReader::slopes() {
  if (const auto call = arguments_.nested("slopes")) return slopesOf(*call);
  return gaussianSlopes(kSlope.defaultValue, kSlope.defaultValue);
}

ShadowingPointer WaveReader::shadowing() {
  const auto call = arguments_.nested("shadowing");
  if (!call || call->name == "none") return nullptr;
  CallArguments own(*call);
  ShadowingPointer shadowing;
  if (call->name == "smith") {
    shadowing = smithShadowing(own.number(kSmith));
  } else if (call->name == "grooves") {
    shadowing = grooveShadowing();
  } else if (call->name == "maxwell_beard") {
    const double omega = own.number(kOmega);
    shadowing = maxwellBeardShadowing(omega, own.number(kTau));
  } else {
    unknown(*call, "shadowing", namesOf("shadowing"));
  }
  own.finish();
  return shadowing;
}

std::vector<ScattererPointer> WaveReader::scatterers(const std::vector<double>& media) {
  const Call call = arguments_.nested("scatterer").value_or(parseCall("mie", arguments_.call().what));
  if (call.name != "mie" && call.name != "rayleigh") unknown(call, "scatterer", namesOf("scatterer"));
  CallArguments own(call);
  WaveReader reader(own, wavelengths_);
  const double radius = own.number(kRadius);
  const std::vector<Complex> index = reader.indices(1.59, 0);
  own.finish();
  std::vector<ScattererPointer> scatterers;
  for (std::size_t c = 0; c < wavelengths_.size(); ++c)
    scatterers.push_back(call.name == "mie" ? mieScatterer(radius, index[c], media[c], wavelengths_[c])
                                            : rayleighScatterer(radius, index[c], media[c], wavelengths_[c]));
  return scatterers;
}

PhaseFunctionPointer WaveReader::phase() {
  const Call call = arguments_.nested("phase").value_or(parseCall("henyey_greenstein", arguments_.call().what));
  CallArguments own(call);
  PhaseFunctionPointer phase;
  if (call.name == "henyey_greenstein") {
    phase = henyeyGreenstein(own.number(kAsymmetry));
  } else if (call.name == "isotropic") {
    phase = isotropicPhase();
  } else if (call.name == "rayleigh") {
    phase = rayleighPhase();
  } else if (call.name == "reynolds_mccormick") {
    const double g = own.number(kAsymmetryReynolds);
    phase = reynoldsMcCormick(g, own.number(kAlpha));
  } else {
    unknown(call, "phase", namesOf("phase"));
  }
  own.finish();
  return phase;
}

std::vector<WaveKind> partKinds() {
  const Reference barrick{"D. E. Barrick",
                          1968,
                          "Rough surface scattering based on the specular point theory",
                          "IEEE Trans. Antennas Propag. 16, 449-454",
                          "10.1109/TAP.1968.1139220",
                          "(9)"};
  const Reference mie{"C. F. Bohren and D. R. Huffman",
                      1983,
                      "Absorption and Scattering of Light by Small Particles",
                      "Wiley",
                      "10.1002/9783527618156",
                      "(4.47), (4.74), (4.88)"};
  const WaveArgument index{"index", "index", "The refractive index by wavelength, in place of eta and k.", "", {}};
  std::vector<WaveKind> kinds;
  for (const SpectrumKind& kind : spectrumKinds()) {
    WaveKind one{"spectrum", kind.name, kind.title, "", kind.parameters, {}, kind.references};
    for (const std::string& argument : kind.arguments) {
      const std::size_t colon = argument.find(": ");
      one.arguments.push_back(
          {argument.substr(0, colon), "text", colon == std::string::npos ? "" : argument.substr(colon + 2), "", {}});
    }
    kinds.push_back(std::move(one));
  }
  kinds.push_back(
      {"slopes", "gaussian", "exp(-(mx/s)^2 - (my/sy)^2) / (pi s sy)", "", {kSlope, kSlopeY}, {}, {barrick}});
  kinds.push_back({"slopes",
                   "exponential",
                   "3/(pi s sy) exp(-sqrt(6) m), m^2 = (mx/s)^2 + (my/sy)^2",
                   "",
                   {kSlope, kSlopeY},
                   {},
                   {barrick}});
  kinds.push_back({"slopes",
                   "ellipsoid",
                   "Ellipsoidal bumps on a plane; its integral is the part they cover",
                   "",
                   {kHalfX, kHalfY, kHalfZ, kBumps},
                   {},
                   {}});
  kinds.push_back({"slopes",
                   "mixed",
                   "(1 - share) first + share second",
                   "",
                   {kShare},
                   {{"first", "slopes", "A distribution.", "", {}}, {"second", "slopes", "Another.", "", {}}},
                   {}});
  kinds.push_back({"shadowing", "none", "All facets are seen", "", {}, {}, {}});
  kinds.push_back({"shadowing",
                   "smith",
                   "Smith's, light and viewer independent",
                   "",
                   {kSmith},
                   {},
                   {{"B. G. Smith", 1967, "Geometrical shadowing of a random rough surface",
                     "IEEE Trans. Antennas Propag. 15, 668-671", "10.1109/TAP.1967.1138991", ""}}});
  kinds.push_back(
      {"shadowing",
       "grooves",
       "V-grooves: min(1, 2 hz cos_i/(h.wi), 2 hz cos_s/(h.wi))",
       "",
       {},
       {},
       {{"K. E. Torrance and E. M. Sparrow", 1967, "Theory for off-specular reflection from roughened surfaces",
         "J. Opt. Soc. Am. 57, 1105-1114", "10.1364/JOSA.57.001105", ""}}});
  kinds.push_back({"shadowing",
                   "maxwell_beard",
                   "Empirical: (1 + theta_n/omega exp(-2 beta/tau)) / (1 + theta_n/omega)",
                   "",
                   {kOmega, kTau},
                   {},
                   {{"J. R. Maxwell, J. Beard, S. Weiner, D. Ladd and S. Ladd", 1973,
                     "Bidirectional Reflectance Model Validation and Utilization", "AFAL-TR-73-303", "", ""}}});
  kinds.push_back({"scatterer", "mie", "Homogeneous sphere", "", {kRadius, kEta, kK}, {index}, {mie}});
  kinds.push_back(
      {"scatterer", "rayleigh", "Sphere much smaller than the wavelength", "", {kRadius, kEta, kK}, {index}, {mie}});
  for (WaveKind& kind : kinds)
    if (kind.family == "scatterer") kind.parameters[1].defaultValue = 1.59;
  kinds.push_back({"phase",
                   "henyey_greenstein",
                   "(1 - g^2) / (4 pi (1 + g^2 - 2 g cos)^(3/2))",
                   "",
                   {kAsymmetry},
                   {},
                   {{"L. G. Henyey and J. L. Greenstein", 1941, "Diffuse radiation in the galaxy",
                     "Astrophys. J. 93, 70-83", "10.1086/144246", ""}}});
  kinds.push_back({"phase", "isotropic", "1 / (4 pi)", "", {}, {}, {}});
  kinds.push_back({"phase", "rayleigh", "3 (1 + cos^2) / (16 pi)", "", {}, {}, {}});
  kinds.push_back(
      {"phase",
       "reynolds_mccormick",
       "K (1 + g^2 - 2 g cos)^-(alpha + 1)",
       "",
       {kAsymmetryReynolds, kAlpha},
       {},
       {{"L. O. Reynolds and N. J. McCormick", 1980, "Approximate two-parameter phase function for light scattering",
         "J. Opt. Soc. Am. 70, 1206-1212", "10.1364/JOSA.70.001206", ""}}});
  kinds.push_back({"index",
                   "table",
                   "Rows of wavelength (um), n, k; linear between them",
                   "",
                   {},
                   {{"file", "text", "A text file; '#' begins a comment.", "", {}}},
                   {}});
  kinds.push_back({"index",
                   "cauchy",
                   "n = a + b/wavelength^2 + c/wavelength^4, k = 0",
                   "",
                   {kCauchyA, kCauchyB, kCauchyC},
                   {},
                   {}});
  kinds.push_back({"films",
                   "films",
                   "films(layer(...), ...): from the outermost to the substrate",
                   "",
                   {},
                   {{"layer", "films", "A film each.", "", {}}},
                   {}});
  Parameter filmEta = kEta;
  filmEta.defaultValue = 1.46;
  kinds.push_back({"films", "layer", "A homogeneous film", "", {kThickness, filmEta, kK}, {index}, {}});
  return kinds;
}

}  // namespace brdf::wave
