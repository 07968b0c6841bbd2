#ifndef vtkBRDFLobe_h
#define vtkBRDFLobe_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

class vtkPolyData;

/**
 * @class vtkBRDFLobe
 * @brief The lobe of a BRDF for one incident direction, as a surface
 *
 * A geodesic hemisphere of view directions, each moved out to the transformed value: the distance from the origin says
 * how much light leaves that way. The mesh is refined where the surface bends and around the mirror and retro-reflected
 * directions, so that sharp lobes are not missed.
 *
 * Point data: "value" (f_r in 1/sr, one component a channel of the choice), "transformed" (the length, the active
 * scalar), "valid" (0 where the BRDF has no value: such points are in no triangle), "Normals". Field data of the input
 * is passed on.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFLobe : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFLobe* New();
  vtkTypeMacro(vtkBRDFLobe, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkPolyData* GetOutput();

  ///@{
  /** The incident direction: polar angle from the normal, [0, 90) degrees, default 45, and azimuth, degrees, default 0.
   */
  vtkSetMacro(ThetaI, double);
  vtkGetMacro(ThetaI, double);
  vtkSetMacro(PhiI, double);
  vtkGetMacro(PhiI, double);
  ///@}

  ///@{
  /** Subdivisions of the starting octahedron: 0 to 9, default 5 (edges of 2.8 degrees). */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /** Edges are split while the surface leaves them by more than this share of the lobe's largest length; 0: never.
   * Default 1e-3: a third of a pixel in a picture where the lobe is 300 pixels long. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** "none" (f_r, 1/sr), "cuberoot" (sr^-1/3) or "log" (ln(1 + f_r)). Default "none". */
  vtkSetMacro(Transform, std::string);
  vtkGetMacro(Transform, std::string);
  ///@}

  ///@{
  /** "luminance" (default), "rgb" (three values, the length is their luminance), a channel number from 0, or a
   * wavelength such as "550nm". */
  vtkSetMacro(Channel, std::string);
  vtkGetMacro(Channel, std::string);
  ///@}

  ///@{
  /** How spectral data become colours: the illuminant (a CIE name such as "A" or "F11", or the path of a spectrum;
   * empty, the default: D65, and equal energy for luminance), the observer ("2", the default, or "10" degrees) and the
   * adaptation to D65 ("bradford", the default, or "none"). See brdf::ColourNames. */
  vtkSetMacro(Illuminant, std::string);
  vtkGetMacro(Illuminant, std::string);
  vtkSetMacro(Observer, std::string);
  vtkGetMacro(Observer, std::string);
  vtkSetMacro(Adaptation, std::string);
  vtkGetMacro(Adaptation, std::string);
  ///@}

  /** The largest length of the last lobe, in the transform's unit. */
  double GetMaximumLength() const { return this->MaximumLength; }

protected:
  vtkBRDFLobe();
  ~vtkBRDFLobe() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFLobe(const vtkBRDFLobe&) = delete;
  void operator=(const vtkBRDFLobe&) = delete;

  double ThetaI = 45;
  double PhiI = 0;
  int Resolution = 5;
  double Tolerance = 1e-3;
  std::string Transform = "none";
  std::string Channel = "luminance";
  std::string Illuminant;
  std::string Observer = "2";
  std::string Adaptation = "bradford";
  double MaximumLength = 0;
};
#endif
