#ifndef vtkBRDF_h
#define vtkBRDF_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkDataObject.h"

#include <memory> // For std::shared_ptr
#include <string> // For std::string

class vtkDataArray;
namespace brdf
{
class Brdf;
}

/**
 * @class vtkBRDF
 * @brief A BRDF on a VTK pipeline
 *
 * Shares one immutable brdf::Brdf: copies, shallow or deep, cost nothing. Conventions: local frame with the normal +z
 * and the tangent +x; `wi` points to the light, `wo` to the viewer, both of unit length; values are f_r in 1/sr without
 * the cosine, 0 where either direction is below the horizon.
 *
 * Field data (kept up to date by SetBrdf, passed on by our filters): the string array "vtkBRDF" holds the description;
 * for a sum of lobes each parameter is an array "<lobe number>.<model>.<parameter>" of one value, or one a channel.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDF : public vtkDataObject
{
public:
  static vtkBRDF* New();
  vtkTypeMacro(vtkBRDF, vtkDataObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The shared BRDF, null when empty. From C++ only. */
  void SetBrdf(std::shared_ptr<const brdf::Brdf> value);
  const std::shared_ptr<const brdf::Brdf>& GetBrdf() const { return this->Brdf; }

  /** One line: a material expression that reads back, or kind and source of measured data; empty without a BRDF. */
  std::string GetDescription() const;

  /** True when no BRDF is held. */
  bool IsEmpty() const { return !this->Brdf; }

  ///@{
  /** Channels: their number (0 when empty), "monochrome", "rgb" or "spectral", and the wavelength of one (nm, 0 when
   * there is none). */
  int GetNumberOfChannels() const;
  std::string GetChannelKind() const;
  double GetWavelength(int channel) const;
  ///@}

  /** Number of measured samples behind the BRDF; 0 for an analytic one. */
  vtkIdType GetNumberOfSamples() const;

  /** Value of one channel for one pair of directions (1/sr); an error and 0 for a channel that does not exist. */
  double Evaluate(const double wi[3], const double wo[3], int channel = 0);

  /**
   * Values for whole arrays of directions, on all threads: `wi` and `wo` have three components and as many tuples;
   * `values` is resized to as many tuples with one component a channel. `valid`, when given, gets one component: 1
   * where the BRDF has a value, 0 where it does not (an unmeasured cell, whose values are 0). False after an error.
   */
  bool Evaluate(vtkDataArray* wi, vtkDataArray* wo, vtkDataArray* values, vtkDataArray* valid = nullptr);

  int GetDataObjectType() override { return VTK_DATA_OBJECT; }
  void Initialize() override;
  void ShallowCopy(vtkDataObject* source) override;
  void DeepCopy(vtkDataObject* source) override;

  static vtkBRDF* GetData(vtkInformation* info);
  static vtkBRDF* GetData(vtkInformationVector* vector, int index = 0);

protected:
  vtkBRDF();
  ~vtkBRDF() override;

private:
  vtkBRDF(const vtkBRDF&) = delete;
  void operator=(const vtkBRDF&) = delete;

  std::shared_ptr<const brdf::Brdf> Brdf;
};
#endif
