#include "Assumptions.h"
#include "Colours.h"
#include "Commands.h"
#include "FrameNames.h"
#include "Output.h"
#include "Progress.h"
#include "ReferenceRender.h"
#include "SceneArguments.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/ImageFile.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace brdf::app {
namespace {

struct Values {
  SceneRequest subject;
  RenderPicture picture;
  ReferenceOptions options;
  std::string standardError;  ///< .exr for the standard error of every number; empty: none
  bool reference = false, converge = false;
  std::optional<double> tolerance;
  std::size_t samples = 0;  ///< 0: not given
  std::size_t turntable = 0;
  std::string turn = "object";
};

double meanOf(const Image& image) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < image.values.size(); ++k)
    if (k % image.channels < 3) {
      sum += double(image.values[k]);
      ++count;
    }
  return sum / static_cast<double>(count);
}

void writePicture(const Image& radiance, const RenderPicture& picture, const std::string& path) {
  path.ends_with(".png") ? pictures().writePng(radiance, picture, path) : writeExr(radiance, path);
}

/// The same picture with its progress shown, stopping with Ctrl-C.
RenderPicture watched(RenderPicture picture, Progress& progress) {
  picture.converge->progress = [&progress](std::size_t done, std::size_t most, double error) {
    progress.update(done, most, std::isfinite(error) ? "relative error " + number(error) : "");
    return !interrupted();
  };
  return picture;
}

nlohmann::json subjectJson(const Values& values, const Scene& scene) {
  return {{"material", values.subject.material},
          {"object", values.subject.object},
          {"scene", values.subject.scene},
          {"lights", values.subject.lights},
          {"colour", coloursJson(values.picture.colours)},
          {"size", {scene.width, scene.height}},
          {"exposure", values.picture.exposure},
          {"out", values.picture.out}};
}

void runReference(const Output& output, const Values& values, const Scene& scene) {
  const Interruptible untilSaved;
  const ReferencePicture picture = drawReference(output, "render", scene, values.picture.colours, values.options);
  for (const std::string& path : values.picture.out) writePicture(picture.radiance, values.picture, path);
  if (!values.standardError.empty()) writeExr(picture.standardError, values.standardError);

  std::string text = joined(values.picture.out) + ": " + std::to_string(picture.samples) +
                     " paths a pixel, mean radiance " + number(meanOf(picture.radiance)) +
                     ", relative standard error " + number(picture.relativeError) + ", " +
                     formatNumber(picture.seconds, 3) + " s on the CPU";
  if (values.options.tolerance > 0 && !picture.converged)
    text += "\n  note: the tolerance " + formatNumber(values.options.tolerance) + " was not reached";
  if (picture.invalidShare > 0)
    text += "\n  note: " + number(100 * picture.invalidShare) +
            " % of the directions asked for have no value in the material and were taken for black";
  output.line(text);
  nlohmann::json report = subjectJson(values, scene);
  report.update({{"samples", picture.samples},
                 {"bounces", values.options.bounces},
                 {"tolerance", values.options.tolerance},
                 {"relative_error", picture.relativeError},
                 {"converged", picture.converged},
                 {"invalid_share", picture.invalidShare},
                 {"mean_radiance", meanOf(picture.radiance)},
                 {"seconds", picture.seconds},
                 {"device", "CPU"}});
  output.report(report);
  if (interrupted())
    throw Error(Error::Kind::Value, {"interrupted; the picture so far was kept", "brdf render", "", ""});
}

/// What drawing made of materials that are no sums of lobes.
void reportTables(const Output& output, const RenderedFrame& frame, nlohmann::json& report) {
  report["tables"] = nlohmann::json::array();
  for (const std::string_view layout : split(frame.tables, '\n'))
    if (!layout.empty()) report["tables"].push_back(layout);
  if (!(frame.resamplingError >= 0)) return;
  report["resampling_error"] = frame.resamplingError;
  output.line("  note: drawn by a table made for it, relative error " + number(frame.resamplingError) +
              " in the worst region of directions; --reference needs none");
}

void runDevice(const Output& output, const Values& values, const Scene& scene) {
  const auto start = std::chrono::steady_clock::now();
  const RenderedFrame frame = pictures().frameDrawer()(scene, values.picture);
  for (const std::string& path : values.picture.out) writePicture(frame.radiance, values.picture, path);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  output.line(joined(values.picture.out) + ": " + std::to_string(values.picture.samples) +
              " samples a pixel, mean radiance " + number(meanOf(frame.radiance)) + ", " + formatNumber(seconds, 3) +
              " s on " + frame.device);
  nlohmann::json report = subjectJson(values, scene);
  reportTables(output, frame, report);
  report.update({{"samples", values.picture.samples},
                 {"shadows", values.picture.shadows},
                 {"mean_radiance", meanOf(frame.radiance)},
                 {"seconds", seconds},
                 {"device", frame.device}});
  output.report(report);
}

/// On the graphics device without filtering. With Ctrl-C what is drawn so far is written.
void runConverging(const Output& output, const Values& values, const Scene& scene) {
  const Interruptible untilSaved;
  const auto start = std::chrono::steady_clock::now();
  RenderedFrame frame;
  {
    Progress progress(output, "render");
    frame = pictures().frameDrawer()(scene, watched(values.picture, progress));
  }
  for (const std::string& path : values.picture.out) writePicture(frame.radiance, values.picture, path);
  if (!values.standardError.empty()) writeExr(frame.standardError, values.standardError);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double tolerance = values.picture.converge->tolerance;
  std::string text = joined(values.picture.out) + ": " + std::to_string(frame.samples) +
                     " samples a pixel, mean radiance " + number(meanOf(frame.radiance)) +
                     ", relative standard error " + number(frame.relativeError) + ", " + formatNumber(seconds, 3) +
                     " s on " + frame.device;
  if (tolerance > 0 && !frame.converged)
    text += "\n  note: the tolerance " + formatNumber(tolerance) + " was not reached";
  output.line(text);
  nlohmann::json report = subjectJson(values, scene);
  reportTables(output, frame, report);
  report.update({{"samples", frame.samples},
                 {"tolerance", tolerance},
                 {"relative_error", frame.relativeError},
                 {"converged", frame.converged},
                 {"mean_radiance", meanOf(frame.radiance)},
                 {"seconds", seconds},
                 {"device", frame.device}});
  output.report(report);
  if (frame.stopped)
    throw Error(Error::Kind::Value, {"interrupted; the picture so far was kept", "brdf render", "", ""});
}

/// Frames of a full turn of the objects or of the environment.
void runTurntable(const Output& output, const Values& values, const Scene& scene, bool reference) {
  const auto start = std::chrono::steady_clock::now();
  const Position center = sceneBounds(scene).center;
  const FrameDrawer draw = reference ? FrameDrawer() : pictures().frameDrawer();
  std::string device = "CPU";
  std::size_t done = 0;
  const Interruptible untilSaved;
  {
    std::optional<Progress> progress;  // the reference renderer shows its own
    if (!reference) progress.emplace(output, "turntable");
    for (; done < values.turntable && !interrupted(); ++done) {
      if (progress) progress->update(done, values.turntable);
      Scene turned = scene;
      const double degrees = 360.0 * static_cast<double>(done) / static_cast<double>(values.turntable);
      if (values.turn == "environment")
        turned.environment->rotation += degrees;
      else
        turnObjects(turned, center, degrees);
      RenderedFrame frame;
      if (reference) {
        const std::string title = "frame " + std::to_string(done + 1) + " of " + std::to_string(values.turntable);
        ReferencePicture picture = drawReference(output, title, turned, values.picture.colours, values.options);
        if (picture.stopped) break;
        frame.radiance = std::move(picture.radiance);
      } else {
        RenderPicture picture = values.picture;
        if (picture.converge)
          picture.converge->progress = [](std::size_t, std::size_t, double) { return !interrupted(); };
        frame = draw(turned, picture);
        device = frame.device;
        if (frame.stopped) break;
      }
      for (const std::string& pattern : values.picture.out)
        writePicture(frame.radiance, values.picture, frameName(pattern, done));
    }
    if (progress) progress->update(done, values.turntable);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  output.line(joined(values.picture.out) + ": " + std::to_string(done) + " frames, " + formatNumber(seconds, 3) +
              " s on " + device);
  nlohmann::json report = subjectJson(values, scene);
  report.update({{"frames", done}, {"seconds", seconds}, {"device", device}});
  output.report(report);
  if (done < values.turntable)
    throw Error(Error::Kind::Value,
                {"interrupted; the finished frames were kept", "brdf render", std::to_string(done) + " frames",
                 std::to_string(values.turntable) + " asked for"});
}

void checkOptions(const Values& values) {
  if (values.reference && values.converge)
    throw Error(Error::Kind::Usage, {"one of two ways to draw", "brdf render", "--reference and --converge", "one"});
  if (!values.reference && values.options.bounces > 1)
    throw Error(Error::Kind::Usage, {"--bounces needs the reference renderer", "brdf render", "", "--reference"});
  if (!values.reference && !values.converge && (values.tolerance || !values.standardError.empty()))
    throw Error(Error::Kind::Usage, {"--tolerance and --standard-error need a way to draw that has them", "brdf render",
                                     "", "--reference or --converge"});
  if (values.turntable > 0 && !values.standardError.empty())
    throw Error(Error::Kind::Usage, {"of one picture only", "--standard-error", "", "without --turntable"});
  for (const std::string& path : values.picture.out) {
    if (values.turntable > 0) checkFrameNames(path);
    checkPictureOutputs({values.turntable > 0 ? frameName(path, 0) : path}, {".png", ".exr"});
  }
  if (!values.standardError.empty()) checkPictureOutputs({values.standardError}, {".exr"});
}

void run(const Output& output, Values values) {
  checkOptions(values);
  values.subject.assumptions = assumptions();
  colourSettings(values.picture.colours);  // says what is wrong before anything is loaded
  const Scene scene = arrangeScene(values.subject);
  if (values.turn == "environment" && !scene.environment)
    throw Error(Error::Kind::Usage, {"no environment to turn", "--turn", "environment", "--light env:FILE"});
  const std::size_t usual = values.reference ? values.options.samples : values.picture.samples;
  values.options.samples = std::max<std::size_t>(2, values.samples > 0 ? values.samples : usual);
  values.options.tolerance = values.tolerance.value_or(values.converge ? ConvergeOptions().tolerance : 0);
  if (values.converge) {
    ConvergeOptions& converge = values.picture.converge.emplace();
    converge.tolerance = values.options.tolerance;
    if (values.samples > 0) converge.samples = values.samples;
  }
  values.picture.samples = values.samples > 0 ? values.samples : values.picture.samples;
  if (values.turntable > 0)
    runTurntable(output, values, scene, values.reference);
  else if (values.reference)
    runReference(output, values, scene);
  else if (values.converge)
    runConverging(output, values, scene);
  else
    runDevice(output, values, scene);
}

}  // namespace

Command renderCommand() {
  const auto values = std::make_shared<Values>();
  return {
      "render", "Render an object of a material under light, or a scene",
      "  brdf render \"(0.3,0.1,0.05)*Lambertian + 0.5*GGX(alpha=0.2)\" --light directional:45,0 --out sphere.png "
      "--out sphere.exr\n"
      "  brdf render spectral.xml --illuminant A --light directional:45,0 --out lamp.png\n"
      "  brdf render \"0.5*Lambertian\" --light point:2,2,3 --reference --samples 64 --size 64x64 --out true.exr\n"
      "  brdf render \"0.5*GGX(alpha=0.3)\" --light directional:45,0 --converge --tolerance 0.02 --size 64x64 "
      "--out converged.exr\n"
      "  brdf render \"GGX(alpha=0.3)\" --ground --camera three-quarter --light directional:40,60 --turntable 3 "
      "--size 64x64 --out frame_%03d.png",
      [values](Arguments& arguments) {
        RenderPicture& picture = values->picture;
        ReferenceOptions& reference = values->options;
        declareScene(arguments, values->subject);
        arguments.option("--samples", values->samples, {1, 1 << 24},
                         "A pixel: under an environment [64]; with --reference, paths at most [256]; with "
                         "--converge, at most [4096]");
        arguments.choice("--shadows", picture.shadows, {"none", "lights", "all"},
                         "On the graphics device: of no light, of lights besides the environment, or of all");
        arguments.choice("--shadow-cells", picture.shadowCells, {"8", "16", "32", "64"},
                         "Of the environment's directions, a side: finer shadows for rays in proportion to the square");
        arguments.flag("--reference", values->reference,
                       "Path tracing on the CPU, unbiased: the truth that other pictures are compared with");
        arguments.flag("--converge", values->converge,
                       "Without filtering on the graphics device, until the noise is below the tolerance");
        arguments.option("--tolerance", values->tolerance, {0, 1}, "NUMBER",
                         "With --reference [0] or --converge [0.01]: stop when the relative standard error is "
                         "below; 0: draw all samples");
        arguments.option("--bounces", reference.bounces, {1, 1000},
                         "With --reference: surfaces that light may meet on its way; 1 is direct light");
        arguments.option("--standard-error", values->standardError, "FILE.exr",
                         "With --reference or --converge: the standard error of every number");
        arguments.option("--turntable", values->turntable, {0, 100000},
                         "Frames of a full turn; --out names them, as in frame_%03d.png; 0: one picture");
        arguments.choice("--turn", values->turn, {"object", "environment"}, "What turns on the turntable");
        arguments.option("--exposure", picture.exposure, {-50, 50}, "STOPS", "Of the .png");
        arguments.choice("--tone", picture.toneCurve, {"clamp", "reinhard", "aces"}, "Curve of the .png");
        declareColours(arguments, picture.colours);
        arguments.option("--out", picture.out, "FILE", "x.png (sRGB) or x.exr (linear radiance); both may be given");
        arguments.required();
      },
      [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
