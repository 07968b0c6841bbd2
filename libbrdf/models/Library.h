#pragma once
#include <brdf/brdf_export.h>
#include <brdf/formula/Parser.h>
#include <brdf/models/Parameter.h>

#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// A function of the formula language that models share: a distribution D, a Fresnel term F, a visibility term V.
struct LibraryFunction {
  formula::Function function;
  std::string title;
  std::vector<Reference> references;
};

/// How a lobe draws directions: two formulas, one that assigns wx, wy, wz from random1, random2 and wo, one for the
/// density.
struct Sampler {
  std::string name;
  std::vector<std::string> arguments;
  std::string draw;
  std::string density;
  std::string title;
  std::vector<Reference> references;
};

/// The functions embedded in the library (models/functions/*.xml).
BRDF_EXPORT const std::vector<LibraryFunction>& libraryFunctions();
BRDF_EXPORT const formula::FunctionTable& functionTable();
/// Precomputed functions that formulas may call (models/tables/*.xml).
BRDF_EXPORT const formula::TableMap& tableMap();
/// The functions of muParser 1.30 that ours spell otherwise or lack, for model files of BRDFLab 0.8.2.
BRDF_EXPORT const formula::FunctionTable& legacyFunctionTable();

/// The samplers embedded in the library (models/samplers/*.xml).
BRDF_EXPORT const std::vector<Sampler>& samplers();
/// The sampler called `name` ; throws Error::Kind::Value with the allowed names.
BRDF_EXPORT const Sampler& findSampler(std::string_view name, const std::string& where);

}  // namespace brdf
