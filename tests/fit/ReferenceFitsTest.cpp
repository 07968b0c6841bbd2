#include <brdf/fit/Fit.h>
#include <brdf/measured/Format.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace brdf {
namespace {

/// Best fits found by a global search with another program on two measured paints: five lobes, four metrics.
class ReferenceFits : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const std::filesystem::path shared(BRDF_SHARED_DIR);
    if (!std::filesystem::exists(shared / "reference/best_fits.json") ||
        !std::filesystem::exists(shared / "data/measured/garnet_red.brdf"))
      GTEST_SKIP() << "no reference fits and measurements in " << shared;
    best_ = nlohmann::json::parse(std::ifstream(shared / "reference/best_fits.json"));
  }
  nlohmann::json best_;
};

TEST_P(ReferenceFits, AreReachedWithinTwoPercentFromTheDefaultStart) {
  for (const auto& [material, metrics] : best_["materials"].items()) {
    const ReadResult measured =
        readMeasured(std::filesystem::path(BRDF_SHARED_DIR) / "data/measured" / (material + ".brdf"));
    for (const auto& [metric, lobes] : metrics.items()) {
      FitOptions options;
      options.metric = metric;
      options.optimizer = GetParam();
      options.channels.kind = FitChannels::Kind::Luminance;
      for (const auto& [lobe, found] : lobes.items()) {
        if (lobe == "zero_model") continue;
        const FitReport report =
            fit(*measured.brdf, {{findModel("Lambertian"), {}, {}, {}}, {findModel(lobe), {}, {}, {}}}, options);
        EXPECT_LE(report.error, 1.02 * found["error"].get<double>()) << material << " " << metric << " " << lobe;
        EXPECT_NEAR(report.zeroModel.at(metric), lobes["zero_model"].get<double>(), 0.01 * report.zeroModel.at(metric))
            << "the reference's luminance agrees to 1 %";
        EXPECT_EQ(report.samples, 1439u);
        EXPECT_TRUE(report.converged) << material << " " << metric << " " << lobe << ": " << report.termination;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Optimizers, ReferenceFits, ::testing::Values("lm", "bobyqa", "neldermead", "sbplx"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace brdf
