#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/SampleSet.h>
#include <brdf/material/TableBrdf.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

constexpr std::size_t kBlock = 256;

/// Positions on the three axes of a table, in steps: phi_d in [0, phiD), the others in [0, count].
struct AxisPositions {
  std::array<double, kBlock> phiD, thetaD, thetaH;
};

/// What toHalfDifference does, without its trigonometry of the half vector, for a block.
void axisPositions(const TableLayout& layout, const DirectionPairs<double>& pairs, AxisPositions& position) {
  // Numerators and denominators first, in a loop that vectorises; the arc tangents after.
  std::array<double, kBlock> sumXY, sumZ, sum, difference, x, y;
  for (std::size_t i = 0; i < pairs.count; ++i) {
    const double sx = pairs.wi[0][i] + pairs.wo[0][i], dx = pairs.wi[0][i] - pairs.wo[0][i];
    const double sy = pairs.wi[1][i] + pairs.wo[1][i], dy = pairs.wi[1][i] - pairs.wo[1][i];
    const double sz = pairs.wi[2][i] + pairs.wo[2][i], dz = pairs.wi[2][i] - pairs.wo[2][i];
    const double xy = std::sqrt(sx * sx + sy * sy);
    sumXY[i] = xy;
    sumZ[i] = sz;
    sum[i] = std::sqrt(sx * sx + sy * sy + sz * sz);
    difference[i] = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double cosPhi = xy > 0 ? sx / xy : 1.0, sinPhi = xy > 0 ? sy / xy : 0.0;
    x[i] = (sz * (cosPhi * dx + sinPhi * dy) - xy * dz) / sum[i];
    y[i] = cosPhi * dy - sinPhi * dx;
  }
  const double period = layout.reciprocal ? kPi : 2 * kPi;
  const double phiSteps = static_cast<double>(layout.phiD);
  const double thetaDSteps = static_cast<double>(layout.thetaD), thetaHSteps = static_cast<double>(layout.thetaH);
  for (std::size_t i = 0; i < pairs.count; ++i) {
    position.thetaH[i] = thetaHSteps * std::sqrt(std::atan2(sumXY[i], sumZ[i]) / (kPi / 2));
    position.thetaD[i] = thetaDSteps * std::atan2(difference[i], sum[i]) / (kPi / 2);
    double phi = std::atan2(y[i], x[i]);
    if (phi < 0) phi += period;
    const double steps = phiSteps * phi / period;
    position.phiD[i] = steps < phiSteps ? steps : 0;  // phi_d = pi is phi_d = 0 where the period is pi
  }
}

/// The two cells about a position, and the weight of the second.
struct Bracket {
  std::size_t lower, upper;
  double weight;
};

Bracket clampedBracket(double position, std::size_t count) {
  const double last = static_cast<double>(count - 1);
  const double inside = std::clamp(position, 0.0, last);
  const auto lower = static_cast<std::size_t>(inside);
  return {lower, std::min(lower + 1, count - 1), inside - static_cast<double>(lower)};
}

Bracket periodicBracket(double position, std::size_t count) {
  if (position < 0) position += static_cast<double>(count);
  const std::size_t lower = std::min(static_cast<std::size_t>(position), count - 1);
  return {lower, lower + 1 == count ? 0 : lower + 1, position - static_cast<double>(lower)};
}

std::size_t truncated(double position, std::size_t count) {
  return std::min(static_cast<std::size_t>(position), count - 1);
}

void check(const TableData& data) {
  const TableLayout& layout = data.layout;
  const std::size_t cells = layout.cells();
  const auto fail = [](const char* what, std::string found, std::string allowed) {
    throw Error(Error::Kind::Value, {what, "BRDF table", std::move(found), std::move(allowed)});
  };
  if (cells == 0)
    fail("an axis has no cell",
         std::to_string(layout.thetaH) + " x " + std::to_string(layout.thetaD) + " x " + std::to_string(layout.phiD),
         "1 or more each");
  if (data.values.size() != cells * data.channels.count() || data.valid.size() != cells)
    fail("arrays and layout disagree",
         std::to_string(data.values.size()) + " values and " + std::to_string(data.valid.size()) + " flags",
         std::to_string(cells * data.channels.count()) + " and " + std::to_string(cells));
  if (const std::uint8_t most = *std::max_element(data.valid.begin(), data.valid.end());
      most > stateByte(CellState::Extrapolated))
    fail("unknown cell state", std::to_string(most), "0 to 2");
}

}  // namespace

class TableBrdf::Cells : public SampleSet {
 public:
  explicit Cells(std::shared_ptr<const TableData> data) : data_(std::move(data)), directions_(data_->layout) {}

  std::size_t count() const override { return data_->layout.cells(); }
  const Channels& channels() const override { return data_->channels; }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    if (pairs) directions_.directions(first, length, *pairs);
    if (!values && !valid) return;
    std::vector<std::uint8_t> ownFlags;
    if (!valid) {
      ownFlags.resize(length);
      valid = ownFlags.data();
    }
    directions_.aboveHorizon(first, length, valid);
    const std::uint8_t* given = data_->valid.data() + first;
    for (std::size_t i = 0; i < length; ++i) valid[i] &= given[i] == stateByte(CellState::Measured);
    if (!values) return;
    for (std::size_t channel = 0; channel < data_->channels.count(); ++channel) {
      const double* __restrict from = data_->values.data() + channel * count() + first;
      double* __restrict to = values + channel * length;
      for (std::size_t i = 0; i < length; ++i) to[i] = valid[i] ? from[i] : 0.0;
    }
  }

 private:
  std::shared_ptr<const TableData> data_;
  TableDirections directions_;
};

TableBrdf::TableBrdf(TableData data, std::string description, Lookup lookup, Position position)
    : description_(std::move(description)), lookup_(lookup), position_(position) {
  check(data);
  const std::size_t cells = data.layout.cells(), channelCount = data.channels.count();
  parallelFor(cells, 65536, [&](std::size_t first, std::size_t last) {
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
      const double* values = data.values.data() + channel * cells;
      for (std::size_t i = first; i < last; ++i)
        data.valid[i] = std::isfinite(values[i]) ? data.valid[i] : stateByte(CellState::Invalid);
    }
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
      double* values = data.values.data() + channel * cells;
      for (std::size_t i = first; i < last; ++i) values[i] = data.valid[i] ? values[i] : 0.0;
    }
  });
  data_ = std::make_shared<const TableData>(std::move(data));
  cells_ = std::make_shared<const Cells>(data_);
}

TableBrdf::TableBrdf(std::shared_ptr<const TableData> data, std::shared_ptr<const Cells> cells, std::string description,
                     Lookup lookup, Position position)
    : data_(std::move(data)),
      cells_(std::move(cells)),
      description_(std::move(description)),
      lookup_(lookup),
      position_(position) {}

TableBrdf::~TableBrdf() = default;

std::shared_ptr<const TableBrdf> TableBrdf::with(Lookup lookup, Position position) const {
  return std::shared_ptr<const TableBrdf>(new TableBrdf(data_, cells_, description_, lookup, position));
}

const SampleSet* TableBrdf::samples() const { return cells_.get(); }

void TableBrdf::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  const TableLayout& layout = data_->layout;
  const std::size_t cells = layout.cells(), channelCount = data_->channels.count();
  const std::size_t slab = layout.phiD * layout.thetaD;
  const double offset = position_ == Position::Centre ? 0.5 : 0.0;
  AxisPositions position;
  for (std::size_t start = 0; start < pairs.count; start += kBlock) {
    const auto block = pairs.slice(start, std::min(kBlock, pairs.count - start));
    axisPositions(layout, block, position);
    for (std::size_t i = 0; i < block.count; ++i) {
      const std::size_t out = start + i;
      if (!(block.wi[2][i] > 0 && block.wo[2][i] > 0)) {
        for (std::size_t channel = 0; channel < channelCount; ++channel) values[channel * pairs.count + out] = 0;
        if (valid) valid[out] = 1;
        continue;
      }
      if (lookup_ == Lookup::Nearest) {
        const std::size_t cell = truncated(position.phiD[i], layout.phiD) +
                                 layout.phiD * truncated(position.thetaD[i], layout.thetaD) +
                                 slab * truncated(position.thetaH[i], layout.thetaH);
        for (std::size_t channel = 0; channel < channelCount; ++channel)
          values[channel * pairs.count + out] = data_->values[channel * cells + cell];
        if (valid) valid[out] = data_->valid[cell] != 0;
        continue;
      }
      const Bracket p = periodicBracket(position.phiD[i] - offset, layout.phiD);
      const Bracket d = clampedBracket(position.thetaD[i] - offset, layout.thetaD);
      const Bracket h = clampedBracket(position.thetaH[i] - offset, layout.thetaH);
      std::array<std::size_t, 8> corner;
      std::array<double, 8> weight;
      double total = 0;
      for (std::size_t k = 0; k < 8; ++k) {
        corner[k] = (k & 1 ? p.upper : p.lower) + layout.phiD * (k & 2 ? d.upper : d.lower) +
                    slab * (k & 4 ? h.upper : h.lower);
        weight[k] =
            (k & 1 ? p.weight : 1 - p.weight) * (k & 2 ? d.weight : 1 - d.weight) * (k & 4 ? h.weight : 1 - h.weight);
        if (!data_->valid[corner[k]]) weight[k] = 0;
        total += weight[k];
      }
      const double scale = total > 0 ? 1 / total : 0;
      for (std::size_t channel = 0; channel < channelCount; ++channel) {
        const double* plane = data_->values.data() + channel * cells;
        double sum = 0;
        for (std::size_t k = 0; k < 8; ++k) sum += weight[k] * plane[corner[k]];
        values[channel * pairs.count + out] = sum * scale;
      }
      if (valid) valid[out] = total > 0;
    }
  }
}

std::shared_ptr<const TableBrdf> TableBrdf::tabulate(const Brdf& brdf, const TableLayout& layout) {
  TableData data{layout, brdf.channels(), {}, {}};
  const std::size_t cells = layout.cells(), channelCount = data.channels.count();
  data.values.resize(cells * channelCount);
  data.valid.resize(cells);
  const TableDirections directions(layout);
  parallelFor(cells, 4096, [&](std::size_t first, std::size_t last) {
    const std::size_t length = last - first;
    DirectionPairBuffer<double> pairs;
    directions.directions(first, length, pairs);
    std::vector<double> values(channelCount * length);
    std::vector<std::uint8_t> above(length);
    brdf.evaluate(pairs.view(), values.data(), data.valid.data() + first);
    directions.aboveHorizon(first, length, above.data());
    for (std::size_t i = 0; i < length; ++i) data.valid[first + i] &= above[i];
    for (std::size_t channel = 0; channel < channelCount; ++channel)
      std::copy_n(values.data() + channel * length, length, data.values.data() + channel * cells + first);
  });
  return std::make_shared<const TableBrdf>(std::move(data), "table of (" + brdf.description() + ")");
}

}  // namespace brdf
