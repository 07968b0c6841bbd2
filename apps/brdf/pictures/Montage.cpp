#include "Pictures.h"

#include <vtkBRDFMontageView.h>
#include <vtkImageData.h>

namespace brdf::app {

void drawMontage(const MontagePicture& request) {
  vtkNew<vtkBRDFMontageView> view;
  for (const MontagePicture::Item& item : request.pictures)
    view->AddImage(toneMapped(toVtk(item.radiance), {}), item.caption);
  view->SetTitle(request.title);
  view->SetNote(request.note);
  view->SetColumns(static_cast<int>(request.columns));
  writeView(view, request.size, request.out);
}

}  // namespace brdf::app
