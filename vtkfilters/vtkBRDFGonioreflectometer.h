#ifndef vtkBRDFGonioreflectometer_h
#define vtkBRDFGonioreflectometer_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <memory> // For std::shared_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkStringArray;
class vtkTable;
namespace brdf
{
struct GonioreflectometerOptions;
struct GonioreflectometerResult;
struct LayoutChoice;
struct LayoutRequest;
struct MadeSurface;
struct Microsurface;
}

/**
 * @class vtkBRDFGonioreflectometer
 * @brief The BRDF of a microsurface, by tracing light through it
 *
 * Input: a vtkBRDFMicrosurface (vtkBRDFMicrosurfaceSource). Output port 0: a table as vtkBRDF, with a standard error
 * for each cell; its field data has "rays", "seconds", "converged", "layout" and "layoutReason" (one value each).
 * Output port 1: a vtkTable, the energy balance: one row an incident direction and channel, "theta_i", "phi_i"
 * (degrees), "channel", "rays", "reflected", "transmitted", "absorbed", "lost", "sum", "specularReflected",
 * "specularTransmitted" (shares of the light that arrives), each but the angles and rays with a column of its standard
 * error ("reflectedError"), "noise" (of the bins) and "converged". What these mean is in docs/simulation.md.
 *
 * With Progressive on there is one incident direction, the first, and an update adds RaysPerUpdate rays to those of the
 * updates before it, so that a lobe gets smoother while one looks; whatever changes the simulation starts anew. Each
 * update is asked for by Refine().
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFGonioreflectometer : public vtkBRDFAlgorithm
{
public:
  static vtkBRDFGonioreflectometer* New();
  vtkTypeMacro(vtkBRDFGonioreflectometer, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The table of the energy balance. */
  vtkTable* GetBalance();

  ///@{
  /** What the surface is made of, as "conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)"; of spheres the first facet is theirs,
   * the second the plane's; what is not given is as the last one. None: as the surface has them, mirrors unless it says
   * otherwise. */
  void AddFacet(const std::string& facet);
  void RemoveAllFacets();
  int GetNumberOfFacets() const { return static_cast<int>(this->Facets.size()); }
  std::string GetFacet(int index) const;
  ///@}
  /** For help: how facets are written, one line each. */
  static void GetFacetForms(vtkStringArray* forms);

  ///@{
  /** Incident polar angles, degrees, ascending, separated by commas; default "0,15,30,45,60,75". */
  vtkSetMacro(ThetaI, std::string);
  vtkGetMacro(ThetaI, std::string);
  ///@}

  ///@{
  /** Incident azimuths likewise: an anisotropic table. Empty (default): an isotropic one, the mean over azimuths. */
  vtkSetMacro(PhiI, std::string);
  vtkGetMacro(PhiI, std::string);
  ///@}

  ///@{
  /** Width of the outgoing bins, degrees, 0.05 to 45; default 5. */
  vtkSetMacro(Resolution, double);
  vtkGetMacro(Resolution, double);
  ///@}

  ///@{
  /** Bins: "spherical" (theta_o by azimuth, as wide as Resolution), "specular" or "retro" (about the mirror direction,
   * or the one back to the light, narrow where a pilot run finds peaks), or "auto" (default: whichever flattens peaks
   * least). */
  vtkSetMacro(Bins, std::string);
  vtkGetMacro(Bins, std::string);
  ///@}

  ///@{
  /** Rays are added to an incident direction until its standard error is at most this; default 0.05. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** What the tolerance is of: "bins" (default: root mean square error of the bins over their root mean square value)
   * or "albedo" (error of the share that is reflected or transmitted). */
  vtkSetMacro(ToleranceOf, std::string);
  vtkGetMacro(ToleranceOf, std::string);
  ///@}

  ///@{
  /** Most rays for an incident direction; default 16777216. */
  vtkSetClampMacro(MaximumRays, vtkIdType, 2, VTK_ID_MAX);
  vtkGetMacro(MaximumRays, vtkIdType);
  ///@}

  ///@{
  /** Facets that a ray may meet; what it still carries then is lost; default 1000. */
  vtkSetClampMacro(Bounces, int, 1, 1000000);
  vtkGetMacro(Bounces, int);
  ///@}

  ///@{
  /** The same seed gives the same table; default 1. */
  vtkSetClampMacro(Seed, int, 0, VTK_INT_MAX);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /** "cpu" (default; Embree, all threads) or "gpu" (OpenGL). */
  vtkSetMacro(Backend, std::string);
  vtkGetMacro(Backend, std::string);
  ///@}

  ///@{
  /** One incident direction, refined by each update; default off. */
  vtkSetMacro(Progressive, bool);
  vtkGetMacro(Progressive, bool);
  vtkBooleanMacro(Progressive, bool);
  ///@}

  ///@{
  /** Rays that an update adds when progressive; default 65536. */
  vtkSetClampMacro(RaysPerUpdate, vtkIdType, 2, 1 << 28);
  vtkGetMacro(RaysPerUpdate, vtkIdType);
  ///@}

  /** Asks the next update for more rays. False when the present lobe has reached the tolerance or the most rays. */
  bool Refine();

protected:
  vtkBRDFGonioreflectometer();
  ~vtkBRDFGonioreflectometer() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkBRDFGonioreflectometer(const vtkBRDFGonioreflectometer&) = delete;
  void operator=(const vtkBRDFGonioreflectometer&) = delete;

  struct Session; // of a progressive simulation
  void Advance(const brdf::Microsurface& surface,
               const std::shared_ptr<const brdf::MadeSurface>& source,
               const brdf::LayoutRequest& request,
               const brdf::GonioreflectometerOptions& options,
               brdf::GonioreflectometerResult& result,
               brdf::LayoutChoice& choice);

  std::vector<std::string> Facets;
  std::string ThetaI = "0,15,30,45,60,75", PhiI, Bins = "auto", ToleranceOf = "bins", Backend = "cpu";
  double Resolution = 5, Tolerance = 0.05;
  vtkIdType MaximumRays = 1 << 24, RaysPerUpdate = 1 << 16;
  int Bounces = 1000, Seed = 1;
  bool Progressive = false;
  std::unique_ptr<Session> Current;
};
#endif
