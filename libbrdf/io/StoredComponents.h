#pragma once
#include <brdf/io/Hdf5.h>
#include <brdf/material/Components.h>

namespace brdf {

/// Writes the components of a material into an entry's group; nothing when there are none. Group Components:
/// Scatter/0, 1, ... (Component, Kind, Description and the BRDF as io/StoredBrdf.h says); Specular/0, 1, ... and
/// Totals/0, 1, ... (Component, theta_i in radians, values).
void storeComponents(const h5::Group& entry, const Components& components);
Components restoreComponents(const h5::Group& entry);

}  // namespace brdf
