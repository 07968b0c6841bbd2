#include <brdf/material/ChannelView.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/material/ValueOrigins.h>
#include <brdf/view/ValueErrors.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// |a| |b|, both with rows first; `inner` columns of a, `columns` of b. Empty is the identity.
std::vector<double> product(const std::vector<double>& a, std::size_t inner, const std::vector<double>& b,
                            std::size_t columns) {
  if (a.empty()) {
    std::vector<double> magnitudes(b.size());
    std::transform(b.begin(), b.end(), magnitudes.begin(), [](double x) { return std::abs(x); });
    return magnitudes;
  }
  std::vector<double> result(a.size() / inner * columns);
  for (std::size_t row = 0; row < a.size() / inner; ++row)
    for (std::size_t k = 0; k < inner; ++k)
      for (std::size_t column = 0; column < columns; ++column)
        result[row * columns + column] += a[row * inner + k] * std::abs(b[k * columns + column]);
  return result;
}

}  // namespace

ValueErrors::ValueErrors(const Brdf& brdf) : outputs_(brdf.channels().count()) {
  const Brdf* source = &brdf;
  while (const auto* view = dynamic_cast<const ChannelView*>(source)) {
    weights_ = product(weights_, source->channels().count(), view->matrix(), view->source()->channels().count());
    source = view->source().get();
  }
  inputs_ = source->channels().count();
  if (const auto* scattered = dynamic_cast<const ScatteredBrdf*>(source)) {
    if (!scattered->data().uncertainty.empty()) sampleErrors_ = &scattered->data().uncertainty;
    samples_ = scattered->data().pairs.size();
  } else if (const auto* grid = dynamic_cast<const GridBrdf*>(source)) {
    if (grid->data().standardError.empty()) return;
    sampleErrors_ = &grid->data().standardError;
    samples_ = grid->layout().cells();
    origins_ = std::make_unique<ValueOrigins>(*source);
  }
}

ValueErrors::~ValueErrors() = default;

bool ValueErrors::knownOfValues() const { return origins_ != nullptr; }

void ValueErrors::ofValues(const DirectionPairs<double>& pairs, double* errors) const {
  if (weights_.empty()) return origins_->standardErrors(pairs, errors);
  std::vector<double> own(inputs_ * pairs.count);
  origins_->standardErrors(pairs, own.data());
  std::fill_n(errors, outputs_ * pairs.count, 0.0);
  for (std::size_t row = 0; row < outputs_; ++row)
    for (std::size_t column = 0; column < inputs_; ++column) {
      const double weight = weights_[row * inputs_ + column];
      if (weight == 0) continue;
      for (std::size_t i = 0; i < pairs.count; ++i)
        errors[row * pairs.count + i] += weight * own[column * pairs.count + i];
    }
}

double ValueErrors::ofSample(std::size_t index, std::size_t channel) const {
  if (weights_.empty()) return (*sampleErrors_)[channel * samples_ + index];
  double error = 0;
  for (std::size_t column = 0; column < inputs_; ++column) {
    const double weight = weights_[channel * inputs_ + column];
    if (weight != 0) error += weight * (*sampleErrors_)[column * samples_ + index];
  }
  return error;
}

}  // namespace brdf
