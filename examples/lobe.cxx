// The lobe of a material for one incident direction, as a picture: lobe MATERIAL PICTURE.png
#include <vtkBRDFLobeView.h>
#include <vtkBRDFSource.h>
#include <vtkNew.h>

#include <cstdio>

int main(int count, char** words)
{
  vtkNew<vtkBRDFSource> source;
  source->SetMaterial(count > 1 ? words[1] : "0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)");

  vtkNew<vtkBRDFLobeView> view;
  view->AddInputConnection(source->GetOutputPort());
  view->SetThetaI(45);
  view->SetSize(450, 350);
  if (!view->WritePNG(count > 2 ? words[2] : "lobe.png"))
  {
    std::fprintf(stderr, "%s\n", view->GetErrorText().c_str());
    return 1;
  }
}
