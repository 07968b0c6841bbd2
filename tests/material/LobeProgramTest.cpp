// A sum of lobes runs as one program with its parameters folded in: each model alone, and twice with different scales,
// gives what the model gives, at its defaults and at the ends of its bounds.
#include <brdf/geometry/Directions.h>
#include <brdf/material/LobeSum.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace brdf {
namespace {

DirectionPairBuffer<double> awkwardPairs() {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  DirectionPairBuffer<double> pairs;
  for (int i = 0; i < 200; ++i) {
    const double grazing = i % 4 == 0 ? std::pow(10, -6 * uniform(random)) : uniform(random);
    const Direction wi = fromSpherical(std::acos(grazing), 2 * kPi * uniform(random));
    const Direction wo = fromSpherical(std::acos(uniform(random)), 2 * kPi * uniform(random));
    pairs.push(wi, i % 5 == 0 ? Direction{-wi[0], -wi[1], wi[2]} : i % 7 == 0 ? wi : wo);
  }
  return pairs;
}

TEST(LobeProgram, GivesWhatEachModelGives) {
  const DirectionPairBuffer<double> pairs = awkwardPairs();
  const std::size_t count = pairs.size();
  for (const ModelPointer& model : allModels()) {
    for (const int end : {0, -1, 1}) {
      std::vector<double> values = model->defaults();
      for (std::size_t k = 0; k < values.size() && end != 0; ++k)
        values[k] = end < 0 ? model->parameters()[k].softMinimum : model->parameters()[k].softMaximum;
      std::vector<double> expected(count), got(3 * count);
      model->evaluate(pairs.view(), values, expected.data());
      Lobe lobe{model, {}, {0.5}}, other{model, {}, {0.25, 0, 2}};
      for (const double value : values) lobe.parameters.push_back({value}), other.parameters.push_back({value});
      LobeSum({lobe, other}, Channels::rgb()).evaluate(pairs.view(), got.data(), nullptr);
      const double scale[] = {0.75, 0.5, 2.5};
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t channel = 0; channel < 3; ++channel)
          EXPECT_NEAR(got[channel * count + i], scale[channel] * expected[i],
                      1e-10 * scale[channel] * expected[i] + 1e-300)
              << model->name() << " end " << end << " pair " << i;
    }
  }
}

}  // namespace
}  // namespace brdf
