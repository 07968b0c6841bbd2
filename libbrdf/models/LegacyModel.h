#pragma once
#include <brdf/models/Model.h>

#include <string>
#include <string_view>

namespace brdf {

/// A model file of BRDFLab 0.8.2 (root element AnalyticBRDFModel) as a record of ours, under the name
/// "BRDFLab082<name>". Its equation is read in that program's dialect: `log` is the logarithm to base 10
/// (muParser 1.30), azimuths lie in (0, 2 pi]. Its GLSL, pdf and sampler texts are left aside: they disagree with the
/// equation in most shipped files. Declared bounds are kept, unphysical as they are, in the order given.
std::string translateLegacyModel(std::string_view xml, const std::string& where);

/// Whether the text looks like such a file.
bool isLegacyModel(std::string_view xml);

}  // namespace brdf
