#include "ScatmechBrdf.h"

#include "ScatmechRequest.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace scatmech {
namespace {

using Stokes = std::array<double, 4>;
/// (Is + Ip, Is - Ip, I(s+p) - I(s-p), Ilcp - Ircp): SCATMECH's order.
const std::array<std::pair<std::string, Stokes>, 6> kStates = {{{"s", {1, 1, 0, 0}},
                                                                {"p", {1, -1, 0, 0}},
                                                                {"s+p", {1, 0, 1, 0}},
                                                                {"s-p", {1, 0, -1, 0}},
                                                                {"lcp", {1, 0, 0, 1}},
                                                                {"rcp", {1, 0, 0, -1}}}};

/// The state called `name`; `plain` is the name of none.
Stokes stateOf(const std::string& name, const std::string& plain, const std::string& where) {
  std::vector<std::string> names = {plain};
  if (name == plain) return {1, 0, 0, 0};
  for (const auto& [known, state] : kStates) {
    if (known == name) return state;
    names.push_back(known);
  }
  throw brdf::Error(brdf::Error::Kind::Value,
                    {"unknown state of polarisation", "scatmech, " + where, "'" + name + "'", brdf::joined(names)});
}

class ScatmechBrdf final : public brdf::Brdf {
 public:
  explicit ScatmechBrdf(std::string_view text) : text_(text), request_(parseRequest(text)) {
    incident_ = stateOf(request_.incident, "unpolarized", "incident");
    analyser_ = stateOf(request_.detected, "all", "detected");
    if (request_.detected != "all")
      for (double& part : analyser_) part /= 2;  // what passes an analyser of that state
    if (const std::string& element = request_.element; !element.empty()) {
      const bool good = element.size() == 3 && element[0] == 'm' && element[1] >= '0' && element[1] <= '3' &&
                        element[2] >= '0' && element[2] <= '3';
      if (!good)
        throw brdf::Error(brdf::Error::Kind::Value, {"unknown element of the Mueller matrix", "scatmech, element",
                                                     "'" + element + "'", "m00 to m33"});
      incident_ = analyser_ = {};
      analyser_[static_cast<std::size_t>(element[1] - '0')] = 1;
      incident_[static_cast<std::size_t>(element[2] - '0')] = 1;
    }
    const std::lock_guard lock(inside());
    if (request_.wavelengths.size() <= 1) {
      models_.push_back(makeModel(request_, request_.wavelengths.empty() ? 0 : request_.wavelengths[0]));
      channels_ = brdf::Channels::monochrome();
      return;
    }
    std::vector<double> nanometres;
    for (const double wavelength : request_.wavelengths) {
      models_.push_back(makeModel(request_, wavelength));
      nanometres.push_back(1000 * wavelength);
    }
    channels_ = request_.rgb ? brdf::Channels::rgb() : brdf::Channels::spectral(std::move(nanometres));
  }
  ~ScatmechBrdf() override {
    const std::lock_guard lock(inside());
    models_.clear();
  }

  const brdf::Channels& channels() const override { return channels_; }
  brdf::Symmetry symmetry() const override { return request_.symmetry; }
  bool reciprocal() const override { return false; }
  std::string description() const override { return "scatmech:" + text_; }

  void evaluate(const brdf::DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
    std::fill_n(values, models_.size() * pairs.count, 0.0);
    if (valid) std::fill_n(valid, pairs.count, std::uint8_t{1});
    const std::lock_guard lock(inside());
    try {
      for (std::size_t i = 0; i < pairs.count; ++i) {
        if (pairs.wi[2][i] <= 0 || pairs.wo[2][i] <= 0) continue;
        bool finite = true;
        for (std::size_t c = 0; c < models_.size(); ++c) {
          const double value = valueOf(models_[c], pairs, i);
          finite = finite && std::isfinite(value);
          values[c * pairs.count + i] = request_.element.empty() ? std::max(0.0, value) : value;
        }
        if (finite) continue;
        for (std::size_t c = 0; c < models_.size(); ++c) values[c * pairs.count + i] = 0;
        if (valid) valid[i] = 0;
      }
    } catch (const Failure& failure) {
      throw errorOf(failure, request_.model);
    }
  }
  using Brdf::evaluate;

 private:
  double valueOf(Model& model, const brdf::DirectionPairs<double>& pairs, std::size_t i) const {
    const double wix = pairs.wi[0][i], wiy = pairs.wi[1][i], wox = pairs.wo[0][i], woy = pairs.wo[1][i];
    const double thetaI = std::atan2(std::hypot(wix, wiy), pairs.wi[2][i]);
    const double thetaS = std::atan2(std::hypot(wox, woy), pairs.wo[2][i]);
    // Along the normal the azimuth is 0, as fromSpherical has it.
    const double sine = std::hypot(wix, wiy);
    const double cosine = sine > 0 ? wix / sine : 1, turn = sine > 0 ? wiy / sine : 0;
    const double along = wox * cosine + woy * turn, across = woy * cosine - wox * turn;
    const double phiS = along == 0 && across == 0 ? 0 : std::atan2(across, -along);
    double m[16];
    model.mueller(thetaI, thetaS, phiS, -std::atan2(turn, cosine), m);
    double value = 0;
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        if (analyser_[row] != 0 && incident_[column] != 0)
          value += analyser_[row] * m[4 * row + column] * incident_[column];
    return value;
  }

  std::string text_;
  Request request_;
  Stokes incident_{}, analyser_{};
  mutable std::vector<Model> models_;  // a model keeps what it worked out; guarded by inside()
  brdf::Channels channels_;
};

}  // namespace

brdf::BrdfPointer scatmechBrdf(std::string_view arguments) { return std::make_shared<ScatmechBrdf>(arguments); }

}  // namespace scatmech
