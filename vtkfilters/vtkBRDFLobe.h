#ifndef vtkBRDFLobe_h
#define vtkBRDFLobe_h
#include "vtkBRDFChannelAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

class vtkPolyData;

/**
 * @class vtkBRDFLobe
 * @brief The lobe of a BRDF for one incident direction, as a surface
 *
 * A geodesic hemisphere of view directions, each moved out to the transformed value: the distance from the origin says
 * how much light leaves that way. Where a choice has several channels the length is that of their luminance ("rgb") or
 * of their mean ("all"). The mesh is refined where the surface bends and around the mirror and retro-reflected
 * directions, so that sharp lobes are not missed. With a second BRDF on input port 1 and another Shape it shows the
 * signed difference of the two.
 *
 * Point data: "value" (f_r in 1/sr, one component a channel of the choice; the first's less the second's for
 * differences), "transformed" (the length, signed for differences; the active scalar), "valid" (0 where a BRDF has no
 * value: such points are in no triangle), "Normals"; where Colour asks for it "colour" (f_r of a channel, 1/sr) or
 * "rgb" (sRGB, 8 bits). Field data of the input is passed on.
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFLobe : public vtkBRDFChannelAlgorithm
{
public:
  static vtkBRDFLobe* New();
  vtkTypeMacro(vtkBRDFLobe, vtkBRDFChannelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkPolyData* GetOutput();

  ///@{
  /** Polar angle of the incident direction from the normal, [0, 90) degrees; default 45. */
  vtkSetMacro(ThetaI, double);
  vtkGetMacro(ThetaI, double);
  ///@}

  ///@{
  /** Azimuth of the incident direction, degrees; default 0. */
  vtkSetMacro(PhiI, double);
  vtkGetMacro(PhiI, double);
  ///@}

  ///@{
  /** What the distance from the origin stands for, T being the transform: "value" (default): T(f) of input 0;
   * "difference": |T(f) - T(g)|, g being input 1; "displaced": R + T(f) - T(g), a hemisphere of radius R, the largest
   * |T(f) - T(g)|, dented and raised. */
  vtkSetMacro(Shape, std::string);
  vtkGetMacro(Shape, std::string);
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
  /** Refinement stops before there are more, the largest errors first; default 200000. The starting mesh is always
   * whole. */
  vtkSetClampMacro(MaximumTriangles, int, 0, 10000000);
  vtkGetMacro(MaximumTriangles, int);
  ///@}

  ///@{
  /** "none" (f_r, 1/sr), "cuberoot" (sr^-1/3), "log" (ln(1 + f_r)), or "logfloor" (log10 of f_r over Floor, at least
   * 0). Default "none". */
  vtkSetMacro(Transform, std::string);
  vtkGetMacro(Transform, std::string);
  ///@}

  ///@{
  /** Where "logfloor" begins, 1/sr, above 0; default 1e-3, a third of a percent of a white diffuser. */
  vtkSetMacro(Floor, double);
  vtkGetMacro(Floor, double);
  ///@}

  ///@{
  /** Colours to go with the surface, apart from its length: empty (default): none; "true": linear sRGB at full
   * brightness; else a channel as above. */
  vtkSetMacro(Colour, std::string);
  vtkGetMacro(Colour, std::string);
  ///@}

  ///@{
  /** Of the last lobe, in the transform's unit: the largest length (magnitude, for differences), the radius R of a
   * displaced one (else 0), and the largest distance of the surface from an edge of the mesh that refinement saw, by
   * share of the largest radius. */
  double GetMaximumLength() const { return this->MaximumLength; }
  double GetReferenceRadius() const { return this->ReferenceRadius; }
  double GetChordError() const { return this->ChordError; }
  ///@}

protected:
  vtkBRDFLobe();
  ~vtkBRDFLobe() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFLobe(const vtkBRDFLobe&) = delete;
  void operator=(const vtkBRDFLobe&) = delete;

  double ThetaI = 45;
  double PhiI = 0;
  int Resolution = 5;
  double Tolerance = 1e-3;
  int MaximumTriangles = 200000;
  std::string Shape = "value";
  std::string Transform = "none";
  double Floor = 1e-3;
  std::string Colour;
  double MaximumLength = 0;
  double ReferenceRadius = 0;
  double ChordError = 0;
};
#endif
