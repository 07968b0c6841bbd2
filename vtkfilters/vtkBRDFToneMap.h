#ifndef vtkBRDFToneMap_h
#define vtkBRDFToneMap_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkImageAlgorithm.h"

/**
 * @class vtkBRDFToneMap
 * @brief Turns a picture of linear radiance into 8-bit sRGB for a screen or a PNG
 *
 * Input: one slice of 1, 3 or 4 float components. Output: unsigned char, as many components. The values are multiplied
 * by 2^Exposure, go through the curve and are sRGB-encoded (IEC 61966-2-1); a fourth component is only scaled.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFToneMap : public vtkImageAlgorithm
{
public:
  static vtkBRDFToneMap* New();
  vtkTypeMacro(vtkBRDFToneMap, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum CurveType
  {
    CLAMP = 0,    // linear up to 1, then cut: what is below 1 stays true (default)
    REINHARD = 1, // x / (1 + x)
    ACES = 2      // Narkowicz's fit of the ACES film curve
  };

  ///@{
  /** How radiance becomes what is shown: CLAMP (default), REINHARD or ACES. */
  vtkSetClampMacro(Curve, int, CLAMP, ACES);
  vtkGetMacro(Curve, int);
  ///@}

  ///@{
  /** Powers of two; default 0. */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double);
  ///@}

protected:
  vtkBRDFToneMap() = default;
  ~vtkBRDFToneMap() override = default;
  int RequestInformation(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFToneMap(const vtkBRDFToneMap&) = delete;
  void operator=(const vtkBRDFToneMap&) = delete;

  int Curve = CLAMP;
  double Exposure = 0;
};
#endif
