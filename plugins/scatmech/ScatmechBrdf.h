#pragma once
#include <brdf/material/Brdf.h>

#include <string_view>

namespace scatmech {

/// A model of SCATMECH as a BRDF, exact: nothing is tabulated. Its directions by SCATMECH's own definition (User's
/// guide, "Conventions"): theta_i, theta_s from the normal; phi_s from the forward direction, so that the mirror
/// direction has phi_s = 0; rotation of the sample -phi_i. Polarisation in the basis {s, p} of each direction.
///
/// A value that is not finite (a fractal spectrum at the mirror direction) is no value: invalid. One thread at a time
/// is inside SCATMECH.
brdf::BrdfPointer scatmechBrdf(std::string_view arguments);

}  // namespace scatmech
