#ifndef vtkBRDFProgramSource_h
#define vtkBRDFProgramSource_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

/**
 * @class vtkBRDFProgramSource
 * @brief Makes a BRDF of what another program computes
 *
 * The program reads directions and prints values; docs/external-programs.md is what is said between the two. The same
 * as the material "program:OPTIONS COMMAND" of vtkBRDFSource. Nothing is tabulated: the program is asked when a filter
 * downstream wants values, and a failure then is an error of that filter.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFProgramSource : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFProgramSource* New();
  vtkTypeMacro(vtkBRDFProgramSource, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The program (looked for along PATH) and its arguments; '...' and "..." keep words together, and no shell reads
   * them. Empty by default, which is an error of the update. */
  vtkSetMacro(Command, std::string);
  vtkGetMacro(Command, std::string);
  ///@}

  ///@{
  /** What the values are: "mono", "rgb", or wavelengths in nm separated by commas; empty (the default): the program
   * says so, and is asked for one value by the update. */
  vtkSetMacro(Channels, std::string);
  vtkGetMacro(Channels, std::string);
  ///@}

  ///@{
  /** What you vouch for, and tables and fits rely on: "isotropic", "bilateral" or "anisotropic" (default). */
  vtkSetMacro(Symmetry, std::string);
  vtkGetMacro(Symmetry, std::string);
  ///@}

  ///@{
  /** Whether light and viewer may change places: you vouch for it; default off. */
  vtkSetMacro(Reciprocal, bool);
  vtkGetMacro(Reciprocal, bool);
  vtkBooleanMacro(Reciprocal, bool);
  ///@}

  ///@{
  /** Whether the program is started once and asked batch by batch; default off: it is started for each batch. */
  vtkSetMacro(Stay, bool);
  vtkGetMacro(Stay, bool);
  vtkBooleanMacro(Stay, bool);
  ///@}

  ///@{
  /** Seconds without a sign of the program before it is ended; 0: wait for ever. Default 300. */
  vtkSetMacro(TimeLimit, double);
  vtkGetMacro(TimeLimit, double);
  ///@}

  ///@{
  /** Most processes that run at a time; 0 (the default): as many as there are threads. */
  vtkSetClampMacro(Processes, int, 0, 1024);
  vtkGetMacro(Processes, int);
  ///@}

protected:
  vtkBRDFProgramSource();
  ~vtkBRDFProgramSource() override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFProgramSource(const vtkBRDFProgramSource&) = delete;
  void operator=(const vtkBRDFProgramSource&) = delete;

  std::string Command, Channels, Symmetry = "anisotropic";
  bool Reciprocal = false, Stay = false;
  double TimeLimit = 300;
  int Processes = 0;
};
#endif
