#include <brdf/base/Error.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/SampleSet.h>
#include <brdf/material/TableBrdf.h>

#include <algorithm>
#include <cmath>

namespace brdf {

/// The source's samples, seen through the same matrix.
class ChannelView::View : public SampleSet {
 public:
  View(const ChannelView& owner, const SampleSet& source) : owner_(owner), source_(source) {}

  std::size_t count() const override { return source_.count(); }
  const Channels& channels() const override { return owner_.channels(); }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    if (!values) return source_.read(first, length, pairs, nullptr, valid);
    const auto scratch = std::make_unique_for_overwrite<double[]>(source_.channels().count() * length);
    source_.read(first, length, pairs, scratch.get(), valid);
    owner_.combine(scratch.get(), length, values);
  }
  bool solidAngles(std::size_t first, std::size_t length, double* measures) const override {
    return source_.solidAngles(first, length, measures);
  }
  /// The sum of the channels' errors by the magnitude of their weights, which its own never exceeds.
  bool standardErrors(std::size_t first, std::size_t length, double* errors) const override {
    const std::size_t inputs = source_.channels().count(), outputs = owner_.channels().count();
    const auto scratch = std::make_unique_for_overwrite<double[]>(inputs * length);
    if (!source_.standardErrors(first, length, scratch.get())) return false;
    std::fill_n(errors, outputs * length, 0.0);
    for (std::size_t row = 0; row < outputs; ++row)
      for (std::size_t column = 0; column < inputs; ++column) {
        const double weight = std::abs(owner_.matrix_[row * inputs + column]);
        if (weight == 0) continue;
        for (std::size_t i = 0; i < length; ++i) errors[row * length + i] += weight * scratch[column * length + i];
      }
    return true;
  }

 private:
  const ChannelView& owner_;
  const SampleSet& source_;
};

ChannelView::ChannelView(BrdfPointer source, Channels channels, std::vector<double> matrix, std::string name)
    : source_(std::move(source)), channels_(std::move(channels)), matrix_(std::move(matrix)), name_(std::move(name)) {
  const std::size_t expected = channels_.count() * source_->channels().count();
  if (matrix_.size() != expected)
    throw Error(Error::Kind::Value, {"channel matrix of the wrong size", name_,
                                     std::to_string(matrix_.size()) + " weights", std::to_string(expected)});
  if (const SampleSet* samples = source_->samples()) samples_ = std::make_unique<View>(*this, *samples);
}

ChannelView::~ChannelView() = default;

std::string ChannelView::description() const { return name_ + " of (" + source_->description() + ")"; }

const SampleSet* ChannelView::samples() const { return samples_.get(); }

void ChannelView::combine(const double* values, std::size_t count, double* result) const {
  const std::size_t inputs = source_->channels().count(), outputs = channels_.count();
  for (std::size_t row = 0; row < outputs; ++row) {
    double* out = result + row * count;
    std::fill_n(out, count, 0.0);
    for (std::size_t column = 0; column < inputs; ++column) {
      const double weight = matrix_[row * inputs + column];
      if (weight == 0) continue;
      const double* in = values + column * count;
      for (std::size_t i = 0; i < count; ++i) out[i] += weight * in[i];
    }
  }
}

void ChannelView::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  const auto scratch = std::make_unique_for_overwrite<double[]>(source_->channels().count() * pairs.count);
  source_->evaluate(pairs, scratch.get(), valid);
  combine(scratch.get(), pairs.count, values);
}

void ChannelView::sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                         const std::array<double*, 3>& wi, std::size_t count) const {
  source_->sample(wo, u, wi, count);
}

void ChannelView::pdf(const DirectionPairs<double>& pairs, double* density) const { source_->pdf(pairs, density); }

BrdfPointer asRgb(BrdfPointer brdf, const ColourSettings& settings) {
  const Channels& channels = brdf->channels();
  if (channels.kind == Channels::Kind::Rgb) return brdf;
  std::vector<double> matrix = channels.kind == Channels::Kind::Spectral ? rgbWeights(channels.wavelengths, settings)
                                                                         : std::vector<double>(3, 1.0);
  return std::make_shared<ChannelView>(std::move(brdf), Channels::rgb(), std::move(matrix), "linear sRGB");
}

std::shared_ptr<const LobeSum> lobesAsRgb(const LobeSum& material, const ColourSettings& settings) {
  const std::vector<double> weights = rgbWeights(material.channels().wavelengths, settings);
  const std::size_t count = material.channels().count();
  std::vector<Lobe> lobes = material.lobes();
  for (Lobe& lobe : lobes) {
    if (!lobe.channelIndependent()) return nullptr;
    std::vector<double> rgb(3, 0.0);
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t c = 0; c < count; ++c) rgb[row] += weights[row * count + c] * lobe.scaleOf(c);
    if (std::ranges::any_of(rgb, [](double s) { return s < 0; })) return nullptr;
    // One factor for all wavelengths is one for all colours, unless white is not white.
    if (lobe.scale.size() > 1 || settings.adaptation == Adaptation::None) lobe.scale = std::move(rgb);
  }
  return std::make_shared<LobeSum>(std::move(lobes), Channels::rgb());
}

std::vector<double> inRgb(const std::vector<double>& values, const Channels& channels, const ColourSettings& settings) {
  const std::vector<double> weights = rgbWeights(channels.wavelengths, settings);
  const std::size_t count = channels.count(), cells = values.size() / count;
  std::vector<double> rgb(3 * cells, 0.0);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t c = 0; c < count; ++c)
      for (std::size_t i = 0; i < cells; ++i) rgb[row * cells + i] += weights[row * count + c] * values[c * cells + i];
  return rgb;
}

BrdfPointer reducedToRgb(BrdfPointer brdf, const ColourSettings& settings) {
  const Channels& channels = brdf->channels();
  if (channels.kind != Channels::Kind::Spectral) return brdf;
  const std::string description = "linear sRGB of (" + brdf->description() + ")";
  if (const auto* table = dynamic_cast<const TableBrdf*>(brdf.get())) {
    const TableData& data = table->data();
    return std::make_shared<TableBrdf>(
        TableData{data.layout, Channels::rgb(), inRgb(data.values, channels, settings), data.valid}, description,
        table->lookup(), table->position());
  }
  if (const auto* grid = dynamic_cast<const GridBrdf*>(brdf.get())) {
    const GridData& data = grid->data();
    return std::make_shared<GridBrdf>(
        GridData{data.layout, Channels::rgb(), inRgb(data.values, channels, settings), data.states, {}, data.original},
        description, grid->lookup());
  }
  return asRgb(std::move(brdf), settings);
}

BrdfPointer asLuminance(BrdfPointer brdf, const ColourSettings& settings) {
  const Channels& channels = brdf->channels();
  if (channels.kind == Channels::Kind::Monochrome) return brdf;
  std::vector<double> matrix = channels.kind == Channels::Kind::Spectral
                                   ? luminanceWeights(channels.wavelengths, settings)
                                   : std::vector<double>(kRgbLuminanceWeights.begin(), kRgbLuminanceWeights.end());
  return std::make_shared<ChannelView>(std::move(brdf), Channels::monochrome(), std::move(matrix), "luminance");
}

BrdfPointer selectedChannels(BrdfPointer brdf, std::span<const std::size_t> indices) {
  const Channels& channels = brdf->channels();
  const std::size_t count = channels.count();
  std::string list;
  for (const std::size_t index : indices) list += (list.empty() ? "" : ",") + std::to_string(index);
  const auto fail = [&](const char* what, const std::string& allowed) {
    throw Error(Error::Kind::Value, {what, "list of channels", list.empty() ? "nothing" : list, allowed});
  };
  if (indices.empty()) fail("no channel chosen", "0 to " + std::to_string(count - 1));
  for (const std::size_t index : indices)
    if (index >= count) fail("no such channel", "0 to " + std::to_string(count - 1));

  Channels result;
  if (channels.kind == Channels::Kind::Spectral) {
    if (!std::is_sorted(indices.begin(), indices.end(), std::less_equal<>()))
      fail("channels of a spectrum out of order", "ascending wavelengths, each once");
    result.kind = Channels::Kind::Spectral;
    for (const std::size_t index : indices) result.wavelengths.push_back(channels.wavelengths[index]);
  } else if (indices.size() > 1) {
    if (!std::ranges::equal(indices, std::array<std::size_t, 3>{0, 1, 2}))
      fail("these channels are no colour", "one channel, or 0,1,2");
    result = Channels::rgb();
  }
  std::vector<double> matrix(indices.size() * count, 0.0);
  for (std::size_t row = 0; row < indices.size(); ++row) matrix[row * count + indices[row]] = 1;
  return std::make_shared<ChannelView>(std::move(brdf), std::move(result), std::move(matrix), "channels " + list);
}

}  // namespace brdf
