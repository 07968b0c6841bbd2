// A BRDF that another program computes: the protocol kept and broken, by shell scripts that each test writes.
#include "../TestFolder.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Parallel.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/simulate/external/ProgramBrdf.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

using namespace brdf;

namespace {

// Each pair's value is 0.1 + wi_x + 10 wo_y + 100 wo_z: a mix-up of columns or rows shows.
constexpr const char* kAnswer = "awk -F, 'NR > 1 { printf \"%.17g\\n\", 0.1 + $1 + 10 * $5 + 100 * $6 }'";
constexpr const char* kConversation = "exec '" BRDF_ANSWERING_PROGRAM "'";

double expected(const DirectionPairs<double>& pairs, std::size_t i) {
  if (pairs.wi[2][i] <= 0 || pairs.wo[2][i] <= 0) return 0;
  return 0.1 + pairs.wi[0][i] + 10 * pairs.wo[1][i] + 100 * pairs.wo[2][i];
}

/// wi in the half plane phi = 0, wo in phi = 90 degrees; a few below the horizon.
DirectionPairBuffer<double> somePairs(std::size_t count) {
  DirectionPairBuffer<double> pairs(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    pairs.set(i, fromSpherical(1.6 * t, 0), fromSpherical(1.7 * (1 - t), kPi / 2));
  }
  return pairs;
}

class Program : public testing::Test {
 protected:
  /// A material that runs a shell script of that text.
  std::string script(const std::string& text, const std::string& options = "") {
    const auto path = folder_ / ("script" + std::to_string(scripts_++) + ".sh");
    writeFile(path, text + "\n");
    return "program:" + options + " sh " + path.string();
  }
  /// Of evaluating a thousand pairs.
  std::string errorOf(const std::string& material) {
    try {
      const BrdfPointer brdf = loadMaterial(material).brdf;
      const auto pairs = somePairs(1000);
      std::vector<double> values(1000 * brdf->channels().count());
      brdf->evaluate(pairs.view(), values.data(), nullptr);
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      return error.what();
    }
    return "no error";
  }

  std::filesystem::path folder_ = testFolder("scripts");
  int scripts_ = 0;
};

void expectAllRight(const Brdf& brdf, std::size_t count) {
  const auto pairs = somePairs(count);
  std::vector<double> values(count, -1);
  std::vector<std::uint8_t> valid(count, 7);
  brdf.evaluateParallel(pairs.view(), values.data(), valid.data());
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(valid[i], 1);
    // awk computes in double, in the same order; 17 digits read back exactly.
    ASSERT_DOUBLE_EQ(values[i], expected(pairs.view(), i)) << i;
  }
}

std::size_t openFiles() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

}  // namespace

TEST_F(Program, ValuesOfManyPairsComeBackInTheirPlacesWithoutADeadlock) {
  // 40 000 rows are far more than the pipes hold in either direction.
  expectAllRight(*loadMaterial(script(kAnswer)).brdf, 40000);
  expectAllRight(*loadMaterial(script(kConversation, "--stay")).brdf, 40000);
}

TEST_F(Program, AProgramThatReadsAllBeforeItPrintsIsNoDeadlock) {
  expectAllRight(*loadMaterial(script("all=$(cat); echo \"$all\" | " + std::string(kAnswer))).brdf, 20000);
}

TEST_F(Program, ABatchOfOnesOwnStartsItButOneThatStaysIsStartedOnce) {
  const auto log = folder_ / "starts";
  const std::string note = "echo start >> '" + log.string() + "'; ";
  const auto starts = [&] {
    const std::string text = readFile(log);
    return std::count(text.begin(), text.end(), '\n');
  };
  const BrdfPointer each = loadMaterial(script(note + kAnswer, "--channels mono")).brdf;
  EXPECT_FALSE(std::filesystem::exists(log)) << "started before anyone asked for a value";
  for (int i = 0; i < 3; ++i) each->evaluate({0, 0, 1}, {0, 0, 1});
  EXPECT_EQ(starts(), 3);
  const BrdfPointer stays = loadMaterial(script(note + kConversation, "--stay --channels mono")).brdf;
  for (int i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(stays->evaluate({0, 0, 1}, {0, 0, 1})[0], 100.1);
  EXPECT_EQ(starts(), 4);
}

TEST_F(Program, SeveralThreadsHaveAProcessEachAndNoMoreThanAllowed) {
  const auto log = folder_ / "starts";
  const BrdfPointer brdf = loadMaterial(script("echo start >> '" + log.string() + "'; " + kConversation,
                                               "--stay --processes 3 --channels mono"))
                               .brdf;
  std::vector<std::thread> threads;
  std::atomic<int> wrong{0};
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([&, t] {
      const auto wi = fromSpherical(0.1 * t, 0);
      for (int i = 0; i < 20; ++i)
        if (std::abs(brdf->evaluate(wi, {0, 0, 1})[0] - (100.1 + wi[0])) > 1e-12) ++wrong;
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  const std::string text = readFile(log);
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 3);
}

TEST_F(Program, ChannelsAreColumnsAndWavelengthsAreAnnounced) {
  const BrdfPointer rgb = loadMaterial(script("awk 'NR > 1 { print 1, 2, 3 }'")).brdf;
  EXPECT_EQ(rgb->channels(), Channels::rgb());
  EXPECT_EQ(rgb->evaluate({0, 0, 1}, {0, 0, 1}), (std::vector<double>{1, 2, 3}));
  const BrdfPointer spectral = loadMaterial(script("echo '# made by a test'; echo '# wavelengths_nm: 450 550'; echo "
                                                   "value_0,value_1; awk 'NR > 1 { print \"1,2\" }'"))
                                   .brdf;
  EXPECT_EQ(spectral->channels(), Channels::spectral({450, 550}));
  EXPECT_EQ(spectral->evaluate({0, 0, 1}, {0, 0, 1}), (std::vector<double>{1, 2}));
  const BrdfPointer told = loadMaterial(script("awk 'NR > 1 { print \"1,2\" }'", "--channels 450,550")).brdf;
  EXPECT_EQ(told->channels(), Channels::spectral({450, 550}));
  EXPECT_NE(errorOf(script("awk 'NR > 1 { print 1, 2 }'")).find("what its columns mean is not known"),
            std::string::npos);
}

TEST_F(Program, NanMeansThatThereIsNoValue) {
  const BrdfPointer brdf = loadMaterial(script("awk -F, 'NR > 1 { print ($1 > 0.5 ? \"nan\" : 1) }'")).brdf;
  DirectionPairBuffer<double> pairs;
  pairs.push({0, 0, 1}, {0, 0, 1});
  pairs.push({0.6, 0, 0.8}, {0, 0, 1});
  double values[2];
  std::uint8_t valid[2];
  brdf->evaluate(pairs.view(), values, valid);
  EXPECT_EQ(values[0], 1);
  EXPECT_EQ(values[1], 0);
  EXPECT_EQ(valid[0], 1);
  EXPECT_EQ(valid[1], 0);
}

TEST_F(Program, FailuresSayInOneLineWhatWentWrong) {
  const struct {
    std::string script, options, expected;
  } cases[] = {
      {"echo 'one line' >&2; echo 'no licence' >&2; exit 3", "",
       "ended with exit code 3 (it said: no licence); found 0 of"},
      {"kill -SEGV $$", "", "signal 11 (Segmentation fault)"},
      {"awk 'NR > 1 && NR < 8 { print 1 }'", "--channels mono", "it ended too early; found 6 of"},
      {"cat >/dev/null; yes 1 | head -n 2000", "--channels mono", "more lines than directions"},
      {"awk 'NR > 1 { print NR == 20 ? -0.5 : 1 }'", "--channels mono", "line 19 of its output; found '-0.5'"},
      {"awk 'NR > 1 { print NR == 20 ? \"inf\" : 1 }'", "--channels mono", "line 19 of its output; found 'inf'"},
      {"awk 'NR > 1 { print \"1 kg\" }'", "", "not a number, line 1 of its output; found 'kg'"},
      {"awk 'NR > 1 { print NR == 20 ? \"1 2\" : 1 }'", "--channels mono", "found '1 2'; allowed: 1, one a channel"},
      {"head -c 3000000 /dev/zero", "", "a line without an end"},
      {"awk 'NR > 1 { print 1 }'; exit 7", "", "ended with exit code 7"},
      {"echo '# wavelengths_nm: 550 450'; awk 'NR > 1 { print 1, 2 }'", "", "ascending wavelengths in nm"},
      {"awk 'NR > 1 { print 1 }'", "--stay --time-limit 0.2 --channels mono",
       "flushes its output when it reads an empty line"},
      {"read header; read row; echo 1", "--stay --channels mono", "answers an empty line by an empty line"},
  };
  for (const auto& broken : cases) {
    const std::string error = errorOf(script(broken.script, broken.options));
    EXPECT_NE(error.find(broken.expected), std::string::npos) << broken.script << "\n" << error;
  }
  EXPECT_NE(errorOf("program:/no/such/program").find("No such file or directory"), std::string::npos);
  EXPECT_NE(errorOf("program:" + folder_.string()).find("Permission denied"), std::string::npos);
}

TEST_F(Program, ASilentProgramIsEndedWhenItsTimeIsUp) {
  const auto log = folder_ / "process";
  const auto start = std::chrono::steady_clock::now();
  const std::string error = errorOf(script("echo $$ > '" + log.string() + "'; exec sleep 100", "--time-limit 0.3"));
  EXPECT_NE(error.find("no sign of it for 0.3 s"), std::string::npos) << error;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(50));
  EXPECT_EQ(kill(std::stoi(readFile(log)), 0), -1) << "it still runs";
}

TEST_F(Program, AFailureIsForgottenByTheNextBatch) {
  const auto mark = folder_ / "mark";
  const BrdfPointer brdf =
      loadMaterial(script("[ -e '" + mark.string() + "' ] || exit 1; " + kConversation, "--stay --channels mono")).brdf;
  EXPECT_THROW(brdf->evaluate({0, 0, 1}, {0, 0, 1}), Error);
  writeFile(mark, "");
  EXPECT_DOUBLE_EQ(brdf->evaluate({0, 0, 1}, {0, 0, 1})[0], 100.1);
}

TEST_F(Program, AChildThatNoLongerReadsCostsNoSignalAndNothingIsLeftOpen) {
  // It answers without reading: the input, more than the pipe holds, has nobody to go to.
  const std::string material = script("exec <&-; yes 1 | head -n 20000", "--channels mono");
  const BrdfPointer brdf = loadMaterial(material).brdf;
  const auto pairs = [] {
    DirectionPairBuffer<double> same(20000);
    for (std::size_t i = 0; i < 20000; ++i) same.set(i, {0, 0, 1}, {0, 0, 1});
    return same;
  }();
  std::vector<double> values(20000);
  const std::size_t before = openFiles();
  brdf->evaluate(pairs.view(), values.data(), nullptr);
  EXPECT_EQ(values, std::vector<double>(20000, 1.0));
  for (int i = 0; i < 20; ++i) EXPECT_THROW(loadMaterial(script("exit 1")).brdf, Error);
  EXPECT_EQ(openFiles(), before);
}

TEST(ProgramText, WordsAreSplitWithoutAShellAndReadBack) {
  const ProgramOptions options =
      parseProgram(R"(--channels 450,550.5 --symmetry bilateral --reciprocal --stay --time-limit 2.5 --processes 4 )"
                   R"('my program' "a \"b\" $HOME" '' 'c\d' e\ f ; * | --channels)");
  EXPECT_EQ(options.command,
            (std::vector<std::string>{"my program", "a \"b\" $HOME", "", "c\\d", "e f", ";", "*", "|", "--channels"}));
  EXPECT_EQ(options.channels, Channels::spectral({450, 550.5}));
  EXPECT_EQ(options.symmetry, Symmetry::Bilateral);
  EXPECT_TRUE(options.reciprocal);
  EXPECT_TRUE(options.stays);
  EXPECT_EQ(options.timeLimit, 2.5);
  EXPECT_EQ(options.processes, 4u);
  const ProgramOptions again = parseProgram(programText(options));
  EXPECT_EQ(again.command, options.command);
  EXPECT_EQ(again.channels, options.channels);
  EXPECT_EQ(programText(again), programText(options));
  EXPECT_EQ(programText(parseProgram("awk 1")), "awk 1");
  EXPECT_EQ(programText(parseProgram("-- --stay 1")), "-- --stay 1");
}

TEST(ProgramText, WhatCannotBeMeantIsRefused) {
  for (const char* text : {"", "  ", "--stay", "--channels", "--channels rgba x", "--channels 500,400 x",
                           "--channels -1 x", "--symmetry round x", "--time-limit -1 x", "--time-limit nan x",
                           "--processes 0 x", "--nonsense x", "x 'y", "x \\"})
    EXPECT_THROW(parseProgram(text), Error) << text;
}

TEST_F(Program, NoShellReadsTheWords) {
  const auto victim = folder_ / "victim";
  // A shell would make the file; awk gets the words as they are.
  const BrdfPointer brdf =
      loadMaterial("program:awk -v 'text=$(touch " + victim.string() + ")' 'NR > 1 { print length(text) }' ").brdf;
  EXPECT_EQ(brdf->evaluate({0, 0, 1}, {0, 0, 1})[0], static_cast<double>(9 + victim.string().size()));
  EXPECT_FALSE(std::filesystem::exists(victim));
}

TEST_F(Program, TheDescriptionReadsBackAndSymmetryIsWhatWasSaid) {
  const BrdfPointer brdf = loadMaterial(script(kAnswer, "--symmetry isotropic --reciprocal")).brdf;
  EXPECT_EQ(brdf->symmetry(), Symmetry::Isotropic);
  EXPECT_TRUE(brdf->reciprocal());
  const BrdfPointer again = loadMaterial(brdf->description()).brdf;
  EXPECT_EQ(again->description(), brdf->description());
  EXPECT_EQ(again->evaluate({0, 0, 1}, {0, 0, 1}), brdf->evaluate({0, 0, 1}, {0, 0, 1}));
  EXPECT_EQ(loadMaterial(script(kAnswer)).brdf->symmetry(), Symmetry::Anisotropic);
}
