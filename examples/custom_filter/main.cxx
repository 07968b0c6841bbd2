// A filter of one's own between a source and a view: brushed metal turned by 0, 45 and 90 degrees, as turned.png.
#include "vtkBRDFTurn.h"

#include <vtkBRDFLobeView.h>
#include <vtkBRDFSource.h>
#include <vtkNew.h>

#include <cstdio>
#include <string>

int main(int count, char** words)
{
  vtkNew<vtkBRDFSource> brushed;
  brushed->SetMaterial("Ward(ax=0.1, ay=0.4)");
  vtkNew<vtkBRDFLobeView> view;
  for (const int angle : { 0, 45, 90 })
  {
    vtkNew<vtkBRDFTurn> turn;
    turn->SetInputConnection(brushed->GetOutputPort());
    turn->SetAngle(angle);
    view->AddInputConnection(turn->GetOutputPort(), "turned by " + std::to_string(angle) + " degrees");
  }
  view->SetThetaI(30);
  view->SetTransform("cuberoot");
  view->SetSize(450, 350);
  if (!view->WritePNG(count > 1 ? words[1] : "turned.png"))
  {
    std::fprintf(stderr, "%s\n", view->GetErrorText().c_str());
    return 1;
  }
}
