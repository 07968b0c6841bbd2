#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/formula/Program.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/LobeSum.h>

#include <algorithm>
#include <mutex>
#include <numeric>

namespace brdf {
namespace {

constexpr std::size_t kBlock = 1024;  // pairs evaluated at a time: temporaries stay in the cache

std::string listText(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(formatNumber(value));
  return values.size() == 1 ? texts[0] : "(" + joined(texts, ",") + ")";
}

/// Index of the parameter that parameter k follows, or k itself.
std::size_t leader(const Model& model, std::size_t k) {
  const std::string& followed = model.parameters()[k].follows;
  return followed.empty() ? k : model.parameterIndex(followed);
}

/// Mean of f cos / pdf over draws of the lobe's own sampler at theta_o = 45 degrees: its directional albedo there.
double estimatedAlbedo(const Model& model, const std::vector<double>& parameters) {
  constexpr std::size_t count = 256;
  std::vector<double> numbers(count * 9);
  double* column[9];
  for (std::size_t k = 0; k < 9; ++k) column[k] = numbers.data() + k * count;
  const Direction viewer = fromSpherical(kPi / 4, 0.3);
  for (std::size_t i = 0; i < count; ++i) {  // R2 sequence (Roberts 2018): points by the plastic number
    column[6][i] = std::fmod(0.5 + 0.7548776662466927 * static_cast<double>(i + 1), 1.0);
    column[7][i] = std::fmod(0.5 + 0.5698402909980532 * static_cast<double>(i + 1), 1.0);
    for (std::size_t axis = 0; axis < 3; ++axis) column[3 + axis][i] = viewer[axis];
  }
  model.sample({column[3], column[4], column[5]}, {column[6], column[7]}, parameters, {column[0], column[1], column[2]},
               count);
  DirectionPairs<double> pairs{{column[0], column[1], column[2]}, {column[3], column[4], column[5]}, count};
  model.pdf(pairs, parameters, column[8]);
  std::vector<double> values(count);
  model.evaluate(pairs, parameters, values.data());
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (column[8][i] > 0 && std::isfinite(values[i])) sum += values[i] * column[2][i] / column[8][i];
  return sum / count;
}

}  // namespace

bool Lobe::channelIndependent() const {
  return std::all_of(parameters.begin(), parameters.end(), [](const auto& values) { return values.size() == 1; });
}

std::vector<double> Lobe::parametersOf(std::size_t channel) const {
  std::vector<double> values;
  for (const auto& parameter : parameters) values.push_back(parameter.size() == 1 ? parameter[0] : parameter[channel]);
  return values;
}

LobeSum::LobeSum(std::vector<Lobe> lobes, Channels channels)
    : lobes_(std::move(lobes)), channels_(std::move(channels)), lazy_(std::make_shared<Lazy>()) {
  const std::size_t count = channels_.count();
  const auto checkLength = [&](std::size_t length, const std::string& where) {
    if (length != 1 && length != count)
      throw Error(Error::Kind::Value, {"wrong number of values", where, std::to_string(length),
                                       count == 1 ? "1" : "1 or " + std::to_string(count) + " (one a channel)"});
  };
  if (lobes_.empty()) throw Error(Error::Kind::Value, {"a material needs at least one lobe"});
  for (const Lobe& lobe : lobes_) {
    checkLength(lobe.scale.size(), "scale of " + lobe.model->name());
    for (const double scale : lobe.scale)
      if (!(scale >= 0 && std::isfinite(scale)))
        throw Error(Error::Kind::Value,
                    {"scale factor out of bounds", "scale of " + lobe.model->name(), formatNumber(scale), "0 or more"});
    if (lobe.parameters.size() != lobe.model->parameters().size())
      throw Error(Error::Kind::Value,
                  {"wrong number of parameters", lobe.model->name(), std::to_string(lobe.parameters.size()),
                   std::to_string(lobe.model->parameters().size())});
    for (std::size_t k = 0; k < lobe.parameters.size(); ++k) {
      checkLength(lobe.parameters[k].size(), lobe.model->name() + "." + lobe.model->parameters()[k].name);
      for (const double value : lobe.parameters[k]) lobe.model->checkBounds(k, value);
    }
  }
  chooseSamplingWeights();
}

void LobeSum::chooseSamplingWeights() {
  const std::size_t channelCount = channels_.count();
  for (std::size_t l = 0; l < lobes_.size(); ++l) {
    const Lobe& lobe = lobes_[l];
    const std::size_t shapes = lobe.channelIndependent() ? 1 : channelCount;
    double total = 0;
    for (std::size_t shape = 0; shape < shapes; ++shape) {
      Component component{l, shape, lobe.parametersOf(shape), 0};
      double scale = lobe.scaleOf(shape);
      if (shapes == 1) {
        scale = 0;
        for (std::size_t channel = 0; channel < channelCount; ++channel) scale += lobe.scaleOf(channel);
      }
      component.weight = scale * estimatedAlbedo(*lobe.model, component.parameters);
      total += component.weight;
      components_.push_back(std::move(component));
    }
    samplingWeights_.push_back(total);
  }
  const double sum = std::accumulate(samplingWeights_.begin(), samplingWeights_.end(), 0.0);
  const bool usable = sum > 0 && std::isfinite(sum);
  for (double& weight : samplingWeights_) weight = usable ? weight / sum : 1.0 / static_cast<double>(lobes_.size());
  for (Component& component : components_)
    component.weight = usable ? component.weight / sum : 1.0 / static_cast<double>(components_.size());
}

Symmetry LobeSum::symmetry() const {
  for (const Lobe& lobe : lobes_) {
    if (lobe.model->isotropic()) continue;
    bool follows = false;
    for (std::size_t k = 0; k < lobe.parameters.size(); ++k) {
      const std::size_t lead = leader(*lobe.model, k);
      if (lead == k) continue;
      follows = true;
      for (std::size_t channel = 0; channel < channels_.count(); ++channel)
        if (lobe.parametersOf(channel)[k] != lobe.parametersOf(channel)[lead]) return Symmetry::Anisotropic;
    }
    if (!follows) return Symmetry::Anisotropic;
  }
  return Symmetry::Isotropic;
}

bool LobeSum::reciprocal() const {
  return std::all_of(lobes_.begin(), lobes_.end(), [](const Lobe& lobe) { return lobe.model->reciprocal(); });
}

std::string LobeSum::description() const {
  std::string text;
  for (const Lobe& lobe : lobes_) {
    if (!text.empty()) text += " + ";
    if (lobe.scale != std::vector<double>{1.0}) text += listText(lobe.scale) + "*";
    text += lobe.model->name();
    std::vector<std::string> arguments;
    for (std::size_t k = 0; k < lobe.parameters.size(); ++k) {
      const std::size_t lead = leader(*lobe.model, k);
      if (lead != k && lobe.parameters[k] == lobe.parameters[lead]) continue;
      arguments.push_back(lobe.model->parameters()[k].name + "=" + listText(lobe.parameters[k]));
    }
    if (!arguments.empty()) text += "(" + joined(arguments) + ")";
  }
  return text;
}

struct LobeSum::Lazy {
  std::once_flag once;
  std::unique_ptr<const formula::Program> program;
};

const formula::Program& LobeSum::program() const {
  std::call_once(lazy_->once, [this] {
    formula::Graph graph;
    std::vector<formula::NodeId> sums(channels_.count(), graph.constant(0));
    for (const Lobe& lobe : lobes_) {
      formula::NodeId value = 0;
      for (std::size_t channel = 0; channel < sums.size(); ++channel) {
        if (channel == 0 || !lobe.channelIndependent())
          value = lobe.model->buildValue(graph, lobe.parametersOf(channel));
        sums[channel] = graph.add(sums[channel], graph.mul(graph.constant(lobe.scaleOf(channel)), value));
      }
    }
    lazy_->program = std::make_unique<const formula::Program>(graph, sums);
  });
  return *lazy_->program;
}

template <class T>
void LobeSum::evaluateProgram(const DirectionPairs<T>& pairs, T* values, std::uint8_t* valid) const {
  const T* const inputs[] = {pairs.wi[0], pairs.wi[1], pairs.wi[2], pairs.wo[0],
                             pairs.wo[1], pairs.wo[2], nullptr,     nullptr};
  std::vector<T*> outputs;
  for (std::size_t channel = 0; channel < channels_.count(); ++channel)
    outputs.push_back(values + channel * pairs.count);
  program().run(inputs, {}, outputs.data(), pairs.count);
  if (valid != nullptr) std::fill_n(valid, pairs.count, std::uint8_t{1});
}

void LobeSum::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  evaluateProgram(pairs, values, valid);
}

void LobeSum::evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const {
  evaluateProgram(pairs, values, valid);
}

void LobeSum::sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                     const std::array<double*, 3>& wi, std::size_t count) const {
  // The first number chooses the component and, stretched, serves again; each component draws its own as one batch.
  std::vector<std::size_t> members;
  std::vector<double> buffer;
  double below = 0;
  for (std::size_t c = 0; c < components_.size(); ++c) {
    const Component& component = components_[c];
    const double above = c + 1 == components_.size() ? 1.0 : below + component.weight;
    members.clear();
    for (std::size_t i = 0; i < count; ++i)
      if (u[0][i] >= below && (u[0][i] < above || c + 1 == components_.size())) members.push_back(i);
    const std::size_t n = members.size();
    if (n > 0) {
      buffer.resize(8 * n);
      double* column[8];
      for (std::size_t k = 0; k < 8; ++k) column[k] = buffer.data() + k * n;
      for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t axis = 0; axis < 3; ++axis) column[axis][j] = wo[axis][members[j]];
        column[3][j] = std::clamp((u[0][members[j]] - below) / std::max(above - below, 1e-300), 0.0, 1 - 0x1p-53);
        column[4][j] = u[1][members[j]];
      }
      lobes_[component.lobe].model->sample({column[0], column[1], column[2]}, {column[3], column[4]},
                                           component.parameters, {column[5], column[6], column[7]}, n);
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t axis = 0; axis < 3; ++axis) wi[axis][members[j]] = column[5 + axis][j];
    }
    below = above;
  }
}

void LobeSum::pdf(const DirectionPairs<double>& pairs, double* density) const {
  double componentDensity[kBlock];
  for (std::size_t first = 0; first < pairs.count; first += kBlock) {
    const std::size_t length = std::min(kBlock, pairs.count - first);
    std::fill_n(density + first, length, 0.0);
    for (const Component& component : components_) {
      lobes_[component.lobe].model->pdf(pairs.slice(first, length), component.parameters, componentDensity);
      for (std::size_t i = 0; i < length; ++i) density[first + i] += component.weight * componentDensity[i];
    }
  }
}

}  // namespace brdf
