// Radiance / WINDOW6 XML: small files written by hand (tests/data), values at directions computed by hand.
#include <brdf/material/PatchBrdf.h>
#include <brdf/material/TreeBrdf.h>
#include <brdf/measured/Format.h>

#include <algorithm>
#include <random>

#include "MeasuredSupport.h"

namespace {

using brdf::ComponentKind;
using brdf::Direction;
using measuredtest::errorOf;
using measuredtest::folder;

std::filesystem::path dataPath(const char* name) {
  return std::filesystem::path(BRDF_SOURCE_DIR) / "tests/data" / name;
}

brdf::ReadResult readData(const char* name, const std::vector<std::string>& options = {}) {
  return brdf::readMeasured(dataPath(name), brdf::parseReadOptions(options));
}

bool mentions(const std::vector<std::string>& sentences, const std::string& text) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& sentence) { return sentence.find(text) != std::string::npos; });
}

Direction spherical(double theta, double phi) { return brdf::fromSpherical(brdf::radians(theta), brdf::radians(phi)); }

double value(const brdf::Brdf& brdf, const Direction& wi, const Direction& wo) { return brdf.evaluate(wi, wo)[0]; }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  std::size_t at = 0;
  int count = 0;
  while ((at = text.find(from, at)) != std::string::npos) {
    text.replace(at, from.size(), to);
    at += to.size();
    ++count;
  }
  EXPECT_GT(count, 0) << from;
  return text;
}

}  // namespace

TEST(Radiance, ColumnsAndRowsOfAnAsymmetricMatrixSayTheSame) {
  // Value (outgoing + 1).(incident + 1); 5 incident patches (one below 45 degrees, four beyond), 3 outgoing ones (one
  // below 60 degrees, two beyond).
  for (const char* name : {"radiance_columns.xml", "radiance_rows.xml"}) {
    const auto result = readData(name);
    EXPECT_EQ(result.report.format, "radiance") << name;
    EXPECT_EQ(result.report.samples, 15u);
    const brdf::Brdf& brdf = *result.brdf;
    EXPECT_EQ(brdf.channels(), brdf::Channels::monochrome());
    EXPECT_EQ(value(brdf, {0, 0, 1}, {0, 0, 1}), 1.1);
    EXPECT_EQ(value(brdf, spherical(44, 77), spherical(59, 200)), 1.1);
    // Light from azimuth 0 travels toward 180 degrees: patch 2 of the ring, number 3.
    EXPECT_EQ(value(brdf, spherical(46, 0), {0, 0, 1}), 1.4);
    EXPECT_EQ(value(brdf, spherical(60, 180), {0, 0, 1}), 1.2);
    EXPECT_EQ(value(brdf, spherical(60, 80), {0, 0, 1}), 1.5);
    EXPECT_EQ(value(brdf, spherical(60, -90), {0, 0, 1}), 1.3);
    // Two azimuths: patch 0 from -90 to 90 degrees.
    EXPECT_EQ(value(brdf, {0, 0, 1}, spherical(61, 80)), 2.1);
    EXPECT_EQ(value(brdf, {0, 0, 1}, spherical(89, -80)), 2.1);
    EXPECT_EQ(value(brdf, spherical(60, 0), spherical(70, 100)), 3.4);
    EXPECT_EQ(result.report.metadata.at("Name"), "hand-made");
    EXPECT_EQ(result.report.metadata.at("Thickness"), "0.012 meter");
    // sum of value x projected solid angle of incident patch 5: pi (0.75 x 1.5 + 0.125 x 2.5 + 0.125 x 3.5).
    EXPECT_EQ(result.report.metadata.at("largest albedo, front reflection"), "5.89");
    EXPECT_TRUE(mentions(result.report.warnings, "energy"));
    EXPECT_TRUE(mentions(result.report.assumptions, "sides: swapped"));
  }
  EXPECT_EQ(readData("radiance_columns.xml").report.metadata.at("wavelengths not read"), "Solar");
}

TEST(Radiance, FourDirectionsBecomeFourComponents) {
  // One ring of four patches about the azimuths 0, 90, 180, 270. Value n + (10 outgoing + incident)/100, n = 1 for
  // Reflection Back, 2 Reflection Front, 3 Transmission Back, 4 Transmission Front.
  const auto result = readData("radiance_sides.xml");
  EXPECT_TRUE(mentions(result.report.warnings, "energy"));
  ASSERT_EQ(result.components.scatter.size(), 3u);
  // Light from azimuth 0 travels to 180 (patch 2); the viewer at 90 (patch 1).
  EXPECT_EQ(value(*result.brdf, spherical(30, 0), spherical(40, 90)), 1.12);
  // Light from the front at azimuth 0, leaving through the back toward azimuth 90: described mirrored, same azimuths.
  EXPECT_EQ(value(*result.components.find(ComponentKind::FrontTransmission), spherical(30, 0), spherical(40, 90)),
            3.12);
  // On the back: light from (0, 0.6, -0.8) travels to azimuth 270, patch 3; it leaves to (0.6, 0, -0.8), patch 0.
  // Turned over about x these are (0, -0.6, 0.8) and (0.6, 0, 0.8).
  const auto back = result.components.find(ComponentKind::BackReflection);
  EXPECT_EQ(value(*back, {0, -0.6, 0.8}, {0.6, 0, 0.8}), 2.03);
  // It leaves to (0, 0.6, -0.8), patch 1: turned over (0, -0.6, 0.8), which is back where it came from.
  EXPECT_EQ(value(*back, {0, -0.6, 0.8}, {0, -0.6, 0.8}), 2.13);
  // From the back to the front toward (0, 0.6, 0.8), patch 1: turned over (0, -0.6, -0.8), described mirrored.
  EXPECT_EQ(value(*result.components.find(ComponentKind::BackTransmission), {0, -0.6, 0.8}, {0, -0.6, 0.8}), 4.13);
}

TEST(Radiance, SidesAsStatedTurnTheSheetOver) {
  const auto usual = readData("radiance_sides.xml"), stated = readData("radiance_sides.xml", {"sides=as_stated"});
  EXPECT_TRUE(mentions(stated.report.assumptions, "sides: as_stated (given"));
  const auto back = usual.components.find(ComponentKind::BackReflection);
  const auto through = usual.components.find(ComponentKind::BackTransmission);
  const auto statedThrough = stated.components.find(ComponentKind::FrontTransmission);
  for (double phiI = 10; phiI < 360; phiI += 90)
    for (double phiO = 20; phiO < 360; phiO += 90) {
      const Direction wi = spherical(50, phiI), wo = spherical(20, phiO);
      EXPECT_EQ(value(*stated.brdf, wi, wo), value(*back, wi, wo));
      EXPECT_EQ(value(*statedThrough, wi, wo), value(*through, wi, wo));
    }
}

TEST(Radiance, GreyTristimulusValuesAreGrey) {
  const auto result = readData("radiance_colour.xml");
  EXPECT_EQ(result.brdf->channels(), brdf::Channels::rgb());
  for (const double v : result.brdf->evaluate({0, 0, 1}, {0, 0, 1})) EXPECT_NEAR(v, 0.2, 1e-15);
  EXPECT_TRUE(mentions(result.report.assumptions, "a grey has X = Y = Z"));
  // Taken as relative to D65, equal energy is reddish: IEC 61966-2-1 gives R = 3.2406 - 1.5372 - 0.4986 of it.
  const auto xyz = readData("radiance_colour.xml", {"colour=xyz"});
  const auto rgb = xyz.brdf->evaluate({0, 0, 1}, {0, 0, 1});
  EXPECT_NEAR(rgb[0], 0.2 * 1.2048, 1e-4);
  EXPECT_NEAR(rgb[1], 0.2 * (-0.9689 + 1.8758 + 0.0415), 1e-4);
  EXPECT_NEAR(rgb[2], 0.2 * (0.0557 - 0.2040 + 1.0570), 1e-4);
  EXPECT_NE(errorOf([] { readData("radiance_colour.xml", {"colour=srgb"}); }).find("no meaning"), std::string::npos);
}

TEST(Radiance, TreeOfRankThreeHasItsChildrenAndLeavesInOrder) {
  const auto result = readData("radiance_tree3.xml");
  const brdf::Brdf& brdf = *result.brdf;
  EXPECT_EQ(brdf.symmetry(), brdf::Symmetry::Bilateral);
  // Children: bit 0 the upper half of x0, bit 1 of x1, bit 2 of x2. Light at 30 degrees: x0 = (1 - 1/2)/2 = 1/4, lower.
  // Viewers 30 degrees to either side of the mirror direction and of the light.
  const Direction wi = spherical(30, 0);
  EXPECT_EQ(value(brdf, wi, spherical(30, -150)), 0.07);  // x1 upper, x2 upper: child 6
  EXPECT_EQ(value(brdf, wi, spherical(30, 30)), 0.01);    // x1 lower, x2 lower: child 0
  EXPECT_EQ(value(brdf, wi, spherical(30, -30)), 0.05);   // x1 lower, x2 upper: child 4
  // Child 2 (x1 upper, x2 lower) is a grid of eight, x2 fastest: x0 = 1/4 is its upper half, x1 = 3/4 its upper half,
  // x2 = 1/3 its upper half: number 7.
  EXPECT_EQ(value(brdf, wi, spherical(30, 150)), 0.18);
  // Grazing light, x0 < 1/4: the lower half: number 3.
  EXPECT_EQ(value(brdf, spherical(60, 0), spherical(30, 150)), 0.14);
  // Near the normal x1 = 0.55 or so, x2 a little below 1/2: number 5.
  EXPECT_EQ(value(brdf, wi, spherical(6, 150)), 0.16);
  // Far out at 40 degrees to the side, x2 = (1 - 8/9 0.95)/2 < 1/4: number 6.
  EXPECT_EQ(value(brdf, wi, brdf::fromSpherical(std::asin(0.95), brdf::radians(140))), 0.17);
}

TEST(Radiance, TreeOfRankFourHasItsChildrenAndLeavesInOrder) {
  const auto result = readData("radiance_tree4.xml");
  // Light from (0.6, 0.2): travel (-0.6, -0.2): x0, x1 lower. Viewer (0.3, -0.4): x2 upper, x3 lower: child 4.
  const auto lifted = [](double x, double y) { return Direction{x, y, std::sqrt(1 - x * x - y * y)}; };
  EXPECT_EQ(value(*result.brdf, lifted(0.6, 0.2), lifted(0.3, -0.4)), 0.05);
  EXPECT_EQ(value(*result.brdf, lifted(-0.6, 0.2), lifted(0.3, -0.4)), 0.06);   // child 5
  EXPECT_EQ(value(*result.brdf, lifted(0.6, -0.2), lifted(-0.3, -0.4)), 0.03);  // child 2
  EXPECT_EQ(value(*result.brdf, lifted(0.6, 0.2), lifted(-0.3, 0.4)), 0.09);    // child 8
  // Transmission Front is the back's: as a grid of 16, x3 fastest. Turned over, y changes its sign: the light comes
  // from (0.6, -0.2) of the sheet and leaves to (0.3, 0.4): x0 lower, x1 upper, x2 upper, x3 upper: number 4 + 2 + 1.
  const auto back = result.components.find(ComponentKind::BackTransmission);
  EXPECT_EQ(value(*back, lifted(0.6, 0.2), lifted(0.3, -0.4)), 0.08);
  EXPECT_EQ(value(*back, lifted(0.6, -0.2), lifted(0.3, 0.4)), 0.03);  // numbers 2
}

TEST(Radiance, TreesOfColourMeetOnTheirCommonRefinement) {
  const auto result = readData("radiance_tree_colour.xml");
  EXPECT_EQ(dynamic_cast<const brdf::TreeBrdf&>(*result.brdf).tree().cells(), 15u);
  for (const double phi : {10.0, 100.0, 200.0, 300.0})
    for (const double v : result.brdf->evaluate(spherical(40, 0), spherical(50, phi))) EXPECT_NEAR(v, 0.2, 1e-14);
}

TEST(Radiance, AcceptsByteOrderMarksLineEndsAndTabs) {
  const auto dir = folder("radiance_bytes");
  const std::string text = brdf::readFile(dataPath("radiance_rows.xml"));
  const std::string variants[] = {"\xEF\xBB\xBF" + text,
                                  replaced(text, "\n", "\r\n"),
                                  replaced(text, ", ", ",\t"),
                                  replaced(text, ", ", "\n"),
                                  replaced(text, ">Rows<", ">\n rows\t<"),
                                  replaced(text, "Reflection Back", "reflection back")};
  for (const std::string& variant : variants) {
    brdf::writeFile(dir / "a.dat", variant);
    const auto result = brdf::readMeasured(dir / "a.dat");
    EXPECT_EQ(result.report.format, "radiance");
    EXPECT_EQ(value(*result.brdf, spherical(60, 0), spherical(70, 100)), 3.4);
  }
}

TEST(Radiance, NegativeAndNotFiniteValuesAreZeroAndCounted) {
  const auto dir = folder("radiance_defects");
  std::string text = replaced(brdf::readFile(dataPath("radiance_rows.xml")), "1.1,", "-1.1,");
  brdf::writeFile(dir / "a.xml", replaced(text, "3.4", "nan"));
  const auto result = brdf::readMeasured(dir / "a.xml");
  EXPECT_EQ(result.report.negative, 1u);
  EXPECT_EQ(result.report.notFinite, 1u);
  EXPECT_EQ(value(*result.brdf, {0, 0, 1}, {0, 0, 1}), 0);
  EXPECT_EQ(value(*result.brdf, spherical(60, 0), spherical(70, 100)), 0);
  EXPECT_TRUE(mentions(result.report.warnings, "1 negative and 1 not finite"));
}

TEST(Radiance, DamagedFilesAreErrorsThatNameTheLine) {
  const auto dir = folder("radiance_damaged");
  const std::string rows = brdf::readFile(dataPath("radiance_rows.xml"));
  const std::string tree = brdf::readFile(dataPath("radiance_tree3.xml"));
  const std::string leaf = "{.01} {.02}";
  std::string deep = "{0}";
  for (int level = 0; level < 40; ++level) deep = "{" + deep + "{0}{0}{0}{0}{0}{0}{0}}";
  const struct {
    std::string text;
    const char* expected;
  } cases[] = {
      {rows.substr(0, rows.size() - 30), "not well-formed XML"},
      {replaced(rows, "3.5\n", "\n"), "line 33: wrong number of values in ScatteringData; found 14; allowed: 15"},
      {replaced(rows, "3.5\n", "3.5 9\n"), "found 16; allowed: 15"},
      {replaced(rows, "2.3", "2,,3"), "line 36: no number in ScatteringData"},
      {replaced(rows, "2.3", "x.3"), "found \"x.3"},
      {replaced(rows, ">Rows<", ">Diagonals<"), "line 13: wrong IncidentDataStructure"},
      {replaced(rows, ">Five</ColumnAngleBasis", ">Six</ColumnAngleBasis"), "line 30: unknown ColumnAngleBasis"},
      {replaced(rows, "<nPhis>4<", "<nPhis>-4<"), "line 17: wrong nPhis"},
      {replaced(rows, "<nPhis>4<", "<nPhis>900000<"), "wrong number of azimuths"},
      {replaced(rows, "<nPhis>4<", "<nPhis>100000<"), "found 15; allowed: 300003"},
      {replaced(rows, "<nPhis>4</nPhis>", ""), "without nPhis"},
      {replaced(rows, "<LowerTheta>45<", "<LowerTheta>46<"), "rings of an AngleBasis do not meet"},
      {replaced(rows, "<UpperTheta>90<", "<UpperTheta>900<"), "polar angles out of order"},
      {replaced(rows, ">Visible<", ">Solar<"), "no Visible data"},
      {replaced(rows, "Reflection Back", "Reflection Sideways"), "no Visible data of a known direction"},
      {replaced(rows, "Optical", "Acoustical"), "no Optical with a Layer"},
      {replaced(tree, leaf, "{.01}"), "line 23: a node of the tensor tree is missing; found \"}\"; allowed: '{'"},
      {replaced(tree, leaf, "{.01 .02}"), "wrong number of values in a node of the tensor tree; found 2"},
      {replaced(tree, leaf, "{.01 {.02}"), "no number in ScatteringData"},
      {replaced(tree, "{.08} }", "{.08}"), "does not end"},
      {replaced(tree, "{.08} }", "{.08} } }"), "something follows"},
      {replaced(tree, leaf, deep + "{.02}"), "the tensor tree is too deep; found 32 levels; allowed: 31"},
      {replaced(tree, leaf, std::string(100000, '{')), "the tensor tree is too deep"},
      {replaced(tree, "LBNL/Shirley-Chiu", "LBNL/Klems Full"), "wrong AngleBasis of a tensor tree"},
      {replaced(replaced(rows, "<WindowElement ",
                         "<!DOCTYPE w [<!ENTITY b \"1 1\"><!ENTITY c \"&b;&b;\">]>\n<WindowElement "),
                "1.1,", "&c;"),
       "no number in ScatteringData; found \"&c;"},
  };
  for (const auto& [text, expected] : cases) {
    brdf::writeFile(dir / "a.xml", text);
    const std::string error = errorOf([&] { brdf::readMeasured(dir / "a.xml"); });
    EXPECT_NE(error.find(expected), std::string::npos) << error << "\nexpected: " << expected;
    EXPECT_NE(error.find("a.xml"), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

TEST(Radiance, AnyCutOrChangedByteIsReadOrRefused) {
  const auto dir = folder("radiance_mutated");
  std::mt19937 engine(4);
  for (const char* name : {"radiance_sides.xml", "radiance_tree3.xml", "radiance_tree_colour.xml"}) {
    const std::string text = brdf::readFile(dataPath(name));
    const auto& format = brdf::findFormat("radiance");
    for (int k = 0; k < 400; ++k) {
      std::string changed = text;
      if (k % 2 == 0)
        changed.resize(engine() % text.size());
      else
        for (int n = 0; n < 3; ++n) changed[engine() % text.size()] = "0{}<>,9e&-"[engine() % 10];
      try {
        const auto result = format.read(changed, "a.xml", {});
        EXPECT_TRUE(std::isfinite(value(*result.brdf, spherical(30, 10), spherical(20, 50))));
      } catch (const brdf::Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
  }
}

TEST(Radiance, OtherXmlIsNotTaken) {
  const auto& format = brdf::findFormat("radiance");
  const auto score = [&](const std::string& text) { return format.recognise(text, text.size()); };
  EXPECT_GT(score("<?xml version=\"1.0\"?><!-- <a> -->\n<!DOCTYPE x>\n<WindowElement>"), 90);
  EXPECT_GT(score("<WindowElement xmlns=\"a\">"), 90);
  EXPECT_EQ(score("<?xml version=\"1.0\"?><brdf><WindowElement>"), 0);
  EXPECT_EQ(score("<WindowElements>"), 0);
  EXPECT_EQ(score("<!-- <WindowElement> -->"), 0);
  EXPECT_EQ(score("text <WindowElement>"), 0);
  EXPECT_EQ(score("<WindowElement"), 0);
  EXPECT_EQ(score(""), 0);
}
