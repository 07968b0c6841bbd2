#include "Program.h"

#include <brdf/base/File.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <ostream>

namespace fs = std::filesystem;

namespace {

constexpr const char* kHeader = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n";

std::string merlHeader(std::int32_t thetaH, std::int32_t thetaD, std::int32_t phiD) {
  std::string bytes(12, '\0');
  const std::int32_t sizes[] = {thetaH, thetaD, phiD};
  std::memcpy(bytes.data(), sizes, sizeof sizes);
  return bytes;
}

/// The files that the table below speaks of, in the folder that the program runs in.
void writeInputs(const fs::path& folder) {
  fs::create_directory(folder / "folder");
  const auto write = [&folder](const char* name, const std::string& text) { brdf::writeFile(folder / name, text); };
  write("empty", "");
  write("text.txt", "These are words, and not a material at all.\n");
  write("zeros.bin", std::string(4096, '\0'));
  write("truncated.binary", merlHeader(90, 90, 180) + std::string(1000, '\0'));
  write("oversized.binary", merlHeader(2147483647, 2147483647, 2147483647) + std::string(1000, '\0'));
  write("negative-size.binary", merlHeader(-90, 90, 180) + std::string(1000, '\0'));
  write("damaged.vtkhdf", "\x89HDF\r\n\x1a\n" + std::string(2000, '\x55'));
  write("picture.png", "\x89PNG\r\n\x1a\n" + std::string(100, '\x01'));
  write("empty.csv", "");
  write("no-column.csv", "wi_x,wi_y,wi_z,wo_x,wo_y\n0,0,1,0,0\n");
  write("twice.csv", "wi_x,wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n0,0,0,1,0,0,1\n");
  write("nan.csv", kHeader + std::string("0,0,1,0,0,1\n0,0,1,nan,0,1\n"));
  write("word.csv", kHeader + std::string("0,0,1,0,zero,1\n"));
  write("comma.csv", kHeader + std::string("0,0,1,0,0\n"));
  write("long.csv", kHeader + std::string("0,0,1,0,0,2\n"));
  write("good.csv", kHeader + std::string("0,0,1,0,0,1\n"));
  write("notes.obj", "no geometry here\n");
}

struct BadInput {
  const char* name;  ///< the claim: what is refused
  std::vector<std::string> arguments;
  int exitCode;                       ///< 1: cannot be met; 2: wrong usage
  std::vector<std::string> mentions;  ///< parts of the message: where, what was found, what is allowed
  bool draws = false;                 ///< needs the part that draws
  std::vector<std::pair<std::string, std::string>> environment = {};
};

const std::vector<BadInput> kTable = {
    // Wrong usage
    {"UnknownOption", {"eval", "Lambertian", "--att", "0,0,0,0"}, 2, {"brdf eval", "--att", "--at"}},
    {"UnexpectedArgument", {"info", "Lambertian", "GGX"}, 2, {"brdf info", "GGX"}},
    {"MissingArgument", {"compare", "Lambertian"}, 2, {"brdf compare", "B", "--help"}},
    {"MissingOptionValue", {"eval", "Lambertian", "--at"}, 2, {"brdf eval", "--at"}},
    {"NothingToEvaluate", {"eval", "Lambertian"}, 2, {"brdf eval", "--at", "--directions"}},
    {"DirectionsWithoutOut", {"eval", "Lambertian", "--directions", "good.csv"}, 2, {"--directions", "--out"}},
    {"ThreeAngles", {"eval", "Lambertian", "--at", "30,0,30"}, 2, {"--at", "30,0,30", "4 numbers"}},
    {"AnglesThatAreWords", {"eval", "Lambertian", "--at", "a,b,c,d"}, 2, {"--at", "a,b,c,d"}},
    {"UnknownPrecision",
     {"eval", "Lambertian", "--at", "0,0,0,0", "--precision", "half"},
     2,
     {"--precision", "half", "double"}},
    {"UnknownMetric", {"fit", "good.csv", "--metric", "l7"}, 2, {"--metric", "l7", "rms"}},
    {"UnknownOptimizer", {"fit", "good.csv", "--optimizer", "magic"}, 2, {"--optimizer", "magic", "lm"}},
    {"NumberOutOfRange", {"fit", "good.csv", "--max-theta", "120"}, 2, {"--max-theta", "120", "0 to 90"}},
    {"NumberThatIsAWord", {"fit", "good.csv", "--tolerance", "small"}, 2, {"--tolerance", "small"}},
    {"NumberThatIsNotFinite", {"fit", "good.csv", "--tolerance", "nan"}, 2, {"--tolerance", "nan"}},
    {"FractionalCount", {"fit", "good.csv", "--starts", "1.5"}, 2, {"--starts", "1.5"}},
    {"CountOfOwnSamples", {"fit", "good.csv", "--sampling", "all", "--samples", "9"}, 2, {"--samples", "9"}},
    {"MalformedFix", {"fit", "good.csv", "--fix", "alpha"}, 2, {"--fix", "alpha", "name=number"}},
    {"ScaleInLobes", {"fit", "good.csv", "--lobes", "0.3*Lambertian"}, 2, {"--lobes", "0.3*Lambertian"}},
    {"UnknownChannels",
     {"compare", "Lambertian", "Lambertian", "--channels", "red"},
     2,
     {"--channels", "red", "luminance"}},
    {"MalformedSize", {"lobe", "Lambertian", "--out", "x.png", "--size", "900"}, 2, {"--size", "900", "WIDTHxHEIGHT"}},
    {"HugeSize", {"lobe", "Lambertian", "--out", "x.png", "--size", "900000x900000"}, 2, {"--size", "8192"}},
    {"UnknownPicture", {"lobe", "Lambertian", "--out", "x.gif"}, 2, {"--out", "x.gif", ".png"}},
    {"UnknownMeasure",
     {"error", "GGX", "GGX", "--out", "x.png", "--measure", "l7"},
     2,
     {"--measure", "l7", "cuberoot"}},
    {"MeasureOfPictures", {"error", "GGX", "GGX", "--out", "x.png", "--measure", "sphere"}, 2, {"--measure", "sphere"}},
    {"ErrorWithoutOutput", {"error", "GGX", "GGX"}, 2, {"--out"}},
    {"DifferenceOfOne", {"lobe", "GGX", "--difference", "lobe", "--out", "x.png"}, 2, {"--difference", "1"}},
    {"MeshOfTwo", {"lobe", "GGX", "GGX", "--out", "x.ply"}, 2, {"--out", "2 materials"}},
    {"UnknownLight", {"render", "Lambertian", "--light", "lamp", "--out", "x.png"}, 2, {"--light", "lamp", "env:FILE"}},
    {"EmptyMaterial", {"info", ""}, 2, {"no material"}},
    // Materials
    {"MissingFile", {"info", "missing.binary"}, 1, {"missing.binary", "no such file"}},
    {"MissingFileInAFolder", {"info", "folder/missing"}, 1, {"folder/missing", "no such file"}},
    {"FolderAsFile", {"info", "./folder"}, 1, {"folder"}},
    {"EmptyFile", {"info", "empty"}, 1, {"empty"}},
    {"TextFile", {"info", "text.txt"}, 1, {"text.txt", "merl"}},
    {"PictureAsMaterial", {"info", "picture.png"}, 1, {"picture.png"}},
    {"ZerosAsMaterial", {"info", "zeros.bin"}, 1, {"zeros.bin"}},
    {"TruncatedTable", {"info", "truncated.binary"}, 1, {"truncated.binary", "1012"}},
    {"OversizedHeader", {"info", "oversized.binary"}, 1, {"oversized.binary"}},
    {"NegativeSize", {"info", "negative-size.binary"}, 1, {"negative-size.binary"}},
    {"DamagedContainer", {"info", "damaged.vtkhdf"}, 1, {"damaged.vtkhdf"}},
    {"UnknownLobe", {"info", "Lambertian + GGY(alpha=0.1)"}, 1, {"GGY", "GGX"}},
    {"UnknownParameter", {"info", "GGX(alhpa=0.1)"}, 1, {"alhpa", "alpha"}},
    {"ParameterOutOfBounds", {"info", "GGX(alpha=-1)"}, 1, {"alpha", "-1"}},
    {"ParameterThatIsNotFinite", {"info", "GGX(alpha=nan)"}, 1, {"alpha"}},
    {"NegativeScale", {"info", "-0.5*Lambertian"}, 1, {"-0.5"}},
    {"UnfinishedExpression", {"info", "0.5*Lambertian + "}, 1, {"column"}},
    {"UnknownPreset", {"info", "preset:unobtainium"}, 1, {"unobtainium"}},
    {"UnknownModel", {"models", "GGY"}, 1, {"GGY", "GGX"}},
    // Tables of directions
    {"EmptyTable", {"eval", "Lambertian", "--directions", "empty.csv", "--out", "x.csv"}, 1, {"empty.csv", "wi_x"}},
    {"MissingColumn",
     {"eval", "Lambertian", "--directions", "no-column.csv", "--out", "x.csv"},
     1,
     {"no-column.csv, line 1", "wo_z"}},
    {"ColumnTwice",
     {"eval", "Lambertian", "--directions", "twice.csv", "--out", "x.csv"},
     1,
     {"twice.csv, line 1", "wi_x"}},
    {"NanInATable",
     {"eval", "Lambertian", "--directions", "nan.csv", "--out", "x.csv"},
     1,
     {"nan.csv, line 3", "wo_x", "nan"}},
    {"WordInATable",
     {"eval", "Lambertian", "--directions", "word.csv", "--out", "x.csv"},
     1,
     {"word.csv, line 2", "wo_y", "zero"}},
    {"ShortRow",
     {"eval", "Lambertian", "--directions", "comma.csv", "--out", "x.csv"},
     1,
     {"comma.csv, line 2", "5", "6"}},
    {"DirectionThatIsNotUnit",
     {"eval", "Lambertian", "--directions", "long.csv", "--out", "x.csv"},
     1,
     {"long.csv, line 2", "wo", "2"}},
    {"MissingTable",
     {"eval", "Lambertian", "--directions", "missing.csv", "--out", "x.csv"},
     1,
     {"missing.csv", "no such file"}},
    // Requests that cannot be met
    {"ExtendedPrecisionOfData",
     {"eval", "table.binary", "--at", "0,0,0,0", "--precision", "extended"},
     1,
     {"table.binary", "extended", "double"}},
    {"OwnSamplesOfAFormula", {"fit", "0.5*Lambertian", "--sampling", "all"}, 1, {"sampling", "samples", "hemisphere"}},
    {"FixOfAnUnknownParameter", {"fit", "table.binary", "--fix", "beta=1"}, 1, {"--fix", "beta", "GGX.alpha"}},
    {"FixOutOfBounds", {"fit", "table.binary", "--fix", "alpha=50"}, 1, {"alpha", "50"}},
    {"ChannelThatIsNotThere", {"fit", "table.binary", "--channels", "7"}, 1, {"7"}},
    {"UnknownFormat", {"convert", "Lambertian", "x.binary", "--format", "tiff"}, 1, {"tiff", "merl"}},
    {"UnknownExtension", {"convert", "Lambertian", "x.tiff"}, 1, {"tiff"}},
    {"OutputIntoAMissingFolder", {"convert", "Lambertian", "no/such/x.binary"}, 1, {"no/such", "cannot be written"}},
    {"OutputOverAFolder", {"convert", "Lambertian", "folder"}, 1, {"folder", "cannot be written"}},
    {"FitIntoAMissingFolder",
     {"fit", "table.binary", "--out", "no/such/x.vtkhdf"},
     1,
     {"no/such", "cannot be written"}},
    {"ReportIntoAMissingFolder",
     {"info", "Lambertian", "--json", "no/such/x.json"},
     1,
     {"no/such", "cannot be written"}},
    {"TableIntoAMissingFolder",
     {"eval", "Lambertian", "--directions", "good.csv", "--out", "no/x.csv"},
     1,
     {"no/x.csv"}},
    {"PictureIntoAMissingFolder", {"lobe", "Lambertian", "--out", "no/x.png"}, 1, {"no/x.png"}},
    // Drawing
    {"UnknownChannelOfALobe", {"lobe", "Lambertian", "--channel", "7", "--out", "x.png"}, 1, {"7"}, true},
    {"MissingMaterialOfALobe",
     {"lobe", "missing.binary", "--out", "x.png"},
     1,
     {"missing.binary", "no such file"},
     true},
    {"MissingEnvironment",
     {"render", "Lambertian", "--light", "env:missing.exr", "--out", "x.png"},
     1,
     {"missing.exr", "no such file"},
     true},
    {"WrongEnvironment", {"render", "Lambertian", "--light", "env:text.txt", "--out", "x.png"}, 1, {"text.txt"}, true},
    {"MissingObject",
     {"render", "Lambertian", "--object", "missing.ply", "--light", "directional:0,0", "--out", "x.png"},
     1,
     {"missing.ply"},
     true},
    {"ObjectWithoutGeometry",
     {"render", "Lambertian", "--object", "notes.obj", "--light", "directional:0,0", "--out", "x.png"},
     1,
     {"notes.obj"},
     true},
    {"UnknownObject",
     {"render", "Lambertian", "--object", "teapot", "--light", "directional:0,0", "--out", "x.png"},
     1,
     {"teapot", "sphere"},
     true},
    {"NoOpenGL",
     {"lobe", "Lambertian", "--out", "x.png"},
     1,
     {"EGL"},
     true,
     {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null"}}},
    {"NoOpenGLToRender",
     {"render", "Lambertian", "--light", "directional:0,0", "--out", "x.exr"},
     1,
     {"EGL"},
     true,
     {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null"}}},
};

class Refused : public ::testing::TestWithParam<BadInput> {};

void PrintTo(const BadInput& input, std::ostream* stream) { *stream << input.name; }

std::string caseName(const ::testing::TestParamInfo<BadInput>& info) { return info.param.name; }

bool mentions(std::string text, std::string part) {
  const auto lower = [](std::string& s) {
    std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return std::tolower(c); });
  };
  lower(text);
  lower(part);
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_P(Refused, WithOneLineThatSaysWhatAndWhereAndNothingLeftBehind) {
  const BadInput& input = GetParam();
#ifndef BRDF_HAS_PICTURES
  if (input.draws) GTEST_SKIP() << "this build has no VTK, so nothing draws";
#endif
  const fs::path folder = scratchFolder();
  writeInputs(folder);
  if (std::find(input.arguments.begin(), input.arguments.end(), "table.binary") != input.arguments.end()) {
    ASSERT_EQ(runBrdf(folder, {"convert", "0.5*Lambertian", "table.binary"}).exitCode, 0);
  }
  const auto before = filesIn(folder);
  const Outcome run = runBrdf(folder, input.arguments, input.environment);
  EXPECT_EQ(run.exitCode, input.exitCode) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_TRUE(run.err.starts_with("brdf: ")) << run.err;
  for (const std::string& part : input.mentions)
    EXPECT_TRUE(mentions(run.err, part)) << "no '" << part << "' in: " << run.err;
  EXPECT_EQ(filesIn(folder), before);
}

INSTANTIATE_TEST_SUITE_P(BadInput, Refused, ::testing::ValuesIn(kTable), caseName);

TEST(BadInput, AnOldOutputFileSurvivesAFailure) {
  const fs::path folder = scratchFolder();
  writeInputs(folder);
  brdf::writeFile(folder / "out.csv", "old");
  EXPECT_EQ(runBrdf(folder, {"eval", "Lambertian", "--directions", "nan.csv", "--out", "out.csv"}).exitCode, 1);
  EXPECT_EQ(brdf::readFile(folder / "out.csv"), "old");
}

TEST(BadInput, AFullDiskIsAnErrorNotAShortFile) {
  const Outcome run = runLine(scratchFolder(), "{ brdf models --json - >/dev/full; }");
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_NE(run.err.find("standard output"), std::string::npos) << run.err;
}
