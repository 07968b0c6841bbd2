#pragma once
#include <brdf/brdf_export.h>
#include <brdf/formula/Graph.h>
#include <brdf/formula/Parser.h>
#include <brdf/formula/Program.h>
#include <brdf/models/Model.h>

#include <map>
#include <memory>
#include <mutex>

namespace pugi {
class xml_node;
}

namespace brdf {

class XmlSource;

/// A Model made from one XML record (models/lobes/*.xml):
///
///   <model name="" title="" isotropic="yes|no" reciprocal="yes|no" constant="yes|no" clamp="yes|no"
///          [dialect="BRDFLab082"]>
///     <description/>
///     <parameter name="" default="" min="" max="" [label symbol unit softMin softMax scale="linear|log" follows]/>...
///     <equation/>                              formula language (formula/Parser.h); f_r in 1/sr, no horizon test. What
///                                              it assigns to D, or to a name that begins with "D_", is a microfacet
///                                              distribution (1/sr), and audited as such (check/Normalisation.h)
///     <sampler name="" arguments="expr, ..." [share="expr"] [cosine="expr"]/>...   of models/samplers, arguments in
///                                              the model's parameters and wo. `share`: of draws, in [0, 1), for each
///                                              sampler but the first, which gets the rest; cosine="expr" is short for
///                                              a sampler "Cosine" of that share. Without <sampler>: cosine-weighted,
///                                              and Model::namesSampler is false
///     <declares check="" [allowed=""]/>...     laws it does not keep (models/Declaration.h)
///     <reference .../>...
///   </model>
///
/// Cosines below 1e-14 count as 1e-14. clamp="yes" replaces negative values by 0. dialect: see models/LegacyModel.h.
/// The formula is compiled at first use; formula errors appear then, or at once through `compile`.
class BRDF_EXPORT FormulaModel final : public Model {
 public:
  /// Throws Error::Kind::Format when the record breaks the layout above; `where` names the file.
  FormulaModel(std::string_view xml, const std::string& where);
  ~FormulaModel() override;

  /// Compiles now; throws Error::Kind::Formula.
  void compile() const { compiled(); }

  void evaluate(const DirectionPairs<double>& pairs, std::span<const double> parameters, double* out) const override;
  void evaluate(const DirectionPairs<float>& pairs, std::span<const double> parameters, float* out) const override;
  void evaluateWithDerivatives(const DirectionPairs<double>& pairs, std::span<const double> parameters,
                               std::span<const std::size_t> which, double* out) const override;
  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
              std::span<const double> parameters, const std::array<double*, 3>& wi, std::size_t count) const override;
  void pdf(const DirectionPairs<double>& pairs, std::span<const double> parameters, double* density) const override;
  std::vector<double> evaluateExtended(const std::array<double, 3>& wi, const std::array<double, 3>& wo,
                                       std::span<const double> parameters) const override;
  std::string glsl() const override;
  formula::NodeId buildValue(formula::Graph& graph, std::span<const double> parameters) const override;

  /// The graph of the value, its node, and the nodes of its derivatives in the order of parameters().
  const formula::Graph& graph() const;
  formula::NodeId valueNode() const;
  const std::vector<formula::NodeId>& derivativeNodes() const;
  /// One of the samplers that draw for the model.
  struct SamplerPart {
    std::string sampler;                 ///< its name (models/Library.h)
    std::vector<std::string> arguments;  ///< formulas
    std::string share;                   ///< of the draws, a formula; empty for the first part: what the others leave
    std::string where;                   ///< its element in the file
    std::vector<formula::Position> argumentStarts;  ///< in the file
    formula::Position shareStart{};
  };
  /// At least one; "Cosine" alone where the record names none.
  const std::vector<SamplerPart>& samplerParts() const { return parts_; }
  /// Names of the microfacet distributions that the equation assigns.
  const std::vector<std::string>& distributions() const;
  /// The distribution distributions()[which] (1/sr) at `count` unit half vectors `h`, which light and viewer coincide
  /// with.
  void evaluateDistribution(std::size_t which, const std::array<const double*, 3>& h,
                            std::span<const double> parameters, double* out, std::size_t count) const;
  bool clamped() const { return clamp_; }  ///< whether negative values are replaced by 0
  /// Names of the library's functions (models/Library.h) that the equation calls, in order of first use.
  const std::vector<std::string>& functionsUsed() const;

 private:
  struct Compiled;
  Compiled& compiled() const;
  /// How this model's texts are read into a graph; parameters are the caller's to name.
  formula::ParseOptions parseOptions(formula::Graph& graph) const;
  /// The value of an equation: clamped where the model says so, and 0 below the horizon.
  formula::NodeId finished(formula::Graph& graph, formula::NodeId raw) const;

  void readParameterInto(const pugi::xml_node& node, const XmlSource& source);
  void readSamplerInto(const pugi::xml_node& node, const XmlSource& source);

  class SamplerGraph;

  std::string where_;
  formula::Position equationStart_;  ///< in the file
  std::vector<SamplerPart> parts_;
  bool clamp_ = false, legacyDialect_ = false;
  mutable std::once_flag once_;
  mutable std::unique_ptr<Compiled> compiled_;
};

}  // namespace brdf
