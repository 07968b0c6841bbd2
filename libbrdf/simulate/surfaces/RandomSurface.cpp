#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/simulate/Fourier.h>
#include <brdf/simulate/Spectrum.h>
#include <brdf/simulate/SurfaceRandom.h>
#include <brdf/simulate/surfaces/BuiltInSurfaces.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace brdf {
namespace {

/// PSD in um^4 at (fx, fy) in 1/um.
using Psd = std::function<double(double fx, double fy)>;

struct Lattice {
  std::size_t columns, rows;
  double periodX, periodY;
};

/// Nodes at most `spacing` apart along each axis of a tile.
Lattice latticeOf(const SurfaceArguments& arguments, double periodX, double periodY, double spacingX, double spacingY) {
  Lattice lattice{0, 0, periodX, periodY};
  const auto nodes = [&](double period, double spacing) {
    const double count = std::ceil(period / spacing * (1 - 1e-12));
    if (!(count <= static_cast<double>(kMaximumGeneratedNodes) / 2))
      throw Error(Error::Kind::Value, {"too many nodes", arguments.where(), formatNumber(count) + " along one axis",
                                       "2^24 in all: a shorter period or a wider spacing"});
    return fastLength(static_cast<std::size_t>(count));
  };
  lattice.columns = nodes(periodX, spacingX);
  lattice.rows = nodes(periodY, spacingY);
  if (lattice.columns > kMaximumGeneratedNodes / lattice.rows)
    throw Error(Error::Kind::Value, {"too many nodes", arguments.where(),
                                     std::to_string(lattice.columns) + " x " + std::to_string(lattice.rows),
                                     "2^24 in all: a shorter period or a wider spacing"});
  return lattice;
}

/// White noise filtered in the frequencies of the tile: Gaussian heights whose spectrum is `psd` at those frequencies,
/// on average over seeds, and nothing at f = 0 and beyond the lattice's highest frequency. `expected`: their variance.
std::vector<double> filteredNoise(const Lattice& lattice, const Psd& psd, std::uint64_t seed, double& expected) {
  const std::size_t nodes = lattice.columns * lattice.rows;
  SurfaceRandom random(seed);
  std::vector<std::complex<double>> values(nodes);
  for (auto& value : values) value = random.normal();
  fourierTransform(values, lattice.columns, lattice.rows, false);
  const double cell = 1 / (lattice.periodX * lattice.periodY);
  expected = 0;
  for (std::size_t n = 0, k = 0; n < lattice.rows; ++n)
    for (std::size_t m = 0; m < lattice.columns; ++m, ++k) {
      const double power = k == 0 ? 0
                                  : psd(frequencyOf(m, lattice.columns, lattice.periodX),
                                        frequencyOf(n, lattice.rows, lattice.periodY)) *
                                        cell;
      expected += power;
      values[k] *= std::sqrt(power * static_cast<double>(nodes));
    }
  fourierTransform(values, lattice.columns, lattice.rows, true);
  std::vector<double> heights(nodes);
  for (std::size_t k = 0; k < nodes; ++k) heights[k] = values[k].real();
  return heights;
}

/// Scaled so that the tile's rms height is `rms`, where that is asked for.
MadeSurface surfaceOf(const Lattice& lattice, const Psd& psd, std::uint64_t seed, double rms, bool exact) {
  double expected = 0;
  std::vector<double> heights = filteredNoise(lattice, psd, seed, expected);
  double squares = 0;
  for (const double h : heights) squares += h * h;
  const double realised = std::sqrt(squares / static_cast<double>(heights.size()));
  const double factor = exact && realised > 0 ? rms / realised : 1;
  HeightField field{lattice.columns,
                    lattice.rows,
                    lattice.periodX / static_cast<double>(lattice.columns),
                    lattice.periodY / static_cast<double>(lattice.rows),
                    {}};
  field.heights.reserve(heights.size());
  for (const double h : heights) field.heights.push_back(static_cast<float>(h * factor));
  MadeSurface made;
  made.facts = {{"rms height expected of the spectrum within the lattice", std::sqrt(expected), "um"},
                {"scaled by", factor, "1"}};
  made.surface.shape = std::move(field);
  return made;
}

/// The PSD of rms^2 times the autocorrelation, of correlation lengths x and y.
Psd scaledPsd(SpectrumPointer unit, double rms, double x, double y) {
  return [unit = std::move(unit), scale = rms * rms * x * y, x, y](double fx, double fy) {
    return scale * unit->psd(x * fx, y * fy);
  };
}

MadeSurface makeCorrelated(const SurfaceArguments& arguments, const SpectrumPointer& unit) {
  const double rms = arguments.number("rms");
  const double x = arguments.number("correlation"), y = arguments.number("correlation_y");
  const double given = arguments.number("period");
  const double periodX = given > 0 ? given : 64 * x, periodY = given > 0 ? given : 64 * y;
  if (given > 0 && given < 4 * std::max(x, y))
    arguments.refuse("period", "tile too small",
                     "at least 4 correlation lengths, " + formatNumber(4 * std::max(x, y)) + " um");
  const double resolution = arguments.number("resolution");
  const Lattice lattice = latticeOf(arguments, periodX, periodY, x / resolution, y / resolution);
  return surfaceOf(lattice, scaledPsd(unit, rms, x, y), arguments.whole("seed"), rms,
                   arguments.text("rms_of") == "tile");
}

MadeSurface makeOfSpectrum(const SurfaceArguments& arguments) {
  const SpectrumPointer spectrum = makeSpectrum(arguments.text("spectrum"));
  const double period = arguments.number("period"), spacing = arguments.number("spacing");
  const Lattice lattice = latticeOf(arguments, period, period, spacing, spacing);
  return surfaceOf(
      lattice, [&](double fx, double fy) { return spectrum->psd(fx, fy); }, arguments.whole("seed"), 0, false);
}

const Reference kGarciaStoll{"N. Garcia and E. Stoll",
                             1984,
                             "Monte Carlo Calculation for Electromagnetic-Wave Scattering from Random Rough Surfaces",
                             "Phys. Rev. Lett. 52, 1798-1801",
                             "10.1103/PhysRevLett.52.1798",
                             ""};

std::vector<Parameter> correlatedParameters() {
  Parameter y = lengthParameter("correlation_y", "correlation length along y", 10, "the same along y");
  y.follows = "correlation";
  return {
      lengthParameter("rms", "rms height", 1, "root mean square of the heights about their mean", 0),
      lengthParameter("correlation", "correlation length", 10,
                      "distance along x at which the autocorrelation falls to 1/e"),
      y,
      lengthParameter("period", "period", 0, "side of the square tile; 0: 64 correlation lengths along each axis", 0),
      numberParameter("resolution", "resolution", 8, 1, 256, "nodes a correlation length, at least"),
      seedParameter()};
}

TextParameter rmsOf() {
  return {"rms_of",
          "rms of",
          "whose rms height is as given: the tile's, which is scaled to it, or the average over all seeds'",
          {"tile", "ensemble"}};
}

}  // namespace

SurfaceKind gaussianSurface() {
  return {
      "gaussian",
      "Gaussian random surface",
      "Heights are Gaussian with the autocovariance rms^2 exp(-(x/correlation)^2 - (y/correlation_y)^2): white "
      "noise filtered by the square root of its spectrum at the frequencies of the tile, which makes it periodic. "
      "Slopes are Gaussian as well, of rms sqrt(2) rms / correlation along x; triangles are less steep, by a factor "
      "1 - 1/(4 resolution^2). Beckmann's roughness is sqrt(2) times the rms slope.",
      correlatedParameters(),
      {rmsOf()},
      {kGarciaStoll},
      [](const SurfaceArguments& arguments, const SurfaceReaders&) {
        return makeCorrelated(arguments, gaussianSpectrum(1, 1, 1));
      }};
}

SurfaceKind exponentialSurface() {
  return {
      "exponential",
      "exponential random surface",
      "Heights are Gaussian with the autocovariance rms^2 exp(-sqrt((x/correlation)^2 + (y/correlation_y)^2)), made "
      "as those of gaussian(). Its spectrum, 2 pi rms^2 Lx Ly / (1 + (2 pi Lx fx)^2 + (2 pi Ly fy)^2)^(3/2), has no "
      "mean square slope: the slopes grow as the lattice gets finer, and what lies beyond its highest frequency, of "
      "the variance about 1 / (pi resolution), is missing.",
      correlatedParameters(),
      {rmsOf()},
      {kGarciaStoll},
      [](const SurfaceArguments& arguments, const SurfaceReaders&) {
        return makeCorrelated(arguments, abcSpectrum(2 * kPi, 2 * kPi, 3));
      }};
}

SurfaceKind spectrumSurface() {
  return {"rough",
          "random surface of a spectrum",
          "Heights are Gaussian with any power spectral density: abc(...), gaussian(...), fractal(...), "
          "sum(...), measured(...). What lies below the tile's lowest frequency, 1/period, and above the lattice's "
          "highest, 1/(2 spacing), is missing; what remains is reported.",
          {lengthParameter("period", "period", 100, "side of the square tile"),
           lengthParameter("spacing", "spacing", 0.2, "between nodes, at most"), seedParameter()},
          {{"spectrum", "spectrum", "power spectral density, as an expression: \"abc(a=0.01, b=5, c=3)\"", {}, true}},
          {kGarciaStoll},
          [](const SurfaceArguments& arguments, const SurfaceReaders&) { return makeOfSpectrum(arguments); }};
}

}  // namespace brdf
