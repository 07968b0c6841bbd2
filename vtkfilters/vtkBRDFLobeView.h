#ifndef vtkBRDFLobeView_h
#define vtkBRDFLobeView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"

#include <array>  // For std::array
#include <memory> // For std::unique_ptr
#include <vector> // For std::vector

class vtkAlgorithmOutput;
class vtkBRDFDirectionWidget;
class vtkDataObject;
class vtkRenderWindowInteractor;

/**
 * @class vtkBRDFLobeView
 * @brief A picture of the lobes of any number of BRDFs for one incident direction
 *
 * Overlaid, the first opaque and the others translucent, each with a colour that the legend names, or side by side.
 * Under them a disc: its rings are polar angles seen from above (a length R at angle theta ends over the ring at
 * R sin theta), its spokes azimuths, its rim the scale's length, which all lobes share. The half circle stands in the
 * plane of incidence. Arrows show where light comes from and the mirror direction.
 *
 * Measured samples can stand as points in place of their lobe, coloured by what a model differs from them, and the
 * signed difference of two BRDFs can be drawn in place of their lobes. With EnableInteraction the arrow of the light
 * can be dragged.
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
  /** The same without a pipeline. */
  void AddInputData(vtkDataObject* brdf, const std::string& name = std::string());
  ///@}
  void RemoveAllInputs();
  int GetNumberOfInputs() const;

  ///@{
  /** Polar angle of the incident direction from the normal, [0, 90) degrees; default 45. */
  vtkSetMacro(ThetaI, double);
  vtkGetMacro(ThetaI, double);
  ///@}

  ///@{
  /** Azimuth of the incident direction, degrees; default 0. */
  vtkSetMacro(PhiI, double);
  vtkGetMacro(PhiI, double);
  ///@}

  ///@{
  /** Of every lobe's lengths: "none" (default), "cuberoot", "log" or "logfloor", as vtkBRDFLobe has them. */
  vtkSetMacro(Transform, std::string);
  vtkGetMacro(Transform, std::string);
  ///@}

  ///@{
  /** Where "logfloor" begins, 1/sr, above 0; default 1e-3. */
  vtkSetMacro(Floor, double);
  vtkGetMacro(Floor, double);
  ///@}

  ///@{
  /** "luminance" (default), "rgb", a channel number from 0, or a wavelength such as "550nm". */
  vtkSetMacro(Channel, std::string);
  vtkGetMacro(Channel, std::string);
  ///@}

  ///@{
  /** Subdivisions of every lobe's starting octahedron: 0 to 9, default 5. */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /** Edges are split while a lobe leaves them by more than this share of its largest length; 0: never; default 1e-3. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
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
  /** "overlay" (default), or "side": a disc for each BRDF. */
  vtkSetMacro(Layout, std::string);
  vtkGetMacro(Layout, std::string);
  ///@}

  ///@{
  /** What colours a lobe: "material" (one colour each), "value" (its length, with a colour bar), "true" (linear sRGB at
   * full brightness), or a channel (its values, with a colour bar, the length being another's), see
   * vtkBRDFLobe::SetChannel. Overlaid, the first lobe has it and the others one colour each. "auto" (default): "true"
   * where the channel is "rgb", else "material". */
  vtkSetMacro(Colour, std::string);
  vtkGetMacro(Colour, std::string);
  ///@}

  ///@{
  /** "value" (default), or "difference" or "displaced" (see vtkBRDFLobe::SetShape): of two inputs, the first less the
   * second, red where it is above and blue where it is below. */
  vtkSetMacro(Shape, std::string);
  vtkGetMacro(Shape, std::string);
  ///@}

  ///@{
  /** Show the samples of the first measured input whose incident direction is near the light's as points. With
   * another input (the first one that is not it: a model) the points have the colour of the model's length less
   * theirs and stand in place of the measured one's lobe. Default off. */
  vtkSetMacro(ShowSamples, bool);
  vtkGetMacro(ShowSamples, bool);
  vtkBooleanMacro(ShowSamples, bool);
  ///@}

  ///@{
  /** How far from the light's the incident direction of samples that are shown may lie, degrees; default 2. */
  vtkSetMacro(SampleAngle, double);
  vtkGetMacro(SampleAngle, double);
  ///@}

  ///@{
  /** Length that the disc's rim stands for, in the transform's unit; 0 (default): the largest of all lobes. */
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /** Where the viewer stands: azimuth from the incident direction, degrees; default -65. */
  vtkSetMacro(CameraAzimuth, double);
  vtkGetMacro(CameraAzimuth, double);
  ///@}

  ///@{
  /** Where the viewer stands: elevation, degrees; default 20. */
  vtkSetMacro(CameraElevation, double);
  vtkGetMacro(CameraElevation, double);
  ///@}

  /** Lets the user drag the light's arrow, and look around: gives the window of `interactor` to the view, and the
   * interactor a vtkBRDFDirectionWidget. Every step of a drag sets ThetaI and PhiI (rounded to a tenth of a degree, at
   * most 89) and draws anew, the lobes more coarsely (a subdivision less, eight times the tolerance) until the arrow is
   * let go. The interactor must outlive the view; null ends it. */
  void EnableInteraction(vtkRenderWindowInteractor* interactor);
  /** The widget of EnableInteraction, or null. */
  vtkBRDFDirectionWidget* GetDirectionWidget();

protected:
  vtkBRDFLobeView();
  ~vtkBRDFLobeView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFLobeView(const vtkBRDFLobeView&) = delete;
  void operator=(const vtkBRDFLobeView&) = delete;

  struct Input;
  struct Frame;
  struct Points;
  struct Plan;
  double UpdateLobes();
  Points FindSamples();
  Frame MakeFrame(int width, int height, std::size_t stages, bool bar) const;
  void ChooseScale(Plan& plan) const;
  void PlaceCamera(const Frame& frame);
  void AddLobe(const Plan& plan, std::size_t input, std::size_t stage);
  void AddPoints(const Plan& plan);
  void AddCaptions(const Plan& plan);
  void AddLegend(const Plan& plan);
  void AddName(const Plan& plan, std::size_t input, std::array<double, 2> at, double width, bool below);
  void AddKey(const Plan& plan, std::size_t input, std::array<double, 2> low);
  bool IsDifference() const { return this->Shape != "value"; }
  bool IsColored(std::size_t input) const;
  std::string NameOf(std::size_t input) const;
  std::string ColourOfLobes() const;
  static void Dragged(vtkObject* widget, unsigned long event, void* view, void* data);

  std::unique_ptr<std::vector<Input>> Inputs;
  vtkSmartPointer<vtkBRDFDirectionWidget> Widget;
  bool CameraPlaced = false;
  bool Moving = false; // the arrow is being dragged
  double ThetaI = 45;
  double PhiI = 0;
  std::string Transform = "none";
  double Floor = 1e-3;
  std::string Channel = "luminance";
  std::string Colour = "auto";
  std::string Layout = "overlay";
  std::string Shape = "value";
  bool ShowSamples = false;
  double SampleAngle = 2;
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
