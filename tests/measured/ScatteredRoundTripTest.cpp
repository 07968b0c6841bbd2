// What holds for every format of scattered samples: a round trip within the format's precision, line ends and marks
// that editors leave, and damage of every kind.
#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <random>

#include "MeasuredSupport.h"

namespace {

using brdf::Channels;
using brdf::Direction;
using brdf::dot;
using brdf::ScatteredSamples;
using measuredtest::dataOf;
namespace fs = std::filesystem;

struct Precision {
  const char* format;
  double direction;    ///< of a cosine
  double value;        ///< relative
  bool keepsSymmetry;  ///< isotropic or not survives
  bool keepsUncertainty;
};

// Text has the shortest decimals that read back exactly; what is left are the roundings of angles and of colour
// matrices.
const Precision kFormats[] = {{"csv", 0, 0, true, true},
                              {"cornell", 1e-15, 0, false, false},
                              {"alta", 1e-15, 0, true, true},
                              {"alta-binary", 1e-15, 0, true, false},
                              {"astm", 1e-15, 0, true, false},
                              {"pab", 1e-15, 1e-14, true, false},
                              {"bird", 1e-15, 0, true, true},
                              {"brdflab-text", 1e-15, 1e-14, true, false},
                              {"brdflab-export", 1e-15, 1e-14, false, false}};

Direction at(const std::array<std::vector<double>, 3>& w, std::size_t i) { return {w[0][i], w[1][i], w[2][i]}; }

/// Samples of one or a few incidences with distinct values.
ScatteredSamples made(Channels channels, bool isotropic, std::size_t incidences) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  ScatteredSamples samples;
  samples.channels = std::move(channels);
  samples.isotropic = isotropic;
  for (std::size_t k = 0; k < incidences; ++k) {
    const Direction wi =
        brdf::fromSpherical(0.2 + 0.3 * static_cast<double>(k), isotropic ? 0.5 : 0.5 + static_cast<double>(k));
    for (int i = 0; i < 20; ++i)
      samples.pairs.push(wi, brdf::fromSpherical(1.4 * uniform(engine), 6 * uniform(engine)));
  }
  samples.values.resize(samples.channels.count() * samples.pairs.size());
  for (double& value : samples.values) value = 0.05 * std::exp(uniform(engine));  // nothing that the linter would name
  samples.uncertainty = samples.values;
  for (double& value : samples.uncertainty) value *= 0.01;
  return samples;
}

/// The channels that a format can hold, and its files.
Channels fitting(const std::string& format) {
  if (format == "brdflab-text") return Channels::rgb();
  if (format == "brdflab-export") return Channels::monochrome();
  return Channels::spectral({450, 550, 650.5});
}

brdf::ReadResult readBytes(const fs::path& path, const std::string& bytes) {
  brdf::writeFile(path, bytes);
  return brdf::readMeasured(path);
}

std::vector<fs::path> handWritten() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(BRDF_SOURCE_DIR) / "tests/data"))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

bool isText(const std::string& bytes) { return bytes.find('\0') == std::string::npos; }

}  // namespace

TEST(RoundTrip, EveryFormatKeepsWhatItCan) {
  const auto dir = measuredtest::folder("round_trip");
  for (const Precision& precision : kFormats)
    for (const bool isotropic : {true, false}) {
      const std::string format = precision.format;
      const brdf::ScatteredBrdf written(made(fitting(format), isotropic, format == "pab" ? 1 : 3), "made");
      const auto report = brdf::writeMeasured(written, dir / format, format);
      const auto result = brdf::readMeasured(dir / format);
      EXPECT_EQ(result.report.format, format);
      EXPECT_TRUE(result.report.warnings.empty()) << format << ": " << result.report.warnings.front();
      const auto &before = written.data(), &after = dataOf(result);
      ASSERT_EQ(after.pairs.size(), before.pairs.size()) << format;
      ASSERT_EQ(after.channels, before.channels) << format;
      if (precision.keepsSymmetry && format != "pab") {
        EXPECT_EQ(after.isotropic, isotropic) << format;
      }
      for (std::size_t i = 0; i < before.pairs.size(); ++i) {
        const Direction wi = at(before.pairs.wi, i), wo = at(before.pairs.wo, i);
        const Direction wi2 = at(after.pairs.wi, i), wo2 = at(after.pairs.wo, i);
        EXPECT_NEAR(wi2[2], wi[2], precision.direction) << format;
        EXPECT_NEAR(wo2[2], wo[2], precision.direction) << format;
        EXPECT_NEAR(dot(wi2, wo2), dot(wi, wo), 3 * precision.direction) << format;
        for (std::size_t axis = 0; axis < 3 && !isotropic; ++axis)
          EXPECT_NEAR(wo2[axis], wo[axis], 2 * precision.direction) << format;
      }
      for (std::size_t i = 0; i < before.values.size(); ++i)
        EXPECT_NEAR(after.values[i], before.values[i], precision.value * 0.2) << format;
      EXPECT_EQ(after.uncertainty, precision.keepsUncertainty ? before.uncertainty : std::vector<double>()) << format;
    }
}

TEST(RoundTrip, ColoursSurviveWhereTheFormatHasColours) {
  const auto dir = measuredtest::folder("round_trip_rgb");
  for (const char* format : {"csv", "alta", "alta-binary", "astm", "pab", "brdflab-text"}) {
    const brdf::ScatteredBrdf written(made(Channels::rgb(), true, 1), "made");
    brdf::writeMeasured(written, dir / format, format);
    const auto result = brdf::readMeasured(dir / format);
    ASSERT_EQ(dataOf(result).channels, Channels::rgb()) << format;
    for (std::size_t i = 0; i < written.data().values.size(); ++i)
      EXPECT_NEAR(dataOf(result).values[i], written.data().values[i], 1e-13 * 0.2) << format;
  }
}

TEST(RoundTrip, PabWritesAFolderOfIncidences) {
  const auto dir = measuredtest::folder("round_trip_folder");
  const brdf::ScatteredBrdf written(made(Channels::monochrome(), true, 3), "made");
  EXPECT_NE(measuredtest::errorOf([&] { brdf::writeMeasured(written, dir / "one.pab"); }).find("3 incidences"),
            std::string::npos);
  brdf::writeMeasured(written, dir / "several/", "pab");
  EXPECT_EQ(std::distance(fs::directory_iterator(dir / "several"), {}), 3);
  const auto result = brdf::readMeasured(dir / "several");
  EXPECT_EQ(dataOf(result).values, written.data().values);
  EXPECT_THROW(brdf::writeMeasured(written, dir / "several/", "pab"), brdf::Error) << "the folder is not empty";
  EXPECT_EQ(std::distance(fs::directory_iterator(dir), {}), 1) << "nothing is left behind";
}

TEST(TextFiles, LineEndsMarksAndAMissingLastNewlineDoNotMatter) {
  const auto dir = measuredtest::folder("line_ends");
  int tried = 0;
  for (const fs::path& file : handWritten()) {
    const std::string bytes = brdf::readFile(file);
    if (!isText(bytes)) continue;
    ++tried;
    std::string unix;
    for (const char c : bytes)
      if (c != '\r') unix += c;
    while (unix.ends_with('\n')) unix.pop_back();
    std::string dos = "\xEF\xBB\xBF";
    for (const char c : unix) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const auto plain = readBytes(dir / "a.txt", unix + "\n\n"), other = readBytes(dir / "b.txt", dos);
    EXPECT_EQ(other.report.format, plain.report.format) << file;
    if (dynamic_cast<const brdf::ScatteredBrdf*>(plain.brdf.get())) {
      EXPECT_EQ(dataOf(other).values, dataOf(plain).values) << file;
      EXPECT_EQ(dataOf(other).pairs.wo, dataOf(plain).pairs.wo) << file;
    } else {
      for (const double phi : {0.5, 2.0, 4.0, 6.0}) {
        const brdf::Direction wi = brdf::fromSpherical(0.8, phi), wo = brdf::fromSpherical(0.3, 3 * phi);
        EXPECT_EQ(other.brdf->evaluate(wi, wo), plain.brdf->evaluate(wi, wo)) << file;
      }
    }
    EXPECT_EQ(other.report.warnings, plain.report.warnings) << file;
  }
  EXPECT_GE(tried, 10);
}

TEST(TextFiles, NumbersBeyondDoubleAreInvalidSamplesNotErrors) {
  const auto dir = measuredtest::folder("numbers");
  const auto result = readBytes(dir / "a.astm",
                                "NUM_POINTS 4\nVARS theta_i,phi_i,theta_s,phi_s,Integrated\n"
                                "0.5,0,0.5,3,1e400\n0.5,0,0.5,3,nan\n0.5,0,0.5,3,-inf\n0.5,0,0.5,3,1e-400\n");
  EXPECT_EQ(result.report.notFinite, 3u);
  EXPECT_EQ(dataOf(result).valid, (std::vector<std::uint8_t>{0, 0, 0, 1}));
  EXPECT_EQ(dataOf(result).values[3], 0);
}

TEST(DamagedFiles, AreReadOrRefusedInOneLine) {
  const auto dir = measuredtest::folder("damaged");
  std::mt19937 engine(3);
  int refused = 0;
  const auto attempt = [&](const std::string& bytes, const fs::path& file) {
    try {
      for (const brdf::Format& format : brdf::allFormats())
        if (format.recognise(std::string_view(bytes).substr(0, 8192), bytes.size()) > 0) format.read(bytes, file, {});
    } catch (const brdf::Error& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  };
  for (const fs::path& file : handWritten()) {
    const std::string bytes = brdf::readFile(file);
    for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 100)
      attempt(bytes.substr(0, length), file);
    std::uniform_int_distribution<std::size_t> place(0, bytes.size() - 1), byte(0, 255);
    for (int i = 0; i < 200; ++i) {
      std::string changed = bytes;
      for (int k = 0; k < 1 + i % 4; ++k) changed[place(engine)] = static_cast<char>(byte(engine));
      attempt(changed, file);
    }
    attempt(bytes + bytes, file);
    attempt(bytes + std::string("\0\xff#{", 4), file);
  }
  EXPECT_GT(refused, 500);
}

TEST(DamagedFiles, WrongCountsAreNamed) {
  const auto dir = measuredtest::folder("wrong_counts");
  const struct {
    const char *text, *expected;
  } cases[] = {
      {"#DIM 3 1\n#PARAM_IN RUSIN_TH_TD\n#PARAM_OUT INV_STERADIAN\n0 0 0 1\n", "2 for RUSIN_TH_TD"},
      {"#DIM 2 1\n#PARAM_IN RUSIN_TH_TD\n#PARAM_OUT INV_STERADIAN\n0 0 1 1\n", "line 4: wrong number of columns"},
      {"#DIM 2 999999999\n#PARAM_IN RUSIN_TH_TD\n#PARAM_OUT INV_STERADIAN\n0 0 1\n", "from 1 to 10000"},
      {"#DIM 2 2\n#PARAM_IN RUSIN_TH_TD\n#PARAM_OUT INV_STERADIAN\n0 0 1 1\n", "no meaning"},
      {"#DIM 2 1\n#PARAM_IN RUSIN_TH_TD\n#PARAM_OUT LUMENS\n0 0 1\n", "unknown #PARAM_OUT"},
      {"#DIM 2 1\n#PARAM_IN RUSIN_TH_TD\n#PARAM_OUT INV_STERADIAN\n", "no sample"},
      {"#ALTA FUNC HEADER\n#CMD fit\n#DIM 2 1\n#PARAM_IN RUSIN_TH_TD\n#ALTA HEADER END\n#FUNC rational\n",
       "function of ALTA"},
      {"#DIM 2 1\n#PARAM_IN RUSIN_TH_TD\n#FORMAT binary\n#VERSION 0\n#PRECISION ieee754-double\n#SAMPLE_COUNT "
       "100000000000\n#ENDIAN little\n#BEGIN_STREAM\n12345678",
       "0 samples"},
      {"NUM_POINTS 1\nVARS theta_i,phi_i,theta_s,phi_s,a,b\n0,0,0,0,1,2\n", "no meaning"},
      {"NUM_POINTS 1\nVARS theta_i,phi_i,theta_s,R\n0,0,0,1\n", "phi_s"},
      {"NUM_POINTS 1\nVARS theta_i,phi_i,theta_s,phi_s,R,G,B\n0,0,0,0,1\n", "wrong number of columns"},
      {"#intheta 0\n#inphi 0\n#format: theta phi GLOSS\n0 0 1\n", "unknown quantity"},
      {"#intheta 0\n#format: theta phi DSF\n0 0 1\n", "incident direction"},
      {"#spectral data generated by x\n#number of datapoints per loop in file: 3\n#intheta 0\n#inphi 0\n#lambda= 1\n0 "
       "0 1\n",
       "wavelengths"},
      {"{\"metadata\": {}, \"data\": {\"BRDF\": {\"unit\": \"sr^-1\", \"values\": [1, 2]}, \"theta_i\": {\"unit\": "
       "\"deg\", "
       "\"values\": [1, 2, 3]}}}",
       "3 values"},
      {"{\"metadata\": {}, \"data\": {\"BRDF\": {\"unit\": \"W\", \"values\": [1]}}}", "unknown unit"},
      {"{\"metadata\": {}, \"data\": [", "not JSON"},
      {"0.5,0,0.5,3,1,1,1\n0.5,0,0.5,3,1,1\n", "line 2: wrong number of columns"},
  };
  for (const auto& [text, expected] : cases) {
    const std::string error = measuredtest::errorOf([&] { readBytes(dir / "a.dat", text); });
    EXPECT_NE(error.find(expected), std::string::npos) << text << "\ngave: " << error;
  }
}
