#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/LobeSum.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// A fit kept in a file of BRDFLab 0.8.2.
struct BrdfLabFitting {
  std::string name;
  std::shared_ptr<const LobeSum> material;
  double error = 0;  ///< as that program computed it: the sum of squares over its own samples
  std::string optimizer = "none";
  bool readOnly = false;
};

/// A BRDF or fitting file of BRDFLab 0.8.2 (root element BRDF): an original, and fits of it.
struct BrdfLabFile {
  std::string name;  ///< of the original
  std::string type;  ///< "Analytic", "MERLBRDFDatabase", "CarPaintBRDFDatabase", or a simulation's
  std::shared_ptr<const LobeSum> analytic;  ///< the original where its type is Analytic, else null
  std::string path, url;                    ///< of a measured original, as the file says
  std::vector<BrdfLabFitting> fittings;
  std::vector<std::string> notes;  ///< what was noticed while reading, one sentence each
};

/// Reads such a file. Its lobes become ours with the same values: a Lambertian value v is f = v, pi v times our lobe of
/// albedo 1; Lafortune lobes take that program's normalisation into their scale; the others are our lobes
/// "BRDFLab082...", or models loaded from that program's model files. Accepted: attributes optimizer and optimizerName,
/// text that a browser left in front of elements, a missing name, missing parameters (their defaults). Throws
/// Error::Kind::Format.
BRDF_EXPORT BrdfLabFile readBrdfLabXml(std::string_view text, const std::string& where);

/// Writes one, with the combination Fixed where no lobe needs a scale factor, else Linear. Throws Error::Kind::Value
/// for a lobe that the dialect does not know, and for spectral channels.
BRDF_EXPORT std::string writeBrdfLabXml(const BrdfLabFile& file);

}  // namespace brdf
