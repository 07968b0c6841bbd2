#pragma once
#include <brdf/check/Check.h>
#include <brdf/color/ColourSettings.h>
#include <brdf/io/Image.h>
#include <brdf/measured/ReadOptions.h>
#include <brdf/render/Scene.h>
#include <brdf/simulate/SurfaceKinds.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The commands that draw: what they ask of the picture module (brdf_pictures), which links VTK and OpenGL. The program
/// loads it when a command needs it, because VTK's libraries take longer to load than most commands take to run.
namespace brdf::app {

struct PictureSize {
  std::size_t width = 0, height = 0;
};
/// "900x700" as a size between 16 and 8192 a side, or throws Error::Kind::Usage.
PictureSize sizeOption(const std::string& text);

struct LobePicture {
  std::vector<std::string> materials;
  std::vector<std::string> names;  ///< of the materials, in the legend; empty: as they are written
  std::string title;               ///< empty: the picture's own
  ReadOptions assumptions;
  double thetaI = 45, phiI = 0;  ///< degrees
  std::string transform = "none";
  double floor = 1e-3;  ///< of the transform "logfloor", 1/sr
  std::string channel = "luminance";
  std::string colour = "auto";
  std::string layout = "overlay";
  std::string difference = "none";  ///< "lobe" or "displaced": of two materials
  bool samples = false;             ///< measured points
  double within = 2;                ///< degrees from the light, of those
  std::size_t subdivision = 5;
  double tolerance = 1e-3;
  ColourNames colours;
  PictureSize size;
  std::vector<std::string> out;  ///< .png: the picture; .vtp, .ply, .obj, .stl: the mesh of the only lobe
};
struct LobeResult {
  std::vector<double> largest;  ///< length of each lobe drawn; of a difference the one
  std::vector<double> chordError;
  std::vector<std::size_t> triangles;
};

struct ErrorPicture {
  std::string a, b;
  std::string nameA, nameB;  ///< on the picture; empty: as they are written
  ReadOptions assumptions;
  std::string measure = "absolute";
  std::string average = "automatic";
  std::string axes = "theta_i,theta_o";
  double thetaI = 45, phiI = 0;  ///< degrees, of the hemisphere
  std::string projection = "equal-area";
  std::string directions = "automatic";
  double within = 2.5;  ///< degrees from the light, of samples on the hemisphere
  std::string channel = "luminance";
  ColourNames colours;
  std::size_t resolution = 0;  ///< intervals along each axis; 0: chosen by the number of samples
  std::size_t worst = 10, bins = 60;
  PictureSize size;
  std::vector<std::string> out;        ///< .png, .svg, .pdf: the picture; .vti, .exr, .csv: the numbers
  std::vector<std::string> histogram;  ///< .png, .svg, .pdf: the picture; .csv: the numbers
  std::string worstOut;                ///< .csv, or empty
};
struct ErrorResult {
  struct Worst {
    double error = 0, thetaI = 0, phiI = 0, thetaO = 0, phiO = 0;  ///< degrees
    std::vector<double> a, b;                                      ///< by channel, 1/sr
  };
  double mean = 0, largest = 0;
  std::size_t count = 0, pairs = 0, leftOut = 0;
  std::string label, pairLabel, sampling;
  std::vector<double> channels;                      ///< the mean of each
  std::vector<std::pair<double, double>> quantiles;  ///< share, error
  std::vector<Worst> worst;
};

/// Slices, plots, hole maps and volumes: what the options of `brdf slice` say. Angles in degrees.
struct SlicePicture {
  std::string kind = "image";
  std::vector<std::string> materials;
  std::vector<std::string> names;  ///< of the materials, in the picture; empty: as they are written
  std::string title;               ///< empty: the picture's own
  ReadOptions assumptions;
  std::string axes;  ///< of an image or a hole map; empty: the usual ones
  std::string over = "theta_o";
  double thetaI = 45, phiI = 0, thetaO = 45, phi = 180, thetaH = 0, phiH = 0, thetaD = 0, phiD = 90;
  std::vector<std::array<double, 4>> directions;  ///< theta_i, phi_i, theta_o, phi_o of a plot over the wavelength
  std::string channel = "luminance";
  ColourNames colours;
  std::string quantity = "f";
  std::string scale;          ///< empty: the kind's own
  double decades = 0;         ///< 0: the kind's own
  std::vector<double> range;  ///< of an image's colours; empty: chosen
  double warp = 1;
  double exposure = 0;         ///< stops
  double within = 0.5;         ///< degrees: samples nearer to a curve are shown
  std::size_t resolution = 0;  ///< cells or intervals along each axis; 0: the kind's own
  std::size_t points = 2048;   ///< of the quadrature of an albedo
  PictureSize size;
  std::vector<std::string> out;
};
struct SliceResult {
  struct Axis {
    std::string name, unit;
    double from = 0, to = 0;
    std::size_t count = 0;
  };
  struct Series {
    std::string material, channel;
    std::vector<std::string> channels{};
    double smallest = 0, largest = 0;                           ///< of the values that there are
    std::vector<std::pair<std::string, std::size_t>> counts{};  ///< points, cells or samples, by what they are
    std::vector<double> albedo{}, albedoError{};                ///< bihemispherical
    double largestError = 0;                                    ///< of the directional albedo
  };
  std::string quantity;  ///< what was sampled, with its unit
  std::string fixed;     ///< the angles that stay
  std::vector<Axis> axes;
  std::vector<Series> series;
};

/// How a scene becomes pictures.
/// Drawing without filtering until the noise is small enough, on the graphics device: vtkBRDFRender's converging mode.
struct ConvergeOptions {
  double tolerance = 0.01;     ///< as ReferenceOptions::tolerance
  std::size_t samples = 4096;  ///< a pixel, at most
  /// As ReferenceOptions::progress, called after every frame; the error is infinite before the first round of frames.
  std::function<bool(std::size_t done, std::size_t most, double error)> progress;
};
struct RenderPicture {
  std::optional<ConvergeOptions> converge;  ///< empty: filtered, with `samples`
  ColourNames colours;
  std::size_t samples = 64;        ///< of the environment, a pixel
  std::string shadows = "all";     ///< or "lights", "none"
  std::string shadowCells = "16";  ///< of the environment, a side
  double exposure = 0;             ///< stops
  std::string toneCurve = "clamp";
  std::vector<std::string> out;  ///< .png: tone-mapped sRGB; .exr: linear radiance
};
struct RenderedFrame {
  Image radiance;  ///< linear sRGB; over no background with alpha
  std::string device;
  Image standardError;          ///< of each number of `radiance` without alpha; this and the rest where it converges
  std::size_t samples = 0;      ///< drawn a pixel
  double relativeError = 0;     ///< as the tolerance means it
  bool converged = false;       ///< relativeError <= tolerance
  bool stopped = false;         ///< by the progress function
  std::string tables;           ///< layouts of the tables drawn, a line each
  double resamplingError = -1;  ///< largest relative error of tables made for drawing (brdf::DrawnTable); -1: none
};
/// Draws one scene after another on the graphics device, keeping shaders and maps; one thread at a time.
using FrameDrawer = std::function<RenderedFrame(const Scene&, const RenderPicture&)>;

/// One material's directional albedo over the angle of the light.
struct AlbedoCurves {
  std::vector<std::string> channels;        ///< names
  std::vector<double> degrees;              ///< of the light
  std::vector<std::vector<double>> values;  ///< by channel, one an angle
};
struct AuditPicture {
  std::vector<Audit> audits;
  AlbedoCurves albedo;  ///< of the only material; empty for several
  PictureSize size;
  std::string out;  ///< .png
};

/// Numbers of several series in several groups, as dots on logarithmic axes.
struct DotPlotPicture {
  std::string title, note;
  std::vector<std::string> groups, series;  ///< of each dot
  /// Title of a panel and its numbers, one a dot; not a number: no dot.
  std::vector<std::pair<std::string, std::vector<double>>> panels;
  PictureSize size;
  std::string out;  ///< .png
};

/// Rendered pictures beside each other.
struct MontagePicture {
  struct Item {
    Image radiance;  ///< linear, three channels; 1 is white
    std::string caption;
  };
  std::string title, note;
  std::vector<Item> pictures;
  std::size_t columns = 1;
  PictureSize size;
  std::string out;  ///< .png
};

/// A microsurface.
struct SurfacePicture {
  std::shared_ptr<const MadeSurface> surface;
  std::string title;                                      ///< empty: the picture's own
  std::size_t tiles = 1;                                  ///< along x and y
  double azimuth = 25, elevation = 40, exaggeration = 0;  ///< degrees; see vtkBRDFMicrosurfaceView
  PictureSize size;
  std::vector<std::string> out;  ///< .png: the picture; .vtp, .ply, .obj, .stl: the mesh; .vti: the heights
};

/// Curves over one axis.
struct CurvesPicture {
  struct Curve {
    std::string name;
    std::vector<double> x, y;
  };
  std::string title, note, xTitle, yTitle;
  std::string scale = "linear";  ///< of y, see vtkBRDFPlotView
  double decades = 6;            ///< of a logarithmic scale at most
  std::vector<Curve> curves;
  PictureSize size;
  std::string out;  ///< .png, .svg, .pdf
};

/// What the module offers; found there under the name `brdfPictures`.
struct PictureFunctions {
  LobeResult (*lobe)(const LobePicture&);
  ErrorResult (*error)(const ErrorPicture&);
  SliceResult (*slice)(const SlicePicture&);
  /// Throws Error::Kind::Device when there is no headless OpenGL.
  FrameDrawer (*frameDrawer)();
  void (*audit)(const AuditPicture&);
  void (*dotPlot)(const DotPlotPicture&);
  void (*montage)(const MontagePicture&);
  void (*surface)(const SurfacePicture&);
  void (*curves)(const CurvesPicture&);
  /// How files that a microsurface names are read: vtkBRDFMicrosurfaceData.
  SurfaceReaders (*surfaceReaders)();
  /// A shape by name, or a mesh from a file, with normals and tangents: see vtkBRDFObjectSource.
  TriangleMesh (*makeObject)(const std::string& object);
  /// Linear radiance from an OpenEXR, Radiance, PNG or JPEG file; the last two are taken for sRGB.
  Image (*readPicture)(const std::string& path);
  /// Linear radiance (three channels, or four with alpha) as the .png that `request` asks for, without its other
  /// wishes.
  void (*writePng)(const Image& radiance, const RenderPicture& request, const std::string& path);
  /// How far the layout of one PNG is from another's: the share of the picture that differs, 0 to 1
  /// (vtkImageDifference: pixels that differ wholly count 1, others in proportion; small differences and shifts by a
  /// pixel do not count). Writes the differences as a PNG where a path is given.
  double (*layoutDifference)(const std::string& found, const std::string& baseline, const std::string& differences);
  /// Throws Error::Kind::Device when there is no headless OpenGL. The runner is for one thread at a time.
  GlslRunner (*shaderProbe)();
};

/// Loads the module on the first call. Throws Error::Kind::Device when it is not there.
const PictureFunctions& pictures();

/// The surface that an expression means, with files read by the module. Throws what makeSurface does.
MadeSurface surfaceOption(const std::string& expression);

/// Throws Error::Kind::Usage unless `path` ends with one of `extensions`, and as checkWritable does.
void checkPictureOutputs(const std::vector<std::string>& paths, const std::vector<std::string>& extensions);

}  // namespace brdf::app
