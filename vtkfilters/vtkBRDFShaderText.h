#ifndef vtkBRDFShaderText_h
#define vtkBRDFShaderText_h
#include <brdf/material/LobeSum.h>

#include <string>
#include <string_view>
#include <vector>

// Text and numbers of the shader that draws a sum of lobes. Pure text: knows neither VTK nor OpenGL.
//
// The sum is written as terms: a lobe whose shape the channels share is one term; a channel-dependent lobe is one term
// a channel, which colours that channel only. Text() depends on the models and their order alone (Structure()), so that
// changing a parameter or a scale changes numbers and never compiles.
//
// For every term N, from 0, the text holds
//   vec3  brdfTermN_value(vec3 wi, vec3 wo)    the term with its scale by channel, 1/sr; 0 below the horizon
//   vec3  brdfTermN_sample(vec3 wo, vec2 u)    unit direction drawn from two numbers in [0, 1); a failed draw is 0
//   float brdfTermN_pdf(vec3 wi, vec3 wo)      density of the draw over solid angle, 1/sr
// in the local frame (normal +z, tangent +x). A constant term is drawn by the cosine.
class vtkBRDFShaderText
{
public:
  // Channels: monochrome (drawn grey) or RGB; throws brdf::Error for spectral ones.
  explicit vtkBRDFShaderText(const brdf::LobeSum& material);

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

  // Uniforms: brdfParameters (floats), brdfScales (3 floats a term), brdfSamples (1 integer a term), brdfShares (1
  // float a term).
  const std::vector<float>& Parameters() const { return this->ParameterValues; }
  const std::vector<float>& Scales() const { return this->ScaleValues; }
  // `samples` divided among the terms by their contribution, at least 8 for a term that reflects anything.
  std::vector<int> Samples(int samples) const;
  // Shares of the terms in the draws of unfiltered light: their contribution; sum 1, or 0 where nothing reflects.
  std::vector<float> Shares() const;

  int NumberOfTerms() const { return static_cast<int>(this->Terms.size()); }

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
    const brdf::Model* Model;
    std::size_t Offset; // of its first parameter
    double Weight;      // share of the samples
  };
  std::vector<Piece> Pieces(Environment environment) const;
  std::string TermText(std::size_t index) const;
  std::string ReflectedText(std::size_t index) const;
  std::string ValueText() const;
  std::string EnvironmentText() const;
  std::string MixtureText() const;

  std::vector<brdf::ModelPointer> Models; // distinct ones, in order of first use
  std::vector<Term> Terms;
  std::vector<float> ParameterValues;
  std::vector<float> ScaleValues;
  std::string StructureText;
};

#endif
