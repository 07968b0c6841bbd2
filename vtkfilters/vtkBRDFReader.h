#ifndef vtkBRDFReader_h
#define vtkBRDFReader_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

/**
 * @class vtkBRDFReader
 * @brief Reads a measured BRDF of any supported format, recognised by content
 *
 * What the reader noticed and assumed is in the field data of the output, one string array each: "format",
 * "assumptions", "warnings"; and the counts "samples", "invalid", "negative", "notFinite", "belowHorizon".
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFReader : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFReader* New();
  vtkTypeMacro(vtkBRDFReader, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to read. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}

protected:
  vtkBRDFReader();
  ~vtkBRDFReader() override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFReader(const vtkBRDFReader&) = delete;
  void operator=(const vtkBRDFReader&) = delete;

  std::string FileName;
};
#endif
