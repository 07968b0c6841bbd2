#ifndef vtkBRDFEXRWriter_h
#define vtkBRDFEXRWriter_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkWriter.h"

#include <string> // For std::string

/**
 * @class vtkBRDFEXRWriter
 * @brief Writes a picture of 1, 3 or 4 float components as OpenEXR (32-bit float, ZIP)
 *
 * The file is replaced only when complete. Write() returns 0, with the reason in GetErrorText(), when it fails.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFEXRWriter : public vtkWriter
{
public:
  static vtkBRDFEXRWriter* New();
  vtkTypeMacro(vtkBRDFEXRWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to write; it is replaced when complete. Empty by default, which is an error. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}

  int Write() override;

  std::string GetErrorText() const { return this->ErrorText; }

protected:
  vtkBRDFEXRWriter() = default;
  ~vtkBRDFEXRWriter() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkBRDFEXRWriter(const vtkBRDFEXRWriter&) = delete;
  void operator=(const vtkBRDFEXRWriter&) = delete;

  std::string FileName;
  std::string ErrorText;
};
#endif
