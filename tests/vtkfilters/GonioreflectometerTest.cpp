// The virtual gonioreflectometer on the pipeline: tables, balance, and one lobe refined while one looks.
#include "Support.h"

#include <brdf/material/GridBrdf.h>
#include <gtest/gtest.h>
#include <vtkBRDFGonioreflectometer.h>
#include <vtkBRDFMicrosurface.h>
#include <vtkBRDFMicrosurfaceSource.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cmath>

namespace {

class GonioreflectometerFilter : public testing::Test {
 protected:
  GonioreflectometerFilter() {
    source_->SetSurface("gaussian(rms=0.5, correlation=2, period=32)");
    filter_->SetInputConnection(source_->GetOutputPort());
    filter_->SetTolerance(0.2);
  }
  void update() { ASSERT_TRUE(filter_->UpdateAndCheck()) << filter_->GetPipelineErrorText(); }
  double field(const char* name) { return filter_->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(0); }
  double balance(const char* column, vtkIdType row) {
    return vtkDataArray::SafeDownCast(filter_->GetBalance()->GetColumnByName(column))->GetTuple1(row);
  }

  vtkNew<vtkBRDFMicrosurfaceSource> source_;
  vtkNew<vtkBRDFGonioreflectometer> filter_;
};

}  // namespace

TEST_F(GonioreflectometerFilter, MakesATableWithErrorsAndItsEnergyBalance) {
  filter_->SetThetaI("0,40");
  filter_->AddFacet("conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)");
  update();
  const auto grid = std::dynamic_pointer_cast<const brdf::GridBrdf>(filter_->GetOutput()->GetBrdf());
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->channels(), brdf::Channels::rgb());
  EXPECT_FALSE(grid->data().standardError.empty());
  EXPECT_EQ(field("converged"), 1);
  ASSERT_EQ(filter_->GetBalance()->GetNumberOfRows(), 6);  // two directions, three channels
  for (vtkIdType row = 0; row < 6; ++row) {
    EXPECT_NEAR(balance("theta_i", row), row < 3 ? 0 : 40, 1e-9);
    EXPECT_EQ(balance("channel", row), static_cast<double>(row % 3));
    EXPECT_NEAR(balance("reflected", row) + balance("absorbed", row) + balance("lost", row), balance("sum", row), 1e-9);
    EXPECT_LE(balance("noise", row), 0.2);
  }
  EXPECT_GT(balance("reflected", 0), balance("reflected", 2));  // gold is red
}

TEST_F(GonioreflectometerFilter, AnAzimuthMakesAnAnisotropicTable) {
  filter_->SetThetaI("30");
  filter_->SetPhiI("0,90");
  update();
  EXPECT_EQ(filter_->GetOutput()->GetBrdf()->symmetry(), brdf::Symmetry::Anisotropic);
  EXPECT_EQ(filter_->GetBalance()->GetNumberOfRows(), 2);
  EXPECT_NEAR(balance("phi_i", 1), 90, 1e-9);
}

TEST_F(GonioreflectometerFilter, ProgressiveUpdatesAddToOneLobeUntilItIsGoodEnough) {
  filter_->SetThetaI("40");
  filter_->ProgressiveOn();
  filter_->SetRaysPerUpdate(4096);
  filter_->SetTolerance(0.15);
  update();
  EXPECT_EQ(field("rays"), 4096);
  const double first = balance("noise", 0);
  update();  // nobody asked for more
  EXPECT_EQ(field("rays"), 4096);
  int updates = 1;
  while (filter_->Refine()) {
    update();
    ++updates;
    ASSERT_LT(updates, 1000);
  }
  EXPECT_EQ(field("rays"), 4096.0 * updates);
  EXPECT_GT(updates, 2);
  EXPECT_LE(balance("noise", 0), 0.15);
  EXPECT_NEAR(balance("noise", 0) * std::sqrt(updates) / first, 1, 0.2);

  filter_->SetThetaI("50");  // another lobe starts anew
  update();
  EXPECT_EQ(field("rays"), 4096);
  EXPECT_TRUE(filter_->Refine());
  source_->SetSurface("flat");
  update();
  EXPECT_EQ(field("rays"), 4096);
  EXPECT_EQ(balance("specularReflected", 0), 1);
}

TEST_F(GonioreflectometerFilter, MistakesAreErrorsOfOneLine) {
  const auto reason = [&](auto change) {
    vtkNew<vtkBRDFGonioreflectometer> filter;
    filter->SetInputConnection(source_->GetOutputPort());
    filter->SetThetaI("0");
    change(filter.Get());
    const brdf::test::ExpectErrors errors;
    EXPECT_FALSE(filter->UpdateAndCheck());
    EXPECT_EQ(filter->GetErrorText().find('\n'), std::string::npos);
    return filter->GetErrorText();
  };
  EXPECT_NE(reason([](auto* f) { f->AddFacet("gold"); }).find("mirror, conductor"), std::string::npos);
  EXPECT_NE(reason([](auto* f) { f->SetThetaI("0,x"); }).find("list of angles"), std::string::npos);
  EXPECT_NE(reason([](auto* f) { f->SetThetaI("95"); }).find("theta_i"), std::string::npos);
  EXPECT_NE(reason([](auto* f) { f->SetBins("round"); }).find("auto, spherical, specular"), std::string::npos);
  EXPECT_NE(reason([](auto* f) { f->SetBackend("abacus"); }).find("cpu"), std::string::npos);
  EXPECT_NE(reason([](auto* f) { f->SetTolerance(0); }).find("tolerance"), std::string::npos);
}

TEST_F(GonioreflectometerFilter, FacetsAreListedAndTheirFormsNamed) {
  filter_->AddFacet("mirror");
  filter_->AddFacet("dielectric(eta=1.5)");
  EXPECT_EQ(filter_->GetNumberOfFacets(), 2);
  EXPECT_EQ(filter_->GetFacet(1), "dielectric(eta=1.5)");
  EXPECT_EQ(filter_->GetFacet(2), "");
  filter_->RemoveAllFacets();
  EXPECT_EQ(filter_->GetNumberOfFacets(), 0);
  vtkNew<vtkStringArray> forms;
  vtkBRDFGonioreflectometer::GetFacetForms(forms);
  EXPECT_EQ(forms->GetNumberOfValues(), 5);
}
