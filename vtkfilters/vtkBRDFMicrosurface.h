#ifndef vtkBRDFMicrosurface_h
#define vtkBRDFMicrosurface_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkDataObject.h"

#include <memory> // For std::shared_ptr
#include <string> // For std::string

namespace brdf
{
struct MadeSurface;
}

/**
 * @class vtkBRDFMicrosurface
 * @brief A microsurface on a VTK pipeline: heights, a mesh or spheres, repeated without end
 *
 * Shares one immutable brdf::MadeSurface: copies, shallow or deep, cost nothing. Lengths are micrometres, outwards is
 * +z. What the surface turned out to be (rms height, slopes, period, spheres placed) are facts: numbers with names and
 * units, which are in the field data as well, as arrays "name (unit)".
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFMicrosurface : public vtkDataObject
{
public:
  static vtkBRDFMicrosurface* New();
  vtkTypeMacro(vtkBRDFMicrosurface, vtkDataObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The shared surface, null when empty. From C++ only. */
  void SetSurface(std::shared_ptr<const brdf::MadeSurface> value);
  const std::shared_ptr<const brdf::MadeSurface>& GetSurface() const { return this->Surface; }

  bool IsEmpty() const { return !this->Surface; }

  /** One line: the expression with all parameters, or where the surface comes from; empty without one. */
  std::string GetDescription() const;

  /** "height field", "mesh" or "spheres"; empty without a surface. */
  std::string GetShape() const;

  ///@{
  /** What the surface turned out to be, by number from 0; empty and not a number where there is none. */
  int GetNumberOfFacts() const;
  std::string GetFactName(int fact) const;
  double GetFactValue(int fact) const;
  std::string GetFactUnit(int fact) const;
  ///@}
  /** The same by name; not a number where there is none. */
  double GetFact(const std::string& name) const;

  int GetDataObjectType() override { return VTK_DATA_OBJECT; }
  void Initialize() override;
  void ShallowCopy(vtkDataObject* source) override;
  void DeepCopy(vtkDataObject* source) override;

  static vtkBRDFMicrosurface* GetData(vtkInformation* info);
  static vtkBRDFMicrosurface* GetData(vtkInformationVector* vector, int index = 0);

protected:
  vtkBRDFMicrosurface();
  ~vtkBRDFMicrosurface() override;

private:
  vtkBRDFMicrosurface(const vtkBRDFMicrosurface&) = delete;
  void operator=(const vtkBRDFMicrosurface&) = delete;

  std::shared_ptr<const brdf::MadeSurface> Surface;
};
#endif
