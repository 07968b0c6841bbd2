// A regression test of one's own material: renders it and compares with the picture kept the first time.
// regression MATERIAL BASELINE.exr; exit code 1 when the picture is no longer the same.
// (`brdf baseline` does this for whole lists of pictures: docs/baselines.md.)
#include <brdf/base/Error.h>
#include <brdf/io/ImageDifference.h>
#include <brdf/io/ImageFile.h>

#include <vtkBRDFRender.h>
#include <vtkBRDFSource.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

int main(int count, char** words)
{
  const std::filesystem::path baseline = count > 2 ? words[2] : "baseline.exr";
  vtkNew<vtkBRDFSource> material;
  material->SetMaterial(count > 1 ? words[1] : "0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)");
  vtkNew<vtkBRDFRender> render;
  render->SetInputConnection(material->GetOutputPort());
  render->AddDirectionalLight(45, 30, 3, 3, 3);
  render->SetSize(64, 64);
  if (!render->UpdateAndCheck())
  {
    std::fprintf(stderr, "%s\n", render->GetPipelineErrorText().c_str());
    return 2;
  }
  // VTK's rows run from the bottom, those of brdf::Image from the top.
  brdf::Image picture(64, 64, 3);
  const auto* radiance = static_cast<const float*>(render->GetOutput()->GetScalarPointer());
  for (std::size_t y = 0; y < 64; ++y)
  {
    std::copy_n(radiance + 3 * 64 * (63 - y), 3 * 64, picture.pixel(0, y));
  }
  try
  {
    if (!std::filesystem::exists(baseline))
    {
      brdf::writeExr(picture, baseline);
      std::printf("%s made\n", baseline.c_str());
      return 0;
    }
    const auto difference = brdf::imageDifference(picture, brdf::readImage(baseline), { 1e-4, 0.001, 0.002 });
    std::printf("%zu pixels beyond the tolerance, rms %g\n", difference.outliers, difference.rms);
    return difference.within ? 0 : 1;
  }
  catch (const brdf::Error& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
