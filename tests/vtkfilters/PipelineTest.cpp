#include "Support.h"

#include <brdf/base/File.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/TableBrdf.h>

#include <gtest/gtest.h>

#include <vtkBRDFCells.h>
#include <vtkBRDFErrorMap.h>
#include <vtkBRDFFillHoles.h>
#include <vtkBRDFFit.h>
#include <vtkBRDFLobe.h>
#include <vtkBRDFLobeSamples.h>
#include <vtkBRDFReader.h>
#include <vtkBRDFSource.h>
#include <vtkBRDFTabulate.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVariant.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace brdf {
namespace {

using test::ExpectErrors;

TEST(Pipeline, EveryFilterExecutesOncePerChange) {
  vtkNew<vtkBRDFSource> source;
  vtkNew<vtkBRDFLobe> lobe;
  vtkNew<vtkBRDFTabulate> table;
  lobe->SetInputConnection(source->GetOutputPort());
  table->SetInputConnection(source->GetOutputPort());
  table->SetCells(8, 8, 8);
  const test::Executions ofSource(source), ofLobe(lobe), ofTable(table);
  const auto counts = [&] { return std::array<int, 3>{ofSource.count(), ofLobe.count(), ofTable.count()}; };
  for (int turn = 0; turn < 2; ++turn) {
    lobe->Update();
    table->Update();
  }
  EXPECT_EQ(counts(), (std::array<int, 3>{1, 1, 1}));
  source->SetMaterial("0.5*Lambertian");
  lobe->Update();
  table->Update();
  EXPECT_EQ(counts(), (std::array<int, 3>{2, 2, 2}));
  lobe->SetThetaI(10);
  lobe->Update();
  table->Update();
  EXPECT_EQ(counts(), (std::array<int, 3>{2, 3, 2}));
}

TEST(Pipeline, DataObjectSharesAndDescribesItsBrdf) {
  vtkNew<vtkBRDFSource> source;
  source->SetMaterial("(0.3,0.2,0.1)*Lambertian + GGX(alpha=0.25)");
  source->Update();
  vtkBRDF* brdf = source->GetOutput();
  EXPECT_EQ(brdf->GetNumberOfChannels(), 3);
  EXPECT_EQ(brdf->GetChannelKind(), "rgb");
  EXPECT_EQ(brdf->GetNumberOfSamples(), 0);
  vtkDataArray* alpha = brdf->GetFieldData()->GetArray("1.GGX.alpha");
  ASSERT_NE(alpha, nullptr);
  EXPECT_EQ(alpha->GetComponent(0, 0), 0.25);
  EXPECT_EQ(brdf->GetFieldData()->GetArray("0.Lambertian.scale")->GetTuple1(2), 0.1);
  const auto copy = vtkSmartPointer<vtkBRDF>::Take(brdf->NewInstance());
  copy->DeepCopy(brdf);
  EXPECT_EQ(copy->GetBrdf(), brdf->GetBrdf());
  EXPECT_EQ(copy->GetDescription(), brdf->GetDescription());
  copy->Initialize();
  EXPECT_TRUE(copy->IsEmpty());
  EXPECT_NE(brdf->GetBrdf(), nullptr);
}

TEST(Pipeline, ArraysEvaluateAsSinglePairsDo) {
  vtkNew<vtkBRDFSource> source;
  source->SetMaterial("(0.3,0.2,0.1)*Lambertian + GGX(alpha=0.25)");
  source->Update();
  vtkNew<vtkDoubleArray> wi, wo, values;
  vtkNew<vtkUnsignedCharArray> valid;
  wi->SetNumberOfComponents(3);
  wo->SetNumberOfComponents(3);
  for (int i = 0; i < 100; ++i) {
    wi->InsertNextTuple(fromSpherical(radians(0.9 * i), 0.1 * i).data());
    wo->InsertNextTuple(fromSpherical(radians(89 - 0.9 * i), 3).data());
  }
  ASSERT_TRUE(source->GetOutput()->Evaluate(wi, wo, values, valid));
  ASSERT_EQ(values->GetNumberOfTuples(), 100);
  ASSERT_EQ(values->GetNumberOfComponents(), 3);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(valid->GetValue(i), 1);
    for (int c = 0; c < 3; ++c)
      EXPECT_DOUBLE_EQ(values->GetComponent(i, c),
                       source->GetOutput()->Evaluate(wi->GetTuple3(i), wo->GetTuple3(i), c));
  }
}

TEST(Pipeline, ErrorsReachTheUserAndTheNextUpdateRecovers) {
  const ExpectErrors errors;
  vtkNew<vtkBRDFSource> source;
  vtkNew<vtkBRDFLobe> lobe;
  lobe->SetInputConnection(source->GetOutputPort());
  source->SetMaterial("0.3*Lambertian + Nonsense");
  lobe->Update();
  EXPECT_NE(source->GetErrorText().find("Nonsense"), std::string::npos) << source->GetErrorText();
  EXPECT_NE(errors.text().find("Nonsense"), std::string::npos);
  EXPECT_TRUE(source->GetOutput()->IsEmpty());
  source->SetMaterial("0.3*Lambertian");
  lobe->Update();
  EXPECT_TRUE(source->GetErrorText().empty());
  EXPECT_GT(lobe->GetOutput()->GetNumberOfPolys(), 0);
  lobe->SetTransform("sqrt");
  lobe->Update();
  EXPECT_NE(lobe->GetErrorText().find("cuberoot"), std::string::npos);
  EXPECT_EQ(lobe->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(Pipeline, EveryKindOfBadInputIsAnErrorAndNothingElse) {
  const ExpectErrors errors;
  vtkNew<vtkBRDFLobe> lobe;
  lobe->Update();  // no input
  vtkNew<vtkSphereSource> sphere;
  lobe->SetInputConnection(sphere->GetOutputPort());
  lobe->Update();  // of the wrong type
  EXPECT_EQ(lobe->GetOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkBRDF> empty;
  lobe->SetInputData(empty);
  lobe->Update();
  EXPECT_NE(lobe->GetErrorText().find("no BRDF"), std::string::npos);
  vtkNew<vtkBRDFReader> reader;
  reader->SetFileName("/no/such/file.binary");
  reader->Update();
  EXPECT_NE(reader->GetErrorText().find("/no/such/file.binary"), std::string::npos);
  vtkNew<vtkBRDFSource> source;
  vtkNew<vtkBRDFFit> fit;
  fit->SetInputConnection(source->GetOutputPort());
  fit->SetSampling("all");
  fit->Update();  // a formula has no samples of its own
  EXPECT_NE(fit->GetErrorText().find("no samples of its own"), std::string::npos);
  fit->SetSampling("automatic");
  fit->SetLobes("Nonsense");
  fit->Update();
  EXPECT_NE(fit->GetErrorText().find("Nonsense"), std::string::npos) << fit->GetErrorText();
  vtkNew<vtkBRDFTabulate> table;
  table->SetInputConnection(source->GetOutputPort());
  table->SetCells(1, 90, 90);
  table->Update();
  EXPECT_NE(table->GetErrorText().find("2 to 1024"), std::string::npos);
  vtkNew<vtkDoubleArray> one;
  EXPECT_FALSE(empty->Evaluate(one, one, one));
  const double up[3] = {0, 0, 1};
  EXPECT_EQ(empty->Evaluate(up, up), 0);
}

TEST(Pipeline, AFitTakesTheOptionsOfTheCommandLine) {
  vtkNew<vtkBRDFSource> source;
  source->SetMaterial("0.3*Lambertian + 0.5*GGX(alpha=0.3, ior=1.5)");
  vtkNew<vtkBRDFFit> fit;
  fit->SetInputConnection(source->GetOutputPort());
  fit->SetSampling("importance");
  fit->SetNumberOfSamples(3000);
  fit->SetMaximumTheta(80);
  fit->SetMetric("ngan");
  fit->SetConstraints("ior=1.5; GGX.alpha_y=alpha");
  fit->SetProgressive(true);
  fit->SetCrossValidation(3);
  fit->Update();
  ASSERT_EQ(fit->GetErrorText(), "");
  vtkFieldData* fields = fit->GetOutput()->GetFieldData();
  EXPECT_LT(fields->GetArray("error")->GetTuple1(0), 1e-6);
  EXPECT_LT(fields->GetArray("crossValidationError")->GetTuple1(0), 1e-6);
  EXPECT_EQ(fields->GetArray("degrees")->GetTuple1(0), 4);  // two scales, alpha and the variance
  fit->SetStrategy("both");
  fit->Update();
  EXPECT_NE(fit->GetErrorText().find("automatic, separable, joint"), std::string::npos);
}

TEST(Pipeline, LambertianLobeHasTheRadiusOfItsValue) {
  vtkNew<vtkBRDFSource> source;
  source->SetMaterial("(0.5,0.5,0.5)*Lambertian");
  vtkNew<vtkBRDFLobe> lobe;
  lobe->SetInputConnection(source->GetOutputPort());
  for (const auto& [transform, radius] : {std::pair{"none", 0.15915494309189535}, {"cuberoot", 0.5419260701392890}}) {
    lobe->SetTransform(transform);
    lobe->Update();
    vtkPolyData* mesh = lobe->GetOutput();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
      const double* p = mesh->GetPoint(i);
      ASSERT_NEAR(std::hypot(p[0], p[1], p[2]), radius, 1e-14);
      ASSERT_GE(p[2], 0);
    }
    EXPECT_NEAR(lobe->GetMaximumLength(), radius, 1e-14);
  }
  EXPECT_EQ(lobe->GetOutput()->GetPointData()->GetArray("value")->GetNumberOfComponents(), 1);
  lobe->SetChannel("rgb");
  lobe->Update();
  EXPECT_EQ(lobe->GetOutput()->GetPointData()->GetArray("value")->GetNumberOfComponents(), 3);
  EXPECT_NE(lobe->GetOutput()->GetFieldData()->GetAbstractArray("vtkBRDF"), nullptr);
}

TEST(Pipeline, GeometryIsForTheFirstRankOnly) {
  vtkNew<vtkBRDFSource> source;
  vtkNew<vtkBRDFLobe> lobe;
  lobe->SetInputConnection(source->GetOutputPort());
  lobe->UpdatePiece(1, 2, 0);
  EXPECT_EQ(lobe->GetOutput()->GetNumberOfPoints(), 0);
  lobe->UpdatePiece(0, 2, 0);
  EXPECT_GT(lobe->GetOutput()->GetNumberOfPoints(), 0);
  source->UpdatePiece(1, 2, 0);
  EXPECT_FALSE(source->GetOutput()->IsEmpty());
}

TEST(Pipeline, TableHoldsTheValuesAtItsCellCentres) {
  vtkNew<vtkBRDFSource> source;
  source->SetMaterial("(0.3,0.2,0.1)*Lambertian + GGX(alpha=0.4)");
  vtkNew<vtkBRDFTabulate> table;
  table->SetInputConnection(source->GetOutputPort());
  table->SetCells(12, 10, 8);
  table->Update();
  vtkImageData* image = table->GetOutput();
  ASSERT_EQ(image->GetNumberOfPoints(), 12 * 10 * 8);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i) {
    const double* at = image->GetPoint(i);
    const DirectionPair pair = fromHalfDifference({radians(90 * at[2] * at[2]), 0, radians(at[1]), radians(at[0])});
    const bool above = pair.wi[2] > 1e-12 && pair.wo[2] > 1e-12;
    if (std::min(std::abs(pair.wi[2]), std::abs(pair.wo[2])) < 1e-12) continue;
    ASSERT_EQ(image->GetPointData()->GetArray("valid")->GetTuple1(i), above);
    for (int c = 0; c < 3; ++c) {
      const double expected = above ? source->GetOutput()->Evaluate(pair.wi.data(), pair.wo.data(), c) : 0;
      ASSERT_NEAR(image->GetPointData()->GetArray("value")->GetComponent(i, c), expected, 1e-9 * (1 + expected));
    }
  }
}

/// A diffuse table with a hole of four cells: phi_d 3 and 4, theta_d 2, theta_h 1 and 2.
vtkNew<vtkBRDF> tableWithAHole(TableBrdf::Position position = TableBrdf::Position::Centre) {
  const TableLayout layout{.phiD = 12, .thetaD = 6, .thetaH = 5};
  TableData data = TableBrdf::tabulate(*parseMaterialExpression("(0.3,0.2,0.1)*Lambertian"), layout)->data();
  for (const std::size_t h : {1, 2})
    for (const std::size_t d : {3, 4}) data.valid[d + 12 * (2 + 6 * h)] = stateByte(CellState::Invalid);
  vtkNew<vtkBRDF> brdf;
  brdf->SetBrdf(std::make_shared<TableBrdf>(std::move(data), "holes", TableBrdf::Lookup::Interpolated, position));
  return brdf;
}

TEST(Pipeline, CellsAreThoseOfTheTableWithTheirStates) {
  vtkNew<vtkBRDFCells> cells;
  const auto table = tableWithAHole();
  cells->SetInputData(table);
  cells->Update();
  ASSERT_EQ(cells->GetErrorText(), "");
  vtkImageData* image = cells->GetOutput();
  EXPECT_EQ(image->GetNumberOfPoints(), 12 * 6 * 5);
  EXPECT_EQ(image->GetDimensions()[0], 12);
  EXPECT_NEAR(image->GetOrigin()[0], 7.5, 1e-9);
  EXPECT_NEAR(image->GetSpacing()[1], 15, 1e-9);
  EXPECT_NEAR(image->GetOrigin()[2], 0.1, 1e-9);
  EXPECT_NEAR(image->GetSpacing()[2], 0.2, 1e-9);
  EXPECT_EQ(vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray("axes"))->GetValue(2), "theta_h");
  EXPECT_EQ(image->GetPointData()->GetArray("standardError"), nullptr);
  vtkDataArray* state = image->GetPointData()->GetArray("state");
  EXPECT_EQ(state->GetTuple1(3 + 12 * (2 + 6 * 1)), 0);
  EXPECT_EQ(state->GetTuple1(2 + 12 * (2 + 6 * 1)), 1);
  vtkDataArray* value = image->GetPointData()->GetScalars();
  EXPECT_EQ(value->GetComponent(3 + 12 * (2 + 6 * 1), 1), 0);
  EXPECT_NEAR(value->GetComponent(2 + 12 * (2 + 6 * 1), 1), 0.2 / kPi, 1e-15);

  const auto atNodes = tableWithAHole(TableBrdf::Position::Node);
  cells->SetInputData(atNodes);
  cells->Update();
  EXPECT_EQ(cells->GetOutput()->GetOrigin()[0], 0);

  GridData grid{{Parametrisation::Spherical, {GridAxis::listedDegrees(AxisQuantity::ThetaO, {0, 10, 50})}},
                Channels::monochrome(),
                {1, 2, 3},
                {1, 2, 1},
                {0.1, 0.2, 0.3}};
  vtkNew<vtkBRDF> line;
  line->SetBrdf(std::make_shared<GridBrdf>(grid, "line"));
  cells->SetInputData(line);
  cells->Update();
  EXPECT_EQ(cells->GetOutput()->GetNumberOfPoints(), 3);
  EXPECT_EQ(cells->GetOutput()->GetPointData()->GetArray("standardError")->GetTuple1(2), 0.3);
  EXPECT_EQ(vtkStringArray::SafeDownCast(cells->GetOutput()->GetFieldData()->GetAbstractArray("units"))->GetValue(0),
            "index");

  const ExpectErrors errors;
  vtkNew<vtkBRDFSource> formula;
  cells->SetInputConnection(formula->GetOutputPort());
  cells->Update();
  EXPECT_NE(errors.text().find("a BRDF without cells"), std::string::npos) << errors.text();
}

TEST(Pipeline, HolesAreFilledByTheMethodNamedAndMarked) {
  const auto table = tableWithAHole();
  vtkNew<vtkBRDFFillHoles> fill;
  fill->SetInputData(table);
  vtkNew<vtkBRDFCells> cells;
  cells->SetInputConnection(fill->GetOutputPort());
  const auto hole = [&](const char* array, int component) {
    cells->Update();
    EXPECT_EQ(fill->GetErrorText(), "");
    return cells->GetOutput()->GetPointData()->GetArray(array)->GetComponent(3 + 12 * (2 + 6 * 1), component);
  };
  EXPECT_EQ(hole("state", 0), 2);
  EXPECT_NEAR(hole("value", 2), 0.1 / kPi, 1e-15);
  EXPECT_EQ(fill->GetNumberOfFilledCells(), 4);
  EXPECT_EQ(fill->GetNumberOfRemainingCells(), 0);
  EXPECT_EQ(fill->GetOutput()->GetFieldData()->GetArray("filledCells")->GetTuple1(0), 4);
  fill->SetMethod("none");
  EXPECT_EQ(hole("state", 0), 0);
  EXPECT_EQ(fill->GetNumberOfRemainingCells(), 4);
  vtkNew<vtkBRDFSource> model;
  model->SetMaterial("(0.6,0.5,0.4)*Lambertian");
  fill->SetInputConnection(1, model->GetOutputPort());
  fill->SetMethod("model");
  EXPECT_NEAR(hole("value", 0), 0.6 / kPi, 1e-15);
  EXPECT_EQ(fill->GetNumberOfFilledCells(), 4);

  const ExpectErrors errors;
  fill->SetMethod("guess");
  fill->Update();
  EXPECT_NE(fill->GetErrorText().find("reciprocity"), std::string::npos) << fill->GetErrorText();
  fill->SetMethod("model");
  fill->SetInputConnection(1, nullptr);
  fill->Update();
  EXPECT_NE(fill->GetErrorText().find("input port 1"), std::string::npos) << fill->GetErrorText();
}

TEST(Pipeline, FitFindsTheParametersThatMadeItsTarget) {
  TableLayout layout;
  layout.phiD = 24;
  layout.thetaD = 12;
  layout.thetaH = 24;
  const auto truth = parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + 0.5*GGX(alpha=0.2, ior=1.5)");
  vtkNew<vtkBRDF> target;
  target->SetBrdf(TableBrdf::tabulate(*truth, layout));
  EXPECT_EQ(target->GetNumberOfSamples(), 24 * 12 * 24);
  vtkNew<vtkBRDFFit> fit;
  fit->SetInputData(target);
  fit->SetLobes("Lambertian + GGX");
  fit->Update();
  ASSERT_EQ(fit->GetErrorText(), "");
  vtkFieldData* fields = fit->GetOutput()->GetFieldData();
  EXPECT_LT(fields->GetArray("error")->GetTuple1(0), 1e-6 * fields->GetArray("zeroModelError")->GetTuple1(0));
  EXPECT_GT(fields->GetArray("constantModelError")->GetTuple1(0), fields->GetArray("error")->GetTuple1(0));
  ASSERT_EQ(fit->GetRegions()->GetNumberOfRows(), 4);
  EXPECT_EQ(fit->GetRegions()->GetValueByName(0, "region").ToString(), "near mirror");
  vtkTable* table = fit->GetParameters();
  bool found = false;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    if (table->GetValueByName(row, "parameter").ToString() == "alpha") {
      found = true;
      EXPECT_NEAR(table->GetValueByName(row, "value").ToDouble(), 0.2, 1e-6);
      EXPECT_EQ(table->GetValueByName(row, "channel").ToInt(), -1);
    }
  EXPECT_TRUE(found);
}

TEST(Pipeline, ErrorMapIsAnImageInDegrees) {
  vtkNew<vtkBRDFSource> a, b;
  a->SetMaterial("0.9*Lambertian");
  b->SetMaterial("0.4*Lambertian");
  vtkNew<vtkBRDFErrorMap> map;
  map->SetInputConnection(0, a->GetOutputPort());
  map->SetInputConnection(1, b->GetOutputPort());
  map->SetIntervals(30);
  map->Update();
  vtkImageData* image = map->GetOutput();
  EXPECT_EQ(image->GetDimensions()[0], 31);
  EXPECT_DOUBLE_EQ(image->GetBounds()[1], 90);
  EXPECT_DOUBLE_EQ(image->GetBounds()[3], 90);
  const double* range = image->GetPointData()->GetArray("error")->GetRange();
  EXPECT_NEAR(range[0], 0.5 / kPi, 1e-15);
  EXPECT_NEAR(range[1], 0.5 / kPi, 1e-15);
  EXPECT_NEAR(map->GetOverallMean(), 0.5 / kPi, 1e-14);
  EXPECT_EQ(map->SuggestIntervals(), 90);
}

TEST(Pipeline, ErrorMapHasAHistogramAndTheWorstDirections) {
  vtkNew<vtkBRDFSource> a, b;
  a->SetMaterial("(0.2, 0.3, 0.4)*Lambertian + 0.1*GGX(alpha=0.3)");
  b->SetMaterial("0.4*Lambertian + 0.1*GGX(alpha=0.2)");
  vtkNew<vtkBRDFErrorMap> map;
  map->SetInputConnection(0, a->GetOutputPort());
  map->SetInputConnection(1, b->GetOutputPort());
  map->SetAxes("hemisphere");
  map->SetThetaI(50);
  map->SetChannel("rgb");
  map->SetMeasure("log");
  map->SetIntervals(40);
  map->SetNumberOfWorst(7);
  map->Update();
  ASSERT_EQ(map->GetErrorText(), "");
  vtkImageData* image = map->GetOutput();
  EXPECT_EQ(image->GetDimensions()[0], 41);
  EXPECT_DOUBLE_EQ(image->GetBounds()[0], -1);
  EXPECT_DOUBLE_EQ(image->GetBounds()[3], 1);
  EXPECT_EQ(image->GetPointData()->GetArray("channel_error")->GetNumberOfComponents(), 3);
  EXPECT_EQ(map->GetNumberOfChannels(), 3);

  vtkTable* histogram = map->GetHistogram();
  EXPECT_EQ(histogram->GetNumberOfRows(), 60);
  double pairs = 0, share = 0;
  for (vtkIdType row = 0; row < 60; ++row) {
    pairs += histogram->GetValueByName(row, "count").ToDouble();
    share += histogram->GetValueByName(row, "share").ToDouble();
    EXPECT_LT(histogram->GetValueByName(row, "low").ToDouble(), histogram->GetValueByName(row, "high").ToDouble());
  }
  EXPECT_EQ(pairs, map->GetNumberOfPairs());
  EXPECT_NEAR(share, 1, 1e-12);
  EXPECT_EQ(map->GetQuantile(1), histogram->GetValueByName(59, "high").ToDouble());

  vtkTable* worst = map->GetWorst();
  ASSERT_EQ(worst->GetNumberOfRows(), 7);
  EXPECT_EQ(worst->GetValueByName(0, "error").ToDouble(), map->GetQuantile(1));
  for (vtkIdType row = 0; row < 7; ++row) {
    const auto value = [&](const char* column) { return worst->GetValueByName(row, column).ToDouble(); };
    EXPECT_NEAR(value("theta_i"), 50, 1e-10);
    double squares = 0;  // the metric's own terms
    for (const auto& [inA, inB] : {std::pair{"a_0", "b_0"}, std::pair{"a_1", "b_1"}, std::pair{"a_2", "b_2"}}) {
      const double cosine = std::cos(radians(50));
      squares += std::pow(std::log1p(value(inA) * cosine) - std::log1p(value(inB) * cosine), 2) / 3;
    }
    EXPECT_NEAR(value("error"), std::sqrt(squares), 1e-12);
    EXPECT_LE(value("error"), worst->GetValueByName(std::max<vtkIdType>(row - 1, 0), "error").ToDouble());
  }
}

TEST(Pipeline, LobesShowDifferencesAndColours) {
  vtkNew<vtkBRDFSource> a, b;
  a->SetMaterial("(1, 0.5, 0)*Lambertian");
  b->SetMaterial("0.25*Lambertian");
  vtkNew<vtkBRDFLobe> lobe;
  lobe->SetInputConnection(0, a->GetOutputPort());
  lobe->SetChannel("1");
  lobe->SetColour("true");
  lobe->Update();
  vtkDataArray* rgb = lobe->GetOutput()->GetPointData()->GetArray("rgb");
  ASSERT_NE(rgb, nullptr);
  EXPECT_EQ(rgb->GetComponent(7, 0), 255);
  EXPECT_EQ(rgb->GetComponent(7, 1), 188);  // sRGB of 0.5
  EXPECT_EQ(rgb->GetComponent(7, 2), 0);
  lobe->SetColour("0");
  lobe->Update();
  EXPECT_NEAR(lobe->GetOutput()->GetPointData()->GetArray("colour")->GetComponent(7, 0), 1 / kPi, 1e-14);
  EXPECT_NEAR(lobe->GetMaximumLength(), 0.5 / kPi, 1e-14);  // still channel 1
  {
    const ExpectErrors errors;
    lobe->SetShape("difference");
    lobe->Update();
    EXPECT_NE(lobe->GetErrorText().find("no BRDF"), std::string::npos) << lobe->GetErrorText();
  }
  lobe->SetInputConnection(1, b->GetOutputPort());
  lobe->SetChannel("luminance");
  lobe->SetShape("displaced");
  lobe->Update();
  ASSERT_EQ(lobe->GetErrorText(), "");
  const double difference = (0.2126 + 0.5 * 0.7152 - 0.25) / kPi;
  EXPECT_NEAR(lobe->GetReferenceRadius(), difference, 1e-4);
  const double* bounds = lobe->GetOutput()->GetBounds();
  EXPECT_NEAR(bounds[5], 2 * lobe->GetReferenceRadius(), 1e-14);
}

TEST(Pipeline, LobeSamplesLieWhereTheyWereMeasured) {
  vtkNew<vtkBRDFSource> a, b;
  a->SetMaterial("0.5*Lambertian");
  b->SetMaterial("0.4*Lambertian");
  const auto measured = test::tabulated("0.5*Lambertian");
  vtkNew<vtkBRDFLobeSamples> samples;
  samples->SetInputDataObject(0, measured);
  samples->SetInputConnection(1, b->GetOutputPort());
  samples->SetTransform("cuberoot");
  samples->SetWithin(4);
  samples->Update();
  ASSERT_EQ(samples->GetErrorText(), "");
  vtkPolyData* points = samples->GetOutput();
  EXPECT_GT(points->GetNumberOfPoints(), 100);
  EXPECT_EQ(points->GetNumberOfVerts(), points->GetNumberOfPoints());
  const double length = std::cbrt(0.5 / kPi), residual = std::cbrt(0.4 / kPi) - length;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
    const double* p = points->GetPoint(i);
    EXPECT_NEAR(std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), length, 1e-14);
    EXPECT_NEAR(points->GetPointData()->GetArray("residual")->GetComponent(i, 0), residual, 1e-14);
  }
  samples->SetMaximumPoints(10);
  samples->Update();
  EXPECT_LE(samples->GetOutput()->GetNumberOfPoints(), 10);
  EXPECT_GT(samples->GetNumberFound(), 100);
  const ExpectErrors errors;
  samples->SetInputConnection(0, a->GetOutputPort());
  samples->Update();
  EXPECT_NE(samples->GetErrorText().find("no measured samples"), std::string::npos) << samples->GetErrorText();
}

/// Diffuse, reflecting red light: a sum of lobes at 31 wavelengths.
std::shared_ptr<const LobeSum> spectralRed() {
  std::vector<double> wavelengths;
  Lobe lobe = parseMaterialExpression("Lambertian")->lobes().front();
  lobe.scale.clear();
  for (int i = 0; i < 31; ++i) {
    wavelengths.push_back(400 + 10 * i);
    lobe.scale.push_back(0.1 + 0.7 / (1 + std::exp((590 - wavelengths.back()) / 12)));
  }
  return std::make_shared<LobeSum>(std::vector<Lobe>{lobe}, Channels::spectral(wavelengths));
}

TEST(Pipeline, LobesAndErrorMapsShowSpectraUnderTheLightAskedFor) {
  vtkNew<vtkBRDF> red;
  red->SetBrdf(spectralRed());
  vtkNew<vtkBRDFLobe> lobe;
  lobe->SetInputDataObject(red);
  lobe->SetChannel("rgb");
  const auto first = [&] {
    lobe->Update();
    EXPECT_EQ(lobe->GetErrorText(), "");
    double rgb[3];
    lobe->GetOutput()->GetPointData()->GetArray("value")->GetTuple(0, rgb);
    return std::array<double, 3>{rgb[0], rgb[1], rgb[2]};
  };
  const auto expected = [&](const ColourNames& names) {
    return asRgb(spectralRed(), colourSettings(names))->evaluate(fromSpherical(0.5, 0), fromSpherical(0.5, 1));
  };
  const auto daylight = first();
  lobe->SetIlluminant("A");
  lobe->SetObserver("10");
  const auto lamp = first();
  lobe->SetAdaptation("none");
  const auto bare = first();
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(daylight[c], expected({})[c], 1e-12);
    EXPECT_NEAR(lamp[c], expected({"A", "10", "bradford"})[c], 1e-12);
    EXPECT_NEAR(bare[c], expected({"A", "10", "none"})[c], 1e-12);
  }
  EXPECT_GT(lamp[0], 1.05 * daylight[0]);

  vtkNew<vtkBRDFSource> black;
  black->SetMaterial("0*Lambertian");
  vtkNew<vtkBRDFErrorMap> map;
  map->SetInputDataObject(0, red);
  map->SetInputConnection(1, black->GetOutputPort());
  map->SetIntervals(9);
  map->SetIlluminant("A");
  map->Update();
  const auto luminance = asLuminance(spectralRed(), colourSettings({"A", "2", "bradford"}));
  EXPECT_NEAR(map->GetOverallMean(), luminance->evaluate(fromSpherical(0.5, 0), fromSpherical(0.5, 1))[0], 1e-12);

  ExpectErrors quiet;
  map->SetIlluminant("lamp");
  map->Update();
  EXPECT_NE(map->GetErrorText().find("D65"), std::string::npos) << map->GetErrorText();
}

TEST(Pipeline, ReaderTellsWhatTheFileHolds) {
  const std::string file = std::string(BRDF_SHARED_DIR) + "/data/measured/garnet_red.brdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no measured data at " << file;
  vtkNew<vtkBRDFReader> reader;
  reader->SetFileName(file);
  reader->Update();
  ASSERT_EQ(reader->GetErrorText(), "");
  EXPECT_EQ(reader->GetOutput()->GetChannelKind(), "spectral");
  EXPECT_EQ(reader->GetOutput()->GetNumberOfChannels(), 31);
  EXPECT_EQ(reader->GetOutput()->GetWavelength(0), 400);
  EXPECT_EQ(reader->GetOutput()->GetWavelength(30), 700);
  EXPECT_EQ(reader->GetOutput()->GetFieldData()->GetArray("samples")->GetTuple1(0),
            reader->GetOutput()->GetNumberOfSamples());
}

}  // namespace
}  // namespace brdf
