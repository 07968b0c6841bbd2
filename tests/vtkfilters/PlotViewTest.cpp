#include "../TestFolder.h"
#include "Support.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/TableBrdf.h>

#include <gtest/gtest.h>

#include <vtkBRDFCurve.h>
#include <vtkBRDFHoleMapView.h>
#include <vtkBRDFPlotView.h>
#include <vtkBRDFSlice.h>
#include <vtkBRDFSliceView.h>
#include <vtkBRDFSource.h>
#include <vtkBRDFVolumeView.h>
#include <vtkDoubleArray.h>
#include <vtkTable.h>

#include <pugixml.hpp>

#include <cmath>
#include <limits>
#include <set>

namespace brdf {
namespace {

using test::ExpectErrors;
using test::Pixel;
using test::pixelAt;

vtkSmartPointer<vtkBRDFSource> material(const char* text) {
  const auto source = vtkSmartPointer<vtkBRDFSource>::New();
  source->SetMaterial(text);
  return source;
}

vtkSmartPointer<vtkTable> table(const std::vector<double>& x, const std::vector<double>& y) {
  const auto result = vtkSmartPointer<vtkTable>::New();
  for (const auto& [name, numbers] : {std::pair{"x", &x}, {"value", &y}}) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (const double number : *numbers) column->InsertNextValue(number);
    result->AddColumn(column);
  }
  return result;
}

/// Whether a pixel is of the first colour of the palette, blue, and not of text.
bool isBlue(const Pixel& p) { return p[2] > p[0] + 60 && p[2] > p[1] + 30; }

/// The middle row of the blue pixels in a column of the picture, from below; -1: none.
double blueRow(vtkImageData* image, int x) {
  double sum = 0;
  int count = 0;
  for (int y = image->GetDimensions()[1] / 6; y < image->GetDimensions()[1]; ++y)
    if (isBlue(pixelAt(image, x, y))) {
      sum += y;
      ++count;
    }
  return count > 0 ? sum / count : -1;
}

/// Texts of an SVG file.
std::multiset<std::string> textsOf(const pugi::xml_document& svg) {
  std::multiset<std::string> texts;
  for (const auto& node : svg.select_nodes("//text")) texts.insert(node.node().child_value());
  return texts;
}

TEST(PlotView, ALineIsStraightOnTheScaleThatSuitsIt) {
  // y = 10^x on a logarithmic axis, y = x on a linear one, y = x^3 in cube roots.
  vtkNew<vtkImageData> image;
  for (const std::string scale : {"log", "linear", "cuberoot"}) {
    std::vector<double> x, y;
    for (int k = 0; k <= 100; ++k) {
      x.push_back(k / 25.0);
      y.push_back(scale == "log" ? std::pow(10, x.back()) : scale == "linear" ? x.back() : std::pow(x.back(), 3));
    }
    vtkNew<vtkBRDFPlotView> view;
    view->AddInputData(table(x, y), "");
    view->SetScale(scale);
    ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
    const double a = blueRow(image, 250), b = blueRow(image, 450), c = blueRow(image, 650);
    ASSERT_GT(a, 0);
    EXPECT_GT(b, a + 50);
    EXPECT_NEAR(b - a, c - b, 1.5) << scale;
  }
}

TEST(PlotView, SvgHoldsTextAndTheCurveAsAPath) {
  const auto source = material("0.2*Lambertian + 0.1*BlinnPhong(n=50)");
  vtkNew<vtkBRDFCurve> curve;
  curve->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkBRDFPlotView> view;
  view->AddInputConnection(curve->GetOutputPort(), "A & B");
  view->SetXTitle("theta_o (degrees)");
  view->SetYTitle("f_r (1/sr)");
  view->SetTitle("A title");
  view->SetXStep(15);
  const auto folder = testFolder("files");
  for (const char* kind : {"cartesian", "half circle", "circle"}) {
    view->SetKind(kind);
    const std::string path = (folder / "plot.svg").string();
    ASSERT_TRUE(view->WriteVectors(path)) << view->GetErrorText();
    pugi::xml_document svg;
    ASSERT_TRUE(svg.load_file(path.c_str()));
    const auto texts = textsOf(svg);
    EXPECT_EQ(texts.count("A title"), 1u);
    EXPECT_EQ(texts.count("A & B"), 1u);
    EXPECT_EQ(texts.count("45\u00b0") + texts.count("30\u00b0"), kind == std::string("circle") ? 1u : 2u);
    EXPECT_FALSE(svg.select_node("//image"));
    EXPECT_GT(svg.select_nodes("//path[@stroke='#0073b3' or @stroke='#0072b2']").size(), 0u) << kind;
  }
}

TEST(PlotView, PdfHoldsTheTexts) {
  vtkNew<vtkBRDFPlotView> view;
  view->AddInputData(table({0, 1}, {1, 2}), "a curve");
  view->SetTitle("A (title)");
  const std::string path = (testFolder("files") / "plot.pdf").string();
  ASSERT_TRUE(view->WriteVectors(path)) << view->GetErrorText();
  const std::string pdf = readFile(path);
  EXPECT_NE(pdf.find("(A \\(title\\)) Tj"), std::string::npos);
  EXPECT_NE(pdf.find("(a curve, value) Tj") + pdf.find("(a curve) Tj"), 2 * std::string::npos);
  EXPECT_EQ(pdf.find("/Subtype /Image"), std::string::npos);
}

TEST(PlotView, ExtremesAreDrawn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::vector<double>, std::vector<double>>> cases{{{}, {}},
                                                                               {{1}, {1}},
                                                                               {{0, 1, 2}, {nan, nan, nan}},
                                                                               {{0, 1}, {0, 0}},
                                                                               {{0, 1, 2}, {1e-12, 1, 1e9}},
                                                                               {{0, 1}, {-1, -2}},
                                                                               {{5, 5}, {1, 2}},
                                                                               {{0, 1}, {1e-300, 1e300}}};
  vtkNew<vtkImageData> image;
  for (const auto& [x, y] : cases)
    for (const char* kind : {"cartesian", "half circle"})
      for (const char* scale : {"linear", "log", "cuberoot", "log1p"}) {
        vtkNew<vtkBRDFPlotView> view;
        view->SetSize(300, 250);
        view->SetKind(kind);
        view->SetScale(scale);
        view->SetDecades(600);
        view->AddInputData(table(x, y), "extreme");
        EXPECT_TRUE(view->Capture(image)) << view->GetErrorText();
      }
}

TEST(PlotView, WithoutInputOrOfAnUnknownKindItSaysSo) {
  vtkNew<vtkBRDFPlotView> view;
  const ExpectErrors quiet;
  EXPECT_FALSE(view->Render());
  EXPECT_NE(view->GetErrorText().find("nothing to plot"), std::string::npos);
  view->AddInputData(table({0, 1}, {1, 2}), "");
  view->SetKind("pie");
  EXPECT_FALSE(view->Render());
  view->SetKind("circle");
  view->SetScale("sqrt");
  EXPECT_FALSE(view->Render());
  EXPECT_NE(view->GetErrorText().find("linear, log, cuberoot, log1p"), std::string::npos);
}

TEST(SliceView, AWhiteLambertianIsWhiteAndAGreyOneAsDarkAsItsAlbedoSays) {
  const auto white = material("Lambertian"), grey = material("(0.5,0.25,0.1)*Lambertian");
  vtkNew<vtkBRDFSliceView> view;
  view->AddInputConnection(white->GetOutputPort(), "white");
  view->AddInputConnection(grey->GetOutputPort(), "grey");
  view->GetSettings()->SetChannel("rgb");
  vtkNew<vtkImageData> image;
  ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
  EXPECT_EQ(pixelAt(image, 225, 350), (Pixel{255, 255, 255}));
  // IEC 61966-2-1: 0.5 -> 188, 0.25 -> 137, 0.1 -> 89.
  const Pixel found = pixelAt(image, 675, 350);
  EXPECT_NEAR(found[0], 188, 1);
  EXPECT_NEAR(found[1], 137, 1);
  EXPECT_NEAR(found[2], 89, 1);
}

TEST(SliceView, BelowTheHorizonIsHatchedNotDark) {
  const auto source = material("Lambertian");
  vtkNew<vtkBRDFSliceView> view;
  view->AddInputConnection(source->GetOutputPort(), "white");
  view->GetSettings()->SetPhiD(0);
  const std::string path = (testFolder("files") / "slice.svg").string();
  ASSERT_TRUE(view->WriteVectors(path));
  pugi::xml_document svg;
  ASSERT_TRUE(svg.load_file(path.c_str()));
  EXPECT_TRUE(svg.select_node("//image"));  // the cells; axes and text are not pixels
  EXPECT_EQ(textsOf(svg).count("90\u00b0"), 2u);
  vtkNew<vtkImageData> image;
  ASSERT_TRUE(view->Capture(image));
  std::size_t light = 0, all = 0;
  for (int y = 420; y < 520; ++y)  // the upper right of the square
    for (int x = 480; x < 580; ++x, ++all) light += pixelAt(image, x, y)[0] > 150;
  EXPECT_EQ(light, all);
}

TEST(HoleMapView, ATableOfHolesIsTheColourOfHoles) {
  TableData data;
  data.layout = {4, 6, 6, true};
  data.values.assign(144, 0);
  data.valid.assign(144, 0);
  vtkNew<vtkBRDF> brdf;
  brdf->SetBrdf(std::make_shared<TableBrdf>(data, "holes"));
  vtkNew<vtkBRDFHoleMapView> view;
  view->SetInputData(brdf);
  vtkNew<vtkImageData> image;
  ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
  const Pixel near = pixelAt(image, 120, 120);  // theta_h and theta_d small: nothing below the horizon
  EXPECT_NEAR(near[0], 214, 3);
  EXPECT_NEAR(near[1], 94, 3);
  EXPECT_NEAR(near[2], 0, 3);
  const auto formula = material("Lambertian");
  view->SetInputConnection(formula->GetOutputPort());
  const ExpectErrors quiet;
  EXPECT_FALSE(view->Capture(image));
}

TEST(VolumeView, AHalfVectorLobeIsDenseAtTheMirrorDirectionAndEmptyElsewhere) {
  const auto source = material("BlinnPhong(n=400)");
  vtkNew<vtkBRDFVolumeView> view;
  view->SetInputConnection(source->GetOutputPort());
  view->SetCells(32, 16, 16);
  view->SetDecades(2);
  view->SetAzimuth(0);
  view->SetElevation(0);
  vtkNew<vtkImageData> image;
  ASSERT_TRUE(view->Capture(image)) << view->GetErrorText();
  // Viridis has little blue at its upper end, where the opacity is.
  const auto leastBlue = [&](int fromX, int toX) {
    int found = 255;
    for (int y = 300; y < 400; ++y)
      for (int x = fromX; x < toX; ++x) found = std::min(found, pixelAt(image, x, y)[2]);
    return found;
  };
  // Seen along phi_d, theta_h to the right from about pixel 195 to 579: the lobe ends at 10 degrees, a third of it.
  EXPECT_LT(leastBlue(200, 260), 150);
  EXPECT_GT(leastBlue(430, 520), 240);
  EXPECT_EQ(view->GetTable()->GetDimensions()[2], 32);
  const ExpectErrors quiet;
  EXPECT_FALSE(view->WriteVectors((testFolder("files") / "volume.svg").string()));
  view->SetChannel("rgb");
  EXPECT_FALSE(view->Render());
}

}  // namespace
}  // namespace brdf
