#ifndef vtkBRDFImageConversion_h
#define vtkBRDFImageConversion_h
// Pictures of the core (rows from the top) and of VTK (rows from the bottom). For .cxx files only.
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <brdf/base/Error.h>
#include <brdf/io/Image.h>

#include <algorithm>

namespace vtkBRDFImageConversion
{
// Float copy of a 2-D image of 1, 3 or 4 components; throws brdf::Error for anything else.
inline brdf::Image FromVtk(vtkImageData* picture)
{
  const int* size = picture->GetDimensions();
  const int channels = picture->GetNumberOfScalarComponents();
  if (size[0] < 1 || size[1] < 1 || size[2] != 1 || picture->GetScalarType() != VTK_FLOAT ||
      (channels != 1 && channels != 3 && channels != 4))
  {
    throw brdf::Error(brdf::Error::Kind::Value,
                      { "not a picture of radiance",
                        {},
                        std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]) +
                          ", " + std::to_string(channels) + " components of " + picture->GetScalarTypeAsString(),
                        "one slice of 1, 3 or 4 float components" });
  }
  brdf::Image image(
    static_cast<std::size_t>(size[0]), static_cast<std::size_t>(size[1]), static_cast<std::size_t>(channels));
  const auto* from = static_cast<const float*>(picture->GetScalarPointer());
  const std::size_t row = image.width * image.channels;
  for (std::size_t y = 0; y < image.height; ++y)
  {
    std::copy_n(from + (image.height - 1 - y) * row, row, image.pixel(0, y));
  }
  return image;
}

// The same way back.
inline vtkSmartPointer<vtkImageData> ToVtk(const brdf::Image& image)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(static_cast<int>(image.width), static_cast<int>(image.height), 1);
  picture->AllocateScalars(VTK_FLOAT, static_cast<int>(image.channels));
  auto* to = static_cast<float*>(picture->GetScalarPointer());
  const std::size_t row = image.width * image.channels;
  for (std::size_t y = 0; y < image.height; ++y)
  {
    std::copy_n(image.pixel(0, image.height - 1 - y), row, to + y * row);
  }
  return picture;
}
}
#endif
