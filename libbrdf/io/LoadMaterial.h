#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>
#include <brdf/measured/Format.h>

#include <string>
#include <string_view>

namespace brdf {

struct LoadedMaterial {
  BrdfPointer brdf;
  std::string kind;         ///< "expression", "preset", "material" (XML), "measured" or "container"
  ReadReport report;        ///< of a file: what its reader noticed; else format and source only
  Components components{};  ///< of measured files and containers: what the material has besides `brdf`
};

/// The material that `spec` means, written the same way everywhere:
/// - a file in any supported format, recognised by content; of a `.vtkhdf` file with several entries the first;
/// - `file#3` or `file#name`: one of several, by its number from 0 or its name;
/// - `preset:NAME`: a shipped published fit;
/// - else a material expression (material/LobeSum.h).
/// An existing file wins over an expression. What looks like a path (has a '/', or ends with an extension) but is no
/// file is Error::Kind::File "no such file". Throws the reader's or the expression's errors otherwise.
///
/// `options` are what the user says of measured files; expressions and presets have no use for them, and the entries of
/// a container keep what was assumed when they were made (a warning says so).
BRDF_EXPORT LoadedMaterial loadMaterial(std::string_view spec, const ReadOptions& options = {});

}  // namespace brdf
