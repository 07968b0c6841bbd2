#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/LobeSum.h>

#include <memory>
#include <string>
#include <string_view>

namespace brdf {

// Our XML of an analytic material:
//
//   <material version="1" channels="rgb">                        or "monochrome", or "spectral" with wavelengths="400
//   ..."
//     <lobe model="GGX">
//       <scale>0.04 0.03 0.02</scale>                            one number, or one a channel; 1 when left out
//       <parameter name="alpha">0.2</parameter>                  likewise; the model's default when left out
//     </lobe>
//   </material>
//
// Wavelengths are nanometres; models are those of `brdf models`, composed ones included. Numbers read back exactly.

/// Throws Error::Kind::Format with `where`, and what LobeSum throws for values out of bounds.
BRDF_EXPORT std::shared_ptr<const LobeSum> readMaterialXml(std::string_view text, const std::string& where);
BRDF_EXPORT std::string writeMaterialXml(const LobeSum& material);

}  // namespace brdf
