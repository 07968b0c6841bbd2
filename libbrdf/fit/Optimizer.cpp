#include <brdf/base/Error.h>
#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>
#include <brdf/fit/Fit.h>
#include <brdf/fit/NloptMethod.h>

#include <algorithm>

namespace brdf {
namespace {

template <NloptMethod Method>
OptimizerResult minimizeBy(CostFunction& cost, std::vector<double> start, const OptimizerOptions& options) {
  return minimizeByNlopt(Method, cost, std::move(start), options);
}

using enum NloptMethod::Kind;

constexpr Optimizer kBuiltIn[] = {
    {"lm", "Levenberg-Marquardt in a box, streaming normal equations (ours)", true, false, levenbergMarquardt},
    {"cobyla", "COBYLA, Powell 1994 (NLopt)", false, false, minimizeBy<{NLOPT_LN_COBYLA, ByValues}>},
    {"bobyqa", "BOBYQA, Powell 2009 (NLopt)", false, false, minimizeBy<{NLOPT_LN_BOBYQA, ByValues}>},
    {"newuoa", "NEWUOA, Powell 2004, with bounds (NLopt)", false, false, minimizeBy<{NLOPT_LN_NEWUOA_BOUND, ByValues}>},
    {"praxis", "PRAXIS, Brent 1972, bounds by folding (NLopt)", false, false, minimizeBy<{NLOPT_LN_PRAXIS, ByValues}>},
    {"neldermead", "Nelder-Mead simplex 1965, with bounds (NLopt)", false, false,
     minimizeBy<{NLOPT_LN_NELDERMEAD, ByValues}>},
    {"sbplx", "Subplex, Rowan 1990, with bounds (NLopt)", false, false, minimizeBy<{NLOPT_LN_SBPLX, ByValues}>},
    {"slsqp", "SLSQP, Kraft 1988, exact gradients (NLopt)", true, false, minimizeBy<{NLOPT_LD_SLSQP, ByDerivatives}>},
    {"mma", "MMA, Svanberg 2002, exact gradients (NLopt)", true, false, minimizeBy<{NLOPT_LD_MMA, ByDerivatives}>},
    {"lbfgs", "L-BFGS, Nocedal 1980, exact gradients (NLopt)", true, false,
     minimizeBy<{NLOPT_LD_LBFGS, ByDerivatives}>},
    {"tnewton", "truncated Newton, Dembo and Steihaug 1983, preconditioned, exact gradients (NLopt)", true, false,
     minimizeBy<{NLOPT_LD_TNEWTON_PRECOND_RESTART, ByDerivatives}>},
    {"crs2", "CRS2 with local mutation, Kaelo and Ali 2006, global (NLopt)", false, true,
     minimizeBy<{NLOPT_GN_CRS2_LM, Global}>},
    {"isres", "ISRES evolution strategy, Runarsson and Yao 2005, global (NLopt)", false, true,
     minimizeBy<{NLOPT_GN_ISRES, Global}>},
    {"direct", "DIRECT, Jones, Perttunen, Stuckman 1993, global (NLopt)", false, true,
     minimizeBy<{NLOPT_GN_DIRECT, Global}>},
    {"mlsl", "MLSL on a Sobol sequence, Kucherenko and Sytsko 2005, local searches by SLSQP, global (NLopt)", true,
     true, minimizeBy<{NLOPT_G_MLSL_LDS, Global, NLOPT_LD_SLSQP}>},
    {"esch", "ESCH evolution strategy, da Silva Santos 2010, global (NLopt)", false, true,
     minimizeBy<{NLOPT_GN_ESCH, Global}>},
};

std::vector<Optimizer>& registry() {
  static std::vector<Optimizer> optimizers(std::begin(kBuiltIn), std::end(kBuiltIn));
  return optimizers;
}

}  // namespace

CostFunction::~CostFunction() = default;

SearchBox CostFunction::searchBox(std::span<const double>) const { return {lower(), upper()}; }

std::span<const Optimizer> allOptimizers() {
  plugins();
  return registry();
}

void registerOptimizer(const Optimizer& optimizer) {
  const auto same = std::ranges::find(registry(), optimizer.name, &Optimizer::name);
  if (same != registry().end())
    *same = optimizer;
  else
    registry().push_back(optimizer);
}

std::vector<std::string> optimizerNames() {
  std::vector<std::string> names;
  for (const Optimizer& optimizer : allOptimizers()) names.emplace_back(optimizer.name);
  return names;
}

const Optimizer& findOptimizer(std::string_view name) {
  const auto optimizers = allOptimizers();
  const auto found = std::ranges::find(optimizers, name, &Optimizer::name);
  if (found == optimizers.end())
    throw Error(Error::Kind::Value, {"unknown optimizer", "optimizer", std::string(name), joined(optimizerNames())});
  return *found;
}

}  // namespace brdf
