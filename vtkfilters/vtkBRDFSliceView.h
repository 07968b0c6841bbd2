#ifndef vtkBRDFSliceView_h
#define vtkBRDFSliceView_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkBRDFView.h"
#include "vtkNew.h"          // For vtkNew
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <vector> // For std::vector

class vtkAlgorithmOutput;
class vtkBRDFSlice;
class vtkDataObject;
class vtkImageData;

/**
 * @class vtkBRDFSliceView
 * @brief Slices of BRDFs as pictures beside each other, with axes and a colour bar
 *
 * The first axis of vtkBRDFSlice to the right, the second upwards. One value is drawn in viridis over one colour bar
 * for all; with the channel "rgb" the values are drawn as colours: pi f_r times 2^Exposure, linear sRGB, clipped, with
 * the sRGB curve, so that a white Lambertian is white. Hatched one way: below the horizon; crosswise: no value. White
 * lines part what is measured from what is filled or extrapolated.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFSliceView : public vtkBRDFView
{
public:
  static vtkBRDFSliceView* New();
  vtkTypeMacro(vtkBRDFSliceView, vtkBRDFView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Adds a BRDF: a pipeline, or a vtkBRDF. `name` stands above its picture; empty: its description. */
  void AddInputConnection(vtkAlgorithmOutput* brdf, const std::string& name = std::string());
  /** The same without a pipeline. */
  void AddInputData(vtkDataObject* brdf, const std::string& name = std::string());
  ///@}
  void RemoveAllInputs();
  int GetNumberOfInputs() const { return static_cast<int>(this->Inputs.size()); }

  /** The settings of all slices: axes, angles, cells, warp, channel and colours. */
  vtkBRDFSlice* GetSettings();

  /** The filter behind picture `index`, as of the last Render(). */
  vtkBRDFSlice* GetSlice(int index);

  ///@{
  /** Of one value: "linear", "log" (default), or "cuberoot". */
  vtkSetMacro(Scale, std::string);
  vtkGetMacro(Scale, std::string);
  ///@}

  ///@{
  /** Decades that a logarithmic scale shows below the largest value at most; 0.1 to 600, default 6. */
  vtkSetClampMacro(Decades, double, 0.1, 600);
  vtkGetMacro(Decades, double);
  ///@}

  ///@{
  /** The values of the two ends of the colour bar; equal (default 0, 0): all but the largest hundredth of all values,
   * and on a logarithmic scale the smallest one. Beyond, the colours are those of the ends. */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  ///@{
  /** Of colours, in stops; default 0: a Lambertian of albedo 1 (f_r = 1/pi) is as bright as the display. */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double);
  ///@}

protected:
  vtkBRDFSliceView();
  ~vtkBRDFSliceView() override;
  void Build(int width, int height) override;

private:
  vtkBRDFSliceView(const vtkBRDFSliceView&) = delete;
  void operator=(const vtkBRDFSliceView&) = delete;

  struct Input
  {
    vtkSmartPointer<vtkBRDFSlice> Slice;
    std::string Name;
  };
  std::vector<Input> Inputs;
  vtkNew<vtkBRDFSlice> Settings;
  std::string Scale = "log";
  double Decades = 6;
  double Range[2] = { 0, 0 };
  double Exposure = 0;
};
#endif
