// What all exporters share: what is said of errors, and in which words.
#include "Renderer.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/material/ScatteredBrdf.h>

#include <algorithm>

namespace brdf::test {
namespace {

TEST(Export, EveryExporterTakesTheMaterialsThatPeopleHave) {
  // A plastic, a brushed metal, something that is no sum of lobes, and nothing at all.
  const BrdfPointer plastic = parseMaterialExpression("0.4*Lambertian + GGX(alpha=0.1)");
  const BrdfPointer brushed = parseMaterialExpression("0.7*Ward(ax=0.1, ay=0.4)");
  const BrdfPointer shape = std::make_shared<ReadBack>(
      [](const Direction& l, const Direction& v) {
        const double h = halfVector(l, v)[2];
        return Colour{0.1 + std::pow(h, 60), 0, 0};
      },
      Channels::monochrome());
  const BrdfPointer black = parseMaterialExpression("0*Lambertian");
  for (const Exporter& exporter : allExporters())
    for (const BrdfPointer& material : {plastic, brushed, shape, black}) {
      ExportOptions options;
      options.metric = "rms_cos";  // the quickest to fit
      const ExportResult result = exportMaterial(material, exporter, options);
      EXPECT_FALSE(result.text.empty());
      EXPECT_TRUE(exporter.refusal(*result.evaluated).empty())
          << exporter.name << " writes " << result.evaluated->description();
      const Comparison& error = result.error.comparison;
      EXPECT_TRUE(material == black || error.metrics.at("rms_cos") < error.zeroModel.at("rms_cos"))
          << exporter.name << " is worse than black for " << material->description();
      EXPECT_EQ(result.exact, result.reason.empty());
    }
}

TEST(Export, SaysInTheFileWhatItIsAndItsError) {
  const auto material = parseMaterialExpression("0.4*Lambertian + 0.2*Ward(ax=0.1)");
  for (const Exporter& exporter : allExporters()) {
    const ExportResult result = exportMaterial(material, exporter);
    EXPECT_NE(result.text.find("0.4*Lambertian + 0.2*Ward"), std::string::npos) << exporter.name;
    EXPECT_EQ(result.text.find("rms_cos") != std::string::npos, !result.exact) << exporter.name;
    EXPECT_EQ(result.text.find("worst: ") != std::string::npos, !result.exact) << exporter.name;
  }
}

TEST(Export, FindsTheWorstOfTheMaterialsOwnSamples) {
  ScatteredSamples samples;
  samples.channels = Channels::monochrome();
  for (int t = 5; t <= 75; t += 10)
    for (int p = 0; p <= 180; p += 30) {
      samples.pairs.push(fromSpherical(radians(30), 0), fromSpherical(radians(t), radians(p)));
      samples.values.push_back(t == 35 && p == 90 ? 1.3 : 0.3);
    }
  const auto material = std::make_shared<ScatteredBrdf>(samples, "one high sample");
  const ExportResult result = exportMaterial(material, findExporter("osl"));
  EXPECT_NEAR(toSpherical(result.error.wo).theta, radians(35), 1e-9);
  EXPECT_NEAR(toSpherical(result.error.wo).phi, radians(90), 1e-9);
  EXPECT_EQ(result.error.worstMaterial, 1.3);
  EXPECT_EQ(result.error.worstEvaluated, result.evaluated->evaluate(result.error.wi, result.error.wo)[0]);
  EXPECT_EQ(result.error.comparison.samples, samples.pairs.size());
}

TEST(Export, ReducesASpectrumToColour) {
  const auto material = parseMaterialExpression("(0.1,0.2,0.3,0.4,0.3)*Lambertian + 0.5*GGX(alpha=0.2)",
                                                Channels::spectral({450, 500, 550, 600, 650}));
  const ExportResult result = exported("osl", material);
  EXPECT_TRUE(result.exact) << "a factor's spectrum is a colour";
  EXPECT_EQ(result.evaluated->channels(), Channels::rgb());
  EXPECT_LT(result.error.comparison.metrics.at("rms"), 1e-12);
  EXPECT_TRUE(
      std::ranges::any_of(result.notes, [](const std::string& n) { return n.find("sRGB") != std::string::npos; }));
}

TEST(Export, TheDocumentationNamesEveryExporter) {
  const std::string page = readFile(std::filesystem::path(BRDF_SOURCE_DIR) / "docs/exports.md");
  for (const Exporter& exporter : allExporters())
    EXPECT_NE(page.find("| `" + exporter.name + "` |"), std::string::npos) << exporter.name;
}

TEST(Export, RefusesNamesThatAreNone) {
  const auto material = parseMaterialExpression("Lambertian");
  for (const char* name : {"", "1st", "a b", "a__b", "a_", "gold\n"}) {
    ExportOptions options;
    options.name = name;
    EXPECT_THROW(exportMaterial(material, findExporter("glsl"), options), Error) << name;
  }
  EXPECT_THROW(findExporter("renderman"), Error);
}

TEST(Export, TakesAnExporterFromOutside) {
  Exporter own;
  own.name = "table-of-numbers";
  own.refusal = [](const LobeSum&) { return std::string(); };
  own.write = [](const LobeSum& sum, const ExportText&) { return sum.description(); };
  registerExporter(own);
  EXPECT_EQ(exported("table-of-numbers", parseMaterialExpression("0.5*Lambertian")).text, "0.5*Lambertian");
}

}  // namespace
}  // namespace brdf::test
