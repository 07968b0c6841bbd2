#ifndef vtkBRDFErrorMapText_h
#define vtkBRDFErrorMapText_h
// Lines of text that the pictures of an error map share. For .cxx files only.

#include "vtkBRDF.h"
#include "vtkBRDFDrawing.h"
#include "vtkBRDFErrorMap.h"

namespace vtkBRDFErrorMapText
{
/** Channel, where it was compared, and the mean. */
inline std::string Note(vtkBRDFErrorMap* map)
{
  return map->GetChannel() + ", " + map->GetSampling() + "; " + std::to_string(map->GetNumberOfPairs()) +
         " pairs; over all " + vtkBRDFDrawing::NumberText(map->GetOverallMean());
}

/** The names of A and B at the foot of the picture; empty: their descriptions. */
inline void AddNames(vtkRenderer* renderer,
                     vtkBRDFErrorMap* map,
                     const std::string& a,
                     const std::string& b,
                     int text,
                     std::size_t letters)
{
  const auto name = [&](int port, const std::string& given)
  {
    auto* brdf = vtkBRDF::SafeDownCast(map->GetInputDataObject(port, 0));
    return vtkBRDFDrawing::Shortened(given.empty() ? vtkBRDFDrawing::Rounded(brdf->GetDescription()) : given,
                                     letters - 3);
  };
  vtkBRDFDrawing::AddText(renderer, "A: " + name(0, a), { 1.0 * text, 2.2 * text }, { .Size = text });
  vtkBRDFDrawing::AddText(renderer, "B: " + name(1, b), { 1.0 * text, 0.8 * text }, { .Size = text });
}
}

#endif
