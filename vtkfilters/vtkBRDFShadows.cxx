#include "vtkBRDFShadows.h"

#include "vtkBRDFCompatibility.h"
#include VTK_BRDF_GL_LOADER_HEADER

#include "vtkBRDFShaderText.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <brdf/base/Error.h>

namespace
{
// Rays through places of the picture, from the matrices that draw it.
class Rays
{
public:
  Rays(vtkCamera* camera, const int size[2])
    : Width(size[0])
    , Height(size[1])
    , Parallel(camera->GetParallelProjection() != 0)
  {
    camera->GetPosition(this->Position.data());
    this->FromClip->DeepCopy(camera->GetCompositeProjectionTransformMatrix(this->Width / this->Height, -1, 1));
    this->FromClip->Invert();
  }
  brdf::Ray operator()(double x, double y) const
  {
    const brdf::Position near = this->Parallel ? this->Place(x, y, -1) : this->Position, far = this->Place(x, y, 1);
    return { near, brdf::normalized({ far[0] - near[0], far[1] - near[1], far[2] - near[2] }) };
  }

private:
  brdf::Position Place(double x, double y, double depth) const
  {
    double p[4] = { 2 * x / this->Width - 1, 2 * y / this->Height - 1, depth, 1 };
    this->FromClip->MultiplyPoint(p, p);
    return { p[0] / p[3], p[1] / p[3], p[2] / p[3] };
  }

  double Width, Height;
  bool Parallel;
  brdf::Position Position;
  vtkNew<vtkMatrix4x4> FromClip;
};
}

void vtkBRDFShadows::Cast(vtkRenderer* renderer, const int size[2], int seed, const std::vector<float>* wanted)
{
  brdf::ShadowOptions options;
  options.width = static_cast<std::size_t>(size[0]);
  options.height = static_cast<std::size_t>(size[1]);
  options.seed = static_cast<std::uint64_t>(seed);
  options.wanted = wanted;
  const Rays rays(renderer->GetActiveCamera(), size);
  options.through = [&rays](double x, double y) { return rays(x, y); };
  this->Caster->cast(options, this->Mask);

  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const std::size_t rows = this->Mask.layers * this->Mask.height;
  const auto largest = static_cast<std::size_t>(vtkTextureObject::GetMaximumTextureSize(window));
  this->Texture->SetContext(window);
  this->Texture->SetInternalFormat(GL_RGBA32UI);
  this->Texture->SetFormat(GL_RGBA_INTEGER);
  this->Texture->SetDataType(GL_UNSIGNED_INT);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  if (rows > largest || !this->Texture->Create2DFromRaw(static_cast<unsigned int>(this->Mask.width),
                                                        static_cast<unsigned int>(rows),
                                                        4,
                                                        VTK_UNSIGNED_INT,
                                                        this->Mask.words.data()))
  {
    throw brdf::Error(brdf::Error::Kind::Device,
                      { "the picture is too high for the shadows of its environment",
                        {},
                        std::to_string(size[1]) + " pixels",
                        "at most " + std::to_string(largest / this->Mask.layers) + ", or no shadows" });
  }
}

void vtkBRDFShadows::SetUniforms(vtkShaderProgram* program)
{
  program->SetUniformi("brdfShadowMask", this->Texture->GetTextureUnit());
  program->SetUniformi("brdfShadowRows", static_cast<int>(this->Mask.height));
  program->SetUniformi("brdfShadowCells", static_cast<int>(this->Mask.cells));
}

std::string vtkBRDFShadows::Text(bool environment) const
{
  return "#define BRDF_SHADOWS " + std::to_string(this->Kind(environment)) + "\n" +
         std::string(vtkBRDFShaderText::File("brdf_shadows.glsl"));
}
