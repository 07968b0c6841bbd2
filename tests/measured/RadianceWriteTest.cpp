// Radiance / WINDOW6 XML written and read back.
#include <brdf/base/Error.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/PatchBrdf.h>
#include <brdf/material/TreeBrdf.h>
#include <brdf/measured/RadianceXml.h>

#include <algorithm>
#include <random>

#include "MeasuredSupport.h"

namespace {

using brdf::ComponentKind;
using brdf::Direction;
using measuredtest::folder;

bool mentions(const std::vector<std::string>& sentences, const std::string& text) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& sentence) { return sentence.find(text) != std::string::npos; });
}

class Directions {
 public:
  Direction next() {
    const double radius = std::sqrt(0.95 * uniform_(engine_)), phi = 2 * brdf::kPi * uniform_(engine_);
    return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(1 - radius * radius)};
  }

 private:
  std::mt19937_64 engine_{12};
  std::uniform_real_distribution<double> uniform_;
};

/// The largest relative difference of values at random pairs.
double worstDifference(const brdf::Brdf& a, const brdf::Brdf& b) {
  Directions directions;
  double worst = 0;
  for (int k = 0; k < 3000; ++k) {
    const Direction wi = directions.next(), wo = directions.next();
    const auto x = a.evaluate(wi, wo), y = b.evaluate(wi, wo);
    EXPECT_EQ(x.size(), y.size());
    for (std::size_t c = 0; c < x.size(); ++c)
      worst = std::max(worst, std::abs(x[c] - y[c]) / std::max(std::abs(x[c]), 1e-3));
  }
  return worst;
}

std::shared_ptr<const brdf::PatchBrdf> somePatches(brdf::PatchBasis incident, brdf::PatchBasis outgoing,
                                                   const brdf::Channels& channels, double first) {
  brdf::PatchData data{std::move(incident), std::move(outgoing), channels, {}};
  const std::size_t count = data.incident.count() * data.outgoing.count() * channels.count();
  for (std::size_t k = 0; k < count; ++k) data.values.push_back(first + static_cast<double>(k % 97) / 7000);
  return std::make_shared<const brdf::PatchBrdf>(std::move(data), "some <patches> & more");
}

std::shared_ptr<const brdf::TreeBrdf> someTree(int rank, const brdf::Channels& channels, double first) {
  brdf::TensorTree tree(rank, channels.count());
  const brdf::TensorTree::Node child = tree.divide(0);
  tree.divide(tree.divide(child + 2) + 5);
  for (std::size_t cell = 0; cell < tree.cells(); ++cell)
    for (std::size_t c = 0; c < channels.count(); ++c)
      tree.values(cell)[c] = first + static_cast<double>((cell * 5 + c * 3) % 23) / 700;
  return std::make_shared<const brdf::TreeBrdf>(std::move(tree), channels, "some tree");
}

}  // namespace

TEST(RadianceWrite, MatricesAndTheirComponentsComeBackExactly) {
  const auto dir = folder("radiance_exact");
  const brdf::PatchBasis odd("Odd", {{brdf::radians(20), 1}, {brdf::radians(50), 5}, {brdf::radians(90), 7}});
  const brdf::PatchBasis namesake("odd", {{brdf::radians(33.3), 2}, {brdf::radians(90), 3}});
  const auto front = somePatches(odd, namesake, brdf::Channels::monochrome(), 0.01);
  brdf::Components components;
  components.scatter.push_back({ComponentKind::BackReflection, somePatches(brdf::PatchBasis::klemsQuarter(), odd,
                                                                           brdf::Channels::monochrome(), 0.02)});
  components.scatter.push_back(
      {ComponentKind::FrontTransmission, somePatches(odd, odd, brdf::Channels::monochrome(), 0.03)});
  components.scatter.push_back(
      {ComponentKind::BackTransmission, somePatches(namesake, odd, brdf::Channels::monochrome(), 0.04)});
  const auto report = brdf::writeMeasured(*front, components, dir / "a.xml");
  EXPECT_TRUE(report.losses.empty()) << report.losses[0];
  const auto back = brdf::readMeasured(dir / "a.xml");
  EXPECT_EQ(dynamic_cast<const brdf::PatchBrdf&>(*back.brdf).data().values, front->data().values);
  EXPECT_EQ(back.report.metadata.at("Name"), "some <patches> & more");
  EXPECT_EQ(worstDifference(*back.brdf, *front), 0);
  ASSERT_EQ(back.components.scatter.size(), 3u);
  for (const auto& component : components.scatter)
    EXPECT_EQ(worstDifference(*back.components.find(component.kind), *component.brdf), 0)
        << brdf::componentName(component.kind);
}

TEST(RadianceWrite, TreesAndTheirComponentsComeBackExactly) {
  const auto dir = folder("radiance_exact_tree");
  for (const int rank : {3, 4}) {
    const auto front = someTree(rank, brdf::Channels::monochrome(), 0.01);
    brdf::Components components;
    for (const auto kind :
         {ComponentKind::BackReflection, ComponentKind::FrontTransmission, ComponentKind::BackTransmission})
      components.scatter.push_back(
          {kind, someTree(rank, brdf::Channels::monochrome(), 0.02 + 0.01 * static_cast<double>(kind))});
    const auto report = brdf::writeMeasured(*front, components, dir / "a.xml");
    EXPECT_TRUE(report.losses.empty()) << report.losses[0];
    const auto back = brdf::readMeasured(dir / "a.xml");
    EXPECT_EQ(worstDifference(*back.brdf, *front), 0) << rank;
    ASSERT_EQ(back.components.scatter.size(), 3u);
    for (const auto& component : components.scatter)
      EXPECT_EQ(worstDifference(*back.components.find(component.kind), *component.brdf), 0)
          << rank << " " << brdf::componentName(component.kind);
  }
}

TEST(RadianceWrite, ColoursComeBackWithinTheirDigits) {
  const auto dir = folder("radiance_colours");
  const auto patches =
      somePatches(brdf::PatchBasis::klemsQuarter(), brdf::PatchBasis::klemsQuarter(), brdf::Channels::rgb(), 0.05);
  EXPECT_TRUE(brdf::writeMeasured(*patches, dir / "a.xml").losses.empty());
  EXPECT_LT(worstDifference(*brdf::readMeasured(dir / "a.xml").brdf, *patches), 1e-13);
  const auto tree = someTree(4, brdf::Channels::rgb(), 0.05);
  EXPECT_TRUE(brdf::writeMeasured(*tree, dir / "b.xml").losses.empty());
  EXPECT_LT(worstDifference(*brdf::readMeasured(dir / "b.xml").brdf, *tree), 1e-8);  // u' and v' have ten digits
}

TEST(RadianceWrite, LambertianIsOneOverPiEverywhere) {
  const auto dir = folder("radiance_lambertian");
  const auto lambertian = brdf::parseMaterialExpression("Lambertian");
  for (const char* format : {"radiance", "radiance_klems", "radiance_tree"}) {
    const auto report = brdf::writeMeasured(*lambertian, dir / "a.xml", format);
    EXPECT_TRUE(mentions(report.losses, "estimated error of the means at most")) << format;
    const auto back = brdf::readMeasured(dir / "a.xml");
    EXPECT_EQ(back.report.format, "radiance");
    EXPECT_LT(worstDifference(*back.brdf, *lambertian), 5e-7) << format;
    EXPECT_EQ(back.report.metadata.at("largest albedo, front reflection"), "1") << format;
    EXPECT_TRUE(back.report.warnings.empty());
    EXPECT_EQ(back.brdf->symmetry(),
              format == std::string("radiance_tree") ? brdf::Symmetry::Isotropic : brdf::Symmetry::Anisotropic);
  }
}

TEST(RadianceWrite, KindsAreKeptUnlessTheFormatNamesAnother) {
  const auto dir = folder("radiance_kinds");
  const auto kindOf = [&](const brdf::Brdf& brdf, const char* format) {
    const auto report = brdf::writeMeasured(brdf, dir / "a.xml", format);
    const auto back = brdf::readMeasured(dir / "a.xml");
    const bool tree = dynamic_cast<const brdf::TreeBrdf*>(back.brdf.get()) != nullptr;
    return std::string(tree ? "tree" : "matrix") + (report.losses.empty() ? "" : " of means");
  };
  const auto tree = someTree(3, brdf::Channels::monochrome(), 0.01);
  const auto patches =
      somePatches(brdf::PatchBasis::klemsFull(), brdf::PatchBasis::klemsFull(), brdf::Channels::monochrome(), 0.01);
  EXPECT_EQ(kindOf(*tree, "radiance"), "tree");
  EXPECT_EQ(kindOf(*tree, "radiance_tree"), "tree");
  brdf::RadianceWriteOptions options;
  options.structure = brdf::RadianceWriteOptions::Structure::Matrix;
  options.basis = brdf::PatchBasis::klemsQuarter();
  EXPECT_FALSE(brdf::writeRadiance(tree.get(), {}, dir / "b.xml", options).losses.empty());
  EXPECT_NE(dynamic_cast<const brdf::PatchBrdf*>(brdf::readMeasured(dir / "b.xml").brdf.get()), nullptr);
  EXPECT_EQ(kindOf(*patches, "radiance"), "matrix");
  EXPECT_EQ(kindOf(*patches, "radiance_klems"), "matrix");
}

TEST(RadianceWrite, GlossyMeansKeepTheEnergyAndTellTheirError) {
  const auto dir = folder("radiance_glossy");
  const auto glossy = brdf::parseMaterialExpression("(0.3,0.1,0.05)*Lambertian + 0.5*GGX(alpha=0.3)");
  brdf::Components components;
  components.specular.push_back({ComponentKind::FrontReflection, brdf::Channels::monochrome(), {0}, {0.1}});
  const auto report = brdf::writeMeasured(*glossy, components, dir / "a.xml");
  ASSERT_EQ(report.losses.size(), 2u);
  EXPECT_TRUE(mentions(report.losses, "means over 145 x 145 patches"));
  EXPECT_TRUE(mentions(report.losses, "specular"));
  const auto back = brdf::readMeasured(dir / "a.xml");
  const auto& patches = dynamic_cast<const brdf::PatchBrdf&>(*back.brdf);
  // The albedo of normal incidence, by a fine sum over outgoing directions, against that of the patches about it.
  std::array<double, 3> albedo{};
  constexpr int n = 200;
  const Direction wi{0, 0, 1};
  for (int k = 0; k < n; ++k) {
    const double sin2 = (k + 0.5) / n;  // the lobe is round at normal incidence
    const auto value = glossy->evaluate(wi, {std::sqrt(sin2), 0, std::sqrt(1 - sin2)});
    for (std::size_t c = 0; c < 3; ++c) albedo[c] += value[c] * brdf::kPi / n;
  }
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(patches.directionalAlbedos()[c * 145], albedo[c], 3e-3 * albedo[c]);
}

TEST(RadianceWrite, OptionsChooseTheBasisAndTheDepth) {
  const auto dir = folder("radiance_options");
  const auto glossy = brdf::parseMaterialExpression("0.3*Lambertian + 0.1*Ward(ax=0.2, ay=0.5)");
  brdf::RadianceWriteOptions options;
  options.basis = brdf::PatchBasis::klemsQuarter();
  brdf::writeRadiance(glossy.get(), {}, dir / "a.xml", options);
  EXPECT_EQ(brdf::readMeasured(dir / "a.xml").report.samples, 41u * 41u);
  options.structure = brdf::RadianceWriteOptions::Structure::Tree;
  options.tree = {.levels = 3, .tolerance = 0, .points = 2};
  brdf::writeRadiance(glossy.get(), {}, dir / "b.xml", options);
  const auto tree = brdf::readMeasured(dir / "b.xml");
  EXPECT_EQ(dynamic_cast<const brdf::TreeBrdf&>(*tree.brdf).tree().rank(), 4);
  EXPECT_EQ(tree.report.samples, 4096u);
}

TEST(RadianceWrite, MaterialsWithoutAFrontReflectionKeepWhatTheyHave) {
  const auto dir = folder("radiance_no_front");
  brdf::Components components;
  components.front = false;
  components.scatter.push_back({ComponentKind::FrontTransmission, someTree(3, brdf::Channels::monochrome(), 0.01)});
  const brdf::BrdfPointer stand = components.scatter[0].brdf;
  EXPECT_TRUE(brdf::writeMeasured(*stand, components, dir / "a.xml", "radiance").losses.empty());
  const auto back = brdf::readMeasured(dir / "a.xml");
  EXPECT_FALSE(back.components.front);
  ASSERT_EQ(back.components.scatter.size(), 1u);
  EXPECT_EQ(back.components.scatter[0].kind, ComponentKind::FrontTransmission);
  EXPECT_EQ(back.brdf, back.components.scatter[0].brdf);
  EXPECT_EQ(worstDifference(*back.brdf, *stand), 0);
  EXPECT_TRUE(mentions(back.report.warnings, "no front reflection"));
  EXPECT_THROW(brdf::writeRadiance(nullptr, {}, dir / "b.xml"), brdf::Error);
}

TEST(RadianceWrite, TheFormatsSettingsReachTheWriter) {
  const auto material = brdf::parseMaterialExpression("0.3*Lambertian + 0.1*GGX(alpha=0.4)");
  const auto folderOf = folder("settings");
  const auto written = [&](const std::string& format) {
    const auto path = folderOf / "a.xml";
    brdf::writeMeasured(*material, path, format);
    return brdf::readMeasured(path).brdf;
  };
  const auto patches = [&](const std::string& format) {
    const auto brdf = written(format);
    return dynamic_cast<const brdf::PatchBrdf&>(*brdf).data().incident.count();
  };
  const auto cells = [&](const std::string& format) {
    const auto brdf = written(format);
    return dynamic_cast<const brdf::TreeBrdf&>(*brdf).tree().cells();
  };
  EXPECT_EQ(patches("radiance_klems"), 145u);
  EXPECT_EQ(patches("radiance_klems:basis=half"), 77u);
  EXPECT_EQ(patches("radiance_klems:basis=quarter,tolerance=0.1"), 41u);
  EXPECT_LE(cells("radiance_tree:depth=2"), 64u);  // 4^3, of which half are not used
  EXPECT_GT(cells("radiance_tree:depth=4,tolerance=0.01"), cells("radiance_tree:depth=4,tolerance=0.5"));
  for (const char* wrong :
       {"radiance_klems:basis=large", "radiance_klems:depth=3", "radiance_tree:depth=9", "radiance_tree:depth=2.5",
        "radiance_tree:depth=2,depth=3", "radiance_tree:", "merl:depth=3"})
    EXPECT_THROW(brdf::writeMeasured(*material, folderOf / "b.xml", wrong), brdf::Error) << wrong;
  EXPECT_FALSE(std::filesystem::exists(folderOf / "b.xml"));
}
