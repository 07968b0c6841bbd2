#ifndef vtkBRDFPolyDataMapper_h
#define vtkBRDFPolyDataMapper_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkWeakPointer.h" // For vtkWeakPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkAlgorithmOutput;
class vtkBRDF;
class vtkBRDFDeferredShading;
class vtkBRDFEnvironment;
class vtkBRDFMaterialShader;
class vtkBRDFShadows;
class vtkMatrix4x4;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * @class vtkBRDFPolyDataMapper
 * @brief Draws poly data with a BRDF under environment, directional and point light
 *
 * Input 0 is the geometry, input 1 the material: any BRDF. A sum of lobes (brdf::LobeSum) is drawn by the lobes' own
 * formulas, a spectral one in the colours of its scale factors. Tables and grids are looked up as brdf::TableBrdf and
 * brdf::GridBrdf do it. Everything else (scattered data, trees, patches, spectra whose shape depends on the wavelength)
 * is tabulated first, and GetResamplingError() says how well. A table holds at most GL_MAX_TEXTURE_BUFFER_SIZE cells
 * (65,536 on the least device that OpenGL 3.2 allows, 2^27 and more on those in use) of 16 bytes; a larger one is
 * resampled too.
 *
 * What is drawn is outgoing radiance, linear, times 2^Exposure; with EncodeForDisplay it is sRGB-encoded, for the 8-bit
 * windows of interactive programs. The color, opacity aside, and the interpolation of the actor's property are not
 * used.
 *
 * Environment: filtered importance sampling (Colbert and Krivanek, GPU Gems 3, chapter 20). Each lobe l gets a share
 * N_l of NumberOfSamples by its estimated contribution and is summed on its own, L = sum_l 1/N_l sum_k f_l(wi_k)
 * cos(theta_k) / p_l(wi_k) * L_env(wi_k, solid angle 1 / (N_l p_l(wi_k))), with p_l the density of the lobe's own
 * sampler, which also chooses the level. It converges to the reflected radiance as N grows; at finite N the filter
 * blurs the light by about a sample's solid angle. A constant lobe takes the cosine-convolved map instead; lobes whose
 * record names no sampler, and tables, draw by importance tables made from their values (brdf::TabulatedSampler), whose
 * density likewise chooses the level. Points are a lattice, shifted per pixel.
 *
 * In converging mode nothing is filtered: every drawing adds a few points of a scrambled Sobol sequence, each of which
 * draws one direction from the map's own density and one from the lobes together, combined by the balance heuristic
 * (Veach 1997, equation 9.8). One drawing is noise; vtkBRDFRender averages them until a standard error is reached.
 *
 * Lights of the renderer: a vtkLight's color times intensity is irradiance across the beam for a directional light, and
 * radiant intensity of a positional one (falling off with the square of distance; cone and attenuation are not used).
 * At most eight. Lights that go with the camera shine only where there is no environment: headlights, because renderers
 * make one by themselves, and those of light kits.
 *
 * The tangent is the active point tangents of the geometry (vtkPointData::SetTangents) where there are any, else an
 * arbitrary one that varies smoothly with the normal: give tangents for anisotropic materials.
 *
 * Changing a parameter or scale of the material changes uniforms only; changing the lobes compiles once.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFPolyDataMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkBRDFPolyDataMapper* New();
  vtkTypeMacro(vtkBRDFPolyDataMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The material: the output of an algorithm. */
  void SetBRDFConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  ///@}

  ///@{
  /** The material: a free-standing object. */
  void SetBRDFData(vtkBRDF* brdf);
  ///@}

  ///@{
  /** The light under which spectral data are seen: a CIE name such as "A" or "F11", or the path of a spectrum. Empty
   * (default): D65, and equal energy for luminance. */
  vtkSetMacro(Illuminant, std::string);
  vtkGetMacro(Illuminant, std::string);
  ///@}

  ///@{
  /** Whose eye sees spectral data: "2" (default) or "10", the degrees of CIE 1931 and CIE 1964. */
  vtkSetMacro(Observer, std::string);
  vtkGetMacro(Observer, std::string);
  ///@}

  ///@{
  /** Whether a white stays white under another light than D65: "bradford" (default) or "none". */
  vtkSetMacro(Adaptation, std::string);
  vtkGetMacro(Adaptation, std::string);
  ///@}

  ///@{
  /** Relative error from which on a material that has to be tabulated is not tabulated more finely: see
   * brdf::DrawnTable; more than 0, default 0.02. */
  vtkSetMacro(ResamplingTolerance, double);
  vtkGetMacro(ResamplingTolerance, double);
  ///@}

  ///@{
  /** What the last drawing did to the material. Resampled: whether it was tabulated for it. ResamplingError: the
   * relative error of that, 0 where there is none. TableLayout: axes and sizes of the table drawn, empty for lobes. */
  bool GetResampled() const;
  double GetResamplingError() const;
  std::string GetTableLayout() const;
  ///@}

  ///@{
  /** Light from far away; null (the default) for none. */
  virtual void SetEnvironment(vtkBRDFEnvironment* environment);
  vtkGetObjectMacro(Environment, vtkBRDFEnvironment);
  ///@}

  ///@{
  /** Samples of the environment a pixel, shared among the lobes; 1 to 16,384, default 64. More is slower in
   * proportion, sharper and less noisy. */
  vtkSetClampMacro(NumberOfSamples, int, 1, 1 << 14);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /** Whether as many samples are drawn as the time allocated to the actor allows (vtkProp::GetAllocatedRenderTime,
   * which renderers set from vtkRenderWindow::SetDesiredUpdateRate: interactors ask for a high rate while something
   * moves and a low one at rest), between MinimumSamples and NumberOfSamples; default off. The time of a sample is
   * that of the last drawing, for which the device is waited for. */
  vtkSetMacro(AdaptSamples, bool);
  vtkGetMacro(AdaptSamples, bool);
  vtkBooleanMacro(AdaptSamples, bool);
  ///@}

  ///@{
  /** Fewest samples that AdaptSamples chooses; default 4. */
  vtkSetClampMacro(MinimumSamples, int, 1, 1 << 20);
  vtkGetMacro(MinimumSamples, int);
  ///@}

  /** Samples a pixel of the last drawing in interactive mode. */
  int GetSamplesDrawn() const { return this->SamplesDrawn; }

  /** What AdaptSamples chooses when `samples` have taken `seconds` and `allocated` seconds may pass: the maximum,
   * halved until it fits in proportion, but not below the minimum (few numbers, since each has draws of its own made in
   * advance); the minimum where nothing has been drawn (seconds 0) and less than a second is allowed. */
  static int AdaptedSamples(double allocated, double seconds, int samples, int minimum, int maximum);

  ///@{
  /** Levels of the map added to each sample's: 0 (the default) takes the mean over the sample's solid angle, to the
   * nearest level; 1 over four times it. More hides noise and leaks light into dark places: at 64 samples the rms error
   * of conductors of roughness 0.02 to 0.3 under the shipped maps is least between -1 and 0.5, up to four times that
   * at 1. */
  vtkSetMacro(LevelBias, double);
  vtkGetMacro(LevelBias, double);
  ///@}

  enum ModeType
  {
    MODE_INTERACTIVE = 0, // filtered importance sampling (default)
    MODE_CONVERGING = 1   // unfiltered; a drawing is one frame of many
  };
  enum SequenceType
  {
    SEQUENCE_LOW_DISCREPANCY = 0, // scrambled Sobol points (default)
    SEQUENCE_RANDOM = 1           // independent points, for studies: the error falls slower
  };

  ///@{
  /** How light from the environment is summed: MODE_INTERACTIVE (default) or MODE_CONVERGING. */
  vtkSetClampMacro(Mode, int, MODE_INTERACTIVE, MODE_CONVERGING);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /** The points of converging mode: SEQUENCE_LOW_DISCREPANCY (default) or SEQUENCE_RANDOM. */
  vtkSetClampMacro(Sequence, int, SEQUENCE_LOW_DISCREPANCY, SEQUENCE_RANDOM);
  vtkGetMacro(Sequence, int);
  ///@}

  /** What the next drawing in converging mode shows: the mean of `count` points, from number `first` on, of the
   * sequence that `Seed` scrambles; default 0, 16. The mapper does not count as modified. */
  void SetFrame(int first, int count)
  {
    this->FirstPoint = first;
    this->NumberOfPoints = count;
  }

  ///@{
  /** Chooses the pattern of the samples' noise; default 0. The mapper does not count as modified: its geometry and
   * shader stay. */
  void SetSeed(int seed) { this->Seed = seed; }
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /** Factor of 2^Exposure on the radiance; default 0. */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /** Whether colours are cut to 1 and sRGB-encoded; default off (linear). */
  vtkSetMacro(EncodeForDisplay, bool);
  vtkGetMacro(EncodeForDisplay, bool);
  vtkBooleanMacro(EncodeForDisplay, bool);
  ///@}

  ///@{
  /** Whether an opaque surface is drawn in two steps, where the framebuffer has one sample a pixel: normals and places
   * of what is seen, then light on them; on by default. The picture is the same. Small triangles then cost no more than
   * large ones: a sphere of 65,000 takes a third of the time. */
  vtkSetMacro(DeferShading, bool);
  vtkGetMacro(DeferShading, bool);
  vtkBooleanMacro(DeferShading, bool);
  ///@}

#ifndef __VTK_WRAP__
  /** Shadows, cast for the frame about to be drawn; null (the default) for none. Not owned. */
  void SetShadows(vtkBRDFShadows* shadows);
#endif

  /** How often a shader of the material has been built since the mapper was made. */
  vtkGetMacro(NumberOfShaderBuilds, int);

  /** Why nothing was drawn the last time, in one line; empty when all went well. */
  std::string GetErrorText() const
  {
    return this->ErrorText;
  }

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkBRDFPolyDataMapper();
  ~vtkBRDFPolyDataMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  bool GetNeedToRebuildShaders(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void UpdateShaders(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderValues(std::map<vtkShader::Type, vtkShader*> shaders,
                           vtkRenderer* renderer,
                           vtkActor* actor) override;
  void ReplaceShaderLight(std::map<vtkShader::Type, vtkShader*> shaders,
                          vtkRenderer* renderer,
                          vtkActor* actor) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkBRDFPolyDataMapper(const vtkBRDFPolyDataMapper&) = delete;
  void operator=(const vtkBRDFPolyDataMapper&) = delete;

  void UpdateMaterial();
  void Draw(vtkRenderer* renderer, vtkActor* actor);
  std::string LightingText();
  void SetLightingUniforms(vtkShaderProgram* program, vtkRenderer* renderer);
  void SetLights(vtkShaderProgram* program, vtkRenderer* renderer, vtkMatrix4x4* worldToView);
  void SetEnvironmentUniforms(vtkShaderProgram* program, vtkMatrix4x4* worldToView);

  std::unique_ptr<vtkBRDFMaterialShader> Material;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the last drawing
  std::unique_ptr<vtkBRDFDeferredShading> Deferred;
  bool Defers = false;       // the drawing at hand is in two steps
  bool Tangents = false;     // it needs them
  int ShadowKind = 0;        // of its shadows, 0 for none
  vtkTimeStamp StepsTime;    // when one of these last changed
  vtkTimeStamp LightingTime; // of the text that Deferred was last given
  vtkBRDFEnvironment* Environment = nullptr;
  vtkBRDFShadows* Shadows = nullptr;
  std::string ErrorText;
  int NumberOfSamples = 64;
  bool AdaptSamples = false;
  int MinimumSamples = 4;
  int SamplesDrawn = 0;
  int LastSamples = 0;     // of the last drawing with AdaptSamples
  double SecondsDrawn = 0; // of the last drawing with AdaptSamples
  double ResamplingTolerance = 0.02;
  double LevelBias = 0;
  int Mode = MODE_INTERACTIVE;
  int Sequence = SEQUENCE_LOW_DISCREPANCY;
  int FirstPoint = 0;
  int NumberOfPoints = 16;
  int Seed = 0;
  double Exposure = 0;
  std::string Illuminant;
  std::string Observer = "2";
  std::string Adaptation = "bradford";
  bool EncodeForDisplay = false;
  bool DeferShading = true;
  int NumberOfShaderBuilds = 0;
};
#endif
