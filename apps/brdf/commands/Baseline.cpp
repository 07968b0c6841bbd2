#include "Arguments.h"
#include "Commands.h"
#include "Output.h"
#include "Pictures.h"
#include "Progress.h"
#include "baseline/Runs.h"
#include "baseline/Suite.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/io/ImageFile.h>

#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

namespace fs = std::filesystem;

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

struct Values {
  std::string suite, results, example;
  std::vector<std::string> only;
  bool update = false;
};

struct Verdict {
  enum class State { Same, Differs, Missing, Failed, Updated } state = State::Same;
  std::string reason;  ///< one line
  Json numbers = Json::object();
};

const char* word(Verdict::State state) {
  switch (state) {
    case Verdict::State::Same:
      return "same";
    case Verdict::State::Differs:
      return "differs";
    case Verdict::State::Missing:
      return "no baseline";
    case Verdict::State::Failed:
      return "failed";
    case Verdict::State::Updated:
      return "updated";
  }
  return "";
}

/// Where the pictures are drawn: the user's folder, or one of our own that goes with us.
class ResultFolder {
 public:
  explicit ResultFolder(const std::string& asked) : kept_(!asked.empty()) {
    if (kept_) {
      path_ = fs::absolute(asked);
    } else {
      std::string name = fs::temp_directory_path() / "brdf-baseline-XXXXXX";
      if (!::mkdtemp(name.data())) throw Error(Error::Kind::File, {"no temporary folder", name, "", "--results DIR"});
      path_ = name;
    }
    std::error_code code;
    fs::create_directories(path_, code);
    if (!fs::is_directory(path_)) throw Error(Error::Kind::File, {"cannot be made", asked, code.message(), "a folder"});
  }
  ~ResultFolder() {
    std::error_code ignored;
    if (!kept_) fs::remove_all(path_, ignored);
  }
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  const fs::path& path() const { return path_; }
  bool kept() const { return kept_; }

 private:
  fs::path path_;
  bool kept_;
};

Verdict compareRadiance(const BaselinePicture& picture, const fs::path& found, const fs::path& baseline) {
  const ImageDifference difference = imageDifference(readImage(found), readImage(baseline), picture.radiance);
  Verdict verdict;
  verdict.numbers = {{"outliers", difference.outliers}, {"worst", difference.worst}, {"rms", difference.rms}};
  if (difference.within) return verdict;
  verdict.state = Verdict::State::Differs;
  verdict.reason = std::to_string(difference.outliers) + " pixels beyond the tolerance, the worst " +
                   number(difference.worst) + " times it at column " + std::to_string(difference.worstX) + ", row " +
                   std::to_string(difference.worstY);
  return verdict;
}

Verdict compareLayout(const BaselinePicture& picture, const fs::path& found, const fs::path& baseline,
                      const fs::path& differences) {
  const double share = pictures().layoutDifference(found, baseline, differences);
  Verdict verdict;
  verdict.numbers = {{"layout", share}};
  if (share <= picture.layout) return verdict;
  verdict.state = Verdict::State::Differs;
  verdict.reason = "differs by " + number(share) + " of the picture, allowed " + number(picture.layout);
  return verdict;
}

Verdict drawAndCompare(const BaselinePicture& picture, const fs::path& folder, const ResultFolder& results) {
  const fs::path found = results.path() / picture.file, baseline = folder / picture.file;
  std::error_code ignored;
  fs::remove(found, ignored);
  auto words = picture.command;
  words.insert(words.end(), {"--out", found.string()});
  Verdict verdict;
  verdict.reason = runThisProgram(words, folder, results.path() / (picture.file + ".log"));
  if (verdict.reason.empty() && !fs::exists(found)) verdict.reason = "the command made no such picture";
  if (!verdict.reason.empty()) {
    verdict.state = Verdict::State::Failed;
    return verdict;
  }
  if (!fs::exists(baseline)) {
    verdict.state = Verdict::State::Missing;
    verdict.reason = "--update makes it";
    return verdict;
  }
  try {
    if (baseline.extension() == ".exr") return compareRadiance(picture, found, baseline);
    return compareLayout(picture, found, baseline,
                         results.kept() ? results.path() / (found.stem().string() + ".difference.png") : fs::path());
  } catch (const Error& error) {
    verdict.state = Verdict::State::Differs;
    verdict.reason = error.what();
    return verdict;
  }
}

std::vector<BaselinePicture> chosen(const Values& values) {
  auto pictures = readBaselineSuite(values.suite);
  if (values.only.empty()) return pictures;
  std::vector<std::string> names;
  for (const auto& picture : pictures) names.push_back(picture.file);
  for (const std::string& name : values.only)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw Error(Error::Kind::Usage, {"no such picture in the suite", "--only", "'" + name + "'", joined(names)});
  std::erase_if(pictures, [&](const BaselinePicture& picture) {
    return std::find(values.only.begin(), values.only.end(), picture.file) == values.only.end();
  });
  return pictures;
}

void run(const Output& output, const Values& values) {
  if (!values.example.empty()) {
    writeFile(values.example, exampleBaselineSuite());
    output.line(values.example + ": a suite to start from");
    output.report({{"example", values.example}});
    return;
  }
  if (values.suite.empty())
    throw Error(Error::Kind::Usage,
                {"no suite given", "brdf baseline", "", "a suite's file, or --example FILE to write one"});
  const auto wanted = chosen(values);
  const fs::path folder = fs::absolute(values.suite).parent_path();
  const ResultFolder results(values.results);
  const Interruptible untilCompared;
  Json report = Json::array();
  std::size_t bad = 0, done = 0;
  for (const BaselinePicture& picture : wanted) {
    if (interrupted()) break;
    Verdict verdict = drawAndCompare(picture, folder, results);
    if (values.update && (verdict.state == Verdict::State::Differs || verdict.state == Verdict::State::Missing)) {
      writeFile(folder / picture.file, readFile(results.path() / picture.file));
      verdict.state = Verdict::State::Updated;
    }
    const bool good = verdict.state == Verdict::State::Same || verdict.state == Verdict::State::Updated;
    bad += !good;
    ++done;
    output.line(picture.file + ": " + word(verdict.state) + (verdict.reason.empty() ? "" : ", " + verdict.reason));
    Json entry = {{"file", picture.file}, {"passed", good}, {"state", word(verdict.state)}, {"reason", verdict.reason}};
    entry.update(verdict.numbers);
    report.push_back(entry);
  }
  output.report({{"suite", values.suite}, {"pictures", report}, {"passed", done - bad}, {"failed", bad}});
  if (done < wanted.size())
    throw Error(Error::Kind::Value, {"interrupted", values.suite,
                                     std::to_string(done) + " of " + std::to_string(wanted.size()) + " pictures", ""});
  if (bad > 0)
    throw Error(
        Error::Kind::Value,
        {std::to_string(bad) + " of " + std::to_string(done) + " pictures are not as their baselines (" +
             (results.kept() ? "look into " + values.results : "look with --results DIR, accept with --update") + ")",
         values.suite, "", ""});
}

}  // namespace

Command baselineCommand() {
  const auto values = std::make_shared<Values>();
  return {
      "baseline", "Draw a suite of pictures again and compare them with those kept",
      "  brdf baseline --example suite.json\n"
      "  brdf baseline suite.json --update\n"
      "  brdf baseline suite.json --results results",
      [values](Arguments& arguments) {
        arguments.positional("SUITE", values->suite, "A suite of commands and tolerances; its pictures lie beside it");
        arguments.optional();
        arguments.flag("--update", values->update, "Keep as baseline what is missing or differs");
        arguments.option("--only", values->only, "FILE", "Of the suite, this picture; several times");
        arguments.option("--results", values->results, "DIR", "Keep the pictures drawn, and what differs in layout");
        arguments.option("--example", values->example, "FILE", "Write a suite to start from, and end");
      },
      [values](const Output& output) { run(output, *values); }};
}

}  // namespace brdf::app
