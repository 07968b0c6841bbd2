#include "Arguments.h"
#include "Assumptions.h"
#include "Progress.h"
#include "commands/Commands.h"

#include <brdf/Version.h>
#include <brdf/base/Error.h>
#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>
#include <brdf/models/Registry.h>

#include <cstdio>
#include <exception>

namespace {

using namespace brdf::app;

constexpr int kSuccess = 0, kNotMet = 1, kWrongUsage = 2;

std::string overview() {
  std::string text = "BRDFLab " BRDF_VERSION
                     ": measure, model, fit and render the reflection of materials\n\n"
                     "Usage: brdf COMMAND [ARGUMENTS]\n\nCommands (brdf COMMAND --help says more):\n";
  TextTable table;
  for (const Command& command : allCommands()) table.row({"  " + command.name, command.summary});
  text += table.text() + "\n\n";
  text +=
      "A material is a file in any supported format (file#3 or file#name picks one of several), an expression such as\n"
      "\"(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)\", preset:NAME, or program:COMMAND (another program's\n"
      "values; brdf plugins lists this and further kinds).\n\n"
      "Every command takes --json FILE (- for standard output), --quiet, --model-path DIR (lobes of your own) and\n"
      "--assume KEY=VALUE (what measured files mean, e.g. quantity=brdf_cos: see a command's --help). Angles are in\n"
      "degrees, values in 1/sr without the cosine. Exit code: 0 success, 1 the request could not be met, 2 "
      "wrong usage.\n";
  return text;
}

/// Models of the user's own: those of the folders searched unasked, where a bad file costs a warning and no more, then
/// those of --model-path, where it is an error.
void loadUserModels(const std::vector<std::string>& folders) {
  for (const brdf::Plugin& plugin : brdf::plugins())
    if (!plugin.error.empty())
      std::fprintf(stderr, "brdf: warning: plugin left out: %s: %s\n", plugin.file.c_str(), plugin.error.c_str());
  for (const std::string& failure : brdf::userModelFailures())
    std::fprintf(stderr, "brdf: warning: models left out: %s\n", failure.c_str());
  for (const std::string& folder : folders) brdf::loadModelFolder(folder);
}

int run(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const Command& command : allCommands()) names.push_back(command.name);
  if (words.empty())
    throw brdf::Error(brdf::Error::Kind::Usage, {"no command given", "brdf", "", brdf::joined(names) + ", --help"});
  if (words[0] == "--help" || words[0] == "-h" || words[0] == "help") {
    std::fputs(overview().c_str(), stdout);
    return kSuccess;
  }
  if (words[0] == "--version") {
    std::puts("brdf " BRDF_VERSION);
    return kSuccess;
  }
  for (Command& command : allCommands()) {
    if (command.name != words[0]) continue;
    Output output;
    Arguments arguments(command.name, command.summary, command.examples);
    command.declare(arguments);
    arguments.option("--json", output.jsonTarget, "FILE", "Write the report as JSON; - for standard output");
    arguments.flag("--quiet", output.quiet, "Print nothing but errors (and the JSON that was asked for)");
    std::vector<std::string> modelFolders;
    arguments.option("--model-path", modelFolders, "DIR",
                     "Load the lobes that DIR/*.xml define (ours, or model files of BRDFLab 0.8.2)");
    std::vector<std::string> assumed;
    arguments.option("--assume", assumed, "KEY=VALUE", assumptionsHelp());
    if (!arguments.parse({words.begin() + 1, words.end()})) {
      std::fputs(arguments.help().c_str(), stdout);
      return kSuccess;
    }
    checkWritable(output.jsonTarget);
    setAssumptions(assumed);
    loadUserModels(modelFolders);
    handleInterrupts();
    command.run(output);
    return kSuccess;
  }
  const std::string nearest = brdf::closestName(words[0], names);
  throw brdf::Error(brdf::Error::Kind::Usage, {"unknown command", "brdf", "'" + words[0] + "'",
                                               brdf::joined(names) + (nearest.empty() ? "" : "; nearest: " + nearest)});
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const brdf::Error& error) {
    std::fprintf(stderr, "brdf: %s\n", error.what());
    return error.kind() == brdf::Error::Kind::Usage ? kWrongUsage : kNotMet;
  } catch (const std::bad_alloc&) {
    std::fputs("brdf: not enough memory for the request\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "brdf: %s\n", error.what());
  }
  return kNotMet;
}
