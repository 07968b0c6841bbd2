#include "Workshop.h"

#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/LoadMaterial.h>

#include <cmath>

namespace workshop {
namespace {

class TurnedBrdf final : public brdf::Brdf {
 public:
  TurnedBrdf(brdf::BrdfPointer inner, double degrees) : inner_(std::move(inner)), degrees_(degrees) {}

  const brdf::Channels& channels() const override { return inner_->channels(); }
  brdf::Symmetry symmetry() const override { return inner_->symmetry(); }
  bool reciprocal() const override { return inner_->reciprocal(); }
  std::string description() const override {
    return "turned:" + brdf::formatNumber(degrees_) + "," + inner_->description();
  }
  void evaluate(const brdf::DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
    // Both directions as the turned surface sees them: turned back.
    const double cosine = std::cos(brdf::radians(degrees_)), sine = std::sin(brdf::radians(degrees_));
    brdf::DirectionPairBuffer<double> turned(pairs.count);
    for (std::size_t i = 0; i < pairs.count; ++i) {
      turned.wi[0][i] = cosine * pairs.wi[0][i] + sine * pairs.wi[1][i];
      turned.wi[1][i] = cosine * pairs.wi[1][i] - sine * pairs.wi[0][i];
      turned.wi[2][i] = pairs.wi[2][i];
      turned.wo[0][i] = cosine * pairs.wo[0][i] + sine * pairs.wo[1][i];
      turned.wo[1][i] = cosine * pairs.wo[1][i] - sine * pairs.wo[0][i];
      turned.wo[2][i] = pairs.wo[2][i];
    }
    inner_->evaluate(turned.view(), values, valid);
  }

 private:
  brdf::BrdfPointer inner_;
  double degrees_;
};

}  // namespace

brdf::BrdfPointer turnedBrdf(std::string_view arguments) {
  const std::size_t comma = arguments.find(',');
  const auto degrees = brdf::parseNumber(brdf::trimmed(arguments.substr(0, comma)));
  if (comma == std::string_view::npos || !degrees)
    throw brdf::Error(brdf::Error::Kind::Value,
                      {"malformed material", "turned", "'" + std::string(arguments) + "'", "turned:DEGREES,MATERIAL"});
  return std::make_shared<TurnedBrdf>(brdf::loadMaterial(arguments.substr(comma + 1)).brdf, *degrees);
}

}  // namespace workshop
