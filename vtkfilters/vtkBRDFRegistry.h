#ifndef vtkBRDFRegistry_h
#define vtkBRDFRegistry_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For std::string

class vtkStringArray;

/**
 * @class vtkBRDFRegistry
 * @brief Names of what there is: lobes, formats, metrics, optimizers, and what plugins add to them
 *
 * Kinds: "lobes", "formats" (of measured data), "extensions" and "extensions written" (of files
 * that vtkBRDFReader and vtkBRDFWriter take, with the dot),
 * "metrics", "optimizers", "exporters", "presets", "materials" (kinds of materials written NAME:ARGUMENTS: other
 * programs, wave models, those of plugins), "surfaces" (kinds to simulate), "plugins" (files loaded) and "failures"
 * (plugins and lobes that were left out, and why).
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFRegistry : public vtkObject
{
public:
  static vtkBRDFRegistry* New();
  vtkTypeMacro(vtkBRDFRegistry, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Fills `names` with those of a kind, in the order of the registry. False for a kind that does not exist. */
  static bool GetNames(const std::string& kind, vtkStringArray* names);

protected:
  vtkBRDFRegistry() = default;
  ~vtkBRDFRegistry() override = default;

private:
  vtkBRDFRegistry(const vtkBRDFRegistry&) = delete;
  void operator=(const vtkBRDFRegistry&) = delete;
};
#endif
