#ifndef vtkBRDFSurfaceRepresentation_h
#define vtkBRDFSurfaceRepresentation_h
#include "vtkBRDFParaViewModule.h" // For export macro
#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkNew.h"         // For vtkNew
#include "vtkWeakPointer.h" // For vtkWeakPointer
#include <memory>           // For std::unique_ptr
#include <string>           // For std::string
#include <vector>           // For std::vector

class vtkBRDFEnvironment;
class vtkBRDFPolyDataMapper;
class vtkPolyData;
class vtkRenderer;
class vtkSkybox;

/**
 * @class vtkBRDFSurfaceRepresentation
 * @brief Draws a surface with its material under environment light: "BRDF under light" among ParaView's representations
 *
 * The material is that of vtkBRDFSurfaceMaterial; a surface without one is drawn as "Surface" draws it, with a warning.
 * Of a composite data set every block is drawn with the material that it has; one without is left out, with a warning.
 * The drawing is vtkBRDFPolyDataMapper's, encoded as sRGB. Transforms, visibility and picking are those of "Surface";
 * colours, textures, opacity and level of detail have no meaning here. Scene lights of the view
 * shine besides; ParaView's light kit, which goes with the camera, only where there is no environment.
 */
class VTKBRDFPARAVIEW_EXPORT vtkBRDFSurfaceRepresentation : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkBRDFSurfaceRepresentation* New();
  vtkTypeMacro(vtkBRDFSurfaceRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** OpenEXR or Radiance picture of the surroundings (equirectangular, linear), read by the process that draws. Empty
   * (default): radiance 1 from everywhere, under which a white Lambertian is white. */
  void SetEnvironmentFile(const char* path);
  std::string GetEnvironmentFile() { return this->EnvironmentFile; }

  ///@{
  /** Degrees by which the surroundings are turned about +y, the vertical, counter-clockwise seen from above; default 0.
   */
  void SetEnvironmentRotation(double degrees);
  double GetEnvironmentRotation();
  ///@}

  ///@{
  /** Whether the surroundings shine; default on. Off: only lights of the view do. */
  void SetUseEnvironment(bool use);
  bool GetUseEnvironment();
  ///@}

  ///@{
  /** Whether the surroundings are drawn behind the view's objects, where they shine; default off. */
  void SetShowEnvironment(bool show);
  bool GetShowEnvironment() { return this->ShowEnvironment; }
  ///@}

  ///@{
  /** Samples of the environment a pixel; default 64. More is slower in proportion, sharper and less noisy. */
  void SetNumberOfSamples(int samples);
  int GetNumberOfSamples();
  ///@}

  ///@{
  /** Powers of two by which the radiance is multiplied before it is shown; default 0. */
  void SetExposure(double stops);
  double GetExposure();
  ///@}

  ///@{
  /** Relative error from which on a material that has to be tabulated for drawing is not tabulated more finely; default
   * 0.02. */
  void SetResamplingTolerance(double tolerance);
  double GetResamplingTolerance();
  ///@}

  /** Why the last drawing shows no material, in one line; empty when all went well. */
  std::string GetErrorText();

  void SetVisibility(bool visible) override;
  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output) override;

protected:
  vtkBRDFSurfaceRepresentation();
  ~vtkBRDFSurfaceRepresentation() override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkBRDFSurfaceRepresentation(const vtkBRDFSurfaceRepresentation&) = delete;
  void operator=(const vtkBRDFSurfaceRepresentation&) = delete;

  struct Part; // a surface beside the first: its material, mapper and actor
  void TakePiece(vtkDataObject* piece);
  void TakeSurfaces(const std::vector<vtkPolyData*>& surfaces);
  void MatchParts();
  void UpdateSky();
  void DrawSky();

  vtkNew<vtkBRDFPolyDataMapper> BRDFMapper; // of the first surface, and of what is the same for all
  vtkNew<vtkBRDFEnvironment> Environment;
  std::vector<std::unique_ptr<Part>> Parts;
  vtkWeakPointer<vtkRenderer> Renderer; // of the view
  vtkNew<vtkSkybox> Sky;
  bool ShowEnvironment = false;
  std::string SkyKey; // what the sky's picture is of
  std::string EnvironmentFile;
  std::string ErrorText;
  vtkDataObject* Drawn = nullptr; // the piece that the mapper has, not owned: compared only
  vtkMTimeType DrawnTime = 0;
};
#endif
