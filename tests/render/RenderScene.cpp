#include "RenderScene.h"

#include <vtkPointData.h>

namespace rendertest {

vtkStandardNewMacro(Messages);

void Render::SetUp() {
  vtkOutputWindow::SetInstance(messages_);
  vtkNew<vtkBRDFHeadlessRenderWindow> window;
  if (!window->IsAvailable()) GTEST_SKIP() << window->GetErrorText();
  render_->SetSize(64, 64);
  render_->SetEdgeSamples(1);
}

void Render::draw(const std::string& expression) {
  material_ = brdf::parseMaterialExpression(expression);
  vtkNew<vtkBRDF> input;
  input->SetBrdf(material_);
  render_->SetInputData(input);
  render_->Update();
}

Rgb Render::pixel(int x, int y) {
  const auto* rgb = static_cast<const float*>(render_->GetOutput()->GetScalarPointer(x, y, 0));
  return {double(rgb[0]), double(rgb[1]), double(rgb[2])};
}

Direction Render::ray(int x, int y) {
  vtkCamera* camera = render_->GetActiveCamera();
  double forward[3], up[3];
  camera->GetDirectionOfProjection(forward);
  camera->GetViewUp(up);
  const Direction f{forward[0], forward[1], forward[2]};
  const Direction right = brdf::normalized(brdf::cross(f, {up[0], up[1], up[2]}));
  const Direction above = brdf::cross(right, f);
  const double extent = std::tan(brdf::radians(camera->GetViewAngle()) / 2);
  const int* size = render_->GetSize();
  const double s = extent * (2 * (x + 0.5) / size[0] - 1) * size[0] / size[1];
  const double t = extent * (2 * (y + 0.5) / size[1] - 1);
  Direction d;
  for (std::size_t axis = 0; axis < 3; ++axis) d[axis] = f[axis] + s * right[axis] + t * above[axis];
  return brdf::normalized(d);
}

std::optional<Render::Hit> Render::hit(int x, int y) {
  const double* position = render_->GetActiveCamera()->GetPosition();
  const Direction origin{position[0], position[1], position[2]}, d = ray(x, y);
  const double b = brdf::dot(origin, d), c = brdf::dot(origin, origin) - 1;
  if (b * b < c) return {};
  const double distance = -b - std::sqrt(b * b - c);
  Hit hit;
  for (std::size_t axis = 0; axis < 3; ++axis) hit.point[axis] = origin[axis] + distance * d[axis];
  hit.tangent = brdf::normalized(brdf::cross({0, 1, 0}, hit.point));  // around the vertical
  hit.bitangent = brdf::cross(hit.point, hit.tangent);
  hit.wo = hit.local({-d[0], -d[1], -d[2]});
  return hit;
}

Quadrature cosineQuadrature(int rings) {
  // Even in the square of the sine (the measure cos dw = d(sin^2) dphi / 2) and in azimuth, midpoints.
  Quadrature q;
  const int sectors = 4 * rings;
  for (int ring = 0; ring < rings; ++ring)
    for (int sector = 0; sector < sectors; ++sector) {
      const double squared = (ring + 0.5) / rings, sine = std::sqrt(squared),
                   phi = 2 * brdf::kPi * (sector + 0.5) / sectors;
      q.directions.push_back({sine * std::cos(phi), sine * std::sin(phi), std::sqrt(1 - squared)});
      q.weights.push_back(brdf::kPi / rings / sectors);
    }
  return q;
}

std::string shippedMap(const std::string& name) {
  return std::string(BRDF_SOURCE_DIR) + "/datasets/environments/" + name + ".exr";
}

}  // namespace rendertest
