// Dot plots put numbers where a logarithmic axis has them; montages put pictures where they belong, the right way up.
#include <gtest/gtest.h>
#include <vtkBRDFDotPlotView.h>
#include <vtkBRDFMontageView.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace {

using Rgb = std::array<int, 3>;
// The first three colours of overlays (Okabe and Ito), as 8-bit sRGB.
constexpr Rgb kBlue = {0, 115, 179}, kVermilion = {204, 102, 0}, kGreen = {0, 158, 115};

/// Where pixels of a colour lie: how many, and their mean position from the lower left corner.
struct Spot {
  int count = 0;
  double x = 0, y = 0;
};

Spot spot(vtkImageData* image, const Rgb& color) {
  Spot found;
  const int* size = image->GetDimensions();
  for (int y = 0; y < size[1]; ++y)
    for (int x = 0; x < size[0]; ++x) {
      const auto* pixel = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
      if (std::abs(pixel[0] - color[0]) + std::abs(pixel[1] - color[1]) + std::abs(pixel[2] - color[2]) > 6) continue;
      ++found.count;
      found.x += x;
      found.y += y;
    }
  if (found.count > 0) {
    found.x /= found.count;
    found.y /= found.count;
  }
  return found;
}

vtkNew<vtkTable> table(const std::vector<double>& values, const char* groupColumn = "group") {
  vtkNew<vtkTable> result;
  vtkNew<vtkStringArray> group, series;
  vtkNew<vtkDoubleArray> number;
  group->SetName(groupColumn);
  series->SetName("series");
  number->SetName("error");
  for (std::size_t k = 0; k < values.size(); ++k) {
    group->InsertNextValue("material");
    series->InsertNextValue("way " + std::to_string(k));
    number->InsertNextValue(values[k]);
  }
  result->AddColumn(group);
  result->AddColumn(series);
  result->AddColumn(number);
  return result;
}

class DotPlotView : public testing::Test {
 protected:
  void SetUp() override {
    vtkObject::GlobalWarningDisplayOff();
    view_->SetSize(1200, 700);
    view_->SetTable(table({1}));
    if (!view_->Render()) GTEST_SKIP() << view_->GetErrorText();
  }
  void draw(const std::vector<double>& values) {
    view_->SetTable(table(values));
    ASSERT_TRUE(view_->Capture(image_)) << view_->GetErrorText();
  }
  vtkNew<vtkBRDFDotPlotView> view_;
  vtkNew<vtkImageData> image_;
};

TEST_F(DotPlotView, EqualRatiosAreEqualDistances) {
  draw({0.001, 1, 1000});
  const Spot low = spot(image_, kBlue), middle = spot(image_, kVermilion), high = spot(image_, kGreen);
  ASSERT_GT(low.count, 10);
  EXPECT_GT(middle.x - low.x, 50);
  EXPECT_NEAR(middle.x - low.x, high.x - middle.x, 0.5);
  EXPECT_GT(low.y, middle.y + 10);  // rows in the table's order, downwards
  EXPECT_GT(middle.y, high.y + 10);
}

TEST_F(DotPlotView, EqualNumbersLieAboveEachOtherAndWhatIsNoNumberHasNoDot) {
  draw({0.25, 0.25, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_NEAR(spot(image_, kBlue).x, spot(image_, kVermilion).x, 0.5);
  EXPECT_EQ(spot(image_, kGreen).count, 0);
}

TEST_F(DotPlotView, ExtremesDraw) {
  for (const std::vector<double>& values :
       {std::vector<double>{0, 0}, {5e-324, 1.7e308}, {std::numeric_limits<double>::infinity(), -1, 3}})
    draw(values);
}

TEST_F(DotPlotView, RefusesATableWithoutItsColumns) {
  view_->SetTable(table({1}, "target"));
  EXPECT_FALSE(view_->Render());
  EXPECT_NE(view_->GetErrorText().find("group"), std::string::npos) << view_->GetErrorText();
  view_->SetTable(nullptr);
  EXPECT_FALSE(view_->Render());
}

/// Upper half of one colour, lower half of another.
vtkNew<vtkImageData> twoHalves(const Rgb& upper, const Rgb& lower) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(20, 20, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0))[c] =
            static_cast<unsigned char>((y < 10 ? lower : upper)[c]);
  return image;
}

TEST(MontageView, PicturesStandInRowsTheRightWayUpInTheirOwnColours) {
  vtkObject::GlobalWarningDisplayOff();
  constexpr Rgb colors[] = {{200, 0, 0}, {0, 120, 0}, {0, 0, 90}, {250, 200, 10}, {90, 0, 90}, {10, 200, 200}};
  vtkNew<vtkBRDFMontageView> view;
  view->SetSize(400, 400);
  view->SetColumns(2);
  for (int k = 0; k < 3; ++k) view->AddImage(twoHalves(colors[2 * k], colors[2 * k + 1]), "a caption");
  vtkNew<vtkImageData> image;
  if (!view->Capture(image)) GTEST_SKIP() << view->GetErrorText();
  Spot spots[6];
  for (int k = 0; k < 6; ++k) {
    spots[k] = spot(image, colors[k]);
    EXPECT_GT(spots[k].count, 5000) << k;
  }
  for (int k = 0; k < 3; ++k) {
    EXPECT_GT(spots[2 * k].y, spots[2 * k + 1].y + 20) << k;
    EXPECT_NEAR(spots[2 * k].x, spots[2 * k + 1].x, 1) << k;
  }
  EXPECT_GT(spots[2].x, spots[0].x + 100);  // second beside the first
  EXPECT_NEAR(spots[4].x, spots[0].x, 1);   // third below the first
  EXPECT_LT(spots[4].y, spots[0].y - 100);
}

TEST(MontageView, WithoutPicturesSaysSo) {
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkBRDFMontageView> view;
  view->SetSize(200, 200);
  EXPECT_FALSE(view->Render());
  EXPECT_NE(view->GetErrorText(), "");
}

}  // namespace
