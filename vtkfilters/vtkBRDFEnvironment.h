#ifndef vtkBRDFEnvironment_h
#define vtkBRDFEnvironment_h
#include "vtkBRDFFiltersModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
namespace brdf
{
class EnvironmentMap;
}

/**
 * @class vtkBRDFEnvironment
 * @brief Light from far away, ready for vtkBRDFPolyDataMapper
 *
 * Holds an equirectangular map of radiance (linear sRGB) and, made when first asked for, an octahedral map with levels
 * (brdf::OctahedralMap) and the light that a white Lambertian reflects; their textures belong to the render window that
 * drew last. Orientation: the vertical is world
 * +y, the middle of the picture -z, columns run to the right (+x) as seen from inside (brdf::EnvironmentMap).
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFEnvironment : public vtkObject
{
public:
  static vtkBRDFEnvironment* New();
  vtkTypeMacro(vtkBRDFEnvironment, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Reads an OpenEXR or Radiance file. False, with the reason in GetErrorText(), when it cannot; the map is then as it
   * was. */
  bool ReadFile(const std::string& path);
  /** The same for a light probe in Debevec's angular map: see brdf::EnvironmentMap::Mapping. */
  bool ReadAngularFile(const std::string& path);
  /** The same radiance from everywhere. The default is 1, 1, 1. */
  void SetConstant(double red, double green, double blue);
  /** Why the last ReadFile failed, in one line; empty when it succeeded. */
  std::string GetErrorText() const { return this->ErrorText; }

  ///@{
  /** Degrees by which the surroundings are turned about +y, counter-clockwise seen from above; default 0. Costs
   * nothing. */
  vtkSetMacro(Rotation, double);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /** Largest number of texels along a side of the octahedral map (a power of two at or below is taken); default 2048.
   * n texels resolve 260 / n degrees and take 32 n^2 bytes on the device. */
  void SetMaximumMapSize(int size);
  vtkGetMacro(MaximumMapSize, int);
  ///@}

  ///@{
  /** Size of the map, in pixels. */
  int GetMapWidth() const;
  int GetMapHeight() const;
  ///@}

  /** Radiance (linear RGB) seen in a world direction, rotation included. */
  void GetRadiance(const double direction[3], double rgb[3]) const;
  /** Irradiance on a surface whose normal is a world direction, rotation included: exact sum over the map. */
  void GetIrradiance(const double normal[3], double rgb[3]) const;

  /** Texels along a side of the finest level of the octahedral map. */
  int GetMapSize() const;

#ifndef __VTK_WRAP__
  ///@{
  /** The map itself, with a factor on its radiance. */
  void SetMap(const brdf::EnvironmentMap& map, double scale = 1);
  const brdf::EnvironmentMap& GetMap() const;
  ///@}

  /** Makes the maps and their textures for a window, whose context is current, where they are missing. With
   * `unfiltered` also the map itself with its own density (16 bytes a pixel of the file). Throws brdf::Error. */
  void UpdateTextures(vtkOpenGLRenderWindow* window, bool unfiltered = false);

  ///@{
  /** Binds the textures and gives them to the uniforms of brdf_map.glsl, brdf_environment.glsl and brdf_light.glsl,
   * until DeactivateTextures. */
  void ActivateTextures();
  void SetUniforms(vtkShaderProgram* program);
  void DeactivateTextures();
  ///@}
#endif

  /** Frees what a window's device holds of the maps. Windows do it by themselves when they close; mappers do not, since
   * others may light with the same environment. */
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkBRDFEnvironment();
  ~vtkBRDFEnvironment() override;

private:
  vtkBRDFEnvironment(const vtkBRDFEnvironment&) = delete;
  void operator=(const vtkBRDFEnvironment&) = delete;

  class Internals;
  bool Read(const std::string& path, bool angular);

  std::unique_ptr<Internals> Data;
  std::string ErrorText;
  double Rotation = 0;
  int MaximumMapSize = 2048;
};
#endif
