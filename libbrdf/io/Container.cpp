#include <brdf/Version.h>
#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/io/Container.h>
#include <brdf/io/Sha256.h>
#include <brdf/io/StoredBrdf.h>
#include <brdf/io/StoredComponents.h>

#include <algorithm>
#include <chrono>
#include <ctime>

namespace brdf {
namespace {

constexpr std::int64_t kFormat = 1;
constexpr std::size_t kMaximumNameLength = 200;

bool isNumber(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string utcNow() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

struct Listing {
  std::vector<Container::Entry> entries;
  std::vector<h5::Group> groups;
};

Listing list(const h5::Group& root) {
  if (!root.hasObject("BRDFLab"))
    throw Error(Error::Kind::Format,
                {"an HDF5 file, but not a BRDFLab container", root.where(), "no group /BRDFLab", {}});
  const h5::Group home = root.group("BRDFLab");
  const std::int64_t format = home.integer("Format");
  if (format != kFormat)
    throw Error(Error::Kind::Format,
                {"unknown version of the container", home.where(), std::to_string(format), std::to_string(kFormat)});
  Listing listing;
  for (std::size_t i = 0; home.hasObject(std::to_string(i)); ++i) {
    const h5::Group group = home.group(std::to_string(i));
    listing.entries.push_back(
        {group.text("Name"), group.text("Kind"), group.text("Description"), group.hasObject("Fit")});
    listing.groups.push_back(group);
  }
  return listing;
}

void storeProvenance(const h5::Group& group, const Provenance& provenance) {
  const ReadReport& read = provenance.read;
  group.setText("Program", provenance.program);
  group.setText("Date", provenance.date);
  group.setText("Options", provenance.options);
  group.setText("Source", read.source);
  group.setText("SHA-256", provenance.sha256);
  group.setText("Reader", read.format);
  group.setInteger("Samples", static_cast<std::int64_t>(read.samples));
  group.setInteger("Invalid", static_cast<std::int64_t>(read.invalid));
  group.setInteger("Negative", static_cast<std::int64_t>(read.negative));
  group.setInteger("NotFinite", static_cast<std::int64_t>(read.notFinite));
  group.setInteger("BelowHorizon", static_cast<std::int64_t>(read.belowHorizon));
  group.setTexts("Assumptions", read.assumptions);
  group.setTexts("Warnings", read.warnings);
  std::vector<std::string> keys, values;
  for (const auto& [key, value] : read.metadata) {
    keys.push_back(key);
    values.push_back(value);
  }
  group.setTexts("MetadataKeys", keys);
  group.setTexts("MetadataValues", values);
}

Provenance restoreProvenance(const h5::Group& group) {
  const auto count = [&](const char* name) { return static_cast<std::uint64_t>(group.integer(name)); };
  Provenance provenance;
  ReadReport& read = provenance.read;
  provenance.program = group.text("Program");
  provenance.date = group.text("Date");
  provenance.options = group.text("Options");
  read.source = group.text("Source");
  provenance.sha256 = group.text("SHA-256");
  read.format = group.text("Reader");
  read.samples = count("Samples");
  read.invalid = count("Invalid");
  read.negative = count("Negative");
  read.notFinite = count("NotFinite");
  read.belowHorizon = count("BelowHorizon");
  read.assumptions = group.texts("Assumptions");
  read.warnings = group.texts("Warnings");
  const std::vector<std::string> keys = group.texts("MetadataKeys"), values = group.texts("MetadataValues");
  for (std::size_t i = 0; i < std::min(keys.size(), values.size()); ++i) read.metadata[keys[i]] = values[i];
  return provenance;
}

std::string presentBytes(const std::filesystem::path& path, ContainerWriter::Mode mode) {
  if (mode == ContainerWriter::Mode::Replace || !std::filesystem::exists(path)) return {};
  return readFile(path);
}

/// VTK 9.1 writes past its heap when an image has one point along an axis: such a table is never shown to it.
bool vtkReads(const h5::Group& table, const std::string& kind) {
  if (kind != "table" && kind != "grid") return false;
  const std::vector<std::int64_t> extent = table.integers("WholeExtent", 6);
  return extent[1] > 0 && extent[3] > 0 && extent[5] > 0;
}

std::string entryPath(std::size_t index) { return "/BRDFLab/" + std::to_string(index); }

}  // namespace

Provenance makeProvenance(const ReadReport& read, std::string options) {
  Provenance provenance;
  provenance.read = read;
  provenance.options = std::move(options);
  provenance.program = "BRDFLab " BRDF_VERSION;
  provenance.date = utcNow();
  std::error_code ignored;
  try {
    if (std::filesystem::is_regular_file(read.source, ignored)) provenance.sha256 = sha256(readFile(read.source));
  } catch (const Error&) {  // gone or closed to us since it was read: no hash
  }
  return provenance;
}

// ----- reading -----------------------------------------------------------------------------------------------------

Container::Container(const std::filesystem::path& path) : Container(h5::openFile(path)) {}

Container Container::fromBytes(std::string_view bytes, const std::string& where) {
  return Container(h5::openBytes(bytes, where));
}

Container::Container(const h5::Group& root) : where_(root.where()) {
  Listing listing = list(root);
  entries_ = std::move(listing.entries);
  groups_ = std::move(listing.groups);
}

bool Container::recognises(std::string_view head) { return head.starts_with(std::string_view("\x89HDF\r\n\x1a\n", 8)); }

std::size_t Container::find(std::string_view which) const {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].name == which || std::to_string(i) == which) return i;
    known.push_back(std::to_string(i) + " (" + entries_[i].name + ")");
  }
  throw Error(Error::Kind::Value, {"no such entry", where_, std::string(which),
                                   known.empty() ? "none: the container is empty" : joined(known)});
}

BrdfPointer Container::load(std::size_t index) const {
  const Entry& entry = entries_.at(index);
  return restoreBrdf(groups_.at(index), entry.kind, entry.description);
}

Components Container::components(std::size_t index) const { return restoreComponents(groups_.at(index)); }

Provenance Container::provenance(std::size_t index) const {
  return restoreProvenance(groups_.at(index).group("Provenance"));
}

// ----- writing -----------------------------------------------------------------------------------------------------

ContainerWriter::ContainerWriter(std::filesystem::path path, Mode mode)
    : path_(std::move(path)), builder_(presentBytes(path_, mode), path_.string()) {
  const h5::Group& root = builder_.root();
  if (mode == Mode::Append && std::filesystem::exists(path_)) {
    entries_ = list(root).entries;
  } else {
    const h5::Group home = root.createGroup("BRDFLab");
    home.setInteger("Format", kFormat);
    home.setText("Program", "BRDFLab " BRDF_VERSION);
  }
}

ContainerWriter::~ContainerWriter() = default;

h5::Group ContainerWriter::add(const std::string& name, const Brdf& brdf, const Provenance& provenance,
                               const Components& components) {
  const auto taken = [&](const Container::Entry& entry) { return entry.name == name; };
  if (name.empty() || name.size() > kMaximumNameLength || isNumber(name) || name.find('#') != std::string::npos ||
      std::any_of(entries_.begin(), entries_.end(), taken))
    throw Error(Error::Kind::Value, {"bad name for an entry", path_.string(), name,
                                     "1 to 200 bytes, no number, no '#', not taken by another entry"});
  const std::string number = std::to_string(entries_.size());
  const h5::Group home = builder_.root().group("BRDFLab");
  const h5::Group group = home.createGroup(number);
  Container::Entry entry{name, {}, brdf.description()};
  try {
    entry.kind = storeBrdf(group, brdf);
    group.setText("Name", entry.name);
    group.setText("Kind", entry.kind);
    group.setText("Description", entry.description);
    storeProvenance(group.createGroup("Provenance"), provenance);
    storeComponents(group, components);
  } catch (...) {
    home.remove(number);
    throw;
  }
  if (vtkReads(group, entry.kind) && builder_.root().linkTarget("VTKHDF").empty())
    builder_.root().linkTo("VTKHDF", entryPath(entries_.size()));
  entries_.push_back(std::move(entry));
  return group;
}

void ContainerWriter::show(std::string_view name) {
  std::vector<std::string> tables;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!vtkReads(builder_.root().group("BRDFLab").group(std::to_string(i)), entries_[i].kind)) continue;
    tables.push_back(entries_[i].name);
    if (entries_[i].name == name) return builder_.root().linkTo("VTKHDF", entryPath(i));
  }
  throw Error(Error::Kind::Value, {"no such table", path_.string(), std::string(name), joined(tables)});
}

void ContainerWriter::commit() { writeFile(path_, finish()); }

std::string ContainerWriter::finish() { return builder_.finish(); }

void writeContainer(const std::filesystem::path& path, const std::string& name, const Brdf& brdf,
                    const Provenance& provenance, const Components& components) {
  ContainerWriter writer(path);
  writer.add(name, brdf, provenance, components);
  writer.commit();
}

}  // namespace brdf
