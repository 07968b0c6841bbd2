// Two fits of one measured material and a map of each one's errors: compare_fits MEASURED LOBES_A LOBES_B
// writes errors-a.png and errors-b.png.
#include <vtkBRDFErrorMap.h>
#include <vtkBRDFErrorMapView.h>
#include <vtkBRDFFit.h>
#include <vtkBRDFSource.h>
#include <vtkFieldData.h>
#include <vtkNew.h>

#include <vtkBRDF.h>

#include <cstdio>
#include <string>

int main(int count, char** words)
{
  vtkNew<vtkBRDFSource> measured;
  measured->SetMaterial(count > 1 ? words[1] : "preset:bagher-sgd-gold-metallic-paint");

  const std::string lobes[] = { count > 2 ? words[2] : "Lambertian + GGX", count > 3 ? words[3] : "Lambertian + Ward" };
  const std::string pictures[] = { "errors-a.png", "errors-b.png" };
  for (int k = 0; k < 2; ++k)
  {
    vtkNew<vtkBRDFFit> fit;
    fit->SetInputConnection(measured->GetOutputPort());
    fit->SetLobes(lobes[k]);
    fit->SetMaximumTheta(80);

    vtkNew<vtkBRDFErrorMapView> view;
    view->SetInputConnection(0, fit->GetOutputPort());
    view->SetInputConnection(1, measured->GetOutputPort());
    view->GetErrorMap()->SetMeasure("cuberoot");
    view->SetNameA(lobes[k]);
    view->SetNameB("measured");
    view->SetSize(450, 350);
    if (!view->WritePNG(pictures[k]))
    {
      std::fprintf(stderr, "%s\n", view->GetErrorText().c_str());
      return 1;
    }
    std::printf("%s: %s\n", lobes[k].c_str(), fit->GetOutput()->GetDescription().c_str());
  }
}
