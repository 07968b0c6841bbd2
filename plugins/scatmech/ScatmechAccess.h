#pragma once
// The one door to SCATMECH: standard C++17 on this side, SCATMECH's headers on the other.
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace scatmech {

/// What SCATMECH refuses, or would silently take for 0, in one line.
struct Failure : std::runtime_error {
  Failure(const std::string& what, std::string whatFound = {}, std::vector<std::string> whatAllowed = {})
      : std::runtime_error(what), found(std::move(whatFound)), allowed(std::move(whatAllowed)) {}
  std::string found;
  std::vector<std::string> allowed;
};

struct ParameterFacts {
  std::string name, type, value, description;
  std::vector<std::string> choices;
};
struct ModelFacts {
  std::string name, description;
};

/// SCATMECH keeps tables of its last results in static variables that it guards only where it was built so: one thread
/// at a time may be inside it, whichever model it asks. Whoever calls what follows holds this.
std::mutex& inside();

/// Every BRDF model that can be made, in alphabetical order.
std::vector<ModelFacts> allModels();

class Model {
 public:
  explicit Model(const std::string& name);
  ~Model();
  Model(Model&&) noexcept;
  Model& operator=(Model&&) noexcept;

  const std::string& description() const;
  /// The tree, as it is: the choices made first, then their own parameters as "psd.A".
  std::vector<ParameterFacts> parameters() const;
  void set(const std::string& parameter, const std::string& text);
  void setWavelength(double micrometres);
  /// Mueller matrix, row by row, in the basis {s, p}; angles in radians.
  void mueller(double thetaI, double thetaS, double phiS, double rotation, double* m);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace scatmech
