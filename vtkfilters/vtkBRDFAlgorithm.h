#ifndef vtkBRDFAlgorithm_h
#define vtkBRDFAlgorithm_h
#include "vtkAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <memory> // For std::shared_ptr
#include <string> // For std::string

class vtkBRDF;
class vtkDataObject;
namespace brdf
{
class Brdf;
}

/**
 * @class vtkBRDFAlgorithm
 * @brief Base of every algorithm that takes or makes a vtkBRDF
 *
 * Does once what all of them need:
 * - Ports: inputs take vtkBRDF; outputs are vtkBRDF unless FillOutputPortInformation of a subclass names another type.
 * - Pieces: a BRDF is wanted whole by every rank, so upstream is asked for piece 0 of 1; an output that is a vtkBRDF
 *   or a vtkBRDFMicrosurface is made on every rank, any other output (geometry, image, table) on rank 0 only and left
 *   empty elsewhere.
 * - Errors: an exception in RequestData becomes vtkErrorMacro and GetErrorText(), the outputs are emptied and the
 * update fails. No exception leaves the class.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFAlgorithm : public vtkAlgorithm
{
public:
  vtkTypeMacro(vtkBRDFAlgorithm, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The first output as a BRDF; null when that output is of another type (see GetOutputDataObject). */
  vtkBRDF* GetOutput();

  /** A free-standing BRDF as input of a port. */
  void SetInputData(vtkDataObject* data) { this->SetInputDataObject(0, data); }
  void SetInputData(int port, vtkDataObject* data) { this->SetInputDataObject(port, data); }

  /** Why the last execution failed, in one line; empty when it succeeded. */
  std::string GetErrorText() const { return this->ErrorText; }

  /** Updates all outputs. False when this algorithm or one upstream failed; GetPipelineErrorText() then says why. */
  bool UpdateAndCheck();

  /** GetErrorText() of this algorithm or, where it is empty, of the first one upstream that failed. */
  std::string GetPipelineErrorText();

  vtkTypeBool ProcessRequest(vtkInformation* request,
                             vtkInformationVector** inputs,
                             vtkInformationVector* outputs) override;

protected:
  vtkBRDFAlgorithm();
  ~vtkBRDFAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  /** Announces what the outputs will be like; images give their extent, spacing and origin here. May throw. */
  virtual int RequestInformation(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs);

  /** Makes the outputs. Throws std::exception (brdf::Error) for every failure. */
  virtual int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) = 0;

  /** The BRDF on an input port; throws brdf::Error when there is none. */
  static std::shared_ptr<const brdf::Brdf> GetInputBrdf(vtkInformationVector** inputs, int port = 0);

private:
  vtkBRDFAlgorithm(const vtkBRDFAlgorithm&) = delete;
  void operator=(const vtkBRDFAlgorithm&) = delete;

  int CreateOutputs(vtkInformationVector* outputs);
  int AskForWholeInputs(vtkInformationVector** inputs);
  int Execute(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs);

  std::string ErrorText;
};
#endif
