#ifndef vtkBRDFWriter_h
#define vtkBRDFWriter_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

namespace brdf
{
class Brdf;
}

/**
 * @class vtkBRDFWriter
 * @brief Writes a BRDF to a file: a container, a material in XML, or any format of measured data, resampling where
 * needed
 *
 * Input: a vtkBRDF. No output. The file is replaced only when complete.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFWriter : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFWriter* New();
  vtkTypeMacro(vtkBRDFWriter, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to write. Empty by default, which is an error. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}

  ///@{
  /** Name of the format, with settings where it has some, as `brdf convert --format` takes it; empty (default): by the
   * extension of the file. An unknown one is an error that lists them. */
  vtkSetMacro(Format, std::string);
  vtkGetMacro(Format, std::string);
  ///@}

  ///@{
  /** What the BRDF is called in a container (.vtkhdf). Empty (default): the file is replaced, and the BRDF is its only
   * entry, "material". A name: the entries that the file has stay, and this one is added; an error where it has one of
   * that name, or the file is no container. */
  vtkSetMacro(Entry, std::string);
  vtkGetMacro(Entry, std::string);
  ///@}

  /** Writes. 0, with the reason in GetPipelineErrorText(), when that failed. */
  int Write();

  /** What the last file could not hold, a line each; empty when nothing was lost. */
  std::string GetLosses() const { return this->Losses; }

protected:
  vtkBRDFWriter();
  ~vtkBRDFWriter() override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFWriter(const vtkBRDFWriter&) = delete;
  void operator=(const vtkBRDFWriter&) = delete;
  void AddEntry(const brdf::Brdf& brdf);

  std::string FileName;
  std::string Format;
  std::string Entry;
  std::string Losses;
};
#endif
