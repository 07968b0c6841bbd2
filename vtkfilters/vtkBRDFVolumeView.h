#ifndef vtkBRDFVolumeView_h
#define vtkBRDFVolumeView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkAlgorithmOutput;
class vtkDataObject;
class vtkImageData;

/**
 * @class vtkBRDFVolumeView
 * @brief A BRDF on half/difference coordinates as a volume
 *
 * sqrt(theta_h) to the right (MERL's spacing, fine near the mirror direction), theta_d upwards, phi_d into the depth: a
 * vtkBRDFTabulate, drawn as a cloud whose colour (viridis) and opacity follow the value on a logarithmic scale. What is
 * below the horizon, or has no value, is empty. A mirror-like lobe is a wall at theta_h = 0, a Fresnel rise the corner
 * at theta_d = 90 degrees, anisotropy or asymmetry a change along phi_d.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFVolumeView : public vtkBRDFView
{
public:
  static vtkBRDFVolumeView* New();
  vtkTypeMacro(vtkBRDFVolumeView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The BRDF, of a pipeline. */
  void SetInputConnection(vtkAlgorithmOutput* brdf);
  ///@}

  ///@{
  /** The same as a vtkBRDF. */
  void SetInputData(vtkDataObject* brdf);
  ///@}

  ///@{
  /** Of the BRDF, in the title. Empty (default): its description. */
  vtkSetMacro(Name, std::string);
  vtkGetMacro(Name, std::string);
  ///@}

  ///@{
  /** One value: "luminance" (default), a channel number from 0, or a wavelength such as "550nm". */
  vtkSetMacro(Channel, std::string);
  vtkGetMacro(Channel, std::string);
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
  /** Cells along theta_h, theta_d and phi_d, 2 to 512 each; default 90, 90, 90. */
  vtkSetVector3Macro(Cells, int);
  vtkGetVector3Macro(Cells, int);
  ///@}

  ///@{
  /** Decades below the largest value, at which the opacity is 0; 0.1 to 600, default 4. */
  vtkSetClampMacro(Decades, double, 0.1, 600);
  vtkGetMacro(Decades, double);
  ///@}

  ///@{
  /** How opaque the largest value is over a tenth of the cube's edge, 0 to 1; default 0.9. It falls with the third
   * power of the position on the scale. */
  vtkSetClampMacro(Opacity, double, 0, 1);
  vtkGetMacro(Opacity, double);
  ///@}

  ///@{
  /** Azimuth of the camera about the vertical axis, degrees; default -32. */
  vtkSetMacro(Azimuth, double);
  vtkGetMacro(Azimuth, double);
  ///@}

  ///@{
  /** Elevation of the camera, degrees; default 22. */
  vtkSetClampMacro(Elevation, double, -89, 89);
  vtkGetMacro(Elevation, double);
  ///@}

  /** Makes the table alone; false, with GetErrorText, when it cannot be made. Render() does so as well. */
  bool Tabulate();

  /** The channel of the last table in words. */
  std::string GetChannelLabel() const { return this->Label; }

  /** The values of the last picture: a vtkImageData of one component, "value" and "valid"; see vtkBRDFTabulate. */
  vtkImageData* GetTable();

protected:
  vtkBRDFVolumeView();
  ~vtkBRDFVolumeView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFVolumeView(const vtkBRDFVolumeView&) = delete;
  void operator=(const vtkBRDFVolumeView&) = delete;

  void TabulateOrThrow();
  void AddAxes(int text);

  vtkSmartPointer<vtkAlgorithmOutput> Connection;
  vtkSmartPointer<vtkDataObject> Data;
  vtkSmartPointer<vtkImageData> Table;
  std::string Name;
  std::string Channel = "luminance";
  std::string Illuminant;
  std::string Observer = "2";
  std::string Adaptation = "bradford";
  int Cells[3] = { 90, 90, 90 };
  double Decades = 4;
  double Opacity = 0.9;
  double Azimuth = -32;
  double Elevation = 22;
  std::string Label;
};
#endif
