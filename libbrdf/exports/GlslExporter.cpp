#include <brdf/base/Text.h>
#include <brdf/exports/Approximation.h>
#include <brdf/exports/BuiltInExporters.h>

#include <algorithm>

namespace brdf {
namespace {

/// A GLSL literal of the float nearest to `value`.
std::string literal(double value) {
  std::string text = formatNumber(static_cast<double>(static_cast<float>(value)), 9);
  if (text.find_first_of(".eE") == std::string::npos) text += ".0";
  return text;
}

/// Names and values of a material's numbers, and the functions over them. A number of lobe l is called
/// <name>_<l>_<model>_<parameter>, followed by _<channel> where the channels differ; a scale factor
/// <name>_<l>_<model>_scale, of the type that the material's values have.
class Writer {
 public:
  Writer(const LobeSum& material, const ExportText& text) : material_(material), text_(text) {
    const Channels& channels = material.channels();
    count_ = channels.count();
    type_ = count_ == 1                            ? "float"
            : channels.kind == Channels::Kind::Rgb ? "vec3"
                                                   : "float[" + std::to_string(count_) + "]";
  }

  std::string file() const {
    std::string out = "// GLSL 3.30 core, without #version: put it after that line.\n";
    for (const std::string& line : text_.comments) out += "// " + line + "\n";
    out +=
        "//\n// Directions are unit vectors in the local frame: +z the normal, +x the tangent; wi to the light, wo to "
        "the\n"
        "// viewer. Values are f_r in 1/sr without the cosine, 0 below the horizon.\n"
        "//   " +
        type_ + " " + text_.name + "_evaluate(vec3 wi, vec3 wo)   value" + channelText() +
        "\n"
        "//   float " +
        text_.name +
        "_pdf(vec3 wi, vec3 wo)   density of sample drawing wi given wo, 1/sr\n"
        "//   vec3 " +
        text_.name +
        "_sample(vec3 wo, vec2 u)   light direction from two random numbers in [0, 1); "
        "vec3(0) fails\n\n";
    out += "#ifndef BRDFLAB_PRELUDE\n#define BRDFLAB_PRELUDE\n" + Model::glslPrelude() + "#endif\n\n";
    std::vector<std::string> done;
    for (const Lobe& lobe : material_.lobes()) {
      if (std::ranges::find(done, lobe.model->name()) != done.end()) continue;
      done.push_back(lobe.model->name());
      const std::string guard = "BRDFLAB_MODEL_" + lobe.model->name();
      out += "// " + lobe.model->title() + "\n#ifndef " + guard + "\n#define " + guard + "\n" + lobe.model->glsl() +
             "#endif\n\n";
    }
    return out + numbers() + evaluate() + pdf() + sample();
  }

 private:
  std::string channelText() const {
    if (material_.channels().kind == Channels::Kind::Rgb) return ", linear sRGB";
    if (count_ == 1) return "";
    std::vector<std::string> list;
    for (const double w : material_.channels().wavelengths) list.push_back(formatNumber(w));
    return ", one a wavelength (nm): " + joined(list);
  }

  std::string prefix(std::size_t lobe) const {
    return text_.name + "_" + std::to_string(lobe) + "_" + material_.lobes()[lobe].model->name() + "_";
  }
  std::string parameterName(std::size_t l, std::size_t p, std::size_t channel) const {
    const Lobe& lobe = material_.lobes()[l];
    return prefix(l) + lobe.model->parameters()[p].name +
           (lobe.parameters[p].size() == 1 ? "" : "_" + std::to_string(channel));
  }
  std::string arguments(std::size_t lobe, std::size_t channel) const {
    std::string list;
    for (std::size_t p = 0; p < material_.lobes()[lobe].parameters.size(); ++p)
      list += ", " + parameterName(lobe, p, channel);
    return list;
  }
  std::string call(std::size_t lobe, const char* suffix, const char* inputs, std::size_t channel) const {
    return "brdf_" + material_.lobes()[lobe].model->name() + suffix + "(" + inputs + arguments(lobe, channel) + ")";
  }

  /// A hard bound as a reader of the shader meets it.
  static double bound(const Parameter& parameter, double value) {
    return parameter.isLogarithmInShaders() ? static_cast<double>(parameter.shaderValue(value)) : value;
  }

  std::string numbers() const {
    const std::string keyword = text_.uniforms ? "uniform " : "const ";
    std::string out;
    for (std::size_t l = 0; l < material_.lobes().size(); ++l) {
      const Lobe& lobe = material_.lobes()[l];
      std::vector<std::string> scales;
      for (std::size_t c = 0; c < count_; ++c) scales.push_back(literal(lobe.scaleOf(c)));
      out += keyword + type_ + " " + prefix(l) +
             "scale = " + (count_ == 1 ? scales[0] : type_ + "(" + joined(scales) + ")") + ";\n";
      for (std::size_t p = 0; p < lobe.parameters.size(); ++p)
        for (std::size_t c = 0; c < lobe.parameters[p].size(); ++c) {
          const Parameter& parameter = lobe.model->parameters()[p];
          out += keyword + "float " + parameterName(l, p, c) + " = " +
                 literal(parameter.shaderValue(lobe.parameters[p][c])) + ";  // " +
                 (parameter.isLogarithmInShaders() ? "logarithm of the " : "") +
                 (parameter.label.empty() ? parameter.name : parameter.label) + ", " +
                 formatNumber(bound(parameter, parameter.minimum)) + " to " +
                 formatNumber(bound(parameter, parameter.maximum)) +
                 (parameter.unit == "1" ? "" : " " + parameter.unit) + "\n";
        }
    }
    return out + "\n";
  }

  std::string evaluate() const {
    std::string out = type_ + " " + text_.name + "_evaluate(vec3 wi, vec3 wo) {\n";
    const bool list = count_ != 1 && type_ != "vec3";
    out += "  " + type_ + " value";
    if (list) {
      out += ";\n  for (int c = 0; c < " + std::to_string(count_) + "; ++c) value[c] = 0.0;\n";
    } else {
      out += " = " + type_ + "(0.0);\n";
    }
    for (std::size_t l = 0; l < material_.lobes().size(); ++l) {
      const std::string scale = prefix(l) + "scale";
      const bool shared = material_.lobes()[l].channelIndependent();
      const auto shape = [&](std::size_t c) { return call(l, "", "wi, wo", c); };
      if (!list && (shared || count_ == 1)) {
        out += "  value += " + scale + " * " + shape(0) + ";\n";
      } else if (!list) {
        out += "  value += " + scale + " * vec3(" + shape(0) + ",\n    " + shape(1) + ",\n    " + shape(2) + ");\n";
      } else if (shared) {
        out += "  {\n    float shape = " + shape(0) + ";\n    for (int c = 0; c < " + std::to_string(count_) +
               "; ++c) value[c] += " + scale + "[c] * shape;\n  }\n";
      } else {
        for (std::size_t c = 0; c < count_; ++c) {
          const std::string index = "[" + std::to_string(c) + "]";
          out += "  value" + index + " += " + scale + index + " * " + shape(c) + ";\n";
        }
      }
    }
    return out + "  return value;\n}\n\n";
  }

  std::string pdf() const {
    std::string out = "float " + text_.name + "_pdf(vec3 wi, vec3 wo) {\n  float density = 0.0;\n";
    for (const LobeSum::Component& c : material_.components())
      out += "  density += " + literal(c.weight) + " * " + call(c.lobe, "_pdf", "wi, wo", c.channel) + ";\n";
    return out + "  return density;\n}\n\n";
  }

  /// The first number chooses the component and, stretched, serves again.
  std::string sample() const {
    std::string out = "vec3 " + text_.name + "_sample(vec3 wo, vec2 u) {\n";
    double below = 0;
    const auto& components = material_.components();
    for (std::size_t k = 0; k < components.size(); ++k) {
      const LobeSum::Component& c = components[k];
      const std::string draw = call(c.lobe, "_sample", "wo, u", c.channel);
      if (c.weight <= 0 && k + 1 < components.size()) continue;
      const double weight = k + 1 == components.size() ? 1 - below : c.weight;
      const std::string stretched =
          "u.x = clamp((u.x - " + literal(below) + ") / " + literal(std::max(weight, 1e-30)) + ", 0.0, 0.99999994);";
      if (k + 1 == components.size())
        out += "  " + stretched + "\n  return " + draw + ";\n}\n";
      else
        out += "  if (u.x < " + literal(below + weight) + ") {\n    " + stretched + "\n    return " + draw + ";\n  }\n";
      below += weight;
    }
    return out;
  }

  const LobeSum& material_;
  const ExportText& text_;
  std::size_t count_;
  std::string type_;
};

}  // namespace

Exporter glslExporter() {
  Exporter exporter;
  exporter.name = "glsl";
  exporter.title = "GLSL functions";
  exporter.extension = ".glsl";
  exporter.spectral = true;
  exporter.refusal = [](const LobeSum&) { return std::string(); };
  exporter.approximate = [](const Brdf& target, const FitOptions& options) {
    return nearest(
        target, options,
        {fitLobes(target, "Lambertian + GGX", options), fitLobes(target, "Lambertian + GGX + GGX", options)});
  };
  exporter.write = [](const LobeSum& material, const ExportText& text) { return Writer(material, text).file(); };
  return exporter;
}

}  // namespace brdf
