// Fits lobes to a material and renders a sphere of the fit under an environment, without a display:
// fit_and_render MEASURED ENVIRONMENT.exr writes sphere.png and sphere.exr.
#include <vtkBRDF.h>
#include <vtkBRDFEXRWriter.h>
#include <vtkBRDFEnvironment.h>
#include <vtkBRDFFit.h>
#include <vtkBRDFRender.h>
#include <vtkBRDFSource.h>
#include <vtkBRDFToneMap.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <cstdio>

int main(int count, char** words)
{
  vtkNew<vtkBRDFSource> measured;
  measured->SetMaterial(count > 1 ? words[1] : "preset:bagher-sgd-gold-metallic-paint");
  vtkNew<vtkBRDFFit> fit;
  fit->SetInputConnection(measured->GetOutputPort());
  fit->SetLobes("Lambertian + GGX");

  vtkNew<vtkBRDFEnvironment> environment; // radiance 1 from everywhere, unless a file is given
  if (count > 2 && !environment->ReadFile(words[2]))
  {
    std::fprintf(stderr, "%s\n", environment->GetErrorText().c_str());
    return 1;
  }
  vtkNew<vtkBRDFRender> render;
  render->SetInputConnection(fit->GetOutputPort());
  render->SetEnvironment(environment);
  render->SetSize(128, 128);
  if (!render->UpdateAndCheck())
  {
    std::fprintf(stderr, "%s\n", render->GetPipelineErrorText().c_str());
    return 1;
  }
  std::printf("%s\n", fit->GetOutput()->GetDescription().c_str());

  vtkNew<vtkBRDFEXRWriter> exr; // linear radiance
  exr->SetInputConnection(render->GetOutputPort());
  exr->SetFileName("sphere.exr");
  exr->Write();

  vtkNew<vtkBRDFToneMap> toneMap; // sRGB
  toneMap->SetInputConnection(render->GetOutputPort());
  vtkNew<vtkPNGWriter> png;
  png->SetInputConnection(toneMap->GetOutputPort());
  png->SetFileName("sphere.png");
  png->Write();
}
