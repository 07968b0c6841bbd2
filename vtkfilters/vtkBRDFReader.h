#ifndef vtkBRDFReader_h
#define vtkBRDFReader_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

/**
 * @class vtkBRDFReader
 * @brief Reads a BRDF from a file of any supported format, recognised by content
 *
 * Measured data, containers (.vtkhdf) and materials in XML.
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
  /** The file to read. Empty by default, which is an error. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}

  ///@{
  /** Which BRDF of a file that holds several: its number from 0, or its name. Empty (default): the first. */
  vtkSetMacro(Entry, std::string);
  vtkGetMacro(Entry, std::string);
  ///@}

  ///@{
  /**
   * What the user says of the file, against what its format says: "KEY=VALUE" items separated by blanks, e.g.
   * "quantity=brdf_cos angles=degrees". Empty (default): nothing. The keys are those of brdf/measured/ReadOptions.h.
   */
  vtkSetMacro(Assumptions, std::string);
  vtkGetMacro(Assumptions, std::string);
  ///@}

  /** 1 where some format recognises the content of the file, else 0. */
  int CanReadFile(const std::string& fileName);

protected:
  vtkBRDFReader();
  ~vtkBRDFReader() override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFReader(const vtkBRDFReader&) = delete;
  void operator=(const vtkBRDFReader&) = delete;

  std::string FileName;
  std::string Entry;
  std::string Assumptions;
};
#endif
