#include "vtkBRDFTurn.h"

#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>

#include <vtkBRDF.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>

#include <cmath>
#include <vector>

namespace
{
/// A BRDF of one's own: another one on a turned surface.
class TurnedBrdf : public brdf::Brdf
{
public:
  TurnedBrdf(brdf::BrdfPointer inner, double degrees)
    : Inner(std::move(inner))
    , Degrees(degrees)
  {
  }
  const brdf::Channels& channels() const override { return this->Inner->channels(); }
  brdf::Symmetry symmetry() const override { return this->Inner->symmetry(); }
  bool reciprocal() const override { return this->Inner->reciprocal(); }
  std::string description() const override
  {
    return this->Inner->description() + ", turned by " + std::to_string(this->Degrees) + " degrees";
  }
  void evaluate(const brdf::DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override
  {
    // Both directions as the turned surface sees them: turned back. Batches come as arrays of components.
    const double cosine = std::cos(brdf::radians(this->Degrees)), sine = std::sin(brdf::radians(this->Degrees));
    std::vector<double> turned[4];
    const double* const from[2][2] = { { pairs.wi[0], pairs.wi[1] }, { pairs.wo[0], pairs.wo[1] } };
    for (int k = 0; k < 2; ++k)
    {
      turned[2 * k].resize(pairs.count);
      turned[2 * k + 1].resize(pairs.count);
      for (std::size_t i = 0; i < pairs.count; ++i)
      {
        turned[2 * k][i] = cosine * from[k][0][i] + sine * from[k][1][i];
        turned[2 * k + 1][i] = cosine * from[k][1][i] - sine * from[k][0][i];
      }
    }
    brdf::DirectionPairs<double> inner = pairs;
    inner.wi = { turned[0].data(), turned[1].data(), pairs.wi[2] };
    inner.wo = { turned[2].data(), turned[3].data(), pairs.wo[2] };
    this->Inner->evaluate(inner, values, valid);
  }

private:
  brdf::BrdfPointer Inner;
  double Degrees;
};
}

vtkStandardNewMacro(vtkBRDFTurn);

vtkBRDFTurn::vtkBRDFTurn()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(1);
}

int vtkBRDFTurn::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkBRDF::GetData(outputs)->SetBrdf(std::make_shared<TurnedBrdf>(GetInputBrdf(inputs), this->Angle));
  return 1;
}
