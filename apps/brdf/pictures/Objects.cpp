#include "Pictures.h"

#include <brdf/io/ImageFile.h>

#include <vtkBRDFObjectSource.h>
#include <vtkBRDFSurface.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkJPEGReader.h>
#include <vtkPNGReader.h>
#include <vtkPolyData.h>

#include <cmath>
#include <filesystem>

/// Things that scenes are made of, read by VTK.
namespace brdf::app {
TriangleMesh makeObject(const std::string& object) {
  vtkNew<vtkBRDFObjectSource> source;
  source->SetObject(object);
  source->Update();
  if (const std::string reason = source->GetErrorText(); !reason.empty())
    throw Error(Error::Kind::Value, {reason, "", "", ""});
  return vtkBRDFSurface::ToMesh(source->GetOutput());
}

Image readPicture(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".png" && extension != ".jpg" && extension != ".jpeg") return readImage(path);
  readFileHead(path, 1);  // says what is wrong with a missing or unreadable file
  vtkSmartPointer<vtkImageReader2> reader;
  if (extension == ".png")
    reader = vtkSmartPointer<vtkPNGReader>::New();
  else
    reader = vtkSmartPointer<vtkJPEGReader>::New();
  if (!reader->CanReadFile(path.c_str()))
    throw Error(Error::Kind::Format, {"not a picture of its kind", path, "", extension});
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  const int* extent = reader->GetDataExtent();
  const auto width = static_cast<std::size_t>(extent[1] - extent[0] + 1),
             height = static_cast<std::size_t>(extent[3] - extent[2] + 1);
  if (width == 0 || height == 0 || width > kMaximumImagePixels / height)
    throw Error(Error::Kind::Format,
                {"a picture too large", path, std::to_string(width) + " x " + std::to_string(height),
                 std::to_string(kMaximumImagePixels) + " pixels"});
  reader->Update();
  vtkImageData* picture = reader->GetOutput();
  const int channels = picture->GetNumberOfScalarComponents();
  const bool wide = picture->GetScalarType() == VTK_UNSIGNED_SHORT;
  if (reader->GetErrorCode() != vtkErrorCode::NoError || channels < 1 ||
      (!wide && picture->GetScalarType() != VTK_UNSIGNED_CHAR))
    throw Error(Error::Kind::Format, {"cannot be read", path, "", "8 or 16 bits a channel"});
  Image image(width, height, 3);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) {
        const double encoded =
            picture->GetScalarComponentAsDouble(static_cast<int>(x) + extent[0],
                                                static_cast<int>(height - 1 - y) + extent[2], 0, channels < 3 ? 0 : c) /
            (wide ? 65535.0 : 255.0);
        // IEC 61966-2-1
        image.pixel(x, y)[c] =
            static_cast<float>(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
      }
  return image;
}

}  // namespace brdf::app
