#pragma once
#include <brdf/fit/Fit.h>
#include <brdf/fit/Optimizer.h>
#include <brdf/geometry/DirectionPairs.h>

#include <string>
#include <vector>

namespace brdf {

/// A parameter of a lobe, both by index.
struct LobeParameter {
  std::size_t lobe = 0, parameter = 0;
  bool operator==(const LobeParameter&) const = default;
};

/// One coordinate of the search over shapes: a free parameter of a lobe, or several tied together, in its logarithm
/// where its scale is logarithmic.
struct BRDF_EXPORT ShapeCoordinate {
  std::size_t lobe = 0;                   ///< of the first parameter
  std::vector<LobeParameter> parameters;  ///< the first gives the coordinate its name, bounds and scale
  bool logarithmic = false;
  double lower = 0, upper = 0;          ///< hard bounds, in the coordinate
  double softLower = 0, softUpper = 0;  ///< where real materials lie, in the coordinate
  double start = 0;

  double toCoordinate(double value) const;
  double toValue(double x) const;
  /// d(parameter) / d(coordinate) at a parameter's value.
  double slope(double value) const { return logarithmic ? value : 1.0; }
  bool moves(const LobeParameter& parameter) const;
};

/// What a coordinate does to one lobe: a column of derivatives. A coordinate has as many as lobes that it moves.
struct DerivativeColumn {
  std::size_t coordinate = 0, lobe = 0;
};

/// A sum of lobes to be fitted, as a function of shape coordinates: which parameters move, in what coordinates and
/// bounds, and the batched evaluation of every lobe with its derivatives.
class BRDF_EXPORT FitProblem {
 public:
  /// Throws Error::Kind::Value for an unknown parameter, a value out of bounds, or a tie that cannot be. On an
  /// isotropic target a parameter that follows another (Parameter::follows: the roughness along y, say) is tied to it
  /// unless the request fixes it; on others it is free.
  FitProblem(const std::vector<LobeRequest>& lobes, Symmetry targetSymmetry);

  std::size_t lobeCount() const { return lobes_.size(); }
  const Model& model(std::size_t lobe) const { return *lobes_[lobe].model; }
  ModelPointer modelPointer(std::size_t lobe) const { return lobes_[lobe].model; }
  /// The lobe's scale factor where the request holds it fixed, else empty.
  std::optional<double> fixedScale(std::size_t lobe) const { return lobes_[lobe].fixedScale; }
  bool isFixed(std::size_t lobe, std::size_t parameter) const { return lobes_[lobe].fixed[parameter]; }

  const std::vector<ShapeCoordinate>& coordinates() const { return coordinates_; }
  /// In the order of their lobes.
  const std::vector<DerivativeColumn>& derivativeColumns() const { return derivativeColumns_; }
  std::vector<double> start() const;
  const std::vector<double>& lower() const { return lower_; }
  const std::vector<double>& upper() const { return upper_; }
  /// The soft bounds, widened where `x` lies outside.
  SearchBox searchBox(std::span<const double> x) const;
  /// Sentences on what was tied, for the report.
  const std::vector<std::string>& notes() const { return notes_; }

  /// The parameters of every lobe at shape coordinates x.
  std::vector<std::vector<double>> parameters(std::span<const double> x) const;

  /// Values of all lobes for a batch, planar in `columns`: lobe l at columns[l * count + i]; with `derivatives` that of
  /// derivativeColumns()[k] follows at columns[(lobeCount() + k) * count + i]. `scratch` is reused between calls.
  void evaluate(const DirectionPairs<double>& pairs, const std::vector<std::vector<double>>& parameters,
                bool derivatives, std::vector<double>& scratch, double* columns) const;

 private:
  struct FitLobe {
    ModelPointer model;
    std::vector<double> base;  ///< parameter values where no coordinate moves them
    std::vector<bool> fixed;
    std::optional<double> fixedScale;
    std::vector<std::size_t> which;   ///< parameters whose derivatives are needed
    std::vector<std::size_t> column;  ///< for each entry of `which`: the derivative column that it adds to
  };
  /// Adds a lobe's parameter to what a coordinate moves, and narrows its bounds to the parameter's.
  void attach(std::size_t coordinate, const LobeParameter& parameter);
  void addDerivativeColumns();

  std::vector<FitLobe> lobes_;
  std::vector<ShapeCoordinate> coordinates_;
  std::vector<DerivativeColumn> derivativeColumns_;
  std::vector<double> lower_, upper_;
  std::vector<std::string> notes_;
};

}  // namespace brdf
