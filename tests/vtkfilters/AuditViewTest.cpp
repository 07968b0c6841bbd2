// The picture of an audit shows failures in their own colour, and the curves that it is given.
#include <gtest/gtest.h>
#include <vtkBRDFAuditView.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <cmath>

namespace {

vtkNew<vtkTable> audit(const char* lastState, int models) {
  vtkNew<vtkTable> table;
  for (const char* name : {"model", "check", "state", "at"}) {
    vtkNew<vtkStringArray> column;
    column->SetName(name);
    table->AddColumn(column);
  }
  for (const char* name : {"worst", "allowed"}) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    table->AddColumn(column);
  }
  for (int model = 0; model < models; ++model)
    for (const char* check : {"finite", "energy"}) {
      const vtkIdType row = table->InsertNextBlankRow();
      const bool last = model + 1 == models && std::string(check) == "energy";
      table->SetValueByName(row, "model", vtkVariant("M" + std::to_string(model)));
      table->SetValueByName(row, "check", vtkVariant(check));
      table->SetValueByName(row, "state", vtkVariant(last ? lastState : "passed"));
      table->SetValueByName(row, "at", vtkVariant(""));
      table->SetValueByName(row, "worst", vtkVariant(0.5));
      table->SetValueByName(row, "allowed", vtkVariant(1.0));
    }
  return table;
}

/// Share of the picture's pixels of about this colour (8-bit sRGB).
double share(vtkImageData* image, int red, int green, int blue) {
  const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
  const vtkIdType count = image->GetNumberOfPoints();
  vtkIdType found = 0;
  for (vtkIdType k = 0; k < count; ++k)
    found +=
        std::abs(pixels[3 * k] - red) + std::abs(pixels[3 * k + 1] - green) + std::abs(pixels[3 * k + 2] - blue) < 12;
  return static_cast<double>(found) / static_cast<double>(count);
}

/// Share of dark pixels: letters of grey ink, their soft edges included.
double ink(vtkImageData* image) {
  const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
  const vtkIdType count = image->GetNumberOfPoints();
  vtkIdType found = 0;
  for (vtkIdType k = 0; k < count; ++k) found += pixels[3 * k] + pixels[3 * k + 1] + pixels[3 * k + 2] < 400;
  return static_cast<double>(found) / static_cast<double>(count);
}

class AuditView : public testing::Test {
 protected:
  void SetUp() override {
    vtkObject::GlobalWarningDisplayOff();
    view_->SetSize(600, 450);
    view_->SetChecks(audit("passed", 2));
    if (!view_->Render()) GTEST_SKIP() << view_->GetErrorText();
  }
  /// The share of vermilion, the colour of what failed.
  double failed(const char* lastState, int models) {
    view_->SetChecks(audit(lastState, models));
    EXPECT_TRUE(view_->Capture(image_)) << view_->GetErrorText();
    return share(image_, 214, 94, 0);
  }
  vtkNew<vtkBRDFAuditView> view_;
  vtkNew<vtkImageData> image_;
};

TEST_F(AuditView, ShowsAFailureOfOneOrSeveralModels) {
  for (const int models : {1, 3}) EXPECT_GT(failed("failed", models), failed("passed", models) + 0.01) << models;
}

TEST_F(AuditView, ShowsADeclaredLawInAnotherColour) {
  const double clean = failed("passed", 3);
  EXPECT_NEAR(failed("declared", 3), clean, 1e-4);
  EXPECT_GT(share(image_, 250, 222, 140), 0.02);
}

TEST_F(AuditView, WritesOnTheRowsOfAListAndTheCellsOfAMatrix) {
  for (const int models : {1, 3}) {
    const auto table = audit("passed", models);
    view_->SetChecks(table);
    ASSERT_TRUE(view_->Capture(image_)) << view_->GetErrorText();
    const double before = ink(image_);
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row) {
      table->SetValueByName(row, "at", vtkVariant("MMMMMMMMMMMM"));
      if (models > 1) table->SetValueByName(row, "worst", vtkVariant(8.88e-88));
    }
    table->Modified();
    ASSERT_TRUE(view_->Capture(image_)) << view_->GetErrorText();
    EXPECT_GT(ink(image_), before + 2e-4) << models << " models: the text is there";
  }
}

TEST_F(AuditView, DrawsAnAlbedoCurveInItsChannelsColour) {
  view_->SetChecks(audit("passed", 1));
  vtkNew<vtkTable> albedo;
  for (const char* name : {"theta", "red"}) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (int degrees = 0; degrees < 90; ++degrees) column->InsertNextValue(name[0] == 't' ? degrees : 0.4);
    albedo->AddColumn(column);
  }
  ASSERT_TRUE(view_->Capture(image_));
  EXPECT_EQ(share(image_, 204, 38, 38), 0);
  view_->SetAlbedo(albedo);
  ASSERT_TRUE(view_->Capture(image_)) << view_->GetErrorText();
  EXPECT_GT(share(image_, 204, 38, 38), 2e-4);
}

TEST_F(AuditView, RefusesATableWithoutItsColumns) {
  vtkNew<vtkTable> empty;
  view_->SetChecks(empty);
  EXPECT_FALSE(view_->Render());
  vtkNew<vtkTable> wrong;
  vtkNew<vtkDoubleArray> column;
  column->SetName("model");
  column->InsertNextValue(1);
  wrong->AddColumn(column);
  view_->SetChecks(wrong);
  EXPECT_FALSE(view_->Render());
  EXPECT_NE(view_->GetErrorText().find("missing column"), std::string::npos);
}

}  // namespace
