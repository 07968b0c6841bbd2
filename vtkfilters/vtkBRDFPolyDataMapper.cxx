#include "vtkBRDFPolyDataMapper.h"

#include "vtkBRDFCompatibility.h"
#include VTK_BRDF_GL_LOADER_HEADER

#include "vtkBRDF.h"
#include "vtkBRDFDeferredShading.h"
#include "vtkBRDFEnvironment.h"
#include "vtkBRDFMaterialShader.h"
#include "vtkBRDFShadows.h"

#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTimerLog.h"

#include <brdf/base/Error.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace
{
using Light = vtkBRDFMaterialShader::Environment;

Light LightOf(vtkBRDFPolyDataMapper& mapper)
{
  return !mapper.GetEnvironment()                                     ? Light::None
         : mapper.GetMode() == vtkBRDFPolyDataMapper::MODE_CONVERGING ? Light::Unfiltered
                                                                      : Light::Filtered;
}
}

vtkStandardNewMacro(vtkBRDFPolyDataMapper);
vtkCxxSetObjectMacro(vtkBRDFPolyDataMapper, Environment, vtkBRDFEnvironment);

vtkBRDFPolyDataMapper::vtkBRDFPolyDataMapper()
  : Material(std::make_unique<vtkBRDFMaterialShader>())
  , Deferred(std::make_unique<vtkBRDFDeferredShading>())
{
  this->SetNumberOfInputPorts(2);
  this->ScalarVisibilityOff();
}

vtkBRDFPolyDataMapper::~vtkBRDFPolyDataMapper()
{
  this->SetEnvironment(nullptr);
}

int vtkBRDFPolyDataMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkBRDF");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

void vtkBRDFPolyDataMapper::SetBRDFData(vtkBRDF* brdf)
{
  this->SetInputDataObject(1, brdf);
}

// Takes the BRDF from the pipeline; throws where it cannot be drawn.
void vtkBRDFPolyDataMapper::UpdateMaterial()
{
  vtkBRDF* input = nullptr;
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    this->GetInputAlgorithm(1, 0)->Update();
    input = vtkBRDF::SafeDownCast(this->GetInputDataObject(1, 0));
  }
  this->Material->Update(input && !input->IsEmpty() ? input->GetBrdf() : nullptr,
                         { this->Illuminant, this->Observer, this->Adaptation },
                         this->ResamplingTolerance);
}

int vtkBRDFPolyDataMapper::AdaptedSamples(double allocated, double seconds, int samples, int minimum, int maximum)
{
  minimum = std::min(minimum, maximum);
  if (!(seconds > 0))
  {
    return allocated < 1 ? minimum : maximum;
  }
  const double wanted = allocated / seconds * samples;
  int found = maximum;
  while (found > wanted && found > minimum)
  {
    found = std::max(found / 2, minimum);
  }
  return found;
}

bool vtkBRDFPolyDataMapper::GetResampled() const
{
  return this->Material->Table().resampled;
}

double vtkBRDFPolyDataMapper::GetResamplingError() const
{
  return this->Material->Table().error;
}

std::string vtkBRDFPolyDataMapper::GetTableLayout() const
{
  return this->Material->Table().grid ? this->Material->Table().grid->layout().text() : std::string();
}

void vtkBRDFPolyDataMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  this->ErrorText.clear();
  try
  {
    auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    if (this->Window && this->Window != window)
    {
      // Freeing leaves the last window's context current where that window's PopContext does nothing.
      this->ReleaseGraphicsResources(this->Window);
      window->MakeCurrent();
    }
    this->Window = window;
    this->UpdateMaterial();
    this->SamplesDrawn = this->NumberOfSamples;
    if (this->AdaptSamples)
    {
      this->SamplesDrawn = AdaptedSamples(actor->GetAllocatedRenderTime(),
                                          this->SecondsDrawn,
                                          this->LastSamples,
                                          this->MinimumSamples,
                                          this->NumberOfSamples);
    }
    this->Material->Activate(window, LightOf(*this), this->SamplesDrawn);
    if (this->Environment)
    {
      this->Environment->UpdateTextures(window, this->Mode == MODE_CONVERGING);
      this->Environment->ActivateTextures();
    }
    if (this->Shadows)
    {
      this->Shadows->Activate();
    }
    double start = 0;
    if (this->AdaptSamples)
    {
      glFinish();
      start = vtkTimerLog::GetUniversalTime();
    }
    this->Draw(renderer, actor);
    if (this->AdaptSamples)
    {
      glFinish();
      this->SecondsDrawn = vtkTimerLog::GetUniversalTime() - start;
      this->LastSamples = this->SamplesDrawn;
    }
    this->Material->Deactivate();
    if (this->Environment)
    {
      this->Environment->DeactivateTextures();
    }
    if (this->Shadows)
    {
      this->Shadows->Deactivate();
    }
  }
  catch (const std::exception& error)
  {
    this->ErrorText = error.what();
    vtkErrorMacro(<< this->ErrorText);
  }
}

// In two steps where that is possible. A surface that is not opaque, and one looked at by a selector, are drawn as
// ever.
void vtkBRDFPolyDataMapper::Draw(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const bool defers = this->DeferShading && !actor->HasTranslucentPolygonalGeometry() && !renderer->GetSelector() &&
                      vtkBRDFDeferredShading::Possible();
  const bool tangents = !defers || this->Material->Text().NeedsTangents();
  const int shadows = this->Shadows ? this->Shadows->Kind(this->Environment != nullptr) : 0;
  if (defers != this->Defers || tangents != this->Tangents || shadows != this->ShadowKind)
  {
    this->ShadowKind = shadows;
    this->Defers = defers;
    this->Tangents = tangents;
    this->StepsTime.Modified();
  }
  if (!defers)
  {
    this->Superclass::RenderPiece(renderer, actor);
    return;
  }
  if (!this->Deferred->IsBuilt(window) ||
      this->LightingTime <
        std::max({ this->GetMTime(), this->StepsTime.GetMTime(), this->Material->StructureTime().GetMTime() }))
  {
    this->NumberOfShaderBuilds += this->Deferred->Build(window, this->LightingText());
    this->LightingTime.Modified();
  }
  this->Deferred->Draw(
    renderer,
    tangents,
    [&] { this->Superclass::RenderPiece(renderer, actor); },
    [&](vtkShaderProgram* program) { this->SetLightingUniforms(program, renderer); });
}

std::string vtkBRDFPolyDataMapper::LightingText()
{
  return (this->Shadows ? this->Shadows->Text(this->Environment != nullptr) : "") +
         this->Material->Text().Text(LightOf(*this));
}

void vtkBRDFPolyDataMapper::SetShadows(vtkBRDFShadows* shadows)
{
  if (shadows != this->Shadows)
  {
    this->Shadows = shadows;
    this->Modified();
  }
}

bool vtkBRDFPolyDataMapper::GetNeedToRebuildShaders(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  const bool needed = this->Superclass::GetNeedToRebuildShaders(cellBO, renderer, actor);
  return needed || cellBO.ShaderSourceTime < this->StepsTime ||
         (!this->Defers && cellBO.ShaderSourceTime < this->Material->StructureTime());
}

void vtkBRDFPolyDataMapper::UpdateShaders(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  const vtkShaderProgram* before = cellBO.Program;
  this->Superclass::UpdateShaders(cellBO, renderer, actor);
  this->NumberOfShaderBuilds += !this->Defers && cellBO.Program != before;
}

void vtkBRDFPolyDataMapper::ReplaceShaderValues(std::map<vtkShader::Type, vtkShader*> shaders,
                                                vtkRenderer* renderer,
                                                vtkActor* actor)
{
  // Without lights in the renderer VTK would leave normals and positions out of the shader.
  auto& complexity = this->PrimitiveInfo[this->LastBoundBO].LastLightComplexity;
  const auto found = complexity;
  complexity = static_cast<std::remove_reference_t<decltype(complexity)>>(1);
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
  complexity = found;
}

void vtkBRDFPolyDataMapper::ReplaceShaderLight(std::map<vtkShader::Type, vtkShader*> shaders,
                                               vtkRenderer* vtkNotUsed(renderer),
                                               vtkActor* vtkNotUsed(actor))
{
  std::string fragment = shaders[vtkShader::Fragment]->GetSource();
  std::string vertex = shaders[vtkShader::Vertex]->GetSource();
  // A geometry shader (wide lines, edges) would have to pass the tangent on.
  const bool tangents = this->Tangents && this->VBOs->GetNumberOfComponents("tangentMC") == 3 &&
                        shaders[vtkShader::Geometry]->GetSource().empty();
  const std::string tangent = tangents ? "brdfTangentVC" : "vec3(0.0)";
  vtkShaderProgram::Substitute(fragment,
                               "//VTK::System::Dec",
                               "//VTK::System::Dec\n"
                               "#extension GL_ARB_shader_bit_encoding : enable\n",
                               false);
  vtkShaderProgram::Substitute(fragment,
                               "//VTK::Light::Dec",
                               std::string(tangents ? "in vec3 brdfTangentVC;\n" : "") +
                                 (this->Defers ? std::string() : this->LightingText()),
                               false);
  vtkShaderProgram::Substitute(
    fragment,
    "//VTK::Light::Impl",
    this->Defers ? vtkBRDFDeferredShading::Outputs(this->Tangents ? tangent : "")
                 : "  vec3 brdfViewer = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);\n"
                   "  gl_FragData[0] = vec4(brdfReflected(vertexVC.xyz, brdfViewer, normalVCVSOutput, " +
                     tangent + "), opacity);\n",
    false);
  if (tangents)
  {
    vtkShaderProgram::Substitute(vertex,
                                 "//VTK::Light::Dec",
                                 "in vec3 tangentMC;\n"
                                 "uniform mat4 brdfModelToView;\n"
                                 "out vec3 brdfTangentVC;\n",
                                 false);
    vtkShaderProgram::Substitute(
      vertex, "//VTK::Light::Impl", "  brdfTangentVC = mat3(brdfModelToView) * tangentMC;\n", false);
  }
  shaders[vtkShader::Fragment]->SetSource(fragment);
  shaders[vtkShader::Vertex]->SetSource(vertex);
}

void vtkBRDFPolyDataMapper::SetMapperShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(cellBO, renderer, actor);
  vtkShaderProgram* program = cellBO.Program;
  if (!this->Defers)
  {
    this->SetLightingUniforms(program, renderer);
  }
  if (program->IsUniformUsed("brdfModelToView"))
  {
    vtkNew<vtkMatrix4x4> modelToView;
    vtkMatrix4x4::Multiply4x4(
      renderer->GetActiveCamera()->GetModelViewTransformMatrix(), actor->GetMatrix(), modelToView);
    modelToView->Transpose();
    program->SetUniformMatrix("brdfModelToView", modelToView);
  }
}

void vtkBRDFPolyDataMapper::SetLightingUniforms(vtkShaderProgram* program, vtkRenderer* renderer)
{
  this->Material->SetUniforms(program);
  program->SetUniformf("brdfGain", static_cast<float>(std::exp2(this->Exposure)));
  program->SetUniformi("brdfEncoded", this->EncodeForDisplay);
  vtkMatrix4x4* worldToView = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  if (this->Environment)
  {
    this->SetEnvironmentUniforms(program, worldToView);
  }
  if (this->Shadows)
  {
    this->Shadows->SetUniforms(program);
  }
  this->SetLights(program, renderer, worldToView);
}

void vtkBRDFPolyDataMapper::SetEnvironmentUniforms(vtkShaderProgram* program, vtkMatrix4x4* worldToView)
{
  // Rows of the rotation from the world to the map, then that of the view undone; columns first for OpenGL.
  const double angle = vtkMath::RadiansFromDegrees(this->Environment->GetRotation());
  const double rotation[3][3] = { { std::cos(angle), 0, -std::sin(angle) },
                                  { 0, 1, 0 },
                                  { std::sin(angle), 0, std::cos(angle) } };
  float matrix[9];
  for (int column = 0; column < 3; ++column)
  {
    for (int row = 0; row < 3; ++row)
    {
      double sum = 0;
      for (int k = 0; k < 3; ++k)
      {
        sum += rotation[row][k] * worldToView->GetElement(column, k);
      }
      matrix[3 * column + row] = static_cast<float>(sum);
    }
  }
  program->SetUniformMatrix3x3("brdfViewToEnvironment", matrix);
  program->SetUniformf("brdfFilter", static_cast<float>(std::exp2(2 * this->LevelBias)));
  program->SetUniformi("brdfSeed", this->Seed);
  if (this->Mode == MODE_CONVERGING)
  {
    program->SetUniformi("brdfFirst", this->FirstPoint);
    program->SetUniformi("brdfCount", this->NumberOfPoints);
    program->SetUniformi("brdfRandom", this->Sequence == SEQUENCE_RANDOM);
  }
  this->Environment->SetUniforms(program);
}

void vtkBRDFPolyDataMapper::SetLights(vtkShaderProgram* program, vtkRenderer* renderer, vtkMatrix4x4* worldToView)
{
  constexpr int maximum = 8; // length of the arrays in brdf_surface.glsl
  float position[maximum][4] = {}, power[maximum][3] = {};
  int count = 0, left = 0;
  vtkCollectionSimpleIterator iterator;
  renderer->GetLights()->InitTraversal(iterator);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(iterator))
  {
    if (!light->GetSwitch() || (this->Environment && !light->LightTypeIsSceneLight()))
    {
      continue;
    }
    if (count == maximum)
    {
      ++left;
      continue;
    }
    double place[4], focus[3];
    light->GetTransformedPosition(place);
    light->GetTransformedFocalPoint(focus);
    place[3] = light->GetPositional() ? 1 : 0;
    for (int axis = 0; axis < 3 && !light->GetPositional(); ++axis)
    {
      place[axis] -= focus[axis];
    }
    worldToView->MultiplyPoint(place, place);
    for (int axis = 0; axis < 3; ++axis)
    {
      position[count][axis] = static_cast<float>(place[axis]);
      power[count][axis] = static_cast<float>(light->GetDiffuseColor()[axis] * light->GetIntensity());
    }
    position[count++][3] = light->GetPositional() ? 1.0f : 0.0f;
  }
  if (left > 0)
  {
    vtkWarningMacro("more than " << maximum << " lights: " << left << " left out");
  }
  program->SetUniformi("brdfLightCount", count);
  if (count > 0)
  {
    program->SetUniform4fv("brdfLightPosition", count, position);
    program->SetUniform3fv("brdfLightPower", count, power);
  }
}

void vtkBRDFPolyDataMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Material->Release(vtkOpenGLRenderWindow::SafeDownCast(window));
  this->Deferred->Release();
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkBRDFPolyDataMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Environment: " << this->Environment << "\n"
     << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n"
     << indent << "AdaptSamples: " << this->AdaptSamples << "\n"
     << indent << "MinimumSamples: " << this->MinimumSamples << "\n"
     << indent << "LevelBias: " << this->LevelBias << "\n"
     << indent << "Mode: " << this->Mode << "\n"
     << indent << "Sequence: " << this->Sequence << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "Exposure: " << this->Exposure << "\n"
     << indent << "ResamplingTolerance: " << this->ResamplingTolerance << "\n"
     << indent << "Illuminant: " << this->Illuminant << "\n"
     << indent << "Observer: " << this->Observer << "\n"
     << indent << "Adaptation: " << this->Adaptation << "\n"
     << indent << "EncodeForDisplay: " << this->EncodeForDisplay << "\n"
     << indent << "DeferShading: " << this->DeferShading << "\n"
     << indent << "NumberOfShaderBuilds: " << this->NumberOfShaderBuilds << "\n"
     << indent << "ErrorText: " << this->ErrorText << "\n";
}
