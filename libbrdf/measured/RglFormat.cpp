// RGL's material database (J. Dupuy, W. Jakob, "An Adaptive Parameterization for Efficient Material Acquisition and
// Rendering", ACM TOG 37(6), 2018): tensor files with the fields description, jacobian, theta_i, phi_i, ndf, sigma,
// vndf, luminance, and rgb or spectra with wavelengths. And the polarised BRDFs of S.-H. Baek et al., "Image-Based
// Acquisition and Modeling of Polarimetric Reflectance", ACM TOG 39(4), 2020, in the same container.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/material/ChannelView.h>
#include <brdf/measured/BuiltInFormats.h>
#include <brdf/measured/GridFile.h>
#include <brdf/measured/RglBrdf.h>
#include <brdf/measured/RglTabulation.h>
#include <brdf/measured/ScatteredText.h>
#include <brdf/measured/TensorFile.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace brdf {
namespace {

/// Whether the directory in the head names a field; all directories seen fit into the head.
bool names(std::string_view head, std::string_view field) {
  return head.starts_with(TensorFile::kMagic) && head.find(field) != std::string_view::npos;
}

int recogniseRgl(std::string_view head, std::uint64_t) {
  if (!head.starts_with(TensorFile::kMagic)) return 0;
  return names(head, "vndf") ? 100 : 50;
}

RglData::Grid grid(const TensorFile& file, std::string_view name, const std::vector<std::size_t>& leading) {
  RglData::Grid result;
  const TensorFile::Field& field = file.field(name, TensorFile::Type::F32, leading.size() + 2);
  for (std::size_t d = 0; d < leading.size(); ++d)
    if (field.shape[d] != leading[d])
      file.fail(name, "wrong shape", std::to_string(field.shape[d]) + " in dimension " + std::to_string(d),
                std::to_string(leading[d]));
  result.height = field.shape[leading.size()];
  result.width = field.shape[leading.size() + 1];
  result.values = file.floats(name, leading.size() + 2);
  return result;
}

ReadResult readRgl(std::string_view bytes, const std::filesystem::path& path, const ReadOptions&) {
  const TensorFile file(bytes, path);
  RglData data;
  data.phi = file.floats("phi_i", 1);
  data.theta = file.floats("theta_i", 1);
  const std::vector<std::size_t> slices = {data.phi.size(), data.theta.size()};
  const TensorFile::Field& jacobian = file.field("jacobian", TensorFile::Type::U8, 1);
  data.jacobian = jacobian.data[0] != 0;
  data.ndf = grid(file, "ndf", {});
  data.sigma = grid(file, "sigma", {});
  data.vndf = grid(file, "vndf", slices);
  data.luminance = grid(file, "luminance", slices);
  const bool spectral = file.has("spectra");
  if (spectral) {
    const std::vector<float> wavelengths = file.floats("wavelengths", 1);
    data.channels = Channels::spectral({wavelengths.begin(), wavelengths.end()});
    if (!std::is_sorted(wavelengths.begin(), wavelengths.end(), std::less_equal<>()) || !(wavelengths[0] > 0))
      file.fail("wavelengths", "wrong wavelengths", formatNumber(wavelengths[0]), "positive, ascending (nm)");
  } else {
    data.channels = Channels::rgb();
  }
  data.spectra = grid(file, spectral ? "spectra" : "rgb", {slices[0], slices[1], data.channels.count()});

  ReadReport report;
  report.samples = data.spectra.values.size() / data.channels.count();
  for (const float v : data.spectra.values) {
    report.negative += v < 0;
    if (!std::isfinite(v)) file.fail(spectral ? "spectra" : "rgb", "a value is not finite", "", "finite values");
  }
  const std::string_view description =
      file.has("description") ? file.field("description", TensorFile::Type::U8, 1).data : std::string_view();
  report.metadata["description"] = std::string(trimmed(description.substr(0, description.find('\0'))));
  report.metadata["dimensions"] = std::to_string(slices[0]) + " phi_i x " + std::to_string(slices[1]) + " theta_i x " +
                                  std::to_string(data.spectra.height) + " x " + std::to_string(data.spectra.width);
  std::shared_ptr<const RglBrdf> brdf;
  try {
    brdf = std::make_shared<RglBrdf>(std::move(data), path.filename().string());
  } catch (const Error& error) {
    Error::Details details = error.details();
    details.where = path.string();
    throw Error(Error::Kind::Format, std::move(details));
  }
  report.assumptions = {
      "values are f_r cos(theta) of the direction that is drawn, 1/sr; they are divided by that cosine, by no less "
      "than "
      "that of 85 degrees",
      "theta_i and phi_i, the directions that condition, are the viewer's, as renderers of these files take them",
      spectral ? "spectra are reflectances, one a wavelength" : "rgb is linear sRGB",
      "negative values are noise about zero and kept",
      brdf->isotropic() ? "the surface is isotropic: at most two azimuths"
                        : "the azimuths cover one of " + std::to_string(brdf->reduction()) + " equal parts of a turn"};
  return {std::move(brdf), std::move(report)};
}

WriteReport writeRgl(const Brdf& brdf, const std::filesystem::path& path) {
  WriteReport report;
  if (brdf.channels().kind == Channels::Kind::Monochrome)
    report.losses.push_back("one channel: written as three equal colours");
  const BrdfPointer seen = brdf.channels().kind == Channels::Kind::Spectral ? BrdfPointer(BrdfPointer(), &brdf)
                                                                            : asRgb(BrdfPointer(BrdfPointer(), &brdf));
  // Fewer of all where the azimuths of viewers multiply them.
  const bool isotropic = seen->symmetry() != Symmetry::Anisotropic;
  const RglData data = tabulateRgl(*seen, isotropic ? RglResolution{} : RglResolution{24, 25, 96, 64, 32});
  report.losses.push_back("resampled at " + std::to_string(data.phi.size()) + " x " +
                          std::to_string(data.theta.size()) + " viewers and " + std::to_string(data.spectra.height) +
                          " x " + std::to_string(data.spectra.width) + " lights each");
  report.losses.push_back("near grazing: lights beyond 85 degrees read back darker");
  const std::size_t phi = data.phi.size(), theta = data.theta.size();
  TensorWriter writer;
  writer.add("description", brdf.description() + " ");
  writer.add("jacobian", std::string_view("\x01", 1));
  writer.add("theta_i", {theta}, data.theta);
  writer.add("phi_i", {phi}, data.phi);
  writer.add("ndf", {data.ndf.height, data.ndf.width}, data.ndf.values);
  writer.add("sigma", {data.sigma.height, data.sigma.width}, data.sigma.values);
  writer.add("vndf", {phi, theta, data.vndf.height, data.vndf.width}, data.vndf.values);
  writer.add("luminance", {phi, theta, data.luminance.height, data.luminance.width}, data.luminance.values);
  const bool spectral = data.channels.kind == Channels::Kind::Spectral;
  if (spectral) {
    const std::vector<double>& wavelengths = data.channels.wavelengths;
    writer.add("wavelengths", {wavelengths.size()}, std::vector<float>(wavelengths.begin(), wavelengths.end()));
  }
  writer.add(spectral ? "spectra" : "rgb", {phi, theta, data.channels.count(), data.spectra.height, data.spectra.width},
             data.spectra.values);
  writeBytes(path, writer.bytes());
  return report;
}

int recogniseKaist(std::string_view head, std::uint64_t) {
  return names(head, "theta_h") && names(head, "phi_d") && names(head, "wvls") ? 101 : 0;
}

/// The angles of a [1, n] field, none beyond its right angle or half turn by the rounding of a float.
std::vector<double> angles(const TensorFile& file, std::string_view name, double limit) {
  const std::vector<float> values = file.floats(name, 2);
  if (file.field(name, TensorFile::Type::F32, 2).shape[0] != 1) file.fail(name, "wrong shape", "several rows", "1 x n");
  std::vector<double> result;
  for (const float v : values) {
    if (!(std::abs(v) <= limit * (1 + 1e-6)) || (!result.empty() && !(v > result.back())))
      file.fail(name, "wrong angle", formatNumber(v), "ascending radians up to " + formatNumber(limit, 6));
    result.push_back(std::clamp<double>(v, -limit, limit));
  }
  return result;
}

ReadResult readKaist(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  const TensorFile file(bytes, path);
  const std::vector<double> thetaH = angles(file, "theta_h", kPi / 2), thetaD = angles(file, "theta_d", kPi / 2),
                            phiD = angles(file, "phi_d", kPi);
  const TensorFile::Field& wavelengths = file.field("wvls", TensorFile::Type::U16, 1);
  std::vector<double> nanometres;
  for (std::size_t k = 0; k < wavelengths.count(); ++k) {
    std::uint16_t w = 0;
    std::memcpy(&w, wavelengths.data.data() + 2 * k, 2);
    if (w == 0 || (k > 0 && !(w > nanometres.back())))
      file.fail("wvls", "wrong wavelength", std::to_string(w), "positive, ascending (nm)");
    nanometres.push_back(w);
  }
  const TensorFile::Field& mueller = file.field("M", TensorFile::Type::F32, 6);
  const std::vector<std::size_t> shape = {phiD.size(), thetaD.size(), thetaH.size(), nanometres.size(), 4, 4};
  if (mueller.shape != shape)
    file.fail("M", "wrong shape", std::to_string(mueller.count()) + " numbers",
              "phi_d x theta_d x theta_h x wavelengths x 4 x 4");

  ReadReport report;
  GridData data;
  data.layout.parametrisation = Parametrisation::HalfDifference;
  data.layout.axes = {{AxisQuantity::ThetaH, thetaH}, {AxisQuantity::ThetaD, thetaD}, {AxisQuantity::PhiD, phiD}};
  if (phiD.size() > 1) {
    // A full turn, its last azimuth being its first or the step before it.
    const double step = phiD[1] - phiD[0];
    if (phiD.back() - phiD.front() > 2 * kPi - 1.5 * step) data.layout.axes[2].period = 2 * kPi;
  }
  data.channels = Channels::spectral(nanometres);
  const std::size_t cells = thetaH.size() * thetaD.size() * phiD.size();
  data.values.resize(nanometres.size() * cells);
  for (std::size_t cell = 0; cell < cells; ++cell)
    for (std::size_t w = 0; w < nanometres.size(); ++w) {
      float m00 = 0;
      std::memcpy(&m00, mueller.data.data() + 4 * 16 * (cell * nanometres.size() + w), 4);
      data.values[w * cells + cell] = m00;
    }
  const Quantity quantity =
      choose(options, Quantity::Brdf, "the renderer of these files multiplies by the cosine", report);
  const InvalidRule rule = choose(options, InvalidRule::NotFinite, "directions that were not measured are NaN", report);
  report.assumptions.push_back("the element (0, 0) of the Mueller matrices is the BRDF for unpolarised light");
  report.assumptions.push_back("angles are radians; phi_d is the light's azimuth about the half vector");
  report.warnings.push_back(
      "polarisation is not kept: the frames that the other 15 elements of the Mueller matrices refer to are not "
      "established");
  return finishGrid(std::move(data), path, std::move(report), quantity, rule);
}

}  // namespace

Format rglFormat() { return {"rgl", "RGL material database, tensor file", ".bsdf", recogniseRgl, readRgl, writeRgl}; }

Format kaistFormat() {
  return {"kaist",
          "KAIST polarised BRDF, tensor file",
          ".pbsdf",
          recogniseKaist,
          readKaist,
          nullptr,
          {"quantity", "invalid"}};
}

}  // namespace brdf
