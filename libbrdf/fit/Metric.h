#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/DirectionPairs.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

class Metric;
using MetricPointer = std::shared_ptr<const Metric>;

/// A measure of the difference between two BRDFs: the root mean square of a residual r(f, t) over samples and channels,
/// f the value judged and t the target's, both in 1/sr. r(t, t) = 0 and r is finite for every finite f and t, unless a
/// user's formula says otherwise. The same records serve `fit`, every optimizer in it, and `compare`.
///
/// Arrays hold one number a pair of directions, both above the horizon. A target is kept in the form that prepare()
/// gives it, so that what does not depend on f is computed once.
class BRDF_EXPORT Metric {
 public:
  virtual ~Metric();

  const std::string& name() const { return name_; }        ///< as on the command line, with its argument
  const std::string& formula() const { return formula_; }  ///< of r, for people, with the numbers in use
  const std::string& source() const { return source_; }    ///< who proposed it
  const std::string& unit() const { return unit_; }        ///< of r, e.g. "1/sr"; empty: none, or a user's formula
  /// r = w (f - t), w not depending on f: scale factors follow by linear least squares.
  bool quadratic() const { return quadratic_; }
  /// w depends on the target's value, and so on the channel.
  bool weighsByTarget() const { return weighsByTarget_; }
  /// Each sample counts by the solid angle that it stands for, whatever weights are asked for.
  bool bySolidAngle() const { return bySolidAngle_; }

  /// The target's values (1/sr) as residual() wants them, and back.
  virtual void prepare(const double* values, const DirectionPairs<double>& pairs, double* target) const;
  virtual void restore(const double* target, const DirectionPairs<double>& pairs, double* values) const;
  virtual void residual(const double* f, const double* target, const DirectionPairs<double>& pairs,
                        double* r) const = 0;
  /// dr/df. Where it is infinite (cube root at 0) it is capped: it then only shapes the steps of the optimizer, and the
  /// value of the metric stays exact.
  virtual void slope(const double* f, const double* target, const DirectionPairs<double>& pairs,
                     double* slope) const = 0;

  /// The residual may have no finite value at some f or t (a user's formula).
  bool partial() const { return partial_; }
  /// Whether the metric takes a scale from the data: it must be replaced by scaledTo() before use.
  bool needsScale() const { return needsScale_; }
  /// The same metric for data whose typical value (fit/Samples.h) is `typical`, 1/sr, above 0.
  virtual MetricPointer scaledTo(double typical) const;

 protected:
  std::string name_, formula_, source_, unit_;
  bool quadratic_ = false, weighsByTarget_ = false, bySolidAngle_ = false, partial_ = false, needsScale_ = false;
};

/// All metrics that need no argument, the plain one first.
BRDF_EXPORT const std::vector<MetricPointer>& allMetrics();
/// Adds a metric; replaces one of the same name. Not while others ask for metrics.
BRDF_EXPORT void registerMetric(MetricPointer metric);

/// The metric that `text` describes: a name of allMetrics(), or
/// - "relative:FLOOR", "huber:DELTA": with another floor or scale than the default, 1/sr, above 0;
/// - "sphere", "sphere:MAP": the picture of a sphere (fit/SpherePicture.h) under the standard light or a map's file;
/// - "formula:TEXT": the user's own in the formula language (formula/Parser.h): of the value f (1/sr), the variables of
///   the directions, the function cbrt, and the target's value t if it likes. Without t the residual is
///   TEXT(f) - TEXT(t); with t it is TEXT itself. Its derivative is exact, from the formula's graph.
/// Throws Error::Kind::Value with the allowed names, and Error::Kind::Formula for a formula that does not parse.
BRDF_EXPORT MetricPointer findMetric(std::string_view text);

}  // namespace brdf
