#include "Arguments.h"
#include "Assumptions.h"
#include "Commands.h"
#include "Output.h"
#include "Pictures.h"
#include "Progress.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Parallel.h>
#include <brdf/base/Text.h>
#include <brdf/check/Check.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/material/LobeSum.h>
#include <brdf/models/Microfacet.h>
#include <brdf/models/Registry.h>
#include <brdf/sampling/DirectionalAlbedo.h>
#include <brdf/sampling/SampledBrdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

struct Values {
  std::vector<std::string> materials;
  bool all = false, noGlsl = false;
  std::string size, out;
  CheckOptions options;
};

/// A model (by its name or its file) or a material.
struct Subject {
  std::string name;
  ModelPointer model;
  BrdfPointer material;

  /// The material's lobes; null for a model and for measured data.
  const LobeSum* lobes() const { return dynamic_cast<const LobeSum*>(material.get()); }
  bool hasShader() const { return model || lobes(); }
};

bool isModelFile(const std::string& path) {
  if (!path.ends_with(".xml") || !std::filesystem::is_regular_file(path)) return false;
  const std::string text = readFile(path);
  return text.find("<model ") != std::string::npos || text.find("<AnalyticBRDFModel") != std::string::npos;
}

Subject subjectOf(const std::string& text) {
  for (const ModelPointer& model : allModels())
    if (model->name() == text) return {text, model, nullptr};
  if (isModelFile(text)) return {text, readModelFile(text), nullptr};
  return {text, nullptr, loadMaterial(text, assumptions()).brdf};
}

/// Runs GLSL, or says once why that is impossible.
class Shaders {
 public:
  explicit Shaders(bool wanted) {
    if (!wanted) {
      reason_ = "left out on request";
      return;
    }
    try {
      run_ = pictures().shaderProbe();
    } catch (const Error& error) {
      reason_ = error.what();
    }
  }
  /// Of a subject that has a shader.
  std::vector<Check> checks(const Subject& subject, const CheckOptions& options) const {
    if (!run_) return {{"glsl", true, 0, 1, {}, "skipped: " + reason_}};
    try {
      if (subject.model) return {checkGlsl(*subject.model, run_, options)};
      return checkGlsl(*subject.lobes(), run_, options);
    } catch (const Error& error) {
      return {{"glsl", false, std::numeric_limits<double>::infinity(), 1, {}, error.what()}};
    }
  }

 private:
  GlslRunner run_;
  std::string reason_;
};

/// Every registered model, and a composed one of each distribution.
std::vector<ModelPointer> modelsToCheck() {
  std::vector<ModelPointer> models = allModels();
  for (const std::string& distribution : microfacetTerms().distributions)
    models.push_back(composeMicrofacet(distribution, "Schlick", "Smith"));
  return models;
}

Audit audit(const Subject& subject, const CheckOptions& options) {
  return subject.model ? checkModel(*subject.model, options) : checkMaterial(subject.material, subject.name, options);
}

std::string limit(double value) { return std::isinf(value) ? "any" : number(value); }

void print(const Output& output, const std::vector<Audit>& audits) {
  TextTable table({"model", "check", "", "worst", "allowed", "where"});
  for (const Audit& audit : audits)
    for (const Check& check : audit.checks) {
      const std::string where = check.note.empty() ? check.at : check.note + (check.at.empty() ? "" : "; " + check.at);
      table.row({audit.name, check.name,
                 !check.passed    ? "FAILED"
                 : check.declared ? "declared"
                                  : "ok",
                 number(check.worst), limit(check.allowed), check.passed && check.note.empty() ? "" : where});
    }
  output.line(table.text());
}

Json reportOf(const std::vector<Audit>& audits) {
  Json models = Json::array();
  for (const Audit& audit : audits) {
    Json checks = Json::array();
    for (const Check& check : audit.checks)
      checks.push_back({{"name", check.name},
                        {"passed", check.passed},
                        {"worst", check.worst},
                        {"at", check.at},
                        {"allowed", check.allowed},
                        {"declared", check.declared},
                        {"note", check.note}});
    models.push_back({{"name", audit.name}, {"checks", checks}, {"kind", audit.kind}, {"passed", audit.passed()}});
  }
  return {{"models", models}};
}

std::string channelName(const Channels& channels, std::size_t index) {
  if (channels.kind == Channels::Kind::Spectral) return number(channels.wavelengths[index]) + " nm";
  return channels.kind == Channels::Kind::Rgb ? std::array{"red", "green", "blue"}[index] : "all light";
}

/// The directional albedo at every third degree, at most three channels of it across the spectrum.
AlbedoCurves albedoOf(const Subject& subject) {
  BrdfPointer brdf = subject.material;
  if (subject.model) {
    Lobe lobe{subject.model, {}, {1.0}};
    for (const double value : subject.model->defaults()) lobe.parameters.push_back({value});
    brdf = std::make_shared<LobeSum>(std::vector{lobe}, Channels::monochrome());
  }
  const BrdfPointer sampled = withSampler(brdf);
  const std::size_t count = brdf->channels().count(), step = count <= 3 ? 1 : (count - 1) / 2;
  AlbedoCurves curves;
  for (std::size_t c = 0; c < count; c += step) {
    curves.channels.push_back(channelName(brdf->channels(), c));
    curves.values.emplace_back();
  }
  for (double degrees = 0; degrees < 90; degrees += degrees < 84 ? 3 : 1) {
    curves.degrees.push_back(degrees);
    const Albedo albedo = directionalAlbedo(*sampled, radians(degrees), 4096);
    for (std::size_t k = 0; k < curves.values.size(); ++k) curves.values[k].push_back(albedo.value[k * step]);
  }
  return curves;
}

void draw(const std::vector<Audit>& audits, const Subject& first, const Values& values) {
  AuditPicture picture{audits, {}, {}, values.out};
  if (audits.size() == 1) picture.albedo = albedoOf(first);
  // A matrix needs room for its rows.
  picture.size = !values.size.empty() ? sizeOption(values.size)
                 : audits.size() == 1 ? PictureSize{1000, 1000}
                                      : PictureSize{1400, std::min<std::size_t>(8192, 300 + 24 * audits.size())};
  pictures().audit(picture);
}

void run(const Output& output, const Values& values) {
  if (!values.out.empty()) checkPictureOutputs({values.out}, {".png"});

  if (values.all != values.materials.empty())
    throw Error(Error::Kind::Usage,
                {"nothing to check, or too much", "brdf check",
                 std::to_string(values.materials.size()) + " materials" + (values.all ? " and --all" : ""),
                 "one or more materials, or --all"});
  std::vector<Subject> subjects;
  for (const std::string& text : values.materials) subjects.push_back(subjectOf(text));
  if (values.all)
    for (const ModelPointer& model : modelsToCheck()) subjects.push_back({model->name(), model, nullptr});

  Progress progress(output, "check");
  std::vector<std::optional<Audit>> done(subjects.size());
  std::size_t count = 0;
  std::mutex mutex;
  parallelFor(subjects.size(), 1, [&](std::size_t k, std::size_t) {
    if (interrupted()) return;
    Audit result = audit(subjects[k], values.options);
    const std::lock_guard lock(mutex);
    done[k] = std::move(result);
    progress.update(++count, subjects.size(), subjects[k].name);
  });
  // One OpenGL context, one thread.
  const bool any = std::ranges::any_of(subjects, [](const Subject& one) { return one.hasShader(); });
  const Shaders shaders(any && !values.noGlsl);
  std::vector<Audit> audits;
  std::size_t checks = 0, failed = 0;
  for (std::size_t k = 0; k < subjects.size(); ++k) {
    if (!done[k]) continue;
    if (subjects[k].hasShader() && !interrupted()) {
      for (Check& check : shaders.checks(subjects[k], values.options)) done[k]->checks.push_back(std::move(check));
      progress.update(k + 1, subjects.size(), subjects[k].name + ", GLSL");
    }
    checks += done[k]->checks.size();
    for (const Check& check : done[k]->checks) failed += !check.passed;
    audits.push_back(std::move(*done[k]));
  }
  print(output, audits);
  output.report(reportOf(audits));
  if (!values.out.empty() && !audits.empty()) draw(audits, subjects.front(), values);
  if (failed > 0)
    throw Error(Error::Kind::Value,
                {"checks failed", "brdf check", std::to_string(failed) + " of " + std::to_string(checks), "none"});
  if (audits.size() < subjects.size())
    throw Error(Error::Kind::Value, {"stopped on request", "brdf check", std::to_string(audits.size()) + " audited",
                                     "all " + std::to_string(subjects.size())});
  output.line(std::to_string(checks) + " checks, none failed");
}

}  // namespace

Command checkCommand() {
  const auto values = std::make_shared<Values>();
  return {"check", "Audit models and materials: digits, reciprocity, energy, samplers, derivatives, GLSL",
          "  brdf check Lambertian\n  brdf check \"0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)\"",
          [values](Arguments& arguments) {
            arguments.positionals("MATERIAL", values->materials,
                                  "A model by its name or its file, a file of data, an expression or preset:NAME");
            arguments.optional();
            arguments.flag("--all", values->all, "Every model, and Microfacet of each distribution");
            arguments.flag("--no-glsl", values->noGlsl, "Leave out the comparison of GLSL with the processor");
            arguments.option("--out", values->out, "FILE",
                             "x.png: models by checks; for one, its checks and its directional albedo");
            arguments.option("--size", values->size, "WxH", "Pixels of the picture [room for every row]");
            arguments.option("--effort", values->options.effort, {0.1, 1000}, "FACTOR",
                             "Times as many directions, parameters and draws");
          },
          [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
