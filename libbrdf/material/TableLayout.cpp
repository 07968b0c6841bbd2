#include <brdf/geometry/Directions.h>
#include <brdf/material/TableLayout.h>

#include <algorithm>

namespace brdf {
namespace {

/// wi = (a cos phi + b, c sin phi, d - e cos phi); wo has the signs of a, c, e turned: the half vector's frame at phi_h
/// = 0.
struct Row {
  double a, b, c, d, e;
};

template <class Angle>
void fill(std::size_t count, const Angle& angle, std::vector<double>& cosine, std::vector<double>& sine) {
  cosine.resize(count);
  sine.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double radiansAtCentre = angle((static_cast<double>(i) + 0.5) / static_cast<double>(count));
    cosine[i] = std::cos(radiansAtCentre);
    sine[i] = std::sin(radiansAtCentre);
  }
}

}  // namespace

TableDirections::TableDirections(const TableLayout& layout) : layout_(layout) {
  const double period = layout.reciprocal ? kPi : 2 * kPi;
  fill(
      layout.phiD, [&](double t) { return period * t; }, cosPhi_, sinPhi_);
  fill(
      layout.thetaD, [](double t) { return kPi / 2 * t; }, cosThetaD_, sinThetaD_);
  fill(
      layout.thetaH, [](double t) { return kPi / 2 * t * t; }, cosThetaH_, sinThetaH_);
}

template <class Body>
void TableDirections::forRows(std::size_t first, std::size_t length, const Body& body) const {
  for (std::size_t done = 0; done < length;) {
    const std::size_t row = (first + done) / layout_.phiD, phi = (first + done) % layout_.phiD;
    const std::size_t count = std::min(layout_.phiD - phi, length - done);
    const std::size_t d = row % layout_.thetaD, h = row / layout_.thetaD;
    body(Row{cosThetaH_[h] * sinThetaD_[d], sinThetaH_[h] * cosThetaD_[d], sinThetaD_[d], cosThetaH_[h] * cosThetaD_[d],
             sinThetaH_[h] * sinThetaD_[d]},
         phi, count, done);
    done += count;
  }
}

void TableDirections::directions(std::size_t first, std::size_t length, DirectionPairBuffer<double>& pairs) const {
  pairs.resize(length);
  forRows(first, length, [&](const Row& row, std::size_t phi, std::size_t count, std::size_t at) {
    const double* __restrict cosine = cosPhi_.data() + phi;
    const double* __restrict sine = sinPhi_.data() + phi;
    double* __restrict wix = pairs.wi[0].data() + at;
    double* __restrict wiy = pairs.wi[1].data() + at;
    double* __restrict wiz = pairs.wi[2].data() + at;
    double* __restrict wox = pairs.wo[0].data() + at;
    double* __restrict woy = pairs.wo[1].data() + at;
    double* __restrict woz = pairs.wo[2].data() + at;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = row.a * cosine[i], y = row.c * sine[i], z = row.e * cosine[i];
      wix[i] = row.b + x;
      wox[i] = row.b - x;
      wiy[i] = y;
      woy[i] = -y;
      wiz[i] = row.d - z;
      woz[i] = row.d + z;
    }
  });
}

void TableDirections::aboveHorizon(std::size_t first, std::size_t length, std::uint8_t* above) const {
  forRows(first, length, [&](const Row& row, std::size_t phi, std::size_t count, std::size_t at) {
    const double* __restrict cosine = cosPhi_.data() + phi;
    for (std::size_t i = 0; i < count; ++i) {
      const double z = row.e * cosine[i];
      above[at + i] = (row.d - z > 0) & (row.d + z > 0);
    }
  });
}

}  // namespace brdf
