// What holds for the files of all lighting programs: round trips, components, texts of any line end, locales, damage.
#include <brdf/material/GridBrdf.h>
#include <brdf/material/ScatteredBrdf.h>

#include <algorithm>
#include <locale>
#include <random>

#include "LightingSupport.h"

namespace {

using namespace lightingtest;
namespace fs = std::filesystem;
using brdf::AxisQuantity;
using brdf::Channels;
using brdf::ComponentKind;
using brdf::GridAxis;
using brdf::GridBrdf;
using brdf::GridLayout;
using brdf::Parametrisation;

/// A layout with odd angles, in an order of axes of its own.
GridLayout specular(bool mirror, bool turns, bool offsets) {
  GridLayout layout{Parametrisation::Specular,
                    {GridAxis::listedDegrees(AxisQuantity::ThetaI, {0, 20.1, 47, 70}),
                     GridAxis::listedDegrees(AxisQuantity::SpecularTheta, {0, 0.3, 5, 33.3, 90}),
                     mirror ? GridAxis::listedDegrees(AxisQuantity::SpecularPhi, {0, 61, 180})
                            : GridAxis::listedDegrees(AxisQuantity::SpecularPhi, {0, 90, 181, 270}).periodic()},
                    {.mirror = mirror}};
  if (turns) layout.axes.push_back(GridAxis::listedDegrees(AxisQuantity::PhiI, {0, 100, 200, 300}).periodic());
  if (offsets) layout.specularOffsets = {0, radians(-3), radians(-7.7), radians(-11)};
  return layout;
}

GridLayout spherical(bool mirror, bool turns) {
  GridLayout layout{Parametrisation::Spherical,
                    {GridAxis::listedDegrees(AxisQuantity::ThetaI, {0, 20.1, 47, 70}),
                     GridAxis::listedDegrees(AxisQuantity::ThetaO, {0, 0.3, 5, 33.3, 90})},
                    {.mirror = mirror}};
  const auto phi = turns ? AxisQuantity::PhiO : AxisQuantity::PhiDifference;
  layout.axes.push_back(mirror ? GridAxis::listedDegrees(phi, {0, 61, 180})
                               : GridAxis::listedDegrees(phi, {0, 90, 181, 270}).periodic());
  if (turns) layout.axes.push_back(GridAxis::listedDegrees(AxisQuantity::PhiI, {0, 100, 200, 300}).periodic());
  return layout;
}

GridLayout halfDifference(bool mirror, bool reciprocal, bool turns) {
  GridLayout layout{Parametrisation::HalfDifference,
                    {GridAxis::listedDegrees(AxisQuantity::ThetaH, {0, 0.7, 20, 88}),
                     GridAxis::listedDegrees(AxisQuantity::ThetaD, {0, 31, 70})},
                    {.mirror = mirror, .reciprocal = reciprocal}};
  std::vector<double> phi{0, 13, 90};
  if (!reciprocal || !mirror) phi.push_back(mirror ? 180 : 151);
  if (!reciprocal && !mirror) phi.push_back(265);
  GridAxis axis = GridAxis::listedDegrees(AxisQuantity::PhiD, phi);
  if (!mirror) axis.period = reciprocal ? brdf::kPi : 2 * brdf::kPi;
  layout.axes.push_back(axis);
  if (turns) layout.axes.push_back(GridAxis::listedDegrees(AxisQuantity::PhiH, {0, 100, 200, 300}).periodic());
  return layout;
}

/// Random values; cells below the horizon invalid.
std::shared_ptr<const GridBrdf> randomGrid(const GridLayout& layout, const Channels& channels, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::lognormal_distribution<double> value(-2, 2);
  brdf::GridData data{layout, channels, {}, {}};
  data.values.resize(layout.cells() * channels.count());
  for (double& v : data.values) v = value(engine);
  brdf::invalidateBelowHorizon(data);
  return std::make_shared<GridBrdf>(std::move(data), "random");
}

struct Case {
  const char *format, *file;
  Channels channels;
  GridLayout layout;
  double precision;  ///< relative, of a value
};

std::vector<Case> cases() {
  const Channels mono = Channels::monochrome(), rgb = Channels::rgb(), spectral = Channels::spectral({450, 550.5, 650});
  // Integra holds pi f_r: two roundings. XYZ and back: the matrices' rounding, cancellation included.
  constexpr double pi = 5e-16, xyz = 1e-11;
  return {
      {"integra", "a.ddr", mono, specular(true, false, false), pi},
      {"integra", "a.ddr", rgb, specular(false, false, true), pi},
      {"integra", "a.ddr", spectral, specular(false, true, true), pi},
      {"zemax", "a.bsdf", mono, specular(true, false, false), 0},
      {"zemax", "a.bsdf", mono, specular(false, true, false), 0},
      {"zemax", "a.bsdf", rgb, specular(false, false, false), xyz},
      {"lighttools", "a.bsdf", mono, spherical(true, false), 0},
      {"lighttools", "a.bsdf", rgb, spherical(false, false), xyz},
      {"ssdd", "a.ssdd", mono, spherical(true, false), 0},
      {"ssdd", "a.ssdd", rgb, spherical(false, true), 0},
      {"ssdd", "a.ssdd", spectral, specular(false, true, true), 0},
      {"ssdd", "a.ssdd", mono, specular(true, false, false), 0},
      {"ssdd", "a.ssdd", rgb, halfDifference(true, true, false), 0},
      {"ssdd", "a.ssdd", rgb, halfDifference(true, false, false), 0},
      {"ssdd", "a.ssdd", rgb, halfDifference(false, true, true), 0},
      {"ssdd", "a.ssdd", rgb, halfDifference(false, false, false), 0},
  };
}

/// The same nodes, symmetry and offsets, the axes in any order. Returns the cell of `b` for each of `a`.
std::vector<std::size_t> matchCells(const GridLayout& a, const GridLayout& b) {
  EXPECT_EQ(a.parametrisation, b.parametrisation);
  EXPECT_EQ(a.symmetry, b.symmetry);
  EXPECT_EQ(a.axes.size(), b.axes.size());
  EXPECT_EQ(a.specularOffsets.size(), b.specularOffsets.size());
  for (std::size_t i = 0; i < std::min(a.specularOffsets.size(), b.specularOffsets.size()); ++i)
    EXPECT_NEAR(a.specularOffsets[i], b.specularOffsets[i], 3e-16);
  std::vector<std::size_t> cells(a.cells(), 0);
  std::size_t strideA = 1;
  for (const GridAxis& axis : a.axes) {
    const std::size_t which = b.find(axis.quantity);
    if (which == b.axes.size()) {
      ADD_FAILURE() << brdf::axisName(axis.quantity);
      return {};
    }
    EXPECT_EQ(axis.nodes, b.axes[which].nodes) << brdf::axisName(axis.quantity);
    EXPECT_EQ(axis.period > 0, b.axes[which].period > 0) << brdf::axisName(axis.quantity);
    std::size_t strideB = 1;
    for (std::size_t k = 0; k < which; ++k) strideB *= b.axes[k].size();
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] += i / strideA % axis.size() * strideB;
    strideA *= axis.size();
  }
  return cells;
}

void expectSame(const GridBrdf& a, const GridBrdf& b, double precision) {
  ASSERT_EQ(a.channels(), b.channels());
  const auto cells = matchCells(a.layout(), b.layout());
  ASSERT_EQ(cells.size(), b.layout().cells());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    ASSERT_EQ(a.data().states[i], b.data().states[cells[i]]);
    double scale = 0;  // a mixture of channels rounds as its largest
    for (std::size_t c = 0; c < a.channels().count(); ++c)
      scale = std::max(scale, precision * a.data().values[c * cells.size() + i] * (precision > 1e-14 ? 1 : 0));
    for (std::size_t c = 0; c < a.channels().count(); ++c) {
      const double value = a.data().values[c * cells.size() + i];
      ASSERT_NEAR(b.data().values[c * cells.size() + cells[i]], value, std::max(scale, precision * value));
    }
  }
}

const GridBrdf& gridOf(const brdf::BrdfPointer& brdf) { return dynamic_cast<const GridBrdf&>(*brdf); }

std::vector<fs::path> files() {
  std::vector<fs::path> list;
  for (const auto& entry : fs::directory_iterator(handWritten(""))) list.push_back(entry.path());
  std::sort(list.begin(), list.end());
  return list;
}

/// Values of all parts of a result, and its sentences.
std::vector<double> everything(const brdf::ReadResult& result) {
  std::vector<double> all = gridOf(result.brdf).data().values;
  for (const auto& part : result.components.scatter) {
    const auto& values = gridOf(part.brdf).data().values;
    all.insert(all.end(), values.begin(), values.end());
  }
  for (const auto& part : result.components.specular) all.insert(all.end(), part.values.begin(), part.values.end());
  for (const auto& part : result.components.totals) all.insert(all.end(), part.values.begin(), part.values.end());
  return all;
}

}  // namespace

TEST(LightingFiles, AGridInTheFormatsLayoutComesBack) {
  const auto dir = measuredtest::folder("lighting_round_trip");
  unsigned seed = 1;
  for (const Case& c : cases()) {
    SCOPED_TRACE(std::string(c.format) + ", " + c.layout.text());
    const auto grid = randomGrid(c.layout, c.channels, seed++);
    const auto report = brdf::writeMeasured(*grid, dir / c.file, c.format);
    EXPECT_TRUE(report.losses.empty()) << report.losses.front();
    const auto back = brdf::readMeasured(dir / c.file);
    EXPECT_EQ(back.report.format, c.format);
    // The reader's own warnings: random values look odd to the linter.
    const auto own = brdf::findFormat(c.format).read(brdf::readFile(dir / c.file), dir / c.file, {});
    EXPECT_TRUE(own.report.warnings.empty()) << own.report.warnings.front();
    expectSame(*grid, gridOf(back.brdf), c.precision);
  }
}

TEST(LightingFiles, OtherBrdfsAreTabulatedAndTheLossIsSaid) {
  const auto dir = measuredtest::folder("lighting_tabulated");
  const measuredtest::FunctionBrdf function(measuredtest::glossy);
  for (const auto& [format, file] :
       {std::pair{"integra", "a.ddr"}, {"zemax", "a.bsdf"}, {"lighttools", "a.bsdf"}, {"ssdd", "a.ssdd"}}) {
    SCOPED_TRACE(format);
    const auto report = brdf::writeMeasured(function, dir / file, format);
    EXPECT_TRUE(mentions(report.losses, "resampled on a grid"));
    const auto back = brdf::readMeasured(dir / file);
    const GridBrdf& grid = gridOf(back.brdf);
    brdf::DirectionPairBuffer<double> pairs;
    grid.layout().directions(0, grid.layout().cells(), pairs);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < pairs.size(); i += 97) {
      if (grid.data().states[i] == 0) continue;
      const Direction wi{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
      const Direction wo{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
      if (!(wi[2] > 1e-9 && wo[2] > 1e-9)) continue;
      ++compared;
      for (std::size_t c = 0; c < 3; ++c)
        ASSERT_NEAR(grid.data().values[c * pairs.size() + i], measuredtest::glossy(wi, wo, c), 1e-9);
    }
    EXPECT_GT(compared, 50u);
  }
}

TEST(LightingFiles, ASpectrumIsSaidToBeLostWhereTheFormatHasColoursOnly) {
  const auto dir = measuredtest::folder("lighting_spectrum");
  // Flat: any spectrum that is the same everywhere is grey of that value.
  const measuredtest::FunctionBrdf grey([](const auto&, const auto&, std::size_t) { return 0.25; },
                                        Channels::spectral({400, 450, 500, 550, 600, 650, 700}));
  for (const char* format : {"zemax", "lighttools"}) {
    const auto report = brdf::writeMeasured(grey, dir / "a.bsdf", format);
    EXPECT_TRUE(mentions(report.losses, "spectrum"));
    const auto back = brdf::readMeasured(dir / "a.bsdf");
    for (const double value : back.brdf->evaluate(polar(20, 0), polar(40, 50))) EXPECT_NEAR(value, 0.25, 1e-12);
  }
}

TEST(LightingFiles, WrittenTotalsAreTheIntegrals) {
  const auto dir = measuredtest::folder("lighting_totals");
  const measuredtest::FunctionBrdf lambert([](const auto&, const auto&, std::size_t) { return 0.4 / brdf::kPi; },
                                           Channels::monochrome());
  for (const char* format : {"zemax", "lighttools"}) {
    brdf::writeMeasured(lambert, dir / "a.bsdf", format);
    const auto totals = brdf::readMeasured(dir / "a.bsdf").components.totals;
    ASSERT_EQ(totals.size(), 1u);
    EXPECT_GE(totals[0].values.size(), 10u);
    for (const double value : totals[0].values) EXPECT_NEAR(value, 0.4, 2e-4) << format;
  }
}

TEST(LightingFiles, ComponentsAreWrittenWhereTheFormatHasAPlaceForThem) {
  const auto dir = measuredtest::folder("lighting_components");
  const auto keeps = [&](const char* name, const char* format, const char* file, bool whole) {
    SCOPED_TRACE(name);
    const auto first = readHandWritten(name);
    const auto report = brdf::writeMeasured(*first.brdf, first.components, dir / file, format);
    EXPECT_EQ(report.losses.empty(), whole);
    const auto second = brdf::readMeasured(dir / file);
    EXPECT_EQ(second.components.front, first.components.front);
    if (first.components.front) expectSame(gridOf(first.brdf), gridOf(second.brdf), 1e-12);
    ASSERT_EQ(second.components.scatter.size(), first.components.scatter.size());
    for (const auto& part : first.components.scatter)
      expectSame(gridOf(part.brdf), gridOf(second.components.find(part.kind)), 1e-12);
    ASSERT_EQ(second.components.specular.size(), first.components.specular.size());
    for (std::size_t i = 0; i < first.components.specular.size(); ++i) {
      EXPECT_EQ(second.components.specular[i].kind, first.components.specular[i].kind);
      EXPECT_EQ(second.components.specular[i].channels, first.components.specular[i].channels);
      EXPECT_EQ(second.components.specular[i].thetaI, first.components.specular[i].thetaI);
      EXPECT_EQ(second.components.specular[i].values, first.components.specular[i].values);
    }
  };
  keeps("sides.lighttools.bsdf", "lighttools", "a.bsdf", true);
  keeps("four.ssdd", "ssdd", "a.ssdd", true);
  keeps("bent.ddt", "integra", "a.ddt", true);
  keeps("glass.sdr", "integra-specular", "a.sdr", true);
  keeps("glass.sdr", "ssdd", "a.ssdd", true);
  keeps("xyz.zemax.bsdf", "zemax", "a.bsdf", true);
  keeps("bent.ddt", "ssdd", "a.ssdd", true);
}

TEST(LightingFiles, WhatAFormatHasNoPlaceForIsALossOrAnError) {
  const auto dir = measuredtest::folder("lighting_unkept");
  const auto four = readHandWritten("four.ssdd");
  const auto zemax = brdf::writeMeasured(*four.brdf, four.components, dir / "a.bsdf", "zemax");
  EXPECT_TRUE(mentions(zemax.losses, "front transmission"));
  EXPECT_TRUE(mentions(zemax.losses, "specular front reflection"));
  const auto merl = brdf::writeMeasured(*four.brdf, four.components, dir / "a.binary");
  EXPECT_TRUE(mentions(merl.losses, "front transmission: merl has no place for it"));
  const auto refused = [&](const char* file, const char* format, const brdf::Components& components) {
    return measuredtest::errorOf([&] { brdf::writeMeasured(*four.brdf, components, dir / file, format); });
  };
  EXPECT_NE(refused("a.ddt", "integra", {}).find("front transmission"), std::string::npos);
  EXPECT_NE(refused("a.sdr", "integra-specular", {}).find("specular front reflection"), std::string::npos);
  EXPECT_FALSE(fs::exists(dir / "a.ddt"));
}

TEST(LightingFiles, AnErrorOfAWriterNamesTheFileThatWasAskedFor) {
  const auto dir = measuredtest::folder("lighting_named");
  const auto four = readHandWritten("four.ssdd");
  for (const char* name : {"a.ddt", "a.sdr", "a.pab"}) {
    const std::string said = measuredtest::errorOf([&] { brdf::writeMeasured(*four.brdf, dir / name); });
    EXPECT_TRUE(said.starts_with((dir / name).string() + ": ")) << said;
    EXPECT_FALSE(fs::exists(dir / name));
  }
}

TEST(LightingFiles, TextsOfAnyLineEndAndBlanksRead) {
  const auto dir = measuredtest::folder("lighting_text");
  for (const fs::path& file : files()) {
    SCOPED_TRACE(file.filename());
    const auto plain = brdf::readMeasured(file);
    std::string unix = brdf::readFile(file), dos = "\xEF\xBB\xBF";
    while (unix.ends_with('\n')) unix.pop_back();
    for (const char c : unix) dos += c == '\n' ? "\r\n" : c == ' ' ? " \t" : std::string(1, c);
    const fs::path path = dir / file.filename();
    brdf::writeFile(path, dos);
    const auto other = brdf::readMeasured(path);
    EXPECT_EQ(other.report.format, plain.report.format);
    EXPECT_EQ(other.report.warnings, plain.report.warnings);
    EXPECT_EQ(everything(other), everything(plain));
  }
}

TEST(LightingFiles, TheLocaleDoesNotMatter) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const auto dir = measuredtest::folder("lighting_locale");
  for (const fs::path& file : files()) {
    const auto plain = brdf::readMeasured(file);
    const fs::path first = dir / ("a_" + file.filename().string()), second = dir / ("b_" + file.filename().string());
    std::string format = plain.report.format;
    if (file.extension() == ".sdr") format = "integra-specular";
    brdf::writeMeasured(*plain.brdf, plain.components, first, format);
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const auto other = brdf::readMeasured(file);
    brdf::writeMeasured(*other.brdf, other.components, second, format);
    std::locale::global(before);
    EXPECT_EQ(everything(other), everything(plain)) << file;
    EXPECT_EQ(brdf::readFile(second), brdf::readFile(first)) << file;
  }
}

TEST(LightingFiles, DamagedFilesAreReadOrRefusedInOneLine) {
  std::mt19937 engine(7);
  int refused = 0, read = 0;
  const auto attempt = [&](const std::string& bytes, const fs::path& file) {
    try {
      for (const brdf::Format& format : brdf::allFormats())
        if (format.recognise(std::string_view(bytes).substr(0, 8192), bytes.size()) > 0) {
          format.read(bytes, file, {});
          ++read;
        }
    } catch (const brdf::Error& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos) << error.what();
    }
  };
  for (const fs::path& file : files()) {
    const std::string bytes = brdf::readFile(file);
    for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 100)
      attempt(bytes.substr(0, length), file);
    std::uniform_int_distribution<std::size_t> place(0, bytes.size() - 1);
    const std::string digits = "0123456789-.e \n";
    for (int i = 0; i < 300; ++i) {
      std::string changed = bytes;
      for (int k = 0; k < 1 + i % 4; ++k)
        changed[place(engine)] = i % 2 ? static_cast<char>(engine() % 256) : digits[engine() % digits.size()];
      attempt(changed, file);
    }
    attempt(bytes + bytes, file);
  }
  EXPECT_GT(refused, 500);
  EXPECT_GT(read, 100);
}

TEST(LightingFiles, TheUserMaySayThatHalfAPlaneIsMirrored) {
  struct Case {
    const char *file, *stated, *unstated;
  };
  for (const Case& c :
       {Case{"plane.zemax.bsdf", "PlaneSymmetrical", "ASymmetrical"},
        Case{"plane.ddr", "PlaneSymmetrical", "ASymmetrical"},
        Case{"four.ssdd", "REDUCTION_TYPE bilateral_symmetry reciprocity", "REDUCTION_TYPE reciprocity"}}) {
    std::string stated = brdf::readFile(handWritten(c.file));
    // Of SSDD's blocks the first: another one goes all around.
    const std::size_t second = stated.find("DATA_TYPE", stated.find("DATA_TYPE") + 1);
    if (second != std::string::npos) stated.resize(second);
    ASSERT_NE(stated.find(c.stated), std::string::npos) << c.file;
    const std::string half = with(stated, c.stated, c.unstated), name = std::string("half-") + c.file;
    const auto whole = readText(name, stated).brdf;
    const auto bilateral = readText(name, half).brdf;
    EXPECT_EQ(bilateral->symmetry(), brdf::Symmetry::Bilateral) << c.file;
    brdf::ReadOptions options;
    options.symmetry = brdf::Symmetry::Isotropic;
    const auto mirrored = readText(name, half, options);
    EXPECT_EQ(mirrored.brdf->symmetry(), brdf::Symmetry::Isotropic) << c.file;
    EXPECT_TRUE(mentions(mirrored.report.assumptions, "symmetry: isotropic (given")) << c.file;
    for (int t = 5; t < 60; t += 7)
      for (int p = 0; p < 360; p += 35)
        EXPECT_EQ(mirrored.brdf->evaluate(polar(40, 10), polar(t, p)), whole->evaluate(polar(40, 10), polar(t, p)))
            << c.file << " " << t << " " << p;
    options.symmetry = brdf::Symmetry::Anisotropic;
    EXPECT_NE(measuredtest::errorOf([&] { readText(name, half, options); }).find("bilateral, isotropic"),
              std::string::npos)
        << c.file;
    options.symmetry = brdf::Symmetry::Bilateral;
    EXPECT_NE(measuredtest::errorOf([&] { readText(name, stated, options); }).find("contradicts"), std::string::npos)
        << c.file;
  }
}
