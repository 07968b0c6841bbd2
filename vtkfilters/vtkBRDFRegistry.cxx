#include "vtkBRDFRegistry.h"

#include "vtkObjectFactory.h"
#include "vtkStringArray.h"

#include <brdf/base/Plugins.h>
#include <brdf/exports/Exporter.h>
#include <brdf/fit/Fit.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/io/Presets.h>
#include <brdf/measured/Format.h>
#include <brdf/models/Registry.h>
#include <brdf/simulate/SurfaceKinds.h>

#include <set>

vtkStandardNewMacro(vtkBRDFRegistry);

namespace
{
// The names of a range of records, or of pointers to them.
template<class Range, class Name>
void Append(vtkStringArray* names, const Range& range, Name&& name)
{
  for (const auto& item : range)
  {
    names->InsertNextValue(std::string(name(item)));
  }
}

const auto OwnName = [](const auto& item) -> const auto&
{
  return item.name;
};
}

bool vtkBRDFRegistry::GetNames(const std::string& kind, vtkStringArray* names)
{
  names->Initialize();
  if (kind == "lobes")
  {
    Append(names, brdf::allModels(), [](const auto& model) { return model->name(); });
  }
  else if (kind == "formats")
  {
    Append(names, brdf::allFormats(), OwnName);
  }
  else if (kind == "extensions" || kind == "extensions written")
  {
    std::set<std::string> extensions = { ".vtkhdf", ".xml" };
    for (const brdf::Format& format : brdf::allFormats())
    {
      if (format.write || kind == "extensions")
      {
        extensions.insert(format.extension);
      }
    }
    extensions.erase("");
    Append(names, extensions, [](const auto& extension) { return extension; });
  }
  else if (kind == "metrics")
  {
    Append(names, brdf::metricNames(), [](const auto& name) { return name; });
  }
  else if (kind == "optimizers")
  {
    Append(names, brdf::optimizerNames(), [](const auto& name) { return name; });
  }
  else if (kind == "exporters")
  {
    Append(names, brdf::allExporters(), OwnName);
  }
  else if (kind == "presets")
  {
    Append(names, brdf::presets(), OwnName);
  }
  else if (kind == "materials")
  {
    Append(names, brdf::materialKinds(), OwnName);
  }
  else if (kind == "surfaces")
  {
    Append(names, brdf::surfaceKinds(), OwnName);
  }
  else if (kind == "plugins" || kind == "failures")
  {
    for (const brdf::Plugin& plugin : brdf::plugins())
    {
      if (plugin.error.empty() == (kind == "plugins"))
      {
        names->InsertNextValue(plugin.file.string() + (plugin.error.empty() ? "" : ": " + plugin.error));
      }
    }
    if (kind == "failures")
    {
      Append(names, brdf::userModelFailures(), [](const auto& line) { return line; });
    }
  }
  else
  {
    return false;
  }
  return true;
}

void vtkBRDFRegistry::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
