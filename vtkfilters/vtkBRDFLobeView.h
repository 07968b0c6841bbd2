#ifndef vtkBRDFLobeView_h
#define vtkBRDFLobeView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"

#include <memory> // For std::unique_ptr
#include <vector> // For std::vector

class vtkAlgorithmOutput;
class vtkDataObject;

/**
 * @class vtkBRDFLobeView
 * @brief A picture of the lobes of any number of BRDFs for one incident direction
 *
 * The first lobe is opaque, the others translucent, each with a colour that the legend names. Under them a disc: its
 * rings are polar angles seen from above (a length R at angle theta ends over the ring at R sin theta), its spokes
 * azimuths, its rim the scale's length. The half circle stands in the plane of incidence. Arrows show where light comes
 * from and the mirror direction.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFLobeView : public vtkBRDFView
{
public:
  static vtkBRDFLobeView* New();
  vtkTypeMacro(vtkBRDFLobeView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Adds a BRDF: a pipeline, or a vtkBRDF. `name` for the legend; empty: its description. */
  void AddInputConnection(vtkAlgorithmOutput* brdf, const std::string& name = std::string());
  void AddInputData(vtkDataObject* brdf, const std::string& name = std::string());
  ///@}
  void RemoveAllInputs();
  int GetNumberOfInputs() const;

  ///@{
  /** Incident direction, transform, channel, resolution and tolerance of every lobe: see vtkBRDFLobe. With the channel
   * "rgb" the first lobe has the colour of its values at full brightness. */
  vtkSetMacro(ThetaI, double);
  vtkGetMacro(ThetaI, double);
  vtkSetMacro(PhiI, double);
  vtkGetMacro(PhiI, double);
  vtkSetMacro(Transform, std::string);
  vtkGetMacro(Transform, std::string);
  vtkSetMacro(Channel, std::string);
  vtkGetMacro(Channel, std::string);
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** How spectral data become colours: the illuminant (a CIE name such as "A" or "F11", or the path of a spectrum;
   * empty, the default: D65, and equal energy for luminance), the observer ("2", the default, or "10" degrees) and the
   * adaptation to D65 ("bradford", the default, or "none"). See brdf::ColourNames. */
  vtkSetMacro(Illuminant, std::string);
  vtkGetMacro(Illuminant, std::string);
  vtkSetMacro(Observer, std::string);
  vtkGetMacro(Observer, std::string);
  vtkSetMacro(Adaptation, std::string);
  vtkGetMacro(Adaptation, std::string);
  ///@}

  ///@{
  /** Length that the disc's rim stands for, in the transform's unit; 0 (default): the largest of all lobes. */
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /** Where the viewer stands: azimuth from the incident direction (default -65) and elevation (default 20), degrees. */
  vtkSetMacro(CameraAzimuth, double);
  vtkGetMacro(CameraAzimuth, double);
  vtkSetMacro(CameraElevation, double);
  vtkGetMacro(CameraElevation, double);
  ///@}

protected:
  vtkBRDFLobeView();
  ~vtkBRDFLobeView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFLobeView(const vtkBRDFLobeView&) = delete;
  void operator=(const vtkBRDFLobeView&) = delete;

  double UpdateLobes();
  void AddLobes(double length);
  void AddGround(int text);
  void AddDirections(int text);
  void AddCaptions(int width, int height, double length);
  void PlaceCamera(int width, int height);

  struct Input;
  std::unique_ptr<std::vector<Input>> Inputs;
  double ThetaI = 45;
  double PhiI = 0;
  std::string Transform = "none";
  std::string Channel = "luminance";
  std::string Illuminant;
  std::string Observer = "2";
  std::string Adaptation = "bradford";
  int Resolution = 5;
  double Tolerance = 1e-3;
  double Length = 0;
  double CameraAzimuth = -65;
  double CameraElevation = 20;
};
#endif
