#ifndef vtkBRDFRender_h
#define vtkBRDFRender_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkNew.h"               // For vtkNew

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkAlgorithmOutput;
class vtkBRDFEnvironment;
class vtkCamera;
class vtkImageData;
class vtkMatrix4x4;
class vtkPolyData;
namespace brdf
{
class EnvironmentMap;
struct Scene;
}

/**
 * @class vtkBRDFRender
 * @brief Renders an object of a material under environment, directional and point light into a picture of radiance
 *
 * Input 0: the material, any BRDF (see vtkBRDFPolyDataMapper). Input 1, optional: the object,
 * vtkPolyData; without it a sphere of radius 1 about the origin whose tangents run around the vertical. Normals are
 * made where the object has none (splitting edges sharper than 40 degrees). More objects, each of its own material, are
 * added by AddObject; where there are any, input 0 may be missing. Output: vtkImageData, linear radiance times
 * 2^Exposure, three floats a pixel. vtkBRDFToneMap makes it a PNG's, vtkBRDFEXRWriter an EXR.
 *
 * The world is right-handed with +y up, as in vtkBRDFEnvironment. Unless a camera is set, it looks at the middle of the
 * objects, from +z turned by Azimuth about +y (counter-clockwise seen from above) and raised by Elevation, so far off
 * that the object's bounding sphere fills the picture up to a margin of 8 %.
 *
 * Draws headless (vtkBRDFHeadlessRenderWindow); the window, and with it the compiled shaders, are kept between updates.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFRender : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFRender* New();
  vtkTypeMacro(vtkBRDFRender, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The object. */
  void SetObjectConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  ///@{
  /** Objects besides the input's: a surface (null for the sphere of radius 1), its material and where it goes (null: as
   * it is). An error, and nothing is added, where the surface has no polygons or a number that is not finite. */
  void AddObject(vtkPolyData* surface, vtkBRDF* material, vtkMatrix4x4* placement = nullptr);
  void RemoveAllObjects();
  ///@}

#ifndef __VTK_WRAP__
  /** Replaces objects, lights, environment, background, camera and size by those of a scene. Throws brdf::Error where
   * there is something that cannot be drawn. */
  void SetScene(const brdf::Scene& scene);
#endif

  /** The picture. */
  vtkImageData* GetOutput();

  ///@{
  /** Pixels; default 512 x 512. */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  enum ModeType
  {
    MODE_INTERACTIVE = 0, // filtered importance sampling with NumberOfSamples (default)
    MODE_CONVERGING = 1   // unfiltered, until Tolerance or MaximumSamples
  };
  enum SequenceType
  {
    SEQUENCE_LOW_DISCREPANCY = 0, // scrambled Sobol points (default)
    SEQUENCE_RANDOM = 1           // independent points, for studies: the error falls slower
  };

  ///@{
  /** How light from the environment is summed: MODE_INTERACTIVE (default) or MODE_CONVERGING. In converging mode
   * nothing is filtered and the picture has no bias; what it has is noise, which is measured: the output gets a second
   * array of point data, "standard error", that of every number. Edges are part of it (see EdgeSamples). ProgressEvent
   * comes after each frame; with SetAbortExecute(1) the picture so far is kept. */
  vtkSetClampMacro(Mode, int, MODE_INTERACTIVE, MODE_CONVERGING);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /** Converging mode stops when the standard error of the luminance, root mean square over the picture, is below this
   * part of the picture's mean luminance (as brdf::ReferenceOptions::tolerance), which is looked at whenever the number
   * of samples has doubled; default 0.01; 0: draw all samples. */
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Samples a pixel at most in converging mode, each a direction of the environment and one of the material; a
   * multiple of 8 is drawn, at least 16; default 4096. */
  vtkSetClampMacro(MaximumSamples, int, 8, 1 << 24);
  vtkGetMacro(MaximumSamples, int);
  ///@}

  ///@{
  /** The points of converging mode: SEQUENCE_LOW_DISCREPANCY (default) or SEQUENCE_RANDOM. */
  vtkSetClampMacro(Sequence, int, SEQUENCE_LOW_DISCREPANCY, SEQUENCE_RANDOM);
  vtkGetMacro(Sequence, int);
  ///@}

  ///@{
  /** Another number gives a picture whose noise has nothing to do with this one's; default 0. */
  vtkSetClampMacro(Seed, int, 0, 1000);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /** Of the last picture in converging mode, or of the one in progress: samples drawn a pixel, the standard error that
   * Tolerance is compared with (infinite before the first round), and whether it was reached. */
  vtkGetMacro(SamplesDrawn, int);
  vtkGetMacro(RelativeError, double);
  vtkGetMacro(Converged, bool);
  ///@}

  /** The standard error of every number of the output, as a picture of its own; empty in interactive mode. */
  vtkImageData* GetStandardError()
  {
    return this->StandardError;
  }

  ///@{
  /** Samples of the environment a pixel in interactive mode; 1 to 16,384, default 64. */
  vtkSetClampMacro(NumberOfSamples, int, 1, 1 << 14);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /** Pictures a second to keep up in interactive mode with one of the EdgeSamples drawings, as while something moves,
   * by drawing fewer than NumberOfSamples: see vtkBRDFPolyDataMapper::SetAdaptSamples. 0 (default): all samples. */
  vtkSetClampMacro(DesiredUpdateRate, double, 0.0, 1e9);
  vtkGetMacro(DesiredUpdateRate, double);
  ///@}

  /** Samples a pixel of the last picture in interactive mode: the fewest of any object's. */
  int GetSamplesOfPicture();

  ///@{
  /** See vtkBRDFPolyDataMapper; default 0. */
  vtkSetMacro(LevelBias, double);
  vtkGetMacro(LevelBias, double);
  ///@}

  ///@{
  /** Of materials that have to be tabulated for drawing: see vtkBRDFPolyDataMapper; default 0.02. */
  vtkSetMacro(ResamplingTolerance, double);
  vtkGetMacro(ResamplingTolerance, double);
  ///@}

  ///@{
  /** What the last picture did to its materials. ResamplingError: the largest relative error of those that were
   * tabulated for it, -1 where none was. TableLayouts: axes and sizes of each table drawn, a line each. */
  double GetResamplingError();
  std::string GetTableLayouts();
  ///@}

  ///@{
  /** Places inside a pixel at which silhouettes and steps in depth are drawn and averaged, 1 for the centre only;
   * default 8. Inside surfaces the centre is drawn. In converging mode with more than 1 every frame is drawn at another
   * place in the pixels, so that the picture is the mean over each pixel. */
  vtkSetClampMacro(EdgeSamples, int, 1, 64);
  vtkGetMacro(EdgeSamples, int);
  ///@}

  ///@{
  /** Factor of 2^Exposure on everything; default 0. */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double);
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
  /** Light from far away; null (the default) for none. */
  virtual void SetEnvironment(vtkBRDFEnvironment* environment);
  vtkGetObjectMacro(Environment, vtkBRDFEnvironment);
  ///@}

  ///@{
  /** A light besides, from the polar angle theta about +y and the azimuth phi (0 is +z, 90 is +x), degrees; r, g, b is
   * the irradiance across the beam. At most eight lights. */
  void AddDirectionalLight(double theta, double phi, double r, double g, double b);
  /** A light besides, at x, y, z; r, g, b is the radiant intensity. At most eight lights. */
  void AddPointLight(double x, double y, double z, double r, double g, double b);
  void RemoveAllLights();
  ///@}

  enum ShadowType
  {
    SHADOWS_NONE = 0,   // nothing is in the way of light
    SHADOWS_LIGHTS = 1, // objects are in the way of lights besides the environment
    SHADOWS_ALL = 2     // and of the environment (default)
  };

  ///@{
  /** SHADOWS_NONE, SHADOWS_LIGHTS or SHADOWS_ALL (default): by rays cast on the CPU through every pixel: exact for
   * lights besides the environment. Of the environment each pixel sees ShadowCells x ShadowCells cells of the
   * directions, of which each is seen or not as one direction in it is: right on average, grainy, and blurred for
   * reflections sharper than a cell. A lone sphere casts none on itself and costs nothing. */
  vtkSetClampMacro(Shadows, int, SHADOWS_NONE, SHADOWS_ALL);
  vtkGetMacro(Shadows, int);
  ///@}

  ///@{
  /** Rays to the environment are ShadowCells^2 / 2 a pixel; 8, 16 (the default, cells of about 12 degrees), 32 or 64.
   */
  vtkSetClampMacro(ShadowCells, int, 8, 64);
  vtkGetMacro(ShadowCells, int);
  ///@}

  enum BackgroundType
  {
    BACKGROUND_ENVIRONMENT = 0, // the environment, where there is one (default)
    BACKGROUND_COLOR = 1,       // BackgroundColor
    BACKGROUND_IMAGE = 2,       // BackgroundImage
    BACKGROUND_TRANSPARENT = 3  // none: the output has a fourth component, the part of the pixel that objects cover, by
                                // which the others are multiplied
  };

  ///@{
  /** What is behind the objects: BACKGROUND_ENVIRONMENT (default), where there is one, BACKGROUND_COLOR,
   * BACKGROUND_IMAGE or BACKGROUND_TRANSPARENT. */
  vtkSetClampMacro(Background, int, BACKGROUND_ENVIRONMENT, BACKGROUND_TRANSPARENT);
  vtkGetMacro(Background, int);
  ///@}

  ///@{
  /** Width in degrees over which the environment is blurred behind the object; default 0. */
  vtkSetMacro(BackgroundBlur, double);
  vtkGetMacro(BackgroundBlur, double);
  ///@}

  ///@{
  /** Linear radiance of a plain background; default 0, 0, 0. Not scaled by Exposure. */
  vtkSetVector3Macro(BackgroundColor, double);
  vtkGetVector3Macro(BackgroundColor, double);
  ///@}

  ///@{
  /** A picture of 1, 3 or 4 floats a pixel, linear radiance, scaled to cover the film about its middle. Not scaled by
   * Exposure. */
  virtual void SetBackgroundImage(vtkImageData* image);
  vtkGetObjectMacro(BackgroundImage, vtkImageData);
  ///@}

  ///@{
  /** Where the camera stands: azimuth about +y, degrees; default 0. */
  vtkSetMacro(Azimuth, double);
  vtkGetMacro(Azimuth, double);
  ///@}

  ///@{
  /** Where the camera stands: elevation, -89 to 89 degrees; default 0. */
  vtkSetClampMacro(Elevation, double, -89.0, 89.0);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /** The camera's vertical angle of view, 1 to 120 degrees; default 30. */
  vtkSetClampMacro(ViewAngle, double, 1.0, 120.0);
  vtkGetMacro(ViewAngle, double);
  ///@}

  ///@{
  /** A camera of one's own; null (the default) for the one above. */
  virtual void SetCamera(vtkCamera* camera);
  vtkGetObjectMacro(Camera, vtkCamera);
  ///@}

  /** A copy of the camera that drew the last picture; null before. */
  vtkCamera* GetActiveCamera();

  /** What draws, in one line: EGL platform, device, OpenGL version; or why nothing can. */
  std::string GetDeviceDescription();

  /** How often a shader has been built since the object was made. */
  int GetNumberOfShaderBuilds();

  vtkMTimeType GetMTime() override;

protected:
  vtkBRDFRender();
  ~vtkBRDFRender() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFRender(const vtkBRDFRender&) = delete;
  void operator=(const vtkBRDFRender&) = delete;

  class Scene;
  Scene& GetScene();
  void PrepareObjects(vtkInformationVector** inputs);
  void PrepareCamera();
  void PrepareBackground();
  void PrepareShadows();
  void Compose(vtkImageData* output);
  void Converge();

  std::unique_ptr<Scene> Graphics;                      // made when first needed
  std::shared_ptr<const brdf::EnvironmentMap> SceneMap; // of SetScene's environment, and the factor on it
  double SceneMapScale = 1;
  vtkBRDFEnvironment* Environment = nullptr;
  vtkCamera* Camera = nullptr;
  vtkImageData* BackgroundImage = nullptr;
  int Size[2] = { 512, 512 };
  int NumberOfSamples = 64;
  double DesiredUpdateRate = 0;
  double LevelBias = 0;
  int Mode = MODE_INTERACTIVE;
  double Tolerance = 0.01;
  int MaximumSamples = 4096;
  int Sequence = SEQUENCE_LOW_DISCREPANCY;
  int Seed = 0;
  int SamplesDrawn = 0;
  double RelativeError = 0;
  bool Converged = false;
  vtkNew<vtkImageData> StandardError;
  double ResamplingTolerance = 0.02;
  int EdgeSamples = 8;
  double Exposure = 0;
  std::string Illuminant;
  std::string Observer = "2";
  std::string Adaptation = "bradford";
  int Shadows = SHADOWS_ALL;
  int ShadowCells = 16;
  int Background = BACKGROUND_ENVIRONMENT;
  double BackgroundBlur = 0;
  double BackgroundColor[3] = { 0, 0, 0 };
  double Azimuth = 0;
  double Elevation = 0;
  double ViewAngle = 30;
};
#endif
