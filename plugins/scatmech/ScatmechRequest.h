#pragma once
#include "ScatmechAccess.h"

#include <brdf/base/Call.h>
#include <brdf/base/Error.h>
#include <brdf/io/LoadMaterial.h>

#include <string>
#include <string_view>
#include <vector>

namespace scatmech {

/// What the text of a material says: "Model_Name(lambda=0.532, substrate=(1.5,0), psd=ABC_PSD_Function, psd.A=0.01)".
struct Request {
  std::string model;
  std::vector<brdf::Call::Argument> parameters;  ///< of the model, those of outer ones before those inside them
  std::vector<double> wavelengths;               ///< micrometres; empty: the model's default
  bool rgb = false;
  std::string incident = "unpolarized", detected = "all", element;
  brdf::Symmetry symmetry = brdf::Symmetry::Anisotropic;
};

/// Throws brdf::Error for text that is none; nothing is asked of SCATMECH yet.
Request parseRequest(std::string_view text);

/// The model with its parameters, at a wavelength in micrometres (0: the model's default). Throws brdf::Error. To be
/// called with inside() locked.
Model makeModel(const Request& request, double wavelength);

/// As the error of the library, in one line.
brdf::Error errorOf(const Failure& failure, const std::string& where);

/// For listings: every model, and one with the parameters that `text` gives it.
std::vector<brdf::MaterialModel> listModels();
brdf::MaterialModel describeModel(std::string_view text);

}  // namespace scatmech
