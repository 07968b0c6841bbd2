#pragma once
#include <brdf/brdf_export.h>
#include <brdf/models/Model.h>

#include <filesystem>
#include <vector>

namespace brdf {

/// Registers a model of the caller's own. Throws Error::Kind::Value when the name is taken by a built-in one; replaces
/// a model registered before under the same name.
BRDF_EXPORT void registerModel(ModelPointer model);

/// Registers every *.xml file of a folder: models in our format (models/FormulaModel.h), and model files of BRDFLab
/// 0.8.2 (root element AnalyticBRDFModel), which get the prefix "BRDFLab082". Formulas are compiled at once, so that a
/// mistake shows here. Throws Error::Kind::File when the folder cannot be read, and what the first bad file throws.
/// Returns the names registered.
BRDF_EXPORT std::vector<std::string> loadModelFolder(const std::filesystem::path& folder);

/// One such file; returns the model without registering it.
BRDF_EXPORT ModelPointer readModelFile(const std::filesystem::path& file);

/// Folders searched without being asked, in order: those of BRDFLAB_MODEL_PATH (separated by ':'), then
/// $XDG_DATA_HOME/brdflab/models (default ~/.local/share/brdflab/models). Those that do not exist are left out.
BRDF_EXPORT std::vector<std::filesystem::path> userModelFolders();

/// Why models of userModelFolders() were left out, one line each. The folders are read when the first model is asked
/// for, in every program that uses the library.
BRDF_EXPORT const std::vector<std::string>& userModelFailures();

}  // namespace brdf
