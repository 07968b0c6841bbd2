#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>

#include <cstdint>
#include <string_view>

namespace brdf {

/// Where the value of an invalid cell comes from.
enum class FillMethod {
  None,         ///< "none": nowhere, holes stay
  Reciprocity,  ///< "reciprocity": the pair with light and viewer exchanged, interpolated
  Symmetry,     ///< "symmetry": the mirror image of the pair (y of both directions negated), interpolated
  Nearest,      ///< "nearest": the valid cell that is the fewest steps along the axes away
  Model         ///< "model": a BRDF, given
};
/// The method called so. Throws Error::Kind::Value with the known ones.
BRDF_EXPORT FillMethod fillMethod(std::string_view name);

struct FilledBrdf {
  BrdfPointer brdf;
  std::uint64_t filled = 0;     ///< cells that were invalid and are now Extrapolated
  std::uint64_t remaining = 0;  ///< cells above the horizon that are invalid still
};

/// A table or grid whose invalid cells above the horizon are filled and marked Extrapolated; measured ones stay as they
/// are, and cells below the horizon stay invalid. Values are taken from measured cells only
/// (material/ValueOrigins.h): nothing is filled from what was filled. A table or grid that is
/// reciprocal by itself has nothing to gain from Reciprocity, nor a mirrored one from Symmetry. `model` is needed for
/// Model, with as many channels as the data. Throws Error::Kind::Value for a BRDF without cells, and for a model that
/// is missing or does not fit.
BRDF_EXPORT FilledBrdf fillHoles(const BrdfPointer& brdf, FillMethod method, const Brdf* model = nullptr);

}  // namespace brdf
