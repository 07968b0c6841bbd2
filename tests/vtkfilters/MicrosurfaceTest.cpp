// Microsurfaces on the pipeline: from expressions, images and meshes; as polygons, heights and pictures.
#include "../TestFolder.h"

#include <brdf/simulate/SurfaceKinds.h>
#include <gtest/gtest.h>
#include <vtkBRDFMicrosurface.h>
#include <vtkBRDFMicrosurfaceGeometry.h>
#include <vtkBRDFMicrosurfaceSource.h>
#include <vtkBRDFMicrosurfaceView.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTIFFWriter.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace {

class MicrosurfaceFilters : public testing::Test {
 protected:
  void SetUp() override { vtkObject::GlobalWarningDisplayOff(); }
  void TearDown() override { vtkObject::GlobalWarningDisplayOn(); }

  vtkBRDFMicrosurface* make(const std::string& expression) {
    source_->SetSurface(expression);
    EXPECT_TRUE(source_->UpdateAndCheck()) << source_->GetErrorText();
    return source_->GetOutput();
  }
  const brdf::HeightField& heights() {
    return std::get<brdf::HeightField>(source_->GetOutput()->GetSurface()->surface.shape);
  }

  vtkNew<vtkBRDFMicrosurfaceSource> source_;
};

/// Values 0, 1, 2, ... from the lower left, along rows.
template <class Array>
vtkSmartPointer<vtkImageData> countingImage(int width, int height) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->SetSpacing(0.5, 0.25, 1);
  vtkNew<Array> values;
  for (int k = 0; k < width * height; ++k) values->InsertNextTuple1(k);
  image->GetPointData()->SetScalars(values);
  return image;
}

}  // namespace

TEST_F(MicrosurfaceFilters, ExpressionBecomesASurfaceWithItsFacts) {
  vtkBRDFMicrosurface* surface = make("gaussian(rms=0.5, correlation=4, period=64, resolution=4)");
  EXPECT_EQ(surface->GetShape(), "height field");
  EXPECT_NEAR(surface->GetFact("rms height"), 0.5, 1e-6);
  EXPECT_TRUE(std::isnan(surface->GetFact("no such fact")));
  ASSERT_GT(surface->GetNumberOfFacts(), 5);
  EXPECT_EQ(surface->GetFactName(-1), "");
  vtkDataArray* array = surface->GetFieldData()->GetArray("rms height (um)");
  ASSERT_NE(array, nullptr);
  EXPECT_NEAR(array->GetTuple1(0), 0.5, 1e-6);
  vtkNew<vtkBRDFMicrosurface> copy;
  copy->DeepCopy(surface);
  EXPECT_EQ(copy->GetSurface(), surface->GetSurface());
  vtkNew<vtkStringArray> kinds;
  vtkBRDFMicrosurfaceSource::GetKinds(kinds);
  EXPECT_EQ(static_cast<std::size_t>(kinds->GetNumberOfValues()), brdf::surfaceKinds().size());
}

TEST_F(MicrosurfaceFilters, BadExpressionIsAnErrorAndTheOutputEmpty) {
  make("flat");
  source_->SetSurface("grooves(width=30)");
  EXPECT_FALSE(source_->UpdateAndCheck());
  EXPECT_NE(source_->GetErrorText().find("width"), std::string::npos);
  EXPECT_TRUE(source_->GetOutput()->IsEmpty());
}

TEST_F(MicrosurfaceFilters, ImageOfHeightsIsASurface) {
  const auto image = countingImage<vtkFloatArray>(4, 3);
  source_->SetInputData(image);
  source_->SetHeightScale(-2);
  ASSERT_TRUE(source_->UpdateAndCheck()) << source_->GetErrorText();
  EXPECT_EQ(heights().columns, 4u);
  EXPECT_EQ(heights().spacingY, 0.25);
  EXPECT_EQ(heights().height(1, 2), -18);
  image->SetDimensions(2, 2, 3);
  image->Modified();
  EXPECT_FALSE(source_->UpdateAndCheck());
}

TEST_F(MicrosurfaceFilters, MeshIsTiledWithItsExtentOrAPeriod) {
  vtkNew<vtkPlaneSource> plane;
  plane->SetPoint1(3, 0, 0);
  plane->SetPoint2(0, 2, 0);
  plane->SetResolution(2, 2);
  source_->SetInputConnection(plane->GetOutputPort());
  ASSERT_TRUE(source_->UpdateAndCheck()) << source_->GetErrorText();
  EXPECT_EQ(source_->GetOutput()->GetShape(), "mesh");
  // The plane's own corner is (-0.5, -0.5): a parallelogram, (3.5, 2.5) its far corner.
  EXPECT_EQ(source_->GetOutput()->GetFact("period along x"), 4);
  EXPECT_EQ(source_->GetOutput()->GetFact("triangles"), 8);
  source_->SetPeriod(7, 0);
  ASSERT_TRUE(source_->UpdateAndCheck());
  EXPECT_EQ(source_->GetOutput()->GetFact("period along x"), 7);
  EXPECT_EQ(source_->GetOutput()->GetFact("period along y"), 3);
}

TEST_F(MicrosurfaceFilters, PicturesOfHeightsAreUprightInEveryFormat) {
  const auto folder = testFolder("pictures");
  const auto image = countingImage<vtkUnsignedShortArray>(5, 4);
  const auto write = [&](vtkImageWriter* writer, const char* name) {
    writer->SetInputData(image);
    writer->SetFileName((folder / name).c_str());
    writer->Write();
  };
  write(vtkNew<vtkPNGWriter>(), "h.png");
  write(vtkNew<vtkTIFFWriter>(), "h.tif");
  for (const char* name : {"h.png", "h.tif"}) {
    make("heightfield(file=\"" + (folder / name).string() + "\", depth=65535)");
    ASSERT_EQ(heights().columns, 5u);
    ASSERT_EQ(heights().rows, 4u);
    for (std::size_t k = 0; k < 20; ++k) EXPECT_NEAR(heights().heights[k], static_cast<double>(k), 1e-4) << name;
  }
}

TEST_F(MicrosurfaceFilters, GeometryIsWhatIsTraced) {
  vtkNew<vtkBRDFMicrosurfaceGeometry> geometry;
  geometry->SetInputConnection(source_->GetOutputPort());
  make("grooves(width=10, spacing=10, angle=90)");
  geometry->SetTiles(3, 2);
  ASSERT_TRUE(geometry->UpdateAndCheck()) << geometry->GetErrorText();
  vtkPolyData* polygons = geometry->GetOutput();
  EXPECT_EQ(polygons->GetNumberOfPolys(), 3 * 2 * 2 * 2 * 2);
  double bounds[6];
  polygons->GetBounds(bounds);
  EXPECT_DOUBLE_EQ(bounds[1], 30);
  EXPECT_DOUBLE_EQ(bounds[3], 20);
  EXPECT_DOUBLE_EQ(bounds[4], -5);
  EXPECT_EQ(polygons->GetPointData()->GetScalars()->GetRange()[0], -5);
  ASSERT_NE(polygons->GetFieldData()->GetArray("groove depth (um)"), nullptr);
  EXPECT_EQ(geometry->GetHeights()->GetNumberOfPoints(), 4);
  EXPECT_EQ(geometry->GetHeights()->GetSpacing()[0], 5);
  geometry->SetTiles(101, 1);
  EXPECT_FALSE(geometry->UpdateAndCheck());
  geometry->SetTiles(2, 2);
  make("spheres(count=3, period=5)");
  ASSERT_TRUE(geometry->UpdateAndCheck()) << geometry->GetErrorText();
  geometry->GetOutput()->GetBounds(bounds);
  EXPECT_NEAR(bounds[5], 1, 1e-6);
  EXPECT_NEAR(bounds[4], 0, 1e-6);
  EXPECT_EQ(geometry->GetHeights()->GetNumberOfPoints(), 0);
  make("lamellar");
  ASSERT_TRUE(geometry->UpdateAndCheck()) << geometry->GetErrorText();
  EXPECT_EQ(geometry->GetOutput()->GetNumberOfPolys(), 4 * 8);
}

TEST_F(MicrosurfaceFilters, ViewShowsEveryShapeAndAFlatOneToo) {
  vtkNew<vtkBRDFMicrosurfaceView> view;
  EXPECT_FALSE(view->Render());
  view->SetInputConnection(source_->GetOutputPort());
  view->SetSize(240, 180);
  std::set<std::string> pictures;
  for (const char* expression :
       {"grooves", "flat", "spheres", "blazed", "gaussian(period=640, correlation=1, resolution=4)"}) {
    make(expression);
    for (const double elevation : {40.0, 90.0}) {
      view->SetElevation(elevation);
      vtkNew<vtkImageData> picture;
      ASSERT_TRUE(view->Capture(picture)) << view->GetErrorText();
      const auto* pixels = static_cast<const char*>(picture->GetScalarPointer());
      pictures.emplace(pixels, pixels + 240 * 180 * 3);
    }
  }
  EXPECT_EQ(pictures.size(), 10u);
}

TEST_F(MicrosurfaceFilters, MapShowsHeightsWhereTheyAre) {
  // One high node at a quarter of the tile along x and a half along y: the picture is yellow there, dark elsewhere.
  vtkNew<vtkImageData> image;
  image->SetDimensions(32, 32, 1);
  vtkNew<vtkFloatArray> values;
  for (int k = 0; k < 32 * 32; ++k)
    values->InsertNextTuple1(std::abs(k % 32 - 8) < 3 && std::abs(k / 32 - 16) < 3 ? 1e-4 : 0);
  image->GetPointData()->SetScalars(values);
  source_->SetInputData(image);
  vtkNew<vtkBRDFMicrosurfaceView> view;
  view->SetInputConnection(source_->GetOutputPort());
  view->SetSize(400, 300);
  view->SetAzimuth(0);
  view->SetElevation(90);
  vtkNew<vtkImageData> picture;
  ASSERT_TRUE(view->Capture(picture)) << view->GetErrorText();
  // The surface's pixels have a saturated colour; the bar at the right is left out.
  double count = 0, x = 0, y = 0, low[2] = {1e9, 1e9}, high[2] = {0, 0};
  for (int j = 0; j < 300; ++j)
    for (int i = 0; i < 300; ++i) {
      const auto* p = static_cast<const unsigned char*>(picture->GetScalarPointer(i, j, 0));
      const int spread = std::max({p[0], p[1], p[2]}) - std::min({p[0], p[1], p[2]});
      if (spread < 40) continue;
      low[0] = std::min<double>(low[0], i), high[0] = std::max<double>(high[0], i);
      low[1] = std::min<double>(low[1], j), high[1] = std::max<double>(high[1], j);
      if (p[0] > 1.5 * p[2] && p[1] > p[2]) count += 1, x += i, y += j;
    }
  ASSERT_GT(count, 0);
  EXPECT_NEAR((x / count - low[0]) / (high[0] - low[0]), 0.25, 0.02);
  EXPECT_NEAR((y / count - low[1]) / (high[1] - low[1]), 0.5, 0.02);
}
