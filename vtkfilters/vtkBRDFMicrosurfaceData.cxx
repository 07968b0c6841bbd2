#include "vtkBRDFMicrosurfaceData.h"

#include "vtkBMPReader.h"
#include "vtkBRDFSurface.h"
#include "vtkBRDFSurfaceFiles.h"
#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkJPEGReader.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTIFFReader.h"
#include "vtkTriangleFilter.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/ImageFile.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <vector>

namespace
{
using brdf::Error;

vtkSmartPointer<vtkImageReader2> ReaderFor(const std::filesystem::path& path)
{
  std::string ending = path.extension().string();
  std::transform(
    ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".png")
  {
    return vtkSmartPointer<vtkPNGReader>::New();
  }
  if (ending == ".jpg" || ending == ".jpeg")
  {
    return vtkSmartPointer<vtkJPEGReader>::New();
  }
  if (ending == ".tif" || ending == ".tiff")
  {
    vtkNew<vtkTIFFReader> reader;
    reader->SetOrientationType(4); // its own default would mirror what says nothing of itself
    return reader;
  }
  return ending == ".bmp" ? vtkSmartPointer<vtkBMPReader>::New() : nullptr;
}

brdf::Image ReadPicture(const std::filesystem::path& path)
{
  const vtkSmartPointer<vtkImageReader2> reader = ReaderFor(path);
  if (!reader)
  {
    return brdf::readImage(path);
  }
  brdf::readFileHead(path, 1); // says what is wrong with a missing or unreadable file
  if (!reader->CanReadFile(path.c_str()))
  {
    throw Error(Error::Kind::Format, { "not a picture of its kind", path.string(), "", path.extension().string() });
  }
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  const int* extent = reader->GetDataExtent();
  const auto width = static_cast<std::size_t>(std::max(extent[1] - extent[0] + 1, 0));
  const auto height = static_cast<std::size_t>(std::max(extent[3] - extent[2] + 1, 0));
  if (width == 0 || height == 0 || width > brdf::kMaximumImagePixels / height)
  {
    throw Error(Error::Kind::Format,
                { "a picture of no use",
                  path.string(),
                  std::to_string(width) + " x " + std::to_string(height),
                  "1 to " + std::to_string(brdf::kMaximumImagePixels) + " pixels" });
  }
  reader->Update();
  vtkDataArray* scalars = reader->GetOutput()->GetPointData()->GetScalars();
  const auto channels = scalars ? static_cast<std::size_t>(scalars->GetNumberOfComponents()) : 0;
  if (reader->GetErrorCode() != vtkErrorCode::NoError || channels < 1 || channels > 4 ||
      static_cast<std::size_t>(scalars->GetNumberOfTuples()) != width * height)
  {
    throw Error(Error::Kind::Format, { "cannot be read", path.string(), "", "1 to 4 channels" });
  }
  const double largest =
    scalars->GetDataType() == VTK_FLOAT || scalars->GetDataType() == VTK_DOUBLE ? 1 : scalars->GetDataTypeMax();
  // Of grey and alpha the grey.
  const std::size_t kept = channels == 2 ? 1 : channels;
  brdf::Image image(width, height, kept);
  for (std::size_t y = 0; y < height; ++y)
  {
    for (std::size_t x = 0; x < width; ++x)
    {
      for (std::size_t c = 0; c < kept; ++c)
      {
        const double value =
          scalars->GetComponent(static_cast<vtkIdType>((height - 1 - y) * width + x), static_cast<int>(c));
        image.pixel(x, y)[c] = static_cast<float>(value / largest);
      }
    }
  }
  return image;
}

/** Points and triangles of one tile, before they are repeated. */
struct Soup
{
  std::vector<std::array<float, 3>> Points;
  std::vector<std::array<vtkIdType, 3>> Triangles;

  void Reserve(double points, double triangles)
  {
    if (!(triangles <= 0x1p26))
    {
      throw Error(Error::Kind::Value,
                  { "too many triangles to look at", "microsurface", std::to_string(triangles), "2^26" });
    }
    this->Points.reserve(static_cast<std::size_t>(points));
    this->Triangles.reserve(static_cast<std::size_t>(triangles));
  }
};

// All copies at once: their nodes are shared.
void Add(Soup& soup, const brdf::HeightField& field, int tilesX, int tilesY, int stride)
{
  const auto step = static_cast<std::size_t>(stride);
  // Every stride-th node of a tile, and at the far end of all tiles the first node again.
  std::vector<std::size_t> columns, rows;
  const auto nodes = [step](std::vector<std::size_t>& list, std::size_t count, int tiles)
  {
    for (int tile = 0; tile < tiles; ++tile)
    {
      for (std::size_t i = 0; i < count; i += step)
      {
        list.push_back(static_cast<std::size_t>(tile) * count + i);
      }
    }
    list.push_back(static_cast<std::size_t>(tiles) * count);
  };
  nodes(columns, field.columns, tilesX);
  nodes(rows, field.rows, tilesY);
  const auto width = static_cast<vtkIdType>(columns.size());
  soup.Reserve(static_cast<double>(columns.size()) * static_cast<double>(rows.size()),
               2.0 * static_cast<double>(columns.size() - 1) * static_cast<double>(rows.size() - 1));
  for (const std::size_t j : rows)
  {
    for (const std::size_t i : columns)
    {
      soup.Points.push_back({ static_cast<float>(static_cast<double>(i) * field.spacingX),
                              static_cast<float>(static_cast<double>(j) * field.spacingY),
                              field.height(i % field.columns, j % field.rows) });
    }
  }
  for (vtkIdType j = 0; j + 1 < static_cast<vtkIdType>(rows.size()); ++j)
  {
    for (vtkIdType i = 0; i + 1 < width; ++i)
    {
      const vtkIdType a = j * width + i;
      soup.Triangles.push_back({ a, a + 1, a + 1 + width });
      soup.Triangles.push_back({ a, a + 1 + width, a + width });
    }
  }
}

void AddShifted(Soup& soup,
                const std::vector<std::array<float, 3>>& points,
                const std::vector<std::array<std::uint32_t, 3>>& triangles,
                double x,
                double y,
                double z,
                double scale)
{
  const auto first = static_cast<vtkIdType>(soup.Points.size());
  for (const auto& p : points)
  {
    soup.Points.push_back({ static_cast<float>(x + scale * p[0]),
                            static_cast<float>(y + scale * p[1]),
                            static_cast<float>(z + scale * p[2]) });
  }
  for (const auto& t : triangles)
  {
    soup.Triangles.push_back({ first + t[0], first + t[1], first + t[2] });
  }
}

void Add(Soup& soup, const brdf::TiledMesh& mesh, int tilesX, int tilesY, int)
{
  const double tiles = static_cast<double>(tilesX) * tilesY;
  soup.Reserve(tiles * static_cast<double>(mesh.points.size()), tiles * static_cast<double>(mesh.triangles.size()));
  for (int j = 0; j < tilesY; ++j)
  {
    for (int i = 0; i < tilesX; ++i)
    {
      AddShifted(soup, mesh.points, mesh.triangles, i * mesh.periodX, j * mesh.periodY, 0, 1);
    }
  }
}

/** A sphere of radius 1 of 2 n (n - 1) + 2 points. */
brdf::TiledMesh UnitSphere(std::uint32_t n)
{
  brdf::TiledMesh sphere;
  const std::uint32_t around = 2 * n;
  sphere.points.push_back({ 0, 0, 1 });
  for (std::uint32_t ring = 1; ring < n; ++ring)
  {
    for (std::uint32_t k = 0; k < around; ++k)
    {
      const brdf::Direction d = brdf::fromSpherical(brdf::kPi * ring / n, brdf::kPi * k / n);
      sphere.points.push_back({ static_cast<float>(d[0]), static_cast<float>(d[1]), static_cast<float>(d[2]) });
    }
  }
  sphere.points.push_back({ 0, 0, -1 });
  const auto last = static_cast<std::uint32_t>(sphere.points.size() - 1);
  for (std::uint32_t k = 0; k < around; ++k)
  {
    const std::uint32_t next = (k + 1) % around, bottom = 1 + (n - 2) * around;
    sphere.triangles.push_back({ 0, 1 + k, 1 + next });
    for (std::uint32_t ring = 0; ring + 2 < n; ++ring)
    {
      const std::uint32_t a = 1 + ring * around;
      sphere.triangles.push_back({ a + k, a + around + k, a + around + next });
      sphere.triangles.push_back({ a + k, a + around + next, a + next });
    }
    sphere.triangles.push_back({ bottom + k, last, bottom + next });
  }
  return sphere;
}

void Add(Soup& soup, const brdf::SpherePacking& packing, int tilesX, int tilesY, int)
{
  const double tiles = static_cast<double>(tilesX) * tilesY;
  const double spheres = tiles * static_cast<double>(packing.spheres.size());
  // Round to the eye, where there are few enough of them.
  const auto n = static_cast<std::uint32_t>(std::clamp(std::sqrt(5e5 / std::max(spheres, 1.0)), 4.0, 24.0));
  const brdf::TiledMesh sphere = UnitSphere(n);
  soup.Reserve(spheres * static_cast<double>(sphere.points.size()) + 4,
               spheres * static_cast<double>(sphere.triangles.size()) + 2);
  if (packing.substrate)
  {
    const auto width = static_cast<float>(tilesX * packing.periodX),
               depth = static_cast<float>(tilesY * packing.periodY);
    AddShifted(soup,
               { { 0, 0, 0 }, { width, 0, 0 }, { width, depth, 0 }, { 0, depth, 0 } },
               { { 0, 1, 2 }, { 0, 2, 3 } },
               0,
               0,
               0,
               1);
  }
  for (int j = 0; j < tilesY; ++j)
  {
    for (int i = 0; i < tilesX; ++i)
    {
      for (const auto& s : packing.spheres)
      {
        AddShifted(soup,
                   sphere.points,
                   sphere.triangles,
                   s.centre[0] + i * packing.periodX,
                   s.centre[1] + j * packing.periodY,
                   s.centre[2],
                   s.radius);
      }
    }
  }
}
}

brdf::SurfaceReaders vtkBRDFMicrosurfaceData::Readers()
{
  brdf::SurfaceReaders readers;
  readers.mesh = [](const std::filesystem::path& path)
  { return FromPolyData(vtkBRDFSurfaceFiles::Read(path.string())); };
  readers.picture = ReadPicture;
  return readers;
}

brdf::HeightField vtkBRDFMicrosurfaceData::FromImage(vtkImageData* image, double scale)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const int* size = image->GetDimensions();
  if (!scalars || size[2] != 1 || scalars->GetNumberOfTuples() != static_cast<vtkIdType>(size[0]) * size[1])
  {
    throw Error(Error::Kind::Value,
                { "no heights",
                  "image of a microsurface",
                  scalars ? std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2])
                          : "no point scalars",
                  "point scalars of one layer along z" });
  }
  const double* spacing = image->GetSpacing();
  brdf::HeightField field{
    static_cast<std::size_t>(size[0]), static_cast<std::size_t>(size[1]), spacing[0], spacing[1], {}
  };
  field.heights.reserve(field.columns * field.rows);
  for (vtkIdType k = 0; k < scalars->GetNumberOfTuples(); ++k)
  {
    field.heights.push_back(static_cast<float>(scale * scalars->GetComponent(k, 0)));
  }
  return field;
}

brdf::TiledMesh vtkBRDFMicrosurfaceData::FromPolyData(vtkPolyData* surface)
{
  vtkBRDFSurface::RequireCorners(surface);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  vtkPolyData* output = triangles->GetOutput();
  brdf::TiledMesh mesh;
  mesh.periodX = mesh.periodY = 0;
  mesh.points.resize(static_cast<std::size_t>(output->GetNumberOfPoints()));
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
  {
    double p[3];
    output->GetPoint(static_cast<vtkIdType>(k), p);
    mesh.points[k] = { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) };
  }
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (output->GetPolys()->InitTraversal(); output->GetPolys()->GetNextCell(count, corners);)
  {
    mesh.triangles.push_back({ static_cast<std::uint32_t>(corners[0]),
                               static_cast<std::uint32_t>(corners[1]),
                               static_cast<std::uint32_t>(corners[2]) });
  }
  return mesh;
}

vtkSmartPointer<vtkImageData> vtkBRDFMicrosurfaceData::ToImage(const brdf::HeightField& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(field.columns), static_cast<int>(field.rows), 1);
  image->SetSpacing(field.spacingX, field.spacingY, 1);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("height");
  heights->SetNumberOfTuples(static_cast<vtkIdType>(field.heights.size()));
  std::copy(field.heights.begin(), field.heights.end(), heights->GetPointer(0));
  image->GetPointData()->SetScalars(heights);
  return image;
}

vtkSmartPointer<vtkPolyData> vtkBRDFMicrosurfaceData::ToPolyData(const brdf::SurfaceShape& shape,
                                                                 int tilesX,
                                                                 int tilesY,
                                                                 int stride)
{
  for (const int tiles : { tilesX, tilesY })
  {
    if (tiles < 1 || tiles > 100)
    {
      throw Error(Error::Kind::Value, { "copies of a tile", "microsurface", std::to_string(tiles), "1 to 100" });
    }
  }
  Soup soup;
  std::visit([&](const auto& kind) { Add(soup, kind, tilesX, tilesY, stride); }, shape);
  vtkNew<vtkFloatArray> coordinates, heights;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(soup.Points.size()));
  heights->SetName("height");
  heights->SetNumberOfTuples(static_cast<vtkIdType>(soup.Points.size()));
  for (std::size_t k = 0; k < soup.Points.size(); ++k)
  {
    std::copy_n(soup.Points[k].data(), 3, coordinates->GetPointer(static_cast<vtkIdType>(3 * k)));
    heights->SetValue(static_cast<vtkIdType>(k), soup.Points[k][2]);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(soup.Triangles.size()),
                       static_cast<vtkIdType>(3 * soup.Triangles.size()));
  for (const auto& triangle : soup.Triangles)
  {
    cells->InsertNextCell(3, triangle.data());
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetPointData()->SetScalars(heights);
  return surface;
}
