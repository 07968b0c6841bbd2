#ifndef vtkBRDFColourSettings_h
#define vtkBRDFColourSettings_h
// Illuminant, observer and adaptation of classes that show spectral data as colours. For .cxx files only.

namespace vtkBRDFColourSettings
{
template<class From, class To>
void Copy(From* from, To* to)
{
  to->SetIlluminant(from->GetIlluminant());
  to->SetObserver(from->GetObserver());
  to->SetAdaptation(from->GetAdaptation());
}
}

#endif
