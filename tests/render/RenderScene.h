#pragma once
// What the render tests share: a sphere drawn by vtkBRDFRender, and the same pixels worked out in double.
#include <brdf/geometry/Directions.h>
#include <brdf/io/EnvironmentMap.h>
#include <brdf/material/LobeSum.h>
#include <gtest/gtest.h>
#include <vtkBRDF.h>
#include <vtkBRDFEnvironment.h>
#include <vtkBRDFHeadlessRenderWindow.h>
#include <vtkBRDFRender.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace rendertest {

using brdf::Direction;
using Rgb = std::array<double, 3>;

/// Keeps VTK's errors and warnings (OpenGL's among them), which otherwise go to standard error.
class Messages : public vtkOutputWindow {
 public:
  static Messages* New();
  vtkTypeMacro(Messages, vtkOutputWindow);
  void DisplayText(const char* text) override { text_ += text; }
  std::string take() { return std::exchange(text_, {}); }

 private:
  std::string text_;
};

/// Skips where there is no EGL; fails where VTK or OpenGL complained.
class Render : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override { EXPECT_EQ(messages_->take(), ""); }

  /// Draws; `expression` is a material.
  void draw(const std::string& expression);
  std::string takeMessages() { return messages_->take(); }

  /// Linear RGB of a pixel; x from the left, y from the bottom.
  Rgb pixel(int x, int y);

  /// Unit direction of the ray through a pixel's centre.
  Direction ray(int x, int y);

  /// Where a ray meets the unit sphere: the frame in world coordinates and the direction to the viewer in it.
  struct Hit {
    Direction point, tangent, bitangent;
    Direction wo;
    Direction local(const Direction& world) const {
      return {brdf::dot(world, tangent), brdf::dot(world, bitangent), brdf::dot(world, point)};
    }
  };
  std::optional<Hit> hit(int x, int y);

  vtkNew<vtkBRDFRender> render_;
  vtkNew<vtkBRDFEnvironment> environment_;
  std::shared_ptr<const brdf::LobeSum> material_;

 private:
  vtkNew<Messages> messages_;
};

/// Directions and weights (solid angle times cosine) of a quadrature of the upper hemisphere in double, finer toward
/// grazing and around `wo`'s mirror direction: `rings` x 2 rings.
struct Quadrature {
  std::vector<Direction> directions;
  std::vector<double> weights;
};
Quadrature cosineQuadrature(int rings);

/// A shipped environment map.
std::string shippedMap(const std::string& name);

}  // namespace rendertest
