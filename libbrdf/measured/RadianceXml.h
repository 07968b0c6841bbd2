#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Averages.h>
#include <brdf/material/Components.h>
#include <brdf/measured/Format.h>

#include <filesystem>

namespace brdf {

/// How the writer of Radiance / WINDOW XML makes what it is given.
struct RadianceWriteOptions {
  enum class Structure {
    Keep,    ///< trees as trees, matrices of patches as they are, all else as Matrix
    Matrix,  ///< a matrix over `basis`
    Tree     ///< a tensor tree: rank 3 for isotropic BRDFs, 4 for others
  };
  Structure structure = Structure::Keep;
  PatchBasis basis = PatchBasis::klemsFull();
  PatchAverageOptions patches{};
  TreeAverageOptions tree{};
};

/// Writes a material as Radiance / WINDOW6 XML (RadianceFormat.cpp says what that is): its front reflection, null where
/// it has none, and the distributions of `components`. The IncidentDataStructure of a file holds for all: that of the
/// first distribution counts. Writes to `path` as given. Throws Error::Kind::Value without any distribution.
BRDF_EXPORT WriteReport writeRadiance(const Brdf* front, const Components& components,
                                      const std::filesystem::path& path, const RadianceWriteOptions& options = {});

}  // namespace brdf
