#include "Arguments.h"
#include "Commands.h"
#include "Output.h"
#include "Pictures.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/io/ImageFile.h>
#include <brdf/reference/ModelPage.h>
#include <brdf/simulate/MeasuredSpectrum.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

struct Values {
  SurfacePicture picture;
  std::string surface, size = "900x700", window = "none", model;
  std::vector<std::string> spectra;
  bool list = false;
};

Json kindJson(const SurfaceKind& kind) {
  Json parameters = Json::array();
  for (const TextParameter& p : kind.texts) {
    Json parameter = {{"name", p.name}, {"label", p.label}, {"description", p.description}, {"required", p.required}};
    if (!p.choices.empty()) {
      parameter["default"] = p.choices.front();
      parameter["choices"] = p.choices;
    }
    parameters.push_back(std::move(parameter));
  }
  for (const Parameter& p : kind.parameters)
    parameters.push_back({{"name", p.name},
                          {"label", p.label},
                          {"default", p.defaultValue},
                          {"min", p.minimum},
                          {"max", p.maximum},
                          {"unit", p.unit},
                          {"description", p.description}});
  std::vector<std::string> references;
  for (const Reference& reference : kind.references) references.push_back(citation(reference));
  return {{"name", kind.name},
          {"title", kind.title},
          {"description", kind.description},
          {"parameters", parameters},
          {"reference", joined(references, "; ")}};
}

void printKind(const Output& output, const SurfaceKind& kind) {
  output.line(kind.name + ": " + kind.title);
  output.line("    " + kind.description);
  if (!kind.parameters.empty() || !kind.texts.empty()) {
    TextTable table({"    parameter", "default", "allowed", "unit", "meaning"});
    for (const TextParameter& p : kind.texts)
      table.row({"    " + p.name, p.choices.empty() ? "-" : p.choices.front(),
                 p.choices.empty() ? "text" : joined(p.choices), "", p.description});
    for (const Parameter& p : kind.parameters)
      table.row({"    " + p.name, p.follows.empty() ? number(p.defaultValue) : p.follows,
                 number(p.minimum) + " to " + number(p.maximum), p.unit, p.description});
    output.line(table.text());
  }
  for (const Reference& reference : kind.references) output.line("    source: " + citation(reference));
  output.line("");
}

void list(const Output& output, const std::string& name) {
  Json json = Json::array();
  for (const SurfaceKind& kind : surfaceKinds()) {
    if (!name.empty() && kind.name != name) continue;
    printKind(output, kind);
    json.push_back(kindJson(kind));
  }
  if (json.empty()) findSurfaceKind(name);  // says which there are
  output.report(json);
}

/// Heights in micrometres, rows from the top.
void writeHeights(const HeightField& field, const std::string& path) {
  Image image(field.columns, field.rows, 1);
  for (std::size_t j = 0; j < field.rows; ++j)
    std::copy_n(field.heights.data() + j * field.columns, field.columns, image.pixel(0, field.rows - 1 - j));
  writeExr(image, path);
}

/// The power spectral density over the frequency: along x, along y, and of all directions together.
std::vector<CurvesPicture::Curve> spectrumCurves(const HeightSpectrum& spectrum) {
  const RadialSpectrum rings = radialAverage(spectrum);
  std::vector<CurvesPicture::Curve> curves{
      {"along x", {}, {}}, {"along y", {}, {}}, {"all directions", rings.frequency, rings.psd}};
  for (std::size_t m = 1; m <= spectrum.columns / 2; ++m) {
    curves[0].x.push_back(spectrum.frequencyX(m));
    curves[0].y.push_back(spectrum.psd[m]);
  }
  for (std::size_t n = 1; n <= spectrum.rows / 2; ++n) {
    curves[1].x.push_back(spectrum.frequencyY(n));
    curves[1].y.push_back(spectrum.psd[n * spectrum.columns]);
  }
  return curves;
}

void writeSpectrum(std::vector<CurvesPicture::Curve> curves, const Values& values, const std::string& title,
                   const std::string& path) {
  if (path.ends_with(".csv")) {
    std::string text = "direction,frequency (1/um),psd (um^4)\n";
    for (const auto& curve : curves)
      for (std::size_t k = 0; k < curve.x.size(); ++k)
        text += curve.name + "," + formatNumber(curve.x[k]) + "," + formatNumber(curve.y[k]) + "\n";
    writeFile(path, text);
    return;
  }
  double largest = 0;
  for (const auto& curve : curves)
    for (const double y : curve.y) largest = std::max(largest, y);
  for (auto& curve : curves) {
    CurvesPicture::Curve drawn{curve.name, {}, {}};
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
      if (!(curve.y[k] > 1e-14 * largest)) continue;  // what rounding of the heights leaves is no spectrum
      drawn.x.push_back(std::log10(curve.x[k]));
      drawn.y.push_back(curve.y[k]);
    }
    curve = std::move(drawn);
  }
  std::erase_if(curves, [](const auto& curve) { return curve.x.empty(); });
  if (curves.empty())
    throw Error(Error::Kind::Value,
                {"a flat surface has no spectrum to draw", path, values.surface, "heights that differ, or .csv"});
  CurvesPicture picture;
  picture.title = "Power spectral density: " + title;
  picture.note = values.window == "hann" ? "two-sided, its integral over both frequencies the variance; Hann window"
                                         : "two-sided, its integral over both frequencies the variance";
  picture.xTitle = "log10 of the frequency (1/\u00b5m)";
  picture.yTitle = "PSD (\u00b5m^4)";
  picture.scale = "log";
  picture.decades = 12;
  picture.curves = std::move(curves);
  picture.size = sizeOption(values.size);
  picture.out = path;
  pictures().curves(picture);
}

void run(const Output& output, Values values) {
  if (values.list) return list(output, values.surface);
  if (values.surface.empty())
    throw Error(Error::Kind::Usage,
                {"no surface", "SURFACE", "nothing", "an expression such as grooves(width=4), or --list"});
  values.picture.size = sizeOption(values.size);
  checkPictureOutputs(values.picture.out, {".png", ".vtp", ".vti", ".exr", ".stl", ".ply", ".obj"});
  for (const std::string& path : values.spectra) {
    if (!path.ends_with(".png") && !path.ends_with(".csv") && !path.ends_with(".svg") && !path.ends_with(".pdf"))
      throw Error(Error::Kind::Usage,
                  {"unknown kind of file", "--spectrum", "'" + path + "'", ".png, .svg, .pdf, .csv"});
    checkWritable(path);
  }
  const SpectrumPointer model = values.model.empty() ? nullptr : makeSpectrum(values.model);
  const auto made = std::make_shared<const MadeSurface>(surfaceOption(values.surface));
  const auto* field = std::get_if<HeightField>(&made->surface.shape);
  if (!field && !values.spectra.empty())
    throw Error(Error::Kind::Value,
                {"only heights at nodes have a spectrum", "--spectrum", values.surface, "a height field"});

  output.line(made->surface.description);
  Json facts = Json::array();
  for (const SurfaceFact& fact : made->facts) {
    output.line("    " + fact.name + ": " + number(fact.value) + (fact.unit == "1" ? "" : " " + fact.unit));
    facts.push_back({{"name", fact.name}, {"value", fact.value}, {"unit", fact.unit}});
  }
  Json report = {{"surface", made->surface.description}, {"facts", facts}};

  std::vector<std::string> drawn;
  for (const std::string& path : values.picture.out) {
    if (!path.ends_with(".exr")) {
      drawn.push_back(path);
      continue;
    }
    if (!field) throw Error(Error::Kind::Value, {"no heights at nodes", path, "a mesh or spheres", "a height field"});
    writeHeights(*field, path);
  }
  if (!drawn.empty()) {
    SurfacePicture picture = values.picture;
    picture.surface = made;
    picture.title = values.surface;
    picture.out = std::move(drawn);
    pictures().surface(picture);
  }
  if (!values.spectra.empty()) {
    const HeightSpectrum spectrum =
        spectrumOf(*field, values.window == "hann" ? SpectrumWindow::Hann : SpectrumWindow::None);
    std::vector<CurvesPicture::Curve> curves = spectrumCurves(spectrum);
    if (model) {
      CurvesPicture::Curve curve{model->description(), curves[2].x, {}};
      for (const double f : curve.x) curve.y.push_back(model->psd(f, 0));
      curves.push_back(std::move(curve));
    }
    for (const std::string& path : values.spectra) writeSpectrum(curves, values, values.surface, path);
    report["spectrum"] = {{"window", values.window},
                          {"variance", spectrum.variance()},
                          {"slope_variance_x", spectrum.slopeVarianceX()},
                          {"slope_variance_y", spectrum.slopeVarianceY()}};
    output.line("    integral of the spectrum: " + number(spectrum.variance()) + " um^2; mean square slopes " +
                number(spectrum.slopeVarianceX()) + ", " + number(spectrum.slopeVarianceY()));
  }
  report["out"] = values.picture.out;
  report["spectrum_out"] = values.spectra;
  if (!values.picture.out.empty() || !values.spectra.empty())
    output.line(joined(values.picture.out) + (values.picture.out.empty() || values.spectra.empty() ? "" : ", ") +
                joined(values.spectra));
  output.report(report);
}

}  // namespace

Command surfaceCommand() {
  const auto values = std::make_shared<Values>();
  return {"surface", "Make a microsurface: its picture, heights, mesh and power spectral density",
          "  brdf surface --list\n"
          "  brdf surface \"grooves(width=4, spacing=20, angle=60)\" --out grooves.png --out grooves.stl\n"
          "  brdf surface \"gaussian(rms=0.5, correlation=10)\" --spectrum psd.png --spectrum psd.csv "
          "--model \"gaussian(rms=0.5, correlation=10)\" --out heights.exr",
          [values](Arguments& arguments) {
            arguments.positional("SURFACE", values->surface, "A surface such as grooves(width=4, spacing=20)");
            arguments.optional();
            arguments.flag("--list", values->list, "The kinds of surfaces and their parameters; or of SURFACE alone");
            arguments.option("--out", values->picture.out, "FILE",
                             "x.png: picture; x.vtp, x.stl, x.ply, x.obj: mesh; x.exr, x.vti: heights in micrometres; "
                             "several times");
            arguments.option("--tiles", values->picture.tiles, {1, 100}, "Copies of the tile along x and y");
            arguments.option("--azimuth", values->picture.azimuth, {-360, 360}, "DEGREES", "Of the picture's view");
            arguments.option("--elevation", values->picture.elevation, {1, 90}, "DEGREES",
                             "Of the picture's view; 90 is a map");
            arguments.option("--exaggeration", values->picture.exaggeration, {0, 1e9}, "FACTOR",
                             "Of heights in the picture; 0 chooses");
            arguments.option("--spectrum", values->spectra, "FILE",
                             "Power spectral density of the heights: x.png, x.svg, x.pdf, x.csv; several times");
            arguments.choice("--window", values->window, {"none", "hann"},
                             "Before the Fourier transform: hann where the tile's edges do not fit");
            arguments.option("--model", values->model, "SPECTRUM",
                             "Drawn beside it, such as abc(a=0.01, b=5, c=3) or gaussian(rms=0.5, correlation=10)");
            arguments.option("--size", values->size, "WxH", "Pixels of the pictures [900x700]");
          },
          [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
