#pragma once
// The test kit of the model registry: direction pairs where formulas break, and parameters from the inside and the edge
// of their ranges. Shared by the tests of models, materials and GLSL.
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/geometry/Directions.h>
#include <brdf/models/Model.h>

#include <random>
#include <string>
#include <vector>

namespace brdf::test {

/// Direction pairs above the horizon and what each was made to provoke.
struct PairSet {
  DirectionPairBuffer<double> pairs;
  std::vector<const char*> kinds;

  std::size_t size() const { return kinds.size(); }
  Direction wi(std::size_t k) const { return {pairs.wi[0][k], pairs.wi[1][k], pairs.wi[2][k]}; }
  Direction wo(std::size_t k) const { return {pairs.wo[0][k], pairs.wo[1][k], pairs.wo[2][k]}; }
  void add(const Direction& wi, const Direction& wo, const char* kind);
  /// The pairs as float holds them; `rounded` receives the same numbers in double.
  DirectionPairBuffer<float> narrow() const;
  PairSet rounded() const;
};

/// `perKind` pairs of each kind: random cosine-distributed, near the mirror direction (0 to 0.1 rad off), the mirror
/// direction itself, retro, half-vector-distributed about the normal at the scale of sharp lobes, grazing to 89.9999
/// degrees, normal incidence; and pairs with cosines of 6e-17, 1e-20 and 1e-30.
PairSet makePairs(std::size_t perKind, unsigned seed, bool belowDouble = true);

/// One set of parameters and where it lies in the ranges.
struct ParameterSet {
  std::vector<double> values;
  std::string name;
};

ParameterSet defaults(const Model& model);
/// Random inside the soft bounds (log scale where the parameter's is), and the corners of the soft box.
std::vector<ParameterSet> softSets(const Model& model, std::size_t count, unsigned seed);
/// Corners of the hard box: all minima, all maxima, random mixtures.
std::vector<ParameterSet> hardSets(const Model& model, std::size_t count, unsigned seed);

/// What may be asked of a model's digits in double and float where its formula itself cannot keep them, and why.
struct Conditioning {
  double relative, relativeNarrow;
  bool passesThroughZero;  ///< by a term that is clamped there: beside it, units of the last place of the peak
};
/// Models that are not in the list are held to full accuracy.
const Conditioning* illConditioned(const Model& model);

/// Whether the model's formula has sums or implicit roots, a hundred times dearer than others in extended precision.
bool isSlow(const Model& model);

/// "name=value, ..." for messages.
std::string text(const Model& model, const std::vector<double>& values);
std::string text(const Direction& wi, const Direction& wo);

/// A unit vector at a cosine-distributed random place of the hemisphere.
Direction cosineDistributed(std::mt19937_64& random);
/// `h` mirrored: the direction that a mirror of normal h (need not be unit) reflects `wo` to.
Direction mirrored(const Direction& wo, const Direction& h);

/// Names of all registered models, for parameterized tests.
std::vector<std::string> modelNames();

}  // namespace brdf::test
