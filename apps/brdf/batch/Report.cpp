#include "Report.h"

#include "Assumptions.h"
#include "Output.h"
#include "Pictures.h"
#include "Progress.h"
#include "Results.h"
#include "commands/ReferenceRender.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace fs = std::filesystem;

namespace brdf::app {
namespace {

using Json = nlohmann::ordered_json;

// More lobes than this are too many for one picture.
constexpr std::size_t kMostOverlaid = 5;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// One fit, as the tables show it.
struct Cell {
  bool fitted = false;
  std::size_t entry = 0;  ///< in results.vtkhdf
  std::string metric, failure;
  double error = kNone, zero = kNone, seconds = kNone;
  double evaluations = kNone;
  bool converged = false;
  std::map<std::string, double> ratios;  ///< error / error of the zero model, by metric

  double ratio(const std::string& judge) const {
    const auto found = ratios.find(judge);
    return found == ratios.end() ? kNone : found->second;
  }
};

/// One part of the job: a table of ways to fit (rows) by targets (columns).
struct Part {
  std::string title;
  bool comparesLobes = false;  ///< its fits differ in their lobes
  std::vector<std::string> targets, ways;
  std::vector<std::string> judges;       ///< metrics that its fits minimise: each fit is shown by all of them
  std::vector<std::vector<Cell>> cells;  ///< by target, then way

  /// The way that fits a target best by the first judge; none when nothing was fitted.
  std::optional<std::size_t> best(std::size_t target) const {
    std::optional<std::size_t> found;
    for (std::size_t way = 0; way < ways.size(); ++way) {
      const Cell& cell = cells[target][way];
      const double ratio = cell.ratio(judges[0]);
      if (std::isfinite(ratio) && (!found || ratio < cells[target][*found].ratio(judges[0]))) found = way;
    }
    return found;
  }
};

Cell readCell(const BatchTask& task, const BatchRecords& records, std::size_t entry) {
  Cell cell;
  cell.metric = task.fit.metric();
  const Json& record = records.record(task.key);
  if (records.state(task.key) == BatchRecords::State::Failed) cell.failure = record["failed"].get<std::string>();
  if (records.state(task.key) != BatchRecords::State::Fitted) return cell;
  const Json& report = record["report"];
  cell.fitted = true;
  cell.entry = entry;
  const auto number = [](const Json& value) { return value.is_number() ? value.get<double>() : kNone; };
  cell.error = number(report.value("error", Json()));
  const Json zero = report.value("zero_model", Json::object());
  cell.zero = number(zero.value(cell.metric, Json()));
  const Json metrics = report.value("metrics", Json::object());
  for (const auto& [name, error] : metrics.items())
    cell.ratios[name] = number(error) / number(zero.value(name, Json()));
  cell.seconds = number(report.value("seconds", Json()));
  cell.evaluations = number(report.value("evaluations", Json()));
  cell.converged = report.value("converged", false);
  return cell;
}

std::string wayName(const BatchTask& task, const BatchBlock& block) {
  std::string name;
  for (const auto& [option, value] : task.options) {
    if (std::ranges::find(block.varied, option) == block.varied.end()) continue;
    const bool bare = option == "lobes" || option == "optimizer" || option == "metric";
    name += (name.empty() ? "" : ", ") + (bare ? value : option + " " + value);
  }
  return name.empty() ? task.fit.lobes() : name;
}

std::vector<Part> readParts(const BatchJob& job, const BatchRecords& records) {
  std::vector<std::size_t> entries;
  std::size_t entry = 0;
  for (const auto& task : job.tasks)
    entries.push_back(records.state(task->key) == BatchRecords::State::Fitted ? entry++ : 0);
  std::vector<Part> parts;
  for (const BatchBlock& block : job.blocks) {
    Part part;
    part.title = block.title.empty() ? job.title : block.title;
    part.comparesLobes = std::ranges::find(block.varied, "lobes") != block.varied.end();
    const std::size_t ways = block.tasks.size() / job.targets.size();
    for (std::size_t way = 0; way < ways; ++way) part.ways.push_back(wayName(*job.tasks[block.tasks[way]], block));
    for (std::size_t target = 0; target < job.targets.size(); ++target) {
      part.targets.push_back(job.targets[target].name);
      std::vector<Cell>& row = part.cells.emplace_back();
      for (std::size_t way = 0; way < ways; ++way) {
        const std::size_t task = block.tasks[target * ways + way];
        row.push_back(readCell(*job.tasks[task], records, entries[task]));
        if (std::ranges::find(part.judges, row.back().metric) == part.judges.end())
          part.judges.push_back(row.back().metric);
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

std::string errorName(const Part& part, const std::string& judge) {
  const std::string what = "error / error of the zero model";
  return part.judges.size() == 1 ? what : judge + ": " + what;
}

// ----- tables ------------------------------------------------------------------------------------------------------

std::string shown(double value) { return std::isfinite(value) ? formatNumber(value, 3) : "–"; }

/// A table of `value`; the smallest of each column in bold; the last column the geometric mean over the targets.
template <class Value>
std::string markdownTable(const Part& part, Value value) {
  std::string text = "| |", line = "|---|";
  for (const std::string& target : part.targets) {
    text += " " + target + " |";
    line += "---|";
  }
  text += " geometric mean |\n" + line + "---|\n";
  std::vector<double> smallest(part.targets.size(), std::numeric_limits<double>::infinity());
  for (std::size_t target = 0; target < part.targets.size(); ++target)
    for (const Cell& cell : part.cells[target])
      if (value(cell) < smallest[target]) smallest[target] = value(cell);
  for (std::size_t way = 0; way < part.ways.size(); ++way) {
    text += "| " + part.ways[way] + " |";
    double logarithms = 0;
    for (std::size_t target = 0; target < part.targets.size(); ++target) {
      const double number = value(part.cells[target][way]);
      logarithms += std::log(number);
      text += std::isfinite(number) && shown(number) == shown(smallest[target]) ? " **" + shown(number) + "** |"
                                                                                : " " + shown(number) + " |";
    }
    text += " " + shown(std::exp(logarithms / static_cast<double>(part.targets.size()))) + " |\n";
  }
  return text;
}

std::string quoted(const std::string& text) {
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + "\"";
}

std::string csvTable(const Part& part, const std::string& note) {
  std::string text = "target,way,metric,error,zero_model,ratio,seconds,evaluations,converged,failed,note\n";
  const auto number = [](double value) { return std::isfinite(value) ? formatNumber(value, 17) : std::string(); };
  for (std::size_t target = 0; target < part.targets.size(); ++target)
    for (std::size_t way = 0; way < part.ways.size(); ++way) {
      const Cell& cell = part.cells[target][way];
      text += quoted(part.targets[target]) + "," + quoted(part.ways[way]) + "," + quoted(cell.metric) + "," +
              number(cell.error) + "," + number(cell.zero) + "," + number(cell.ratio(cell.metric)) + "," +
              number(cell.seconds) + "," + number(cell.evaluations) + "," +
              (cell.fitted ? cell.converged ? "yes" : "no" : "") + "," + quoted(cell.failure) + "," + quoted(note) +
              "\n";
    }
  return text;
}

std::string failures(const Part& part) {
  std::string text;
  for (std::size_t target = 0; target < part.targets.size(); ++target)
    for (std::size_t way = 0; way < part.ways.size(); ++way)
      if (const Cell& cell = part.cells[target][way]; !cell.fitted)
        text += "- " + part.targets[target] + ", " + part.ways[way] + ": " +
                (cell.failure.empty() ? "not done" : cell.failure) + "\n";
  return text.empty() ? text : "Without a result:\n\n" + text + "\n";
}

// ----- pictures ----------------------------------------------------------------------------------------------------

class Illustrator {
 public:
  Illustrator(const BatchJob& job, const fs::path& results, const fs::path& folder)
      : job_(job), container_((results / "results.vtkhdf").string()), folder_(folder) {}

  /// Markdown that shows the pictures of part number `number` (from 1), which it draws.
  std::string draw(const Part& part, std::size_t number) const {
    const std::string suffix = "-" + std::to_string(number);
    std::string text = drawErrors(part, "errors" + suffix + ".png");
    if (!part.comparesLobes || part.ways.size() > kMostOverlaid) return text;
    for (std::size_t target = 0; target < part.targets.size() && !interrupted(); ++target) {
      const std::string own = suffix + "-" + std::to_string(target + 1) + ".png";
      text += drawLobes(part, target, "lobes" + own);
      if (const auto best = part.best(target)) text += drawErrorMap(part, target, *best, "error-map" + own);
    }
    return interrupted() ? text : text + drawSpheres(part, "spheres" + suffix + ".png");
  }

 private:
  std::string shownAs(const std::string& name, const std::string& what) const {
    return "![" + what + "](" + name + ")\n\n";
  }
  std::string fitSpec(const Cell& cell) const { return container_ + "#" + std::to_string(cell.entry); }

  std::string drawErrors(const Part& part, const std::string& name) const {
    DotPlotPicture picture;
    picture.title = part.title;
    picture.note = job_.note;
    for (const std::string& judge : part.judges) picture.panels.push_back({errorName(part, judge), {}});
    picture.panels.push_back({"seconds", {}});
    for (std::size_t target = 0; target < part.targets.size(); ++target)
      for (std::size_t way = 0; way < part.ways.size(); ++way) {
        const Cell& cell = part.cells[target][way];
        picture.groups.push_back(part.targets[target]);
        picture.series.push_back(part.ways[way]);
        for (std::size_t k = 0; k < part.judges.size(); ++k)
          picture.panels[k].second.push_back(cell.ratio(part.judges[k]));
        picture.panels.back().second.push_back(cell.seconds);
      }
    const std::size_t rows = picture.groups.size() + 2 * part.targets.size();
    picture.size = {1100, std::min<std::size_t>(150 + 21 * rows, 6000)};
    picture.out = (folder_ / name).string();
    pictures().dotPlot(picture);
    return shownAs(name, "Errors and times of all fits");
  }

  std::string drawLobes(const Part& part, std::size_t target, const std::string& name) const {
    LobePicture picture;
    picture.assumptions = assumptions();
    picture.materials = {job_.targets[target].material};
    picture.names = {part.targets[target]};
    for (std::size_t way = 0; way < part.ways.size(); ++way)
      if (const Cell& cell = part.cells[target][way]; cell.fitted) {
        picture.materials.push_back(fitSpec(cell));
        picture.names.push_back(part.ways[way]);
      }
    picture.title = part.targets[target] + ": lobes at 45 degrees, cube root";
    picture.transform = "cuberoot";
    picture.size = {900, 700};
    picture.out = {(folder_ / name).string()};
    pictures().lobe(picture);
    return shownAs(name, "Lobes of " + part.targets[target] + " and its fits");
  }

  std::string drawErrorMap(const Part& part, std::size_t target, std::size_t way, const std::string& name) const {
    ErrorPicture picture;
    picture.assumptions = assumptions();
    picture.a = fitSpec(part.cells[target][way]);
    picture.nameA = part.ways[way];
    picture.b = job_.targets[target].material;
    picture.nameB = part.targets[target];
    picture.measure = "cuberoot";
    picture.size = {900, 700};
    picture.out = {(folder_ / name).string()};
    pictures().error(picture);
    return shownAs(name, "Where the best fit of " + part.targets[target] + " errs");
  }

  /// A row a target: the target, then its fits.
  std::string drawSpheres(const Part& part, const std::string& name) const {
    constexpr std::size_t side = 220;
    MontagePicture montage;
    montage.title = part.title + ": spheres under a lamp";
    montage.note = job_.note;
    montage.columns = part.ways.size() + 1;
    for (std::size_t target = 0; target < part.targets.size(); ++target)
      for (std::size_t column = 0; column <= part.ways.size(); ++column) {
        const Cell* cell = column == 0 ? nullptr : &part.cells[target][column - 1];
        if (interrupted()) return {};
        const bool black = cell && !cell->fitted;
        SceneRequest sphere;
        sphere.assumptions = assumptions();
        sphere.material = !cell ? job_.targets[target].material : black ? "0*Lambertian" : fitSpec(*cell);
        sphere.lights = {"directional:55,25"};
        sphere.size = std::to_string(side) + "x" + std::to_string(side);
        ReferenceOptions options;
        options.samples = 32;
        montage.pictures.push_back({referenceRadiance(sphere, options), !cell   ? part.targets[target]
                                                                        : black ? "no fit"
                                                                                : part.ways[column - 1]});
      }
    montage.size = {montage.columns * (side + 12) + 12, part.targets.size() * (side + 36) + 80};
    montage.out = (folder_ / name).string();
    pictures().montage(montage);
    return shownAs(name, "Spheres of the targets and their fits");
  }

  const BatchJob& job_;
  std::string container_;
  fs::path folder_;
};

}  // namespace

std::string writeBatchReport(const BatchJob& job, const BatchRecords& records, const fs::path& results,
                             const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (!fs::is_directory(folder))
    throw Error(Error::Kind::File, {"cannot be made", folder.string(), code.message(), "a folder"});
  const std::vector<Part> parts = readParts(job, records);
  const BatchCounts counts = countBatch(job, records);
  std::string reason;
  try {
    pictures();
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::Device) throw;
    reason = error.what();
  }
  std::string text = "# " + job.title + "\n\n";
  if (!job.note.empty()) text += "**" + job.note + "**\n\n";
  text += std::to_string(counts.fits) + " fits: " + std::to_string(counts.fitted) + " done, " +
          std::to_string(counts.failed) + " failed, " + std::to_string(counts.open()) +
          " open. Errors are in the metric that was minimised, divided by the error of answering 0 everywhere; where "
          "a part has several metrics, every fit is judged by each. The smallest of each column is bold. Times are "
          "wall-clock seconds of the fit alone.\n\n";
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Part& part = parts[k];
    const std::string table = "table-" + std::to_string(k + 1) + ".csv";
    text += "## " + part.title + "\n\nNumbers: [" + table + "](" + table + ").\n\n";
    for (const std::string& judge : part.judges) {
      text += (part.judges.size() == 1 ? std::string("Error / error of the zero model") : errorName(part, judge)) +
              ":\n\n" + markdownTable(part, [&judge](const Cell& cell) { return cell.ratio(judge); }) + "\n";
    }
    text += "Seconds:\n\n" + markdownTable(part, [](const Cell& cell) { return cell.seconds; }) + "\n" + failures(part);
    writeFile(folder / table, csvTable(part, job.note));
    if (!reason.empty() || counts.fitted == 0 || interrupted()) continue;
    try {
      text += Illustrator(job, results, folder).draw(part, k + 1);
    } catch (const Error& error) {
      if (error.kind() != Error::Kind::Device) throw;
      reason = error.what();
    }
  }
  if (!reason.empty()) text += "No pictures: " + reason + "\n";
  writeFile(folder / "report.md", text);
  return reason;
}

}  // namespace brdf::app
