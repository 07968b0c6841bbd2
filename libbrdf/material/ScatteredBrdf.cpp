#include <brdf/base/Error.h>
#include <brdf/material/CellState.h>
#include <brdf/material/ScatteredBrdf.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <nanoflann.hpp>

namespace brdf {
namespace {

constexpr double kHalfOffset = 0.1;  ///< of sin theta_h, under the root: limits the stretch at the mirror direction
constexpr double kSwapScale = 0.25;  ///< of s.d: how far apart a pair and its swap are
constexpr double kRidge = 1e-3;      ///< of the trace: keeps the slope finite where neighbours lie in a plane
constexpr double kOvershoot = 0.5;   ///< of the neighbours' range, in asinh: how far the linear fit may leave it
constexpr double kTinyDistance = 1e-9;

/// The coordinates in which samples are near each other; see the header.
template <int Dimensions>
Eigen::Matrix<double, Dimensions, 1> coordinates(const DirectionPairs<double>& pairs, std::size_t i) {
  const double sx = pairs.wi[0][i] + pairs.wo[0][i], sy = pairs.wi[1][i] + pairs.wo[1][i];
  const double dx = pairs.wi[0][i] - pairs.wo[0][i], dy = pairs.wi[1][i] - pairs.wo[1][i];
  const double sz = pairs.wi[2][i] + pairs.wo[2][i];
  const double s = std::hypot(sx, sy);
  const double sinThetaH = s / std::hypot(s, sz);
  const double stretched = std::sqrt(sinThetaH + kHalfOffset);
  if constexpr (Dimensions == 3) {
    return {stretched, std::hypot(dx, dy), kSwapScale * (sx * dx + sy * dy)};
  } else {
    const double radius = s > 0 ? (stretched - std::sqrt(kHalfOffset)) / s : 0;
    return {radius * sx, radius * sy, dx, dy};
  }
}

double medianMagnitude(const std::vector<double>& values) {
  std::vector<double> magnitudes;
  magnitudes.reserve(values.size());
  for (const double value : values)
    if (value != 0) magnitudes.push_back(std::abs(value));
  if (magnitudes.empty()) return 1;
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
  std::nth_element(magnitudes.begin(), middle, magnitudes.end());
  return *middle;
}

}  // namespace

class ScatteredBrdf::Samples : public SampleSet {
 public:
  explicit Samples(const ScatteredSamples& data) : data_(data) {}

  std::size_t count() const override { return data_.pairs.size(); }
  const Channels& channels() const override { return data_.channels; }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    if (pairs) {
      pairs->resize(length);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::copy_n(data_.pairs.wi[axis].data() + first, length, pairs->wi[axis].data());
        std::copy_n(data_.pairs.wo[axis].data() + first, length, pairs->wo[axis].data());
      }
    }
    if (values)
      for (std::size_t channel = 0; channel < data_.channels.count(); ++channel)
        std::copy_n(data_.values.data() + channel * count() + first, length, values + channel * length);
    if (valid) std::copy_n(data_.valid.data() + first, length, valid);
  }

 private:
  const ScatteredSamples& data_;
};

class ScatteredBrdf::Interpolator {
 public:
  virtual ~Interpolator() = default;
  /// The value at pair i of a batch, which is above the horizon, into values[c * pairs.count + i].
  virtual void interpolate(const DirectionPairs<double>& pairs, std::size_t i, double* values) const = 0;
  /// Whether pair i lies among the samples that its value is made from.
  virtual bool isWithin(const DirectionPairs<double>& pairs, std::size_t i) const = 0;
};

template <int Dimensions>
class ScatteredBrdf::TreeInterpolator : public ScatteredBrdf::Interpolator {
 public:
  explicit TreeInterpolator(const ScatteredSamples& data)
      : channelCount_(data.channels.count()), unit_(0.1 * medianMagnitude(data.values)) {
    const auto pairs = data.pairs.view();
    for (std::size_t i = 0; i < pairs.count; ++i) {
      if (!data.valid[i]) continue;
      points_.points.push_back(coordinates<Dimensions>(pairs, i));
      for (std::size_t channel = 0; channel < channelCount_; ++channel)
        transformed_.push_back(std::asinh(data.values[channel * pairs.count + i] / unit_));
    }
    tree_ = std::make_unique<Tree>(Dimensions, points_);
  }

  void interpolate(const DirectionPairs<double>& pairs, std::size_t i, double* values) const override {
    const Point query = coordinates<Dimensions>(pairs, i);
    std::array<std::uint32_t, kNeighbours + 1> index;
    std::array<double, kNeighbours + 1> squared;
    const std::size_t found = tree_->knnSearch(query.data(), kNeighbours + 1, index.data(), squared.data());
    const std::size_t used = std::min(found, kNeighbours);
    if (used == 0) {  // a direction that is no number
      for (std::size_t channel = 0; channel < channelCount_; ++channel)
        values[channel * pairs.count + i] = std::nan("");
      return;
    }
    const double rim = std::sqrt(squared[found - 1]);
    const std::array<double, kNeighbours> weight = weights(query, index, squared, used, rim);
    for (std::size_t channel = 0; channel < channelCount_; ++channel) {
      double sum = 0, low = HUGE_VAL, high = -HUGE_VAL;
      for (std::size_t k = 0; k < used; ++k) {
        const double value = transformed_[index[k] * channelCount_ + channel];
        sum += weight[k] * value;
        low = std::min(low, value);
        high = std::max(high, value);
      }
      const double margin = kOvershoot * (high - low);
      const double lowest = low >= 0 ? std::max(low - margin, 0.0) : low - margin;  // no negative value of its own
      values[channel * pairs.count + i] = unit_ * std::sinh(std::clamp(sum, lowest, high + margin));
    }
  }

  /// Gilbert's iteration towards the point of the convex hull nearest to the query (E. G. Gilbert 1966, SIAM J. Control
  /// 4, 61-80, doi:10.1137/0304007): outside once all neighbours lie beyond a plane.
  bool isWithin(const DirectionPairs<double>& pairs, std::size_t i) const override {
    constexpr int mostSteps = 64;
    constexpr double slack = 1e-3;  // of the neighbours' distance
    const Point query = coordinates<Dimensions>(pairs, i);
    std::array<std::uint32_t, kNeighbours> index;
    std::array<double, kNeighbours> squared;
    const std::size_t found = tree_->knnSearch(query.data(), kNeighbours, index.data(), squared.data());
    if (found == 0) return false;
    Point nearest = points_.points[index[0]] - query;
    const double close = slack * slack * squared[found - 1];
    for (int step = 0; step < mostSteps && nearest.squaredNorm() > close; ++step) {
      Point support = nearest;
      for (std::size_t k = 0; k < found; ++k) {
        const Point offset = points_.points[index[k]] - query;
        if (offset.dot(nearest) < support.dot(nearest)) support = offset;
      }
      if (support.dot(nearest) > slack * nearest.squaredNorm()) return false;
      const Point along = support - nearest;
      nearest += std::clamp(-nearest.dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
    }
    return true;
  }

 private:
  /// Four times the unknowns of the local fit: fewer follow the nearest incidence angle alone.
  static constexpr std::size_t kNeighbours = Dimensions == 3 ? 16 : 20;

  using Point = Eigen::Matrix<double, Dimensions, 1>;
  struct Points {
    std::vector<Point> points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][static_cast<Eigen::Index>(axis)]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, Dimensions>;

  /// Weights of the neighbours' values in the local linear fit at `query`; they sum to 1. `farthest` is the distance of
  /// the farthest neighbour found, where the weight ends.
  std::array<double, kNeighbours> weights(const Point& query, const std::array<std::uint32_t, kNeighbours + 1>& index,
                                          const std::array<double, kNeighbours + 1>& squared, std::size_t used,
                                          double farthest) const {
    std::array<double, kNeighbours> weight{};
    const double rim = std::max(farthest * 1.0001, 2 * kTinyDistance);
    double total = 0;
    for (std::size_t k = 0; k < used; ++k) {
      const double distance = std::max(std::sqrt(squared[k]), kTinyDistance);
      const double root = std::max(rim - distance, 0.0) / (rim * distance);
      weight[k] = root * root;
      total += weight[k];
    }
    Point mean = Point::Zero();
    for (std::size_t k = 0; k < used; ++k) {
      weight[k] /= total;
      mean += weight[k] * (points_.points[index[k]] - query);
    }
    Eigen::Matrix<double, Dimensions, Dimensions> moment = decltype(moment)::Zero();
    std::array<Point, kNeighbours> offset;
    for (std::size_t k = 0; k < used; ++k) {
      offset[k] = points_.points[index[k]] - query - mean;
      moment += weight[k] * offset[k] * offset[k].transpose();
    }
    const double trace = moment.trace();
    if (!(trace > 0)) return weight;
    moment.diagonal().array() += kRidge * trace;
    const Point slope = moment.ldlt().solve(mean);
    for (std::size_t k = 0; k < used; ++k) weight[k] -= weight[k] * offset[k].dot(slope);
    return weight;
  }

  std::size_t channelCount_;
  double unit_;                      ///< f0, 1/sr
  Points points_;                    ///< of the valid samples
  std::vector<double> transformed_;  ///< asinh(f / f0), the channels of a sample together
  std::unique_ptr<Tree> tree_;
};

ScatteredBrdf::ScatteredBrdf(ScatteredSamples samples, std::string description)
    : data_(std::move(samples)), description_(std::move(description)) {
  const std::size_t count = data_.pairs.size(), channelCount = data_.channels.count();
  if (data_.valid.empty()) data_.valid.assign(count, 1);
  const std::size_t expected = channelCount * count, uncertainties = data_.uncertainty.size();
  if (data_.values.size() != expected || data_.valid.size() != count ||
      (uncertainties != 0 && uncertainties != expected))
    throw Error(Error::Kind::Value,
                {"arrays of different lengths", "scattered samples",
                 std::to_string(data_.values.size()) + " values, " + std::to_string(uncertainties) +
                     " uncertainties and " + std::to_string(data_.valid.size()) + " flags",
                 std::to_string(expected) + " (uncertainties: or none) and " + std::to_string(count)});
  bool any = false;
  for (std::size_t i = 0; i < count; ++i) {
    bool usable = data_.valid[i] && data_.pairs.wi[2][i] > 0 && data_.pairs.wo[2][i] > 0;
    for (std::size_t channel = 0; channel < channelCount && usable; ++channel)
      usable = std::isfinite(data_.values[channel * count + i]);
    data_.valid[i] = usable;
    any = any || usable;
    if (!usable)
      for (std::size_t channel = 0; channel < channelCount; ++channel) data_.values[channel * count + i] = 0;
  }
  samples_ = std::make_unique<Samples>(data_);
  if (any && data_.isotropic)
    interpolator_ = std::make_unique<TreeInterpolator<3>>(data_);
  else if (any)
    interpolator_ = std::make_unique<TreeInterpolator<4>>(data_);
}

ScatteredBrdf::~ScatteredBrdf() = default;

void ScatteredBrdf::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  const std::size_t channelCount = data_.channels.count();
  for (std::size_t i = 0; i < pairs.count; ++i) {
    const bool above = pairs.wi[2][i] > 0 && pairs.wo[2][i] > 0;
    if (valid) valid[i] = !above || interpolator_;
    if (above && interpolator_) {
      interpolator_->interpolate(pairs, i, values);
    } else {
      for (std::size_t channel = 0; channel < channelCount; ++channel) values[channel * pairs.count + i] = 0;
    }
  }
}

void ScatteredBrdf::classify(const DirectionPairs<double>& pairs, std::uint8_t* states) const {
  for (std::size_t i = 0; i < pairs.count; ++i)
    if (states[i] != 0)
      states[i] =
          stateByte(interpolator_ && interpolator_->isWithin(pairs, i) ? CellState::Measured : CellState::Extrapolated);
}

}  // namespace brdf
