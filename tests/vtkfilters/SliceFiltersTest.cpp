#include "Support.h"

#include <brdf/geometry/Directions.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/material/TableBrdf.h>

#include <gtest/gtest.h>

#include <vtkBRDFAlbedo.h>
#include <vtkBRDFCurve.h>
#include <vtkBRDFHoleMap.h>
#include <vtkBRDFSlice.h>
#include <vtkBRDFSource.h>
#include <vtkBRDFSpectrum.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cmath>

namespace brdf {
namespace {

using test::ExpectErrors;

vtkSmartPointer<vtkBRDFSource> material(const char* text) {
  const auto source = vtkSmartPointer<vtkBRDFSource>::New();
  source->SetMaterial(text);
  return source;
}

double cell(vtkTable* table, vtkIdType row, const char* column) {
  return vtkDataArray::SafeDownCast(table->GetColumnByName(column))->GetTuple1(row);
}

/// Spectral data on a grid: 1 + theta_o / 90 degrees at 500 nm, twice that at 600, with errors of a tenth.
vtkSmartPointer<vtkBRDF> spectralGrid() {
  GridData data;
  data.layout.axes = {GridAxis::listedDegrees(AxisQuantity::ThetaO, {0, 45, 89}),
                      GridAxis::listedDegrees(AxisQuantity::ThetaI, {0, 89})};
  data.channels = Channels::spectral({500, 600});
  for (const double gain : {1.0, 2.0})
    for (int i = 0; i < 2; ++i)
      for (const double theta : {0.0, 45.0, 89.0}) data.values.push_back(gain * (1 + theta / 90));
  for (const double value : data.values) data.standardError.push_back(0.1 * value);
  const auto brdf = vtkSmartPointer<vtkBRDF>::New();
  brdf->SetBrdf(std::make_shared<GridBrdf>(data, "spectral grid"));
  return brdf;
}

TEST(Slice, EveryPointIsTheValueOfItsDirections) {
  const auto source = material("(0.3,0.2,0.1)*Lambertian + 0.5*GGX(alpha=0.3)");
  vtkNew<vtkBRDFSlice> slice;
  slice->SetInputConnection(source->GetOutputPort());
  slice->SetChannel("rgb");
  slice->SetCells(6, 5);
  slice->SetWarp(2);
  slice->SetPhiD(70);
  ASSERT_TRUE(slice->UpdateAndCheck()) << slice->GetErrorText();
  vtkImageData* image = slice->GetOutput();
  ASSERT_EQ(image->GetDimensions()[0], 6);
  ASSERT_EQ(image->GetDimensions()[1], 5);
  vtkDataArray* x = image->GetFieldData()->GetArray("x");
  vtkDataArray* y = image->GetFieldData()->GetArray("y");
  vtkDataArray* values = image->GetPointData()->GetArray("value");
  vtkDataArray* states = image->GetPointData()->GetArray("state");
  std::size_t below = 0;
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 6; ++column) {
      const double half = 90 * std::pow((column + 0.5) / 6, 2), difference = (row + 0.5) * 18;
      EXPECT_NEAR(x->GetTuple1(column), half, 1e-12);
      EXPECT_NEAR(y->GetTuple1(row), difference, 1e-12);
      const DirectionPair pair = fromHalfDifference({radians(half), 0, radians(difference), radians(70)});
      const bool above = pair.wi[2] > 0 && pair.wo[2] > 0;
      below += !above;
      EXPECT_EQ(states->GetTuple1(row * 6 + column), above ? 1 : 3);
      for (int c = 0; c < 3; ++c)
        EXPECT_DOUBLE_EQ(values->GetComponent(row * 6 + column, c),
                         source->GetOutput()->Evaluate(pair.wi.data(), pair.wo.data(), c));
    }
  EXPECT_EQ(slice->GetNumberOfCells(3), static_cast<vtkIdType>(below));
  EXPECT_GT(below, 0u);
}

TEST(Slice, OverTheWavelengthRowsAreTheChannels) {
  vtkNew<vtkBRDFSlice> slice;
  slice->SetInputData(spectralGrid());
  slice->SetAxes("theta_o,wavelength");
  slice->SetCells(18, 999);  // the rows are the wavelengths
  slice->SetThetaI(20);
  ASSERT_TRUE(slice->UpdateAndCheck()) << slice->GetErrorText();
  vtkImageData* image = slice->GetOutput();
  ASSERT_EQ(image->GetDimensions()[1], 2);
  EXPECT_EQ(image->GetOrigin()[1], 500);
  EXPECT_EQ(image->GetSpacing()[1], 100);
  EXPECT_NEAR(image->GetFieldData()->GetArray("x")->GetTuple1(0), -85, 1e-12);
  for (int row = 0; row < 2; ++row)
    EXPECT_NEAR(image->GetScalarComponentAsDouble(13, row, 0, 0), (row + 1) * (1 + 45.0 / 90), 1e-12);  // 45 degrees
  const auto rgb = material("Lambertian");
  slice->SetInputConnection(rgb->GetOutputPort());
  const ExpectErrors quiet;
  EXPECT_FALSE(slice->UpdateAndCheck());
  EXPECT_NE(slice->GetErrorText().find("spectral data"), std::string::npos);
}

TEST(Curve, BelowTheHorizonIsNotANumberAndTheCosineIsTheViewers) {
  const auto source = material("Lambertian");
  vtkNew<vtkBRDFCurve> curve;
  curve->SetInputConnection(source->GetOutputPort());
  curve->SetQuantity("f_cos");
  curve->SetIntervals(180);
  ASSERT_TRUE(curve->UpdateAndCheck());
  vtkTable* table = curve->GetOutput();
  for (vtkIdType row = 1; row + 1 < table->GetNumberOfRows(); ++row)
    EXPECT_NEAR(cell(table, row, "value"), std::cos(radians(cell(table, row, "angle"))) / kPi, 1e-14);
  curve->SetAngle("theta_h");
  curve->SetThetaD(40);
  curve->SetPhiD(0);
  ASSERT_TRUE(curve->UpdateAndCheck());
  table = curve->GetOutput();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    if (std::abs(cell(table, row, "angle") - 50) > 0.1) {
      EXPECT_EQ(std::isnan(cell(table, row, "value")), cell(table, row, "angle") > 50);
    }
  EXPECT_GT(curve->GetNumberOfPoints(3), 0);
  EXPECT_EQ(curve->GetOutput(1)->GetNumberOfRows(), 0);
}

TEST(Curve, StandardErrorsAndSamplesOfAGridComeAlong) {
  vtkNew<vtkBRDFCurve> curve;
  curve->SetInputData(spectralGrid());
  curve->SetChannel("all");
  curve->SetThetaI(0);
  ASSERT_TRUE(curve->UpdateAndCheck()) << curve->GetErrorText();
  vtkTable* table = curve->GetOutput();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    EXPECT_NEAR(cell(table, row, "standard error of 600 nm"), 0.1 * cell(table, row, "600 nm"), 1e-12);
  vtkTable* samples = curve->GetOutput(1);
  ASSERT_EQ(samples->GetNumberOfRows(), 3);  // those at theta_i = 0
  for (vtkIdType row = 0; row < 3; ++row) {
    EXPECT_NEAR(cell(samples, row, "500 nm"), 1 + std::abs(cell(samples, row, "angle")) / 90, 1e-9);
    EXPECT_NEAR(cell(samples, row, "standard error of 500 nm"), 0.1 * cell(samples, row, "500 nm"), 1e-12);
  }
}

TEST(Albedo, OfAWhiteLambertianIsOneFromEverywhere) {
  const auto source = material("(1,0.5,0.25)*Lambertian");
  vtkNew<vtkBRDFAlbedo> albedo;
  albedo->SetInputConnection(source->GetOutputPort());
  albedo->SetChannel("all");
  albedo->SetIntervals(9);
  albedo->SetPoints(256);
  ASSERT_TRUE(albedo->UpdateAndCheck());
  vtkTable* table = albedo->GetOutput();
  ASSERT_EQ(table->GetNumberOfRows(), 10);
  for (vtkIdType row = 0; row < 10; ++row) {
    EXPECT_NEAR(cell(table, row, "red"), 1, 1e-12);
    EXPECT_NEAR(cell(table, row, "blue"), 0.25, 1e-12);
  }
  EXPECT_NEAR(cell(table, 9, "theta_i"), 90, 0.006);
  EXPECT_NEAR(table->GetFieldData()->GetArray("bihemispherical")->GetTuple1(1), 0.5, 1e-12);
}

TEST(Spectrum, HasAColumnForEachPairOfDirections) {
  vtkNew<vtkBRDFSpectrum> spectrum;
  spectrum->SetInputData(spectralGrid());
  spectrum->AddDirections(10, 0, 45, 180);
  spectrum->AddDirections(10, 0, 0, 0);
  ASSERT_TRUE(spectrum->UpdateAndCheck());
  vtkTable* table = spectrum->GetOutput();
  ASSERT_EQ(table->GetNumberOfRows(), 2);
  ASSERT_EQ(table->GetNumberOfColumns(), 5);
  EXPECT_EQ(cell(table, 1, "wavelength"), 600);
  const char* pair = "in 10\u00b0, 0\u00b0, out 45\u00b0, 180\u00b0";
  EXPECT_NEAR(cell(table, 1, pair), 3, 1e-12);
  EXPECT_NEAR(cell(table, 0, (std::string("standard error of ") + pair).c_str()), 0.15, 1e-12);
  const auto rgb = material("Lambertian");
  spectrum->SetInputConnection(rgb->GetOutputPort());
  const ExpectErrors quiet;
  EXPECT_FALSE(spectrum->UpdateAndCheck());
}

TEST(HoleMap, CountsTheCellsOfATableWithHoles) {
  TableData data;
  data.layout = {4, 3, 2, true};
  data.values.assign(24, 1);
  data.valid.assign(24, 1);
  data.valid[0] = 0;
  data.valid[1] = 2;
  vtkNew<vtkBRDF> brdf;
  brdf->SetBrdf(std::make_shared<TableBrdf>(data, "table"));
  vtkNew<vtkBRDFHoleMap> map;
  map->SetInputData(brdf);
  ASSERT_TRUE(map->UpdateAndCheck());
  vtkImageData* image = map->GetOutput();
  EXPECT_EQ(image->GetDimensions()[0], 2);  // theta_h
  EXPECT_EQ(image->GetDimensions()[1], 3);
  EXPECT_EQ(image->GetPointData()->GetArray("invalid")->GetTuple1(0), 1);
  EXPECT_EQ(image->GetPointData()->GetArray("filled")->GetTuple1(0), 1);
  EXPECT_EQ(map->GetNumberOfCells(0) + map->GetNumberOfCells(1) + map->GetNumberOfCells(2) + map->GetNumberOfCells(3),
            24);
  map->SetXAxis("phi_d");
  ASSERT_TRUE(map->UpdateAndCheck());
  EXPECT_EQ(map->GetOutput()->GetDimensions()[0], 4);
  map->SetXAxis("theta_o");
  const ExpectErrors quiet;
  EXPECT_FALSE(map->UpdateAndCheck());
  EXPECT_NE(map->GetErrorText().find("phi_d, theta_d, theta_h"), std::string::npos);
}

}  // namespace
}  // namespace brdf
