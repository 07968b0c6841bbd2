#include <brdf/base/Parallel.h>
#include <brdf/fit/BoxQuadratic.h>
#include <brdf/fit/Cost.h>
#include <brdf/fit/Gram.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

// Samples evaluated at a time: the columns of a few lobes stay in the first-level cache.
constexpr std::size_t kBlock = FitData::kBlockLength;

double zeroError(const FitData& data, ChannelRange channels) {
  double sum = 0;
  std::vector<double> residual, zero;
  for (const FitChunk& chunk : data.chunks) {
    const std::size_t count = data.residuals(chunk);
    double part = 0;
    zero.resize(count);
    residual.resize(count);
    for (std::size_t c = channels.first; c < channels.first + channels.count; ++c) {
      data.block(chunk, c).residual(zero.data(), residual.data());
      addProducts(residual.data(), 1, residual.data(), count, &part);
    }
    sum += part;
  }
  return sum;
}

/// Runs body(chunk, sums of that chunk) on all chunks in parallel and adds the sums in the chunks' order.
template <class Body>
std::vector<double> sumOverChunks(const FitData& data, std::size_t size, const Body& body) {
  std::vector<std::vector<double>> parts(data.chunks.size());
  parallelFor(data.chunks.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      parts[k].assign(size, 0.0);
      body(data.chunks[k], parts[k].data());
    }
  });
  std::vector<double> total(size, 0.0);
  for (const std::vector<double>& part : parts)
    for (std::size_t i = 0; i < size; ++i) total[i] += part[i];
  return total;
}

void mirrorUpper(double* matrix, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) matrix[i * n + j] = matrix[j * n + i];
}

}  // namespace

Scales initialScales(const FitProblem& problem, std::size_t channels) {
  Scales scales(channels * problem.lobeCount());
  for (std::size_t i = 0; i < scales.size(); ++i) scales[i] = problem.fixedScale(i % problem.lobeCount()).value_or(0);
  return scales;
}

// ----- separable --------------------------------------------------------------------------------------------------

/// Sums over the samples of products of the columns [lobes, derivatives] among themselves (`gram`, full, m x m) and
/// with each channel's residual at the reference scales (`cross`, channel by channel, m each), and of the residual
/// squared.
struct SeparableCost::Sums {
  std::size_t m = 0;
  std::vector<double> all;
  double* gram() { return all.data(); }
  const double* gram() const { return all.data(); }
  const double* cross(std::size_t channel) const { return all.data() + m * m + channel * m; }
  double squared(std::size_t channel, std::size_t channels) const { return all[m * m + channels * m + channel]; }
};

SeparableCost::SeparableCost(const FitProblem& problem, const FitData& data, ChannelRange channels)
    : problem_(problem),
      data_(data),
      channels_(channels),
      zeroError_(zeroError(data, channels)),
      scales_(initialScales(problem, channels.count)),
      bestScales_(scales_) {}

SeparableCost::Sums SeparableCost::accumulate(std::span<const double> x, bool derivatives, ChannelRange range) const {
  const std::size_t lobes = problem_.lobeCount(), channels = range.count;
  const std::size_t m = lobes + (derivatives ? problem_.derivativeColumns().size() : 0);
  const std::vector<std::vector<double>> parameters = problem_.parameters(x);
  Sums sums;
  sums.m = m;
  sums.all = sumOverChunks(data_, m * m + channels * (m + 1), [&](const FitChunk& chunk, double* out) {
    const std::size_t total = chunk.pairs.size();
    std::vector<double> columns(m * kBlock), scratch, residual(kBlock);
    for (std::size_t first = 0; first < total; first += kBlock) {
      const std::size_t count = std::min(kBlock, total - first);
      const ResidualBlock block = data_.block(chunk, range.first, first, count);
      problem_.evaluate(block.pairs, parameters, derivatives, scratch, columns.data());
      if (block.factor)
        for (std::size_t k = 0; k < m; ++k)
          for (std::size_t i = 0; i < count; ++i) columns[k * count + i] *= block.factor[i];
      addGram(columns.data(), m, count, out);
      for (std::size_t c = 0; c < channels; ++c) {
        const double* target = chunk.target.data() + (range.first + c) * total + first;
        const double* scales = scales_.data() + (range.first - channels_.first + c) * lobes;
        for (std::size_t i = 0; i < count; ++i) residual[i] = -target[i];
        for (std::size_t l = 0; l < lobes; ++l)
          if (const double scale = scales[l]; scale != 0)
            for (std::size_t i = 0; i < count; ++i) residual[i] += scale * columns[l * count + i];
        addProducts(columns.data(), m, residual.data(), count, out + m * m + c * m);
        addProducts(residual.data(), 1, residual.data(), count, out + m * m + channels * m + c);
      }
    }
  });
  mirrorUpper(sums.gram(), m);
  return sums;
}

void SeparableCost::project(const Sums& sums, ChannelRange range, NormalEquations& equations) {
  const std::size_t lobes = problem_.lobeCount(), m = sums.m, shapes = equations.gradient.size(), moves = m - lobes;
  const std::vector<DerivativeColumn>& moved = problem_.derivativeColumns();
  const double* gram = sums.gram();
  std::vector<double> a(lobes * lobes), b(lobes), lower(lobes), upper(lobes);
  std::vector<double> residualProducts(moves), reduced(moves * lobes);
  for (std::size_t c = 0; c < range.count; ++c) {
    const double* cross = sums.cross(c);
    double* scale = scales_.data() + (range.first - channels_.first + c) * lobes;
    for (std::size_t l = 0; l < lobes; ++l) {
      for (std::size_t k = 0; k < lobes; ++k) a[l * lobes + k] = gram[l * m + k];
      b[l] = -cross[l];
      const bool held = problem_.fixedScale(l).has_value();
      lower[l] = held ? 0 : -scale[l];
      upper[l] = held ? 0 : std::numeric_limits<double>::infinity();
    }
    const std::vector<double> change = minimizeInBox(a, b, lower, upper);
    double squared = sums.squared(c, range.count);
    std::vector<std::size_t> freeLobes;
    for (std::size_t l = 0; l < lobes; ++l) {
      double row = 2 * cross[l];
      for (std::size_t k = 0; k < lobes; ++k) row += a[l * lobes + k] * change[k];
      squared += row * change[l];
      scale[l] = std::max(0.0, scale[l] + change[l]);
      if (scale[l] > 0 && upper[l] > 0) freeLobes.push_back(l);
    }
    equations.squaredError += std::max(0.0, squared);
    if (shapes == 0) continue;

    // With D_i the derivative columns, r the residual and F the free lobes (Golub and Pereyra 1973, eq. 5.4):
    // J_i = s_i P D_i + F (F'F)^-1 e_i (D_i'r), the two parts orthogonal, P the projector off F; a coordinate that
    // moves several lobes is the sum over them.
    const std::size_t free = freeLobes.size();
    std::vector<double> freeGram(free * free);
    for (std::size_t p = 0; p < free; ++p)
      for (std::size_t q = 0; q < free; ++q) freeGram[p * free + q] = gram[freeLobes[p] * m + freeLobes[q]];
    const std::vector<double> inverse = pseudoInverse(freeGram, free);
    for (std::size_t i = 0; i < moves; ++i) {
      residualProducts[i] = cross[lobes + i];
      for (std::size_t l = 0; l < lobes; ++l) residualProducts[i] += gram[(lobes + i) * m + l] * change[l];
      for (std::size_t p = 0; p < free; ++p) {
        reduced[i * free + p] = 0;
        for (std::size_t q = 0; q < free; ++q)
          reduced[i * free + p] += inverse[p * free + q] * gram[(lobes + i) * m + freeLobes[q]];
      }
    }
    for (std::size_t i = 0; i < moves; ++i) {
      const auto [coordinateI, lobeI] = moved[i];
      equations.gradient[coordinateI] += scale[lobeI] * residualProducts[i];
      for (std::size_t j = 0; j < moves; ++j) {
        const auto [coordinateJ, lobeJ] = moved[j];
        double projected = gram[(lobes + i) * m + lobes + j];
        for (std::size_t p = 0; p < free; ++p)
          projected -= reduced[i * free + p] * gram[(lobes + j) * m + freeLobes[p]];
        double entry = scale[lobeI] * scale[lobeJ] * projected;
        const auto p = std::ranges::find(freeLobes, lobeI), q = std::ranges::find(freeLobes, lobeJ);
        if (p != freeLobes.end() && q != freeLobes.end())
          entry += residualProducts[i] * residualProducts[j] *
                   inverse[static_cast<std::size_t>(p - freeLobes.begin()) * free +
                           static_cast<std::size_t>(q - freeLobes.begin())];
        equations.matrix[coordinateI * shapes + coordinateJ] += entry;
      }
    }
  }
}

NormalEquations SeparableCost::evaluate(std::span<const double> x, bool derivatives) {
  // Two passes where the scales move so far that the residual is what is left of a difference of large numbers.
  constexpr double kCancellation = 1e-6;
  constexpr double kSpoilt = 4;
  const Scales initial = initialScales(problem_, channels_.count);
  const std::size_t shapes = derivatives ? problem_.coordinates().size() : 0;
  // Channels that share their factors share the Gram matrix; else each has its own.
  const std::size_t together = data_.factorsByChannel() ? 1 : channels_.count;
  bool refined = false;
  while (true) {
    std::vector<Sums> groups;
    double before = 0;
    bool finite = true;
    for (std::size_t first = 0; first < channels_.count; first += together) {
      const Sums& sums = groups.emplace_back(accumulate(x, derivatives, {channels_.first + first, together}));
      for (std::size_t c = 0; c < together; ++c) before += sums.squared(c, together);
      finite = finite && std::ranges::all_of(sums.all, [](double v) { return std::isfinite(v); });
    }
    NormalEquations equations;
    // Scales that a trial without sense spoiled are not carried on: next to them the data are rounding.
    finite = finite && std::isfinite(before);
    if ((!finite || before > kSpoilt * zeroError_) && scales_ != initial) {
      scales_ = initial;
      continue;
    }
    if (!finite) {
      equations.squaredError = std::numeric_limits<double>::infinity();
      return equations;
    }
    equations.gradient.assign(shapes, 0.0);
    equations.matrix.assign(shapes * shapes, 0.0);
    for (std::size_t k = 0; k < groups.size(); ++k)
      project(groups[k], {channels_.first + k * together, together}, equations);
    if (!refined && equations.squaredError < kCancellation * before) {
      refined = true;
      continue;
    }
    if (equations.squaredError < bestError_) {
      bestError_ = equations.squaredError;
      bestScales_ = scales_;
    }
    return equations;
  }
}

double SeparableCost::squaredError(std::span<const double> x) { return evaluate(x, false).squaredError; }
NormalEquations SeparableCost::normalEquations(std::span<const double> x) { return evaluate(x, true); }

// ----- joint ------------------------------------------------------------------------------------------------------

namespace {

/// Columns of values at pairs of directions as the residuals of one channel see them: as they are, or in a picture each
/// pixel's sum over its light.
struct Seen {
  const double* columns;  ///< one after the other, `count` numbers each
  std::size_t count;
};

Seen seen(const FitData& data, const FitChunk& chunk, std::size_t channel, std::size_t first, std::size_t count,
          const std::vector<double>& columns, std::size_t m, std::vector<double>& sums) {
  const std::size_t group = data.pairsAResidual, pixels = count / group;
  if (group == 1) return {columns.data(), count};
  const double* light = chunk.light.data() + channel * chunk.pairs.size() + first;
  sums.assign(m * pixels, 0.0);
  for (std::size_t k = 0; k < m; ++k)
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
      addProducts(columns.data() + k * count + pixel * group, 1, light + pixel * group, group,
                  &sums[k * pixels + pixel]);
  return {sums.data(), pixels};
}

}  // namespace

JointCost::JointCost(const FitProblem& problem, const FitData& data, ChannelRange channels)
    : problem_(problem),
      data_(data),
      channels_(channels),
      zeroError_(zeroError(data, channels)),
      lower_(problem.lower()),
      upper_(problem.upper()) {
  for (std::size_t c = 0; c < channels.count; ++c)
    for (std::size_t l = 0; l < problem.lobeCount(); ++l)
      if (!problem.fixedScale(l)) freeScales_.emplace_back(l, c);
  lower_.resize(lower_.size() + freeScales_.size(), 0.0);
  upper_.resize(lower_.size(), std::numeric_limits<double>::infinity());
}

std::vector<double> JointCost::join(std::span<const double> shape, const Scales& scales) const {
  std::vector<double> x(shape.begin(), shape.end());
  for (const auto& [lobe, channel] : freeScales_) x.push_back(scales[channel * problem_.lobeCount() + lobe]);
  return x;
}

Scales JointCost::scalesOf(std::span<const double> x) const {
  Scales scales = initialScales(problem_, channels_.count);
  const std::size_t shapes = problem_.coordinates().size();
  for (std::size_t k = 0; k < freeScales_.size(); ++k)
    scales[freeScales_[k].second * problem_.lobeCount() + freeScales_[k].first] = x[shapes + k];
  return scales;
}

SearchBox JointCost::searchBox(std::span<const double> start) const {
  constexpr double kRoom = 10;
  const std::size_t shapes = problem_.coordinates().size();
  SearchBox box = problem_.searchBox(start.first(shapes));
  std::vector<double> largest(problem_.lobeCount());
  for (std::size_t k = 0; k < freeScales_.size(); ++k) {
    double& own = largest[freeScales_[k].first];
    own = std::max(own, start[shapes + k]);
  }
  const double any = largest.empty() ? 0 : std::ranges::max(largest);
  for (const auto& [lobe, channel] : freeScales_) {
    box.lower.push_back(0);
    box.upper.push_back(kRoom * (largest[lobe] > 0 ? largest[lobe] : any > 0 ? any : 1));
  }
  return box;
}

double JointCost::squaredError(std::span<const double> x) {
  const std::size_t lobes = problem_.lobeCount();
  const Scales scales = scalesOf(x);
  const auto parameters = problem_.parameters(x.first(problem_.coordinates().size()));
  return sumOverChunks(data_, 1, [&](const FitChunk& chunk, double* out) {
    const std::size_t total = chunk.pairs.size();
    std::vector<double> columns(lobes * kBlock), scratch, lit, model(kBlock), residual(kBlock);
    for (std::size_t first = 0; first < total; first += kBlock) {
      const std::size_t pairs = std::min(kBlock, total - first);
      problem_.evaluate(chunk.pairs.view().slice(first, pairs), parameters, false, scratch, columns.data());
      for (std::size_t c = 0; c < channels_.count; ++c) {
        const std::size_t channel = channels_.first + c;
        const auto [values, count] = seen(data_, chunk, channel, first, pairs, columns, lobes, lit);
        std::fill_n(model.data(), count, 0.0);
        for (std::size_t l = 0; l < lobes; ++l)
          for (std::size_t i = 0; i < count; ++i) model[i] += scales[c * lobes + l] * values[l * count + i];
        data_.block(chunk, channel, first / data_.pairsAResidual, count).residual(model.data(), residual.data());
        addProducts(residual.data(), 1, residual.data(), count, out);
      }
    }
  })[0];
}

NormalEquations JointCost::normalEquations(std::span<const double> x) {
  const std::size_t lobes = problem_.lobeCount(), shapes = problem_.coordinates().size();
  const std::vector<DerivativeColumn>& moved = problem_.derivativeColumns();
  const std::size_t m = lobes + moved.size() + 1, n = lower_.size();  // columns of one channel, the residual last
  const Scales scales = scalesOf(x);
  const auto parameters = problem_.parameters(x.first(shapes));
  std::vector<double> sums = sumOverChunks(data_, channels_.count * m * m, [&](const FitChunk& chunk, double* out) {
    const std::size_t total = chunk.pairs.size();
    std::vector<double> columns((m - 1) * kBlock), scratch, lit, model(kBlock), slope(kBlock), own(m * kBlock);
    for (std::size_t first = 0; first < total; first += kBlock) {
      const std::size_t pairs = std::min(kBlock, total - first);
      problem_.evaluate(chunk.pairs.view().slice(first, pairs), parameters, true, scratch, columns.data());
      for (std::size_t c = 0; c < channels_.count; ++c) {
        const std::size_t channel = channels_.first + c;
        const auto [values, count] = seen(data_, chunk, channel, first, pairs, columns, m - 1, lit);
        std::fill_n(model.data(), count, 0.0);
        for (std::size_t l = 0; l < lobes; ++l)
          for (std::size_t i = 0; i < count; ++i) model[i] += scales[c * lobes + l] * values[l * count + i];
        const ResidualBlock block = data_.block(chunk, channel, first / data_.pairsAResidual, count);
        block.slope(model.data(), slope.data());
        block.residual(model.data(), own.data() + (m - 1) * count);
        for (std::size_t k = 0; k + 1 < m; ++k) {
          const double factor = k < lobes ? 1.0 : scales[c * lobes + moved[k - lobes].lobe];
          for (std::size_t i = 0; i < count; ++i) own[k * count + i] = factor * slope[i] * values[k * count + i];
        }
        addGram(own.data(), m, count, out + c * m * m);
      }
    }
  });

  NormalEquations equations;
  equations.gradient.assign(n, 0.0);
  equations.matrix.assign(n * n, 0.0);
  // Where column k of a channel's sums lies in x; the scale factors of a channel follow those of the one before.
  std::vector<std::size_t> place(m - 1);
  std::size_t nextScale = shapes;
  for (std::size_t c = 0; c < channels_.count; ++c) {
    double* gram = sums.data() + c * m * m;
    mirrorUpper(gram, m);
    for (std::size_t l = 0; l < lobes; ++l) place[l] = problem_.fixedScale(l) ? n : nextScale++;
    for (std::size_t k = 0; k < moved.size(); ++k) place[lobes + k] = moved[k].coordinate;
    equations.squaredError += gram[m * m - 1];
    for (std::size_t i = 0; i + 1 < m; ++i) {
      if (place[i] == n) continue;
      equations.gradient[place[i]] += gram[i * m + m - 1];
      for (std::size_t j = 0; j + 1 < m; ++j)
        if (place[j] != n) equations.matrix[place[i] * n + place[j]] += gram[i * m + j];
    }
  }
  return equations;
}

}  // namespace brdf
