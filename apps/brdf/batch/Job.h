#pragma once
#include "FitArguments.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace brdf::app {

/// What `brdf batch` is asked to do, from a file of JSON:
///
///   {"title": "...", "note": "...",                            both may be missing; the note goes onto every picture
///    "targets": ["red.binary", {"name": "orange", "material": "measured/orange-paint.binary"}],
///    "fits": {"lobes": ["Lambertian + GGX", "Lambertian + Ward"], "metric": ["rms", "log"], "max-theta": 80}}
///
/// The keys of "fits" are the options of `brdf fit` without their dashes. A list means each of its items; an item that
/// is itself a list is an option given several times; true is an option that takes no value. "fits" may be a list of
/// such objects, each with a "title". Every target meets every combination; what appears twice is done once. Files are
/// looked for in the job file's folder.

/// A material to fit to.
struct BatchTarget {
  std::string name;      ///< unique in its job
  std::string material;  ///< as loadTarget takes it
  std::string hash;      ///< SHA-256 of its content
};

/// One fit of a batch.
struct BatchTask {
  std::string key;         ///< what is fitted, how, and by which models and program: 16 hexadecimal digits
  std::size_t target = 0;  ///< index in the job
  std::vector<std::pair<std::string, std::string>> options;  ///< as given, in the job's order
  std::string words;                                         ///< the options as they would be typed
  FitArguments fit;

  /// "red: Lambertian + GGX, lm, rms", for people.
  std::string title(const std::string& targetName) const;
};

/// A part of a job: the fits of one object of "fits".
struct BatchBlock {
  std::string title;
  std::vector<std::string> varied;  ///< options with more than one value
  std::vector<std::size_t> tasks;   ///< indices in the job, targets outermost
};

struct BatchJob {
  std::string title, note;
  std::vector<BatchTarget> targets;
  std::vector<std::unique_ptr<BatchTask>> tasks;  ///< each once; targets of one content share keys
  std::vector<BatchBlock> blocks;
};

/// Reads a job from the text of the file `path`. `contentHash(material)` gives the hash of a target. Throws
/// Error::Kind::Format or Usage naming the file and the place, and what `contentHash` throws.
BatchJob parseBatchJob(const std::string& text, const std::filesystem::path& path,
                       const std::function<std::string(const std::string& material)>& contentHash);

/// Hash of what a fit to this target sees: of the file, or all files of the folder, that it is read from, or of the
/// expression and its lobes. Loads the target once, so that one that cannot be read is known at the start. Throws what
/// loadTarget throws.
std::string targetContentHash(const std::string& material);

/// A job that runs with the file sample.binary of the help's example.
std::string exampleBatchJob();

}  // namespace brdf::app
