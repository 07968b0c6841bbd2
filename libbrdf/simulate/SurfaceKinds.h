#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/Image.h>
#include <brdf/simulate/Microsurface.h>
#include <brdf/simulate/SurfaceArguments.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// What a surface turned out to be where that is not what was asked for exactly, or tells its reader something: the
/// rms height and slope of a random surface, the rounded period of crossed grooves, the number of spheres placed.
struct SurfaceFact {
  std::string name;  ///< a few words: "rms slope along x"
  double value = 0;
  std::string unit;  ///< "1", "um", "deg"
};

struct MadeSurface {
  Microsurface surface;  ///< perfect mirror; `description` is the expression with all parameters
  std::vector<SurfaceFact> facts{};
};

using SurfaceShape = decltype(Microsurface::shape);

/// A surface of someone's own shape, with its facts. Throws what checking it does.
BRDF_EXPORT MadeSurface describedSurface(SurfaceShape shape, std::string description);

/// Gives a mesh the extent of its points as period along the axes where that is 0. Throws Error::Kind::Value, naming
/// `where`, for a mesh without points or extent.
BRDF_EXPORT void setMissingPeriods(TiledMesh& mesh, const std::string& where);

/// How files that a surface names are read. Without `mesh`, surfaces from meshes are Error::Kind::Value; without
/// `picture`, pictures are read by readImage (OpenEXR, Radiance).
struct SurfaceReaders {
  std::function<TiledMesh(const std::filesystem::path&)> mesh{};  ///< points and triangles; the periods are not used
  std::function<Image(const std::filesystem::path&)> picture{};   ///< linear values, rows from the top
};

/// A kind of microsurface: parameters, and how one is made of them. Lengths are micrometres, angles degrees.
struct SurfaceKind {
  std::string name;         ///< letters, digits, '_' and '-', beginning with a letter
  std::string title;        ///< a few words
  std::string description;  ///< what the surface is, in sentences
  std::vector<Parameter> parameters{};
  std::vector<TextParameter> texts{};
  std::vector<Reference> references{};  ///< where its formulas come from
  /// Makes shape, facts and, of more than one facet, facets. Throws brdf::Error; its messages begin with
  /// SurfaceArguments::where(). What it makes is checked (Microsurface::check).
  std::function<MadeSurface(const SurfaceArguments&, const SurfaceReaders&)> make{};
  bool builtIn = false;  ///< comes with BRDFLab; set by the registry
};

/// Adds a kind; replaces one of the same name. Throws Error::Kind::Value for a name that is none, and for a kind that
/// cannot be made.
BRDF_EXPORT void registerSurfaceKind(SurfaceKind kind);
/// All kinds, the built-in ones first.
BRDF_EXPORT const std::vector<SurfaceKind>& surfaceKinds();
/// Throws Error::Kind::Value, with the known names and the nearest.
BRDF_EXPORT const SurfaceKind& findSurfaceKind(std::string_view name);

/// The surface that an expression means: "grooves(width=4, spacing=20, angle=60)", "gaussian(rms=0.2, correlation=2)",
/// "heightfield(file=h.exr, depth=3)" (base/Call.h). Parameters that are not given have their defaults. Throws
/// Error::Kind::Formula or Value with the parameter at fault, and what reading a file throws.
BRDF_EXPORT MadeSurface makeSurface(std::string_view expression, const SurfaceReaders& readers = {});

}  // namespace brdf
