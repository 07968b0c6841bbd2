#ifndef vtkBRDFShaderText_h
#define vtkBRDFShaderText_h
#include "vtkBRDFFiltersModule.h" // For export macro

#include <brdf/material/LobeSum.h>
#include <brdf/sampling/DrawnTable.h>
#include <brdf/sampling/TabulatedSampler.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// Text and numbers of the shader that draws a material. Pure text: knows neither VTK nor OpenGL.
//
// A material is written as terms. Of a sum of lobes, a lobe whose shape the channels share is one term; a
// channel-dependent lobe is one term a channel, which colours that channel only. A table is one term, its values and
// importance tables in texture buffers. Text() depends on the models and their order, or on the layout of the table,
// alone (Structure()), so that changing a parameter or a scale changes numbers and never compiles.
//
// For every term N, from 0, the text holds
//   vec3  brdfTermN_value(vec3 wi, vec3 wo)    the term with its scale by channel, 1/sr; 0 below the horizon
//   vec3  brdfTermN_sample(vec3 wo, vec2 u)    unit direction drawn from two numbers in [0, 1); a failed draw is 0
//   float brdfTermN_pdf(vec3 wi, vec3 wo)      density of the draw over solid angle, 1/sr
// in the local frame (normal +z, tangent +x). A constant term is drawn by the cosine; a lobe whose record names no
// sampler, and a table, by importance tables made from their values (brdf::TabulatedSampler).
class VTKBRDFFILTERS_EXPORT vtkBRDFShaderText
{
public:
  // Channels: monochrome (drawn grey) or RGB; throws brdf::Error for spectral ones. Lobes that need importance tables
  // keep the kind of those of `before`, where it has the same models, so that the structure stays.
  // Lobes that could not be turned about the normal in `before` count as such for the same reason.
  explicit vtkBRDFShaderText(const brdf::LobeSum& material, const vtkBRDFShaderText* before = nullptr);

  vtkBRDFShaderText(const brdf::DrawnTable& table, const brdf::TabulatedSampler& sampler);

  // Same text for the same structure.
  const std::string& Structure() const { return this->StructureText; }

  // How light from an environment reaches the material.
  enum class Environment
  {
    None,
    Filtered,  // importance sampling of each term, the map filtered by the samples' solid angles
    Unfiltered // importance sampling of the terms and the map together, a few points of a long sequence
  };

  // GLSL of the whole material, for the place of the declarations. Every piece starts with its name in a comment and a
  // #line, whose source number counts the pieces from 0.
  std::string Text(Environment environment) const;

  // GLSL of the material alone, for a program of one's own: brdfValue(wi, wo) of all terms, brdfMaterialSample(wo, u)
  // and brdfMaterialPdf(wi, wo) of their mixture by brdfShares.
  std::string MaterialText() const;

  // Uniforms: brdfParameters (floats), brdfScales (3 floats a term), brdfSamples (1 integer a term), brdfShares (1
  // float a term).
  const std::vector<float>& Parameters() const { return this->ParameterValues; }
  const std::vector<float>& Scales() const { return this->ScaleValues; }
  // `samples` divided among the terms by their contribution, at least 8 for a term that reflects anything.
  std::vector<int> Samples(int samples) const;
  // Shares of the terms in the draws of unfiltered light: their contribution; sum 1, or 0 where nothing reflects.
  std::vector<float> Shares() const;

  // Texture buffers: the name of a samplerBuffer and its texels of four floats.
  struct Buffer
  {
    std::string Name;
    std::vector<float> Texels;
  };
  const std::vector<Buffer>& Buffers() const { return this->BufferValues; }
  // Uniform brdfSamplerShapes: 4 integers for each set of importance tables.
  const std::vector<int>& SamplerShapes() const { return this->SamplerShapeValues; }

  // Uniform brdfTableBase: brdf::DrawnTable::base in three channels; 0 for lobes.
  const std::array<float, 3>& TableBase() const { return this->TableBaseValues; }

  // Whether some term changes when it is turned about the normal.
  bool NeedsTangents() const;

  int NumberOfTerms() const { return static_cast<int>(this->Terms.size()); }

  // Terms whose filtered light is summed by draws made in advance (brdf::ViewerDraws): what is to be drawn, null for
  // the other terms. The text reads them from the usamplerBuffer brdfDraws; uniforms brdfDrawShapes, 2 integers a term,
  // the first texel and the number of sets, each of as many samples as brdfSamples says, and brdfDrawUnits,
  // ViewerDraws::unit of each term.
  std::vector<brdf::BrdfPointer> DrawnTerms() const;

  // Text of an embedded shader file.
  static std::string_view File(std::string_view name);

private:
  struct Piece
  {
    std::string Name;
    std::string Text;
  };
  struct Term
  {
    const brdf::Model* Model;  // null: a table
    std::size_t Offset;        // of its first parameter
    double Weight;             // share of the samples
    int Sampler = -1;          // number of its importance tables
    bool Turns = false;        // may be turned about the normal: filtered light on it is drawn in advance
    brdf::BrdfPointer Shape{}; // of a lobe that is, with a sampler
    bool Constant() const { return this->Model && this->Model->constant(); }
  };
  struct Sampler
  {
    brdf::TabulatedSampler::Kind Kind;
    bool Turning;
    int Search; // largest step of a search
  };
  int AddSampler(const brdf::TabulatedSampler& sampler, bool final, double base);
  void AddShape(Term& term, const brdf::Lobe& lobe, std::size_t channel, const vtkBRDFShaderText* before);
  std::string UniformText() const;
  std::string SamplerText(std::size_t index) const;
  std::vector<Piece> Pieces(Environment environment, bool draws) const;
  std::string TermText(std::size_t index, bool draws) const;
  std::string ReflectedText(std::size_t index) const;
  std::string DrawnText(std::size_t index) const;
  std::string ValueText() const;
  std::string EnvironmentText() const;
  std::string MixtureText() const;

  std::vector<brdf::ModelPointer> Models; // distinct ones, in order of first use
  std::vector<Term> Terms;
  std::vector<float> ParameterValues;
  std::vector<float> ScaleValues;
  std::vector<Sampler> Samplers;
  std::map<brdf::ModelPointer, brdf::TabulatedSampler::Kind> SamplerKinds; // of lobes
  std::set<brdf::ModelPointer> FixedModels;                                // of lobes that may not be turned
  std::vector<int> SamplerShapeValues;
  std::vector<Buffer> BufferValues;
  brdf::DrawnTable Table;
  std::string TableText; // its look-up
  std::array<float, 3> TableBaseValues{};
  std::string StructureText;
};

#endif
