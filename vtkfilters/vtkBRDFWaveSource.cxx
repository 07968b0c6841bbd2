#include "vtkBRDFWaveSource.h"

#include "vtkBRDF.h"
#include "vtkBRDFArrays.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"

#include <brdf/base/Parallel.h>
#include <brdf/simulate/wave/WaveModels.h>

vtkStandardNewMacro(vtkBRDFWaveSource);

vtkBRDFWaveSource::vtkBRDFWaveSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkBRDFWaveSource::~vtkBRDFWaveSource() = default;

int vtkBRDFWaveSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkBRDF::GetData(outputs)->SetBrdf(brdf::makeWaveBrdf(this->Model));
  return 1;
}

bool vtkBRDFWaveSource::EvaluateMueller(vtkDataArray* wi, vtkDataArray* wo, vtkDataArray* matrices, int channel)
{
  if (!wi || !wo || !matrices)
  {
    vtkErrorMacro("EvaluateMueller needs the arrays wi, wo and matrices");
    return false;
  }
  if (!this->UpdateAndCheck())
  {
    return false;
  }
  const auto model = std::dynamic_pointer_cast<const brdf::WaveBrdf>(this->GetOutput()->GetBrdf());
  if (channel < 0 || channel >= static_cast<int>(model->models().size()))
  {
    vtkErrorMacro("channel " << channel << " does not exist; the BRDF has " << model->models().size());
    return false;
  }
  try
  {
    const auto pairs = vtkBRDFArrays::DirectionPairs(wi, wo);
    const auto count = static_cast<vtkIdType>(pairs.size());
    std::vector<brdf::wave::Mueller> values(count);
    brdf::parallelFor(count,
                      4096,
                      [&](std::size_t first, std::size_t last)
                      { model->mueller(pairs.view().slice(first, last - first), channel, values.data() + first); });
    matrices->SetNumberOfComponents(16);
    matrices->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      matrices->SetTuple(i, values[i].m.data());
    }
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
}

vtkStringArray* vtkBRDFWaveSource::GetModelNames()
{
  static vtkNew<vtkStringArray> names;
  if (names->GetNumberOfValues() == 0)
  {
    for (const brdf::WaveKind& kind : brdf::waveKinds())
    {
      if (kind.family == "model")
      {
        names->InsertNextValue(kind.name);
      }
    }
  }
  return names;
}

void vtkBRDFWaveSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << this->Model << "\n";
}
