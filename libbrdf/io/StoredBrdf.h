#pragma once
#include <brdf/io/Hdf5.h>
#include <brdf/material/Brdf.h>

#include <string>

namespace brdf {

/// Writes a BRDF into an empty group, losslessly, and says as what:
/// "analytic"  a LobeSum: channels, and each lobe's model, scale factors and parameters by name;
/// "table"     a TableBrdf: a VTKHDF ImageData (attributes Version, Type, WholeExtent, Origin, Spacing, Direction;
///             point arrays value_0, value_1, ... one a channel, and valid: a CellState each), plus the axes' meaning;
/// "grid"      a GridBrdf (io/StoredGrid.h);
/// "patches"   a PatchBrdf, "tree" a TreeBrdf (io/StoredPatches.h);
/// "scattered" anything else that has samples: wi and wo (count x 3), value_0, value_1, ..., valid; error_0,
///             error_1, ... where uncertainties are known (what kind, the provenance says).
/// Throws Error::Kind::Value for a BRDF that is none of these.
std::string storeBrdf(const h5::Group& group, const Brdf& brdf);

/// Reads back what storeBrdf wrote as `kind`; `description` is that of measured data. Throws Error::Kind::Format where
/// the group breaks the layout, and Error::Kind::Value for an unknown model or a parameter out of its bounds.
BrdfPointer restoreBrdf(const h5::Group& group, const std::string& kind, const std::string& description);

}  // namespace brdf
