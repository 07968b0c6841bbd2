#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>
#include <brdf/measured/Format.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

struct LoadedMaterial {
  BrdfPointer brdf;
  std::string kind;         ///< "expression", "preset", "material" (XML), "measured", "container", or a registered one
  ReadReport report;        ///< of a file: what its reader noticed; else format and source only
  Components components{};  ///< what the material has besides `brdf`: of files, containers, and kinds that say so
};

/// The material that `spec` means, written the same way everywhere:
/// - a file in any supported format, recognised by content; of a `.vtkhdf` file with several entries the first;
/// - `file#3` or `file#name`: one of several, by its number from 0 or its name;
/// - `preset:NAME`: a shipped published fit;
/// - `NAME:ARGUMENTS` of a kind registered from outside (registerMaterialKind);
/// - else a material expression (material/LobeSum.h).
/// An existing file wins over an expression. What looks like a path (has a '/', or ends with an extension) but is no
/// file is Error::Kind::File "no such file". Throws the reader's or the expression's errors otherwise.
///
/// `options` are what the user says of measured files; expressions and presets have no use for them, and the entries of
/// a container keep what was assumed when they were made (a warning says so).
BRDF_EXPORT LoadedMaterial loadMaterial(std::string_view spec, const ReadOptions& options = {});

/// A parameter of a model that a kind of materials offers, for listings.
struct MaterialParameter {
  std::string name;                    ///< "psd.A": of the model that the parameter `psd` chooses
  std::string type;                    ///< in a word
  std::string value;                   ///< as it would be used: the default where nothing is given
  std::string description;             ///< with its unit
  std::vector<std::string> choices{};  ///< what it may be, where it is a choice
};
struct MaterialModel {
  std::string name, title;
  std::vector<MaterialParameter> parameters{};
};

/// A kind of material of someone's own, written `name:arguments`: a BRDF class in C++, a simulation, a data base.
struct MaterialKind {
  std::string name;   ///< letters, digits, '_' and '-', at least two; not "preset"
  std::string title;  ///< one line, with the form of the arguments
  std::function<BrdfPointer(std::string_view arguments)> make;  ///< throws brdf::Error
  /// Where the arguments name one of several models: all of them, without their parameters; and one with them, as the
  /// arguments choose (`brdf plugins scatmech:Model`). May be null; throw brdf::Error.
  std::function<std::vector<MaterialModel>()> models{};
  std::function<MaterialModel(std::string_view arguments)> describe{};
  /// What a material that `make` made has besides, a specular part for example. May be null.
  std::function<Components(const Brdf& brdf)> components{};
};
/// Adds a kind; replaces one of the same name. Throws Error::Kind::Value for a name that is none.
BRDF_EXPORT void registerMaterialKind(MaterialKind kind);
BRDF_EXPORT const std::vector<MaterialKind>& materialKinds();

}  // namespace brdf
