#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/BuiltInKinds.h>
#include <brdf/simulate/wave/WaveEntries.h>
#include <brdf/simulate/wave/WaveModels.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdf {
namespace wave {
namespace {

const Parameter kWavelength =
    numberRecord("wavelength", "um", "In vacuum; a list makes a spectral BRDF.", 0.532, 1e-4, 1e5, 0.2, 2, true);
const Parameter kReflectance =
    numberRecord("reflectance", "1", "Part of the light that is reflected.", 0.5, 0, 1, 0, 1);
const Parameter kDensity =
    numberRecord("density", "1/um^2", "Particles on a unit of surface.", 0.01, 0, 1e6, 1e-6, 1, true);
const Parameter kDistance =
    numberRecord("distance", "um", "From the centre of the sphere to the surface.", 0.05, 0, 1e6, 0.01, 10, true);
const Parameter kScattering =
    numberRecord("scattering", "1/um", "Scattering coefficient of the medium.", 1, 0, 1e9, 1e-4, 10, true);
const Parameter kAbsorption =
    numberRecord("absorption", "1/um", "Absorption coefficient of the medium, beside its k.", 0, 0, 1e9, 0, 1);
const Parameter kPeriod = numberRecord("period", "um", "Of the grooves.", 10, 1e-3, 1e6, 1, 100, true);
const Parameter kDepth = numberRecord("depth", "um", "From valley to peak.", 0.1, 0, 1e4, 0.01, 2);
const Parameter kDuty = numberRecord("duty", "1", "Part of the period that is ridge (lamellar).", 0.5, 0, 1, 0.1, 0.9);
const Parameter kAngle =
    numberRecord("angle", "deg", "Of the grating vector from the tangent +x.", 0, -360, 360, 0, 180);
const Parameter kWidth = numberRecord("width", "1",
                                      "Standard deviation of the instrument's response, in direction "
                                      "cosines.",
                                      0.02, 1e-5, 0.2, 0.001, 0.05, true);

const WaveArgument kScattererArgument{"scatterer", "scatterer", "The particles.", "mie", {}};

const WaveArgument kIncidenceArgument{
    "incidence",
    "text",
    "exact, or as SCATMECH moves it by up to 5e-5 radians near the plane of incidence (for comparisons).",
    "exact",
    {"exact", "scatmech"}};

/// The argument `incidence`.
class Placed {
 public:
  explicit Placed(WaveReader& reader)
      : moved_(reader.arguments().choice("incidence", {"exact", "scatmech"}) == "scatmech") {}
  ScatterModelPointer operator()(ScatterModelPointer model) const {
    return moved_ ? movedIncidence(std::move(model)) : model;
  }

 private:
  bool moved_;
};

Entry lambertianEntry() {
  return {{"model",
           "Lambertian",
           "Diffuse reflection, depolarised",
           "reflectance/pi whatever comes in, unpolarised.",
           {kReflectance},
           {},
           {}},
          [](WaveReader& reader) {
            const std::vector<double> values = reader.arguments().numbers(kReflectance);
            if (values.size() != 1 && values.size() != reader.wavelengths().size())
              reader.arguments().fail("reflectance", "reflectance has one number, or one a wavelength",
                                      std::to_string(values.size()),
                                      "1 or " + std::to_string(reader.wavelengths().size()));
            Models models;
            for (std::size_t c = 0; c < reader.wavelengths().size(); ++c)
              models.push_back(lambertian(values[values.size() == 1 ? 0 : c]));
            return models;
          }};
}

Entry doubleInteractionEntry() {
  return {{"model",
           "DoubleInteraction",
           "Independent spheres above a surface, double interaction",
           "Sphere and surface see each other's light once. Spheres small, or far from the surface.",
           {kEta, kK, kDensity, kDistance},
           {kIndexArgument, kFilmsArgument, kScattererArgument, kIncidenceArgument},
           {{"T. A. Germer", 1997,
             "Angular dependence and polarization of out-of-plane optical scattering from particulate contamination, "
             "subsurface defects, and surface microroughness",
             "Appl. Opt. 36, 8798-8805", "10.1364/AO.36.008798", ""},
            {"C. F. Bohren and D. R. Huffman", 1983, "Absorption and Scattering of Light by Small Particles", "Wiley",
             "10.1002/9783527618156", "(4.47), (4.74), (4.88)"}}},
          [](WaveReader& reader) {
            const std::vector<FilmStack> stacks = reader.stacks(reader.indices(kEta.defaultValue, 0));
            const std::vector<ScattererPointer> spheres =
                reader.scatterers(std::vector<double>(reader.wavelengths().size(), 1.0));
            const Placed placed(reader);
            const double density = reader.arguments().number(kDensity), distance = reader.arguments().number(kDistance);
            Models models;
            for (std::size_t c = 0; c < stacks.size(); ++c)
              models.push_back(
                  placed(doubleInteraction(spheres[c], stacks[c], density, distance, reader.wavelengths()[c])));
            return models;
          }};
}

Entry subsurfaceEntry() {
  return {{"model",
           "SubsurfaceParticle",
           "Independent spheres under a surface",
           "In a substrate that does not absorb; scattered once. How deep they lie does not matter.",
           {kEta, kK, kDensity},
           {kIndexArgument, kFilmsArgument, kScattererArgument, kIncidenceArgument},
           {{"T. A. Germer", 1997,
             "Angular dependence and polarization of out-of-plane optical scattering from particulate contamination, "
             "subsurface defects, and surface microroughness",
             "Appl. Opt. 36, 8798-8805", "10.1364/AO.36.008798", ""}}},
          [](WaveReader& reader) {
            const std::vector<Complex> substrate = reader.indices(kEta.defaultValue, 0);
            const std::vector<ScattererPointer> spheres =
                reader.scatterers(reader.realIndices(substrate, "the substrate"));
            const std::vector<FilmStack> stacks = reader.stacks(substrate);
            const Placed placed(reader);
            const double density = reader.arguments().number(kDensity);
            Models models;
            for (std::size_t c = 0; c < stacks.size(); ++c)
              models.push_back(placed(subsurfaceParticle(spheres[c], stacks[c], density, reader.wavelengths()[c])));
            return models;
          }};
}

Entry firstDiffuseEntry() {
  return {
      {"model",
       "FirstDiffuse",
       "Light scattered once in a medium under a smooth surface",
       "Semi-infinite, depolarising medium; what is scattered more than once is left to a diffuse term.",
       {kEta, kK, kScattering, kAbsorption},
       {kIndexArgument, kFilmsArgument, {"phase", "phase", "Phase function of the medium.", "henyey_greenstein", {}}},
       {{"S. Chandrasekhar", 1960, "Radiative Transfer", "Dover, section 47", "", ""},
        {"T. A. Germer", 2003, "Polarized light diffusely scattered under smooth and rough interfaces",
         "Proc. SPIE 5158, 193-204", "10.1117/12.505976", ""}}},
      [](WaveReader& reader) {
        const std::vector<Complex> substrate = reader.indices(kEta.defaultValue, 0);
        const std::vector<FilmStack> stacks = reader.stacks(substrate);
        const PhaseFunctionPointer phase = reader.phase();
        const double scattering = reader.arguments().number(kScattering);
        const double absorption = reader.arguments().number(kAbsorption);
        Models models;
        for (std::size_t c = 0; c < stacks.size(); ++c) {
          if (!(substrate[c].real() >= 1))
            reader.arguments().fail("eta", "the medium must not reflect totally", formatNumber(substrate[c].real()),
                                    "eta >= 1");
          // An absorbing host: absorption 4 pi k / wavelength; refraction by the real part (weak absorption).
          const double host = 4 * std::numbers::pi * substrate[c].imag() / reader.wavelengths()[c];
          models.push_back(firstDiffuse(phase, stacks[c], scattering, absorption + host));
        }
        return models;
      }};
}

GratingShape gratingShape(CallArguments& arguments) {
  GratingShape shape;
  shape.profile = arguments.choice("profile", {"sinusoidal", "lamellar"}) == "lamellar"
                      ? GratingShape::Profile::Lamellar
                      : GratingShape::Profile::Sinusoidal;
  shape.period = arguments.number(kPeriod);
  shape.depth = arguments.number(kDepth);
  shape.duty = arguments.number(kDuty);
  shape.angle = arguments.number(kAngle) * std::numbers::pi / 180;
  return shape;
}

Entry gratingEntry() {
  return {{"model",
           "Grating",
           "Sinusoidal or lamellar grating, scalar diffraction",
           "Orders seen by an instrument of Gaussian response. Periods of many wavelengths, depths without shadowing; "
           "the shares of the orders above the horizon are not renormalised.",
           {kEta, kK, kPeriod, kDepth, kDuty, kAngle, kWidth},
           {kIndexArgument,
            kFilmsArgument,
            {"profile", "text", "Of the grooves.", "sinusoidal", {"sinusoidal", "lamellar"}}},
           {{"J. W. Goodman", 1996, "Introduction to Fourier Optics", "McGraw-Hill, 2nd ed., section 4.4.4", "", ""}}},
          [](WaveReader& reader) {
            CallArguments& arguments = reader.arguments();
            const std::vector<FilmStack> stacks = reader.stacks(reader.indices(kEta.defaultValue, 0));
            const GratingShape shape = gratingShape(arguments);
            const double width = arguments.number(kWidth);
            Models models;
            for (std::size_t c = 0; c < stacks.size(); ++c)
              models.push_back(grating(shape, stacks[c], reader.wavelengths()[c], width));
            return models;
          }};
}

Entry filmsEntry() {
  return {
      {"model",
       "ThinFilms",
       "Smooth stack of films, seen by an instrument",
       "Fresnel's reflectance of a stack of homogeneous films, in the mirror direction widened by an instrument of "
       "Gaussian response.",
       {kEta, kK, kWidth},
       {kIndexArgument, kFilmsArgument},
       {{"M. Born and E. Wolf", 1999, "Principles of Optics", "Cambridge, 7th ed., sections 1.5.2 and 1.6.4", "", ""}}},
      [](WaveReader& reader) {
        const std::vector<FilmStack> stacks = reader.stacks(reader.indices(kEta.defaultValue, 0));
        const double width = reader.arguments().number(kWidth);
        Models models;
        for (const FilmStack& stack : stacks) models.push_back(mirror(stack, width));
        return models;
      }};
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> made{lambertianEntry()};
    std::ranges::move(surfaceEntries(), std::back_inserter(made));
    for (Entry (*make)() : {doubleInteractionEntry, subsurfaceEntry, firstDiffuseEntry, gratingEntry, filmsEntry})
      made.push_back(make());
    std::vector<std::string> states;
    for (const PolarizationState& state : polarizationStates()) states.push_back(state.name);
    std::vector<std::string> analysers = states;
    analysers.front() = "all";
    for (Entry& entry : made) {
      entry.kind.parameters.insert(entry.kind.parameters.begin(), kWavelength);
      entry.kind.arguments.push_back({"channels",
                                      "text",
                                      "What several wavelengths mean: a spectrum, or red, green and blue.",
                                      "auto",
                                      {"auto", "rgb"}});
      entry.kind.arguments.push_back({"incident", "text", "State of the light.", "unpolarized", states});
      entry.kind.arguments.push_back(
          {"detected", "text", "All light, or what an analyser of this state passes.", "all", analysers});
    }
    return made;
  }();
  return all;
}

PolarizationState stateOf(const std::string& name) {
  for (const PolarizationState& state : polarizationStates())
    if (state.name == name) return state;
  return {"all", {1, 0, 0, 0}};
}

std::vector<double> wavelengthsOf(CallArguments& arguments, Channels& channels) {
  std::vector<double> wavelengths = arguments.numbers(kWavelength);
  const bool rgb = arguments.choice("channels", {"auto", "rgb"}) == "rgb";
  if (rgb && wavelengths.size() != 3)
    arguments.fail("channels", "RGB needs three wavelengths: red, green, blue", std::to_string(wavelengths.size()),
                   "3");
  if (rgb) {
    channels = Channels::rgb();
  } else if (wavelengths.size() == 1) {
    channels = Channels::monochrome();
  } else {
    if (!std::ranges::is_sorted(wavelengths, std::ranges::less_equal{}))
      arguments.fail("wavelength", "wavelengths must ascend", {}, "ascending, or channels=rgb with red, green, blue");
    std::vector<double> nanometres;
    for (const double wavelength : wavelengths) nanometres.push_back(wavelength * 1000);
    channels = Channels::spectral(std::move(nanometres));
  }
  return wavelengths;
}

const Entry& entryOf(const Call& call) {
  std::vector<std::string> names;
  for (const Entry& entry : entries()) {
    if (entry.kind.name == call.name) return entry;
    names.push_back(entry.kind.name);
  }
  const std::string nearest = closestName(call.name, names);
  throw Error(Error::Kind::Value, {"unknown wave model", call.where(call.column), "'" + call.name + "'",
                                   joined(names) + (nearest.empty() ? "" : " (did you mean " + nearest + "?)")});
}

std::string_view withoutPrefix(std::string_view expression) {
  expression = trimmed(expression);
  constexpr std::string_view prefix = "wave:";
  return expression.starts_with(prefix) ? expression.substr(prefix.size()) : expression;
}

/// The wavelengths and stacks of any expression with a substrate.
std::pair<std::vector<double>, std::vector<FilmStack>> stacksOf(const Call& call, std::size_t channel) {
  CallArguments arguments(call);
  Channels channels;
  std::vector<double> wavelengths = wavelengthsOf(arguments, channels);
  if (channel >= wavelengths.size())
    throw Error(Error::Kind::Value, {"no such channel", call.what, std::to_string(channel),
                                     "0 to " + std::to_string(wavelengths.size() - 1)});
  WaveReader reader(arguments, wavelengths);
  std::vector<FilmStack> stacks = reader.stacks(reader.indices(kEta.defaultValue, 0));
  return {std::move(wavelengths), std::move(stacks)};
}

}  // namespace
}  // namespace wave

const std::vector<WaveKind>& waveKinds() {
  static const std::vector<WaveKind> all = [] {
    std::vector<WaveKind> kinds;
    for (const wave::Entry& entry : wave::entries()) kinds.push_back(entry.kind);
    for (WaveKind& kind : wave::partKinds()) kinds.push_back(std::move(kind));
    return kinds;
  }();
  return all;
}

const WaveKind& findWaveModel(std::string_view name) {
  return wave::entryOf(Call{std::string(name), 1, "wave model", {}}).kind;
}

std::shared_ptr<const WaveBrdf> makeWaveBrdf(std::string_view expression) {
  const std::string_view text = wave::withoutPrefix(expression);
  const Call call = parseCall(text, "wave model");
  const wave::Entry& entry = wave::entryOf(call);
  CallArguments arguments(call);
  Channels channels;
  const std::vector<double> wavelengths = wave::wavelengthsOf(arguments, channels);
  std::vector<std::string> states;
  for (const wave::PolarizationState& state : wave::polarizationStates()) states.push_back(state.name);
  const wave::PolarizationState incident = wave::stateOf(arguments.choice("incident", states));
  states.front() = "all";
  const wave::PolarizationState detected = wave::stateOf(arguments.choice("detected", states));
  wave::WaveReader reader(arguments, wavelengths);
  std::vector<wave::ScatterModelPointer> models = entry.make(reader);
  arguments.finish();
  return std::make_shared<WaveBrdf>(std::move(models), std::move(channels), incident, detected,
                                    "wave:" + std::string(text));
}

std::vector<wave::GratingOrder> gratingOrders(std::string_view expression, std::size_t channel, double theta,
                                              double phi) {
  const Call call = parseCall(wave::withoutPrefix(expression), "wave model");
  if (call.name != "Grating")
    throw Error(Error::Kind::Value, {"no orders: not a grating", "wave model", "'" + call.name + "'", "Grating"});
  makeWaveBrdf(expression);
  const auto [wavelengths, stacks] = wave::stacksOf(call, channel);
  CallArguments arguments(call);
  const wave::GratingShape shape = wave::gratingShape(arguments);
  const wave::Vector wi{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
  return wave::gratingOrders(shape, stacks[channel], wavelengths[channel], wi);
}

wave::FilmStack::Powers filmPowers(std::string_view expression, std::size_t channel, double theta) {
  const Call call = parseCall(wave::withoutPrefix(expression), "wave model");
  makeWaveBrdf(expression);
  return wave::stacksOf(call, channel).second[channel].powers(std::sin(theta), std::cos(theta));
}

MaterialKind waveKind() {
  MaterialKind kind{"wave", "wave:MODEL(parameter=value, ...): wave optics, see brdf waves",
                    [](std::string_view arguments) -> BrdfPointer { return makeWaveBrdf(arguments); }};
  kind.components = [](const Brdf& brdf) { return dynamic_cast<const WaveBrdf&>(brdf).components(); };
  return kind;
}

}  // namespace brdf
