#pragma once
#include <brdf/brdf_export.h>

#include <string>
#include <vector>

namespace brdf {

/// One parameter of a model: a record that fitting, sliders, the command line and the documentation all read.
struct BRDF_EXPORT Parameter {
  enum class Scale { Linear, Logarithmic };

  std::string name;         ///< identifier in the equation and in material expressions, e.g. "alpha"
  std::string label;        ///< a few words for user interfaces, e.g. "roughness"
  std::string symbol;       ///< as the paper writes it
  std::string unit;         ///< "1" for a pure number, else "rad", "um", ...
  std::string description;  ///< one sentence
  double defaultValue = 0;
  double minimum = 0;  ///< hard bounds, inclusive: the model is finite and non-negative everywhere inside
  double maximum = 1;
  double softMinimum = 0;  ///< the range in which real materials lie: sliders and multi-start use it
  double softMaximum = 1;
  /// Name of the parameter whose value this one takes when it is not given (ay follows ax: isotropic unless asked
  /// otherwise), or empty. A fit ties the two unless told to free them.
  std::string follows;
  Scale scale = Scale::Linear;  ///< Logarithmic: positive, fitted and scanned in the logarithm

  /// Shaders hold parameters in float. One whose hard bounds float cannot hold (1e300) is handed to them as its natural
  /// logarithm, which a model's GLSL then expects.
  bool isLogarithmInShaders() const;
  /// What a shader is given for `value`.
  float shaderValue(double value) const;
};

/// Where a formula comes from.
struct Reference {
  std::string authors;
  int year = 0;
  std::string title;
  std::string venue;
  std::string doi;
  std::string equations;  ///< equation numbers used, e.g. "(33), (34)"
};

}  // namespace brdf
