#pragma once
#include <brdf/io/Hdf5.h>
#include <brdf/material/PatchBrdf.h>
#include <brdf/material/TreeBrdf.h>

#include <string>

namespace brdf {

/// Writes a matrix of patches into an empty group, losslessly: groups Incident and Outgoing with Name, UpperTheta
/// (radians) and Counts of the rings; value_0, value_1, ... (1/sr), outgoing x incident patches; Channels.
void storePatches(const h5::Group& group, const PatchBrdf& patches);
BrdfPointer restorePatches(const h5::Group& group, const std::string& description);

/// Writes a tensor tree into an empty group, losslessly: Rank; Channels; branches, one byte a node, 1 for a branch and
/// 0 for a cell, a node before its children; value_0, value_1, ... (1/sr), one a cell in that order.
void storeTree(const h5::Group& group, const TreeBrdf& tree);
BrdfPointer restoreTree(const h5::Group& group, const std::string& description);

}  // namespace brdf
