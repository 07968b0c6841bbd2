// How far the shaders' environment light is from the truth: docs/rendering-accuracy.md. No timing; minutes to run.
//
//   render_study convergence > convergence.csv   error of converging mode against the number of samples
//   render_study bias > bias.csv                 bias and noise of interactive mode against roughness
//   render_study hundred > hundred.csv           the same at 100 samples of lobes and tables
//   render_study material FILE|EXPRESSION...     the same at 64, 256 and 1024 samples of any material
#include <brdf/base/Error.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/EnvironmentMap.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/sampling/DrawnTable.h>

#include <vtkBRDF.h>
#include <vtkBRDFEnvironment.h>
#include <vtkBRDFRender.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

namespace {

brdf::EnvironmentMap mapOf(const std::string& name) {
  if (name == "even") return brdf::EnvironmentMap::constant({1, 1, 1});
  if (name == "one texel") {
    // Radiance 1000 in one texel of 11 degrees, 0.1 in the rest of the upper half.
    brdf::Image picture(32, 16, 3);
    for (std::size_t y = 0; y < 8; ++y)
      for (std::size_t x = 0; x < 32; ++x) std::fill_n(picture.pixel(x, y), 3, 0.1f);
    std::fill_n(picture.pixel(20, 4), 3, 1000.0f);
    return brdf::EnvironmentMap(picture);
  }
  return brdf::EnvironmentMap::read(std::string(BRDF_SOURCE_DIR) + "/datasets/environments/" + name + ".exr");
}

/// A pixel whose centre sees the unit sphere at less than 80 degrees, and the frame there in world coordinates.
struct Place {
  int x, y;
  brdf::Direction normal, tangent, bitangent, viewer;
  brdf::Direction local(const brdf::Direction& d) const {
    return {brdf::dot(d, tangent), brdf::dot(d, bitangent), brdf::dot(d, normal)};
  }
};

std::vector<Place> placesSeen(int size) {
  // The camera stands on +z at 1.08 / sin 15 degrees and looks at the middle.
  const double distance = 1.08 / std::sin(brdf::radians(15)), extent = std::tan(brdf::radians(15));
  std::vector<Place> places;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double s = extent * (2 * (x + 0.5) / size - 1), t = extent * (2 * (y + 0.5) / size - 1);
      const brdf::Direction ray = brdf::normalized({s, t, -1});
      const double root = std::pow(distance * ray[2], 2) - distance * distance + 1;
      if (root < 0) continue;
      const double length = -distance * ray[2] - std::sqrt(root);
      Place place{x, y, {length * ray[0], length * ray[1], distance + length * ray[2]}, {}, {}, {}};
      place.viewer = {-ray[0], -ray[1], -ray[2]};
      if (brdf::dot(place.viewer, place.normal) <= std::cos(brdf::radians(80))) continue;
      place.tangent = brdf::normalized(brdf::cross({0, 1, 0}, place.normal));
      place.bitangent = brdf::cross(place.normal, place.tangent);
      places.push_back(place);
    }
  return places;
}

/// A sphere under a map, its pixels' centres only.
class Subject {
 public:
  explicit Subject(const std::string& map, int size = 16) : size_(size) {
    environment_->SetMap(mapOf(map));
    render_->SetEnvironment(environment_);
    render_->SetBackground(vtkBRDFRender::BACKGROUND_COLOR);
    render_->SetSize(size, size);
    render_->SetEdgeSamples(1);
    render_->SetTolerance(0);
  }
  vtkBRDFRender* operator->() { return render_; }
  void setMaterial(const std::string& expression) { setMaterial(brdf::parseMaterialExpression(expression)); }
  void setMaterial(const brdf::BrdfPointer& material) {
    vtkNew<vtkBRDF> input;
    input->SetBrdf(material);
    render_->SetInputData(input);
  }
  /// Green of the pixels whose centres see the sphere at less than 80 degrees.
  std::vector<double> draw() {
    if (!render_->UpdateAndCheck()) throw brdf::Error(brdf::Error::Kind::Device, {render_->GetPipelineErrorText()});
    return inside(render_->GetOutput());
  }
  std::vector<double> standardError() { return inside(render_->GetStandardError()); }

 private:
  std::vector<double> inside(vtkImageData* image) const {
    std::vector<double> values;
    for (const Place& place : placesSeen(size_))
      values.push_back(double(static_cast<const float*>(image->GetScalarPointer(place.x, place.y, 0))[1]));
    return values;
  }

  int size_;
  vtkNew<vtkBRDFRender> render_;
  vtkNew<vtkBRDFEnvironment> environment_;
};

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / double(values.size()));
}

/// The standard error of replicates of n points each is the error of n points over the root of their number.
void convergence() {
  std::printf("map,material,sequence,n,error\n");
  for (const char* material : {"0.2*Lambertian + GGX(alpha=0.3, ior=1.5)", "GGXConductor(alpha=0.1)"})
    for (const char* map : {"venice", "sunset", "one texel"})
      for (const int sequence : {vtkBRDFRender::SEQUENCE_RANDOM, vtkBRDFRender::SEQUENCE_LOW_DISCREPANCY}) {
        Subject subject(map, 8);
        subject->SetMode(vtkBRDFRender::MODE_CONVERGING);
        subject->SetSequence(sequence);
        subject.setMaterial(material);
        for (int doubled = 0; doubled <= 12; ++doubled) {
          const int n = 1 << doubled;
          subject->SetMaximumSamples(8 * n);
          subject->SetSeed(doubled);
          const double picture = rms(subject.draw()), error = std::sqrt(8.0) * rms(subject.standardError());
          std::printf("%s,\"%s\",%s,%d,%.6g\n", map, material,
                      sequence == vtkBRDFRender::SEQUENCE_RANDOM ? "random" : "low-discrepancy", n, error / picture);
          std::fflush(stdout);
        }
      }
}

/// The converged picture and the root mean square of its standard error.
struct Truth {
  explicit Truth(Subject& subject) {
    subject->SetMode(vtkBRDFRender::MODE_CONVERGING);
    subject->SetTolerance(0.002);
    subject->SetMaximumSamples(8192);
    subject->SetSeed(0);
    picture = subject.draw();
    doubt = rms(subject.standardError());
  }
  std::vector<double> picture;
  double doubt;
};

/// Interactive mode drawn with many seeds: the mean's distance from the converged picture is the bias, the scatter
/// about the mean the noise. "bias,noise,bias_error".
std::string errors(Subject& subject, const Truth& truth, int samples) {
  constexpr int seeds = 64;
  const std::size_t count = truth.picture.size();
  subject->SetMode(vtkBRDFRender::MODE_INTERACTIVE);
  subject->SetNumberOfSamples(samples);
  std::vector<double> sum(count), squares(count);
  for (int seed = 0; seed < seeds; ++seed) {
    subject->SetSeed(seed);
    const auto drawn = subject.draw();
    for (std::size_t i = 0; i < count; ++i) {
      sum[i] += drawn[i];
      squares[i] += drawn[i] * drawn[i];
    }
  }
  double off = 0, scatter = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double mean = sum[i] / seeds;
    off += std::pow(mean - truth.picture[i], 2) / double(count);
    scatter += std::max(0.0, squares[i] / seeds - mean * mean) * seeds / (seeds - 1.0) / double(count);
  }
  // What the scatter and the truth's own noise leave in the distance is taken off.
  const double left = scatter / seeds + truth.doubt * truth.doubt, whole = rms(truth.picture);
  char text[100];
  std::snprintf(text, sizeof text, "%.6g,%.6g,%.6g", std::sqrt(std::max(0.0, off - left)) / whole,
                std::sqrt(scatter) / whole, std::sqrt(left) / whole);
  return text;
}

void bias() {
  std::printf("map,alpha,samples,level_bias,bias,noise,bias_error\n");
  for (const char* map : {"studio", "venice", "sunset", "one texel"}) {
    Subject subject(map);
    for (const char* alpha : {"0.02", "0.05", "0.1", "0.2", "0.4", "0.8"}) {
      subject.setMaterial("GGXConductor(alpha=" + std::string(alpha) + ")");
      const Truth truth(subject);
      for (const int samples : {16, 64, 256}) {
        std::printf("%s,%s,%d,0,%s\n", map, alpha, samples, errors(subject, truth, samples).c_str());
        std::fflush(stdout);
      }
    }
  }
}

void hundred() {
  std::printf("map,material,bias,noise,bias_error\n");
  for (const char* map : {"studio", "venice", "sunset"}) {
    Subject subject(map);
    for (const char* text :
         {"(0.3,0.2,0.1)*Lambertian + 0.5*GGX(alpha=0.2)", "GGXConductor(alpha=0.05)", "GGXConductor(alpha=0.4)",
          "0.2*Lambertian + 0.5*Ward(ax=0.1, ay=0.4)", "OrenNayar(sigma=0.5) + Lafortune(Cx=1, Cy=1, Cz=1, n=20)"})
      for (const bool table : {false, true}) {
        const brdf::BrdfPointer lobes = brdf::parseMaterialExpression(text);
        if (table && lobes->symmetry() == brdf::Symmetry::Anisotropic) continue;
        subject.setMaterial(table ? brdf::BrdfPointer(brdf::TableBrdf::tabulate(*lobes)) : lobes);
        const Truth truth(subject);
        std::printf("%s,\"%s%s\",%s\n", map, table ? "table of " : "", text, errors(subject, truth, 100).c_str());
        std::fflush(stdout);
      }
  }
}

/// Noise of one independent draw without filtering, root mean square over the sphere relative to the picture's, by sums
/// over all texels: with the density of the tables that a material which is no sum of lobes is drawn by, and with the
/// best one that does not know the map, in exact proportion to the value times the cosine.
struct DrawNoise {
  double tables, best;
};
DrawNoise drawNoise(const brdf::BrdfPointer& material, const brdf::EnvironmentMap& map) {
  const brdf::DrawnTable table = brdf::drawnTable(brdf::reducedToRgb(material));
  const brdf::BrdfPointer above = brdf::aboveBase(table);
  const std::size_t channels = above->channels().count(), green = channels == 1 ? 0 : 1;
  double square = 0, tables = 0, best = 0;
  brdf::DirectionPairBuffer<double> pairs;
  std::vector<double> light, weights, values, density;
  for (const Place& place : placesSeen(16)) {
    pairs.resize(0);
    light.clear();
    weights.clear();
    for (std::size_t y = 0; y < map.height(); ++y)
      for (std::size_t x = 0; x < map.width(); ++x) {
        const brdf::Direction wi = place.local(map.direction(x, y));
        if (wi[2] <= 0) continue;
        pairs.push(wi, place.local(place.viewer));
        light.push_back(double(map.picture().pixel(x, y)[1]));
        weights.push_back(map.solidAngle(y));
      }
    values.resize(channels * pairs.size());
    density.resize(pairs.size());
    above->evaluateParallel(pairs.view(), values.data(), nullptr);
    above->pdf(pairs.view(), density.data());
    double mean = 0, base = 0, albedo = 0, drawn = 0, proportional = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double f = values[green * pairs.size() + i] * pairs.wi[2][i];
      mean += f * light[i] * weights[i];
      base += table.base[green] * pairs.wi[2][i] * light[i] * weights[i];
      albedo += std::abs(f) * weights[i];
      if (density[i] > 0) drawn += f * f * light[i] * light[i] / density[i] * weights[i];
      proportional += std::abs(f) * light[i] * light[i] * weights[i];
    }
    square += std::pow(mean + base, 2);
    tables += drawn - mean * mean;
    best += proportional * albedo - mean * mean;
  }
  return {std::sqrt(tables / square), std::sqrt(best / square)};
}

/// Also in a white furnace, where only the draws of the material make noise: none of it is the map's.
void materials(std::span<char*> words) {
  std::printf("map,material,samples,bias,noise,bias_error,independent_draws,best_draws\n");
  for (const char* word : words) {
    const brdf::BrdfPointer material = brdf::loadMaterial(word).brdf;
    for (const char* map : {"even", "venice", "sunset", "studio"}) {
      Subject subject(map);
      subject.setMaterial(material);
      const Truth truth(subject);
      const DrawNoise draws = drawNoise(material, mapOf(map));
      for (const int samples : {64, 256, 1024}) {
        std::printf("%s,\"%s\",%d,%s,%.4g,%.4g\n", map, word, samples, errors(subject, truth, samples).c_str(),
                    draws.tables / std::sqrt(samples), draws.best / std::sqrt(samples));
        std::fflush(stdout);
      }
    }
  }
}

}  // namespace

int main(int count, char** words) try {
  const std::string what = count == 2 || (count > 2 && words[1] == std::string("material")) ? words[1] : "";
  if (what == "convergence")
    convergence();
  else if (what == "bias")
    bias();
  else if (what == "hundred")
    hundred();
  else if (what == "material")
    materials(std::span(words + 2, words + count));
  else
    throw brdf::Error(brdf::Error::Kind::Usage, {"what to study", "render_study", "'" + what + "'",
                                                 "convergence, bias, hundred, material FILE|EXPRESSION..."});
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "render_study: %s\n", error.what());
  return 1;
}
