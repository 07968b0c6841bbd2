#ifndef vtkBRDFArrays_h
#define vtkBRDFArrays_h
// Numbers of libbrdf as VTK's arrays. For .cxx files only.

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <brdf/base/Error.h>
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Channels.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace vtkBRDFArrays
{
/** Planar numbers, `channels` planes, as tuples of one component a channel. */
inline vtkSmartPointer<vtkDoubleArray> Interleaved(const std::string& name,
                                                   const std::vector<double>& planes,
                                                   std::size_t channels)
{
  const std::size_t count = planes.size() / std::max<std::size_t>(channels, 1);
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(static_cast<int>(channels));
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  double* to = array->GetPointer(0);
  for (std::size_t c = 0; c < channels; ++c)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      to[i * channels + c] = planes[c * count + i];
    }
  }
  return array;
}

inline vtkSmartPointer<vtkDoubleArray> Numbers(const std::string& name, const std::vector<double>& numbers)
{
  return Interleaved(name, numbers, 1);
}

/** Angles in degrees, round ones without the rounding of having been radians. */
inline std::vector<double> InDegrees(std::vector<double> angles)
{
  for (double& angle : angles)
  {
    angle = brdf::degrees(angle);
    const double round = std::round(angle * 1e6) / 1e6;
    angle = std::abs(angle - round) < 1e-11 ? round : angle;
  }
  return angles;
}

inline vtkSmartPointer<vtkUnsignedCharArray> Bytes(const std::string& name, const std::vector<std::uint8_t>& bytes)
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfTuples(static_cast<vtkIdType>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), array->GetPointer(0));
  return array;
}

inline void AddTexts(vtkFieldData* fields, const char* name, const std::vector<std::string>& texts)
{
  auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetName(name);
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  fields->AddArray(array);
}

/** The numbers of a field of one component. */
inline std::vector<double> FieldNumbers(vtkFieldData* fields, const char* name)
{
  vtkDataArray* array = fields->GetArray(name);
  std::vector<double> numbers(array ? static_cast<std::size_t>(array->GetNumberOfTuples()) : 0);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = array->GetTuple1(static_cast<vtkIdType>(i));
  }
  return numbers;
}

/** The directions to the light and to the viewer, three components each, as pairs; throws brdf::Error for arrays of
 * other components or unequal length. */
inline brdf::DirectionPairBuffer<double> DirectionPairs(vtkDataArray* wi, vtkDataArray* wo)
{
  const vtkIdType count = wi->GetNumberOfTuples();
  if (wi->GetNumberOfComponents() != 3 || wo->GetNumberOfComponents() != 3 || wo->GetNumberOfTuples() != count)
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "wrong arrays of directions",
                        "wi, wo",
                        std::to_string(wi->GetNumberOfComponents()) + " x " + std::to_string(count) + " and " +
                          std::to_string(wo->GetNumberOfComponents()) + " x " + std::to_string(wo->GetNumberOfTuples()),
                        "three components and equal length" });
  }
  brdf::DirectionPairBuffer<double> pairs(static_cast<std::size_t>(count));
  for (int axis = 0; axis < 3; ++axis)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      pairs.wi[axis][i] = wi->GetComponent(i, axis);
      pairs.wo[axis][i] = wo->GetComponent(i, axis);
    }
  }
  return pairs;
}

/** What so many components of values mean: by the array "wavelengths" (nm) of the field data, else 1 is monochrome and
 * 3 is RGB. Throws brdf::Error, naming `where`, for anything else. */
inline brdf::Channels ChannelsOf(vtkFieldData* fields, int components, const char* where)
{
  auto wavelengths = FieldNumbers(fields, "wavelengths");
  if (wavelengths.empty() && (components == 1 || components == 3))
  {
    return components == 1 ? brdf::Channels::monochrome() : brdf::Channels::rgb();
  }
  if (wavelengths.size() != static_cast<std::size_t>(components) ||
      std::adjacent_find(wavelengths.begin(), wavelengths.end(), std::greater_equal<>()) != wavelengths.end())
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "number of components",
                        where,
                        std::to_string(components) + ", with " + std::to_string(wavelengths.size()) + " wavelengths",
                        "1, 3, or as many ascending wavelengths (nm) in the field data" });
  }
  return brdf::Channels::spectral(std::move(wavelengths));
}
}

#endif
