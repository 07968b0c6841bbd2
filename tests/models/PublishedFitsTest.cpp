// Parameters published for the MERL materials (Bagher 2012, Low 2012, Ngan 2005) through our lobes: all 1302 fits lie
// in the hard bounds and give finite values; some of each file agree with the papers' formulas written out plainly.
#include <brdf/base/File.h>
#include <brdf/check/Cases.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

namespace brdf {
namespace {

using Json = nlohmann::json;

/// The quantities of a pair that the formulas below are written in.
struct Geometry {
  double ci, co, hz, cd, tan2, ux, uy, vx, vy;
  Geometry(const Direction& u, const Direction& v) : ci(u[2]), co(v[2]), ux(u[0]), uy(u[1]), vx(v[0]), vy(v[1]) {
    const double x = u[0] + v[0], y = u[1] + v[1], z = u[2] + v[2], length = std::sqrt(x * x + y * y + z * z);
    hz = z / length;
    cd = (u[0] * x + u[1] * y + u[2] * z) / length;
    tan2 = (x * x + y * y) / (z * z);
  }
  double vGroove() const { return std::min({1.0, 2 * hz * ci / cd, 2 * hz * co / cd}); }
  /// max(0, mirror . viewer): 1 - |mirror - viewer|^2/2, which keeps its digits near 1.
  double mirror() const {
    const double x = ux + vx, y = uy + vy, z = ci - co;
    return std::max(0.0, 1 - 0.5 * (x * x + y * y + z * z));
  }
};

double schlick(double f0, double c) { return f0 + (1 - f0) * std::pow(1 - c, 5); }

double dielectric(double n, double c) {
  const double g = std::sqrt(n * n - 1 + c * c), a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return 0.5 * a * a * (1 + b * b);
}

/// A value by the paper's formula, and the size that its error is measured by.
struct Truth {
  double value, size;
  Truth(double v) : value(v), size(v) {}  // NOLINT(google-explicit-constructor)
  Truth(double v, double s) : value(v), size(s) {}
};

Truth bagher(const Json& f, std::size_t c, const Geometry& g) {
  const double alpha = f["alpha"][c], p = f["p"][c], lambda = f["Lambda"][c], factor = f["c"][c], k = f["k"][c],
               theta0 = f["theta0"][c], f0 = f["eta"][0][c], f1 = f["eta"][1][c], x = alpha + g.tan2 / alpha;
  const auto shadow = [&](double cosine) {
    const double theta = std::acos(cosine);
    return theta > theta0 ? std::max(0.0, 1 + lambda * (1 - std::exp(factor * std::pow(theta - theta0, k)))) : 1.0;
  };
  const double d = f["K"][c].get<double>() * std::exp(-x) * std::pow(x, -p) / (kPi * std::pow(g.hz, 4));
  const double lit = d * std::max(0.0, schlick(f0, g.cd) - f1 * g.cd) / (kPi * g.ci * g.co);
  return {lit * shadow(g.ci) * shadow(g.co), lit};
}

Truth lowAshikhmin(const Json& f, std::size_t, const Geometry& g) {
  const double n = f["sharpness"];
  return (n + 1) / (8 * kPi) * std::pow(1 + g.tan2, -n / 2) * dielectric(f["fresnelReflectance"], g.cd) /
         (g.cd * std::max(g.ci, g.co));
}

Truth nganAshikhmin(const Json& f, std::size_t, const Geometry& g) {
  const double n = f["sharpness"];
  return (n + 1) / (8 * kPi) * std::pow(1 + g.tan2, -n / 2) * schlick(f["fresnelReflectance"], g.cd) /
         (g.cd * std::max(g.ci, g.co));
}

double beckmannWithoutPi(double m, const Geometry& g) {
  return std::exp(-g.tan2 / (m * m)) / (m * m * std::pow(g.hz, 4));
}

Truth lowCookTorrance(const Json& f, std::size_t, const Geometry& g) {
  return beckmannWithoutPi(f["roughness"], g) * g.vGroove() * dielectric(f["eta"], g.cd) / (kPi * g.ci * g.co);
}

Truth nganCookTorrance(const Json& f, std::size_t, const Geometry& g) {
  return beckmannWithoutPi(f["roughness"], g) / kPi * g.vGroove() * schlick(f["eta"], g.cd) / (kPi * g.ci * g.co);
}

Truth lowMicrofacet(const Json& f, std::size_t, const Geometry& g) {
  const double b = f["B"], sin2 = g.tan2 / (1 + g.tan2);
  return std::pow(1 + b * sin2 / (1 + g.hz), -f["C"].get<double>()) * g.vGroove() * dielectric(f["eta"], g.cd) /
         (kPi * g.ci * g.co);
}

Truth lowSmooth(const Json& f, std::size_t, const Geometry& g) {
  const double x = g.ux + g.vx, y = g.uy + g.vy, dx = g.ux - g.vx, dy = g.uy - g.vy;
  return std::pow(1 + f["B"].get<double>() * (x * x + y * y), -f["C"].get<double>()) *
         dielectric(f["eta"], std::sqrt(1 - 0.25 * (dx * dx + dy * dy)));
}

Truth phong(const Json& f, std::size_t, const Geometry& g) {
  const double n = f["sharpness"];
  return (n + 2) / (2 * kPi) * std::pow(g.mirror(), n);
}

Truth lafortune(const Json& f, std::size_t, const Geometry& g) {
  const double n = f["sharpness"], cxy = f["Cxy"], cz = f["Cz"];
  const double dot = cxy * (g.ux * g.vx + g.uy * g.vy) + cz * g.ci * g.co;
  return (n + 2) / (2 * kPi) * std::pow(std::max(0.0, dot) / std::max(std::fabs(cxy), std::fabs(cz)), n);
}

Truth ward(const Json& f, std::size_t, const Geometry& g) {
  const double a = f["roughness"];
  return std::exp(-g.tan2 / (a * a)) / (4 * kPi * a * a * std::sqrt(g.ci * g.co));
}

Truth wardDuer(const Json& f, std::size_t, const Geometry& g) {
  const double a = f["roughness"];
  return std::exp(-g.tan2 / (a * a)) / (4 * kPi * a * a * g.ci * g.co);
}

constexpr double kWavelengths[] = {0.645, 0.526, 0.444};  // um, of the three channels

/// He and others 1991, directional-diffuse: the series (78) term by term, the apparent roughness (80)-(83) by
/// bisection.
Truth he(const Json& f, std::size_t c, const Geometry& g) {
  const double sigma0 = f["roughness"], tau = f["autocorrelation"], wave = 2 * kPi / kWavelengths[c];
  const auto tangent = [](double cosine) { return std::sqrt(1 - cosine * cosine) / cosine; };
  const auto cotangent = [&](double cosine) { return tau / (2 * sigma0 * tangent(cosine)); };
  const auto shadow = [&](double cosine) {
    const double x = cotangent(cosine), e = std::erfc(x);
    const double lambda = 0.5 * (2 / std::sqrt(kPi) * sigma0 / tau * tangent(cosine) * std::exp(-x * x) - e);
    return (1 - 0.5 * e) / (lambda + 1);
  };
  const auto k = [&](double cosine) { return tangent(cosine) * std::erfc(cotangent(cosine)) / 4; };
  const double right = std::sqrt(2 / kPi) * (k(g.ci) + k(g.co));  // z exp(z^2/2) = right
  double low = 0, high = right;
  for (int step = 0; step < 200; ++step) {
    const double z = 0.5 * (low + high);
    (z * std::exp(std::min(700.0, 0.5 * z * z)) < right ? low : high) = z;
  }
  const double sigma = sigma0 / std::sqrt(1 + low * low);
  const double x = g.ux + g.vx, y = g.uy + g.vy, z = g.ci + g.co, v2 = x * x + y * y + z * z;
  const double gr = std::pow(wave * sigma * z, 2), b = std::pow(wave * tau, 2) * (x * x + y * y) / 4;
  double sum = 0;
  const double last = 3 * gr + 2 * std::sqrt(b) + 200;
  for (double m = 1; m < last; ++m) sum += std::exp(-gr + m * std::log(gr) - std::lgamma(m + 1) - b / m) / m;
  const double d = kPi * kPi / 4 * std::pow(tau / kWavelengths[c], 2) * sum;
  return dielectric(f["eta"], g.cd) * std::pow(v2 / z, 2) * shadow(g.ci) * shadow(g.co) * d / (kPi * g.ci * g.co);
}

/// How one file's fits become parameters of a lobe of ours, by name, and what its values must be; both without the
/// scale, which each fit calls `scale`.
struct Source {
  const char* file;
  const char* lobe;
  double factor;  ///< of the paper's normalisation over ours
  const char* scale;
  std::map<std::string, std::string> parameters;  ///< ours -> the file's
  std::function<Truth(const Json&, std::size_t, const Geometry&)> formula;
};

const std::vector<Source>& sources() {
  static const std::map<std::string, std::string> cook{{"m", "roughness"}, {"ior", "eta"}},
      abc{{"B", "B"}, {"C", "C"}, {"ior", "eta"}}, ashikhmin{{"nu", "sharpness"}, {"ior", "fresnelReflectance"}},
      wards{{"ax", "roughness"}};
  static const std::vector<Source> list{
      {"bagher_sgd",
       "SGD",
       1,
       "albedo",
       {{"alpha", "alpha"},
        {"p", "p"},
        {"F0", "eta0"},
        {"F1", "eta1"},
        {"K", "K"},
        {"Lambda", "Lambda"},
        {"c", "c"},
        {"k", "k"},
        {"theta0", "theta0"}},
       bagher},
      {"low_ashikhminshirley_E1", "AshikhminShirleyDielectric", 1, "albedo", ashikhmin, lowAshikhmin},
      {"low_ashikhminshirley_E2", "AshikhminShirleyDielectric", 1, "albedo", ashikhmin, lowAshikhmin},
      {"low_cooktorrance_E1", "CookTorrance", 4, "albedo", cook, lowCookTorrance},
      {"low_cooktorrance_E2", "CookTorrance", 4, "albedo", cook, lowCookTorrance},
      {"low_lowmicrofacet_E2", "LowMicrofacet", 1, "A", abc, lowMicrofacet},
      {"low_lowsmooth_E2", "LowSmooth", 1, "A", abc, lowSmooth},
      {"ngan_ashikhminshirley",
       "AshikhminShirley",
       1,
       "albedo",
       {{"nu", "sharpness"}, {"F0", "fresnelReflectance"}},
       nganAshikhmin},
      {"ngan_blinnphong", "Phong", 1, "albedo", {{"n", "sharpness"}}, phong},
      {"ngan_cooktorrance",
       "Microfacet_Beckmann_Schlick_VGroove",
       4 / kPi,
       "albedo",
       {{"alpha", "roughness"}, {"F0", "eta"}},
       nganCookTorrance},
      {"ngan_he", "HeTorrance", 1, "albedo", {{"sigma0", "roughness"}, {"tau", "autocorrelation"}, {"eta", "eta"}}, he},
      {"ngan_lafortune", "LafortuneNgan", 1, "albedo", {{"Cxy", "Cxy"}, {"Cz", "Cz"}, {"n", "sharpness"}}, lafortune},
      {"ngan_ward", "Ward", 1, "albedo", wards, ward},
      {"ngan_wardduer", "WardDuer", 1, "albedo", wards, wardDuer}};
  return list;
}

/// The number of `name` in one channel; "eta0" and "eta1" are the rows of a fit's eta.
double numberOf(const Json& fit, const std::string& name, std::size_t channel) {
  if (name == "eta0" || name == "eta1") return fit.at("eta")[name == "eta1" ? 1 : 0][channel];
  const Json& value = fit.at(name);
  return value.is_array() ? value[channel].get<double>() : value.get<double>();
}

/// Parameters of the lobe in one channel: the file's where it has them, what follows another as that one.
std::vector<double> parametersOf(const Source& source, const Model& model, const Json& fit, std::size_t channel) {
  std::vector<double> values = model.defaults();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Parameter& p = model.parameters()[k];
    if (const auto it = source.parameters.find(p.name); it != source.parameters.end())
      values[k] = numberOf(fit, it->second, channel);
    else if (p.name == "wavelength")
      values[k] = kWavelengths[channel];
    else if (!p.follows.empty())
      values[k] = values[model.parameterIndex(p.follows)];
  }
  return values;
}

class PublishedFits : public testing::TestWithParam<Source> {
 protected:
  std::vector<std::pair<std::string, Json>> read() const {
    const auto file =
        std::filesystem::path(BRDF_SHARED_DIR) / "data" / "published_fits" / (std::string(GetParam().file) + ".json");
    std::vector<std::pair<std::string, Json>> fits;
    if (!std::filesystem::exists(file)) return fits;
    const Json content = Json::parse(readFile(file));
    for (const auto& [name, lobes] : content.at("materials").items()) fits.emplace_back(name, lobes.at(1));
    return fits;
  }
};

TEST_P(PublishedFits, LieInTheHardBoundsAndAreFiniteAndNotNegative) {
  const auto fits = read();
  if (fits.empty()) GTEST_SKIP() << "no published fits at hand";
  EXPECT_EQ(fits.size(), std::string(GetParam().file).starts_with("ngan") ? 86u : 100u);
  const ModelPointer model = findModel(GetParam().lobe);
  const CheckPairs set = adversarialPairs(3, 51, true);
  std::vector<double> values(set.size());
  for (const auto& [name, fit] : fits)
    for (std::size_t channel = 0; channel < 3; ++channel) {
      EXPECT_GE(numberOf(fit, GetParam().scale, channel), 0) << name;
      const std::vector<double> parameters = parametersOf(GetParam(), *model, fit, channel);
      for (std::size_t k = 0; k < parameters.size(); ++k)
        EXPECT_NO_THROW(model->checkBounds(k, parameters[k])) << name << ", " << parameterText(*model, parameters);
      model->evaluate(set.pairs.view(), parameters, values.data());
      for (std::size_t k = 0; k < set.size(); ++k)
        ASSERT_TRUE(std::isfinite(values[k]) && values[k] >= 0)
            << name << ", " << parameterText(*model, parameters) << ", " << directionText(set.wi(k), set.wo(k));
    }
}

TEST_P(PublishedFits, AgreeWithThePapersFormula) {
  const auto fits = read();
  if (fits.empty()) GTEST_SKIP() << "no published fits at hand";
  const ModelPointer model = findModel(GetParam().lobe);
  const CheckPairs set = adversarialPairs(4, 52, false);
  std::vector<double> values(set.size());
  std::size_t compared = 0;
  for (std::size_t at = 3; at < fits.size(); at += 16)
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const auto& [name, fit] = fits[at];
      const std::vector<double> parameters = parametersOf(GetParam(), *model, fit, channel);
      model->evaluate(set.pairs.view(), parameters, values.data());
      for (std::size_t k = 0; k < set.size(); ++k) {
        const Truth truth = GetParam().formula(fit, channel, {set.wi(k), set.wo(k)});
        if (truth.size < 1e-200) continue;
        ASSERT_NEAR(GetParam().factor * values[k], truth.value, 1e-7 * truth.size)
            << name << ", " << parameterText(*model, parameters) << ", " << directionText(set.wi(k), set.wo(k));
        ++compared;
      }
    }
  EXPECT_GT(compared, 200u);
}

INSTANTIATE_TEST_SUITE_P(Files, PublishedFits, testing::ValuesIn(sources()),
                         [](const auto& source) { return std::string(source.param.file); });

}  // namespace
}  // namespace brdf
