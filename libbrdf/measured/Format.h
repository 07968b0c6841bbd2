#pragma once
#include <brdf/brdf_export.h>
#include <brdf/color/ColourSettings.h>
#include <brdf/material/Brdf.h>
#include <brdf/material/Components.h>
#include <brdf/measured/ReadOptions.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// What a reader noticed and assumed; shown by `brdf info`, stored as provenance.
struct ReadReport {
  std::string format;         ///< name of the format that read it, e.g. "merl"
  std::string source;         ///< path as given
  std::uint64_t samples = 0;  ///< samples or cells in the file
  std::uint64_t invalid = 0;  ///< of those: marked invalid, or not usable
  std::uint64_t negative = 0;
  std::uint64_t notFinite = 0;
  std::uint64_t belowHorizon = 0;               ///< of the invalid: directions below the horizon
  std::vector<std::string> assumptions;         ///< one sentence each: quantity, units, symmetry, colour, interpolation
  std::vector<std::string> warnings;            ///< one sentence each
  std::map<std::string, std::string> metadata;  ///< what the file says of itself
};

struct ReadResult {
  /// The front reflection; where the file has none, its first component, and a warning says which.
  BrdfPointer brdf;
  ReadReport report;
  Components components{};  ///< what the file has besides
};

/// What a writer lost.
struct WriteReport {
  std::vector<std::string> losses;  ///< one sentence each: spectrum, anisotropy, validity, resolution
};

/// A file of a folder, already read.
struct NamedBytes {
  std::filesystem::path path;
  std::string bytes;
};

/// Something that the writer of a format can be told: "NAME:KEY=VALUE,KEY=VALUE" in place of the format's name.
struct WriteSetting {
  std::string key;
  std::string values;   ///< "full, half, quarter", "1 to 8"
  std::string meaning;  ///< one line, with the default
};

/// A file format of measured (or tabulated) BRDFs: one record in the registry, one pair of files in measured/.
struct Format {
  std::string name;       ///< short, lower case: "merl"
  std::string title;      ///< "MERL BRDF database, binary"
  std::string extension;  ///< for writing, with the dot: ".binary"
  /// How sure the format is that `head` (the first kilobytes of a file of `size` bytes) is its own: 0 no, 100 certain
  /// (a magic number). The highest wins; extensions never decide.
  std::function<int(std::string_view head, std::uint64_t size)> recognise;
  /// Reads the file's bytes. Throws Error::Kind::Format with offset or line. `path` is for messages only. `options`
  /// are those of `takes` alone: every one that is given is honoured, and recorded as an assumption (choose()). Null
  /// for another way of writing a format that a record of its own reads; its `recognise` says 0.
  std::function<ReadResult(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options)> read;
  /// Writes any BRDF, resampling where needed; null when the format is read-only. Writes to `path` as given (the caller
  /// passes AtomicFile's temporary).
  std::function<WriteReport(const Brdf& brdf, const std::filesystem::path& path)> write;
  /// Keys of the read options that have a meaning for this format (readOptionKeys()); any other is refused.
  std::vector<std::string> takes{};
  /// For formats of one file an incidence: reads the files of a folder as one BRDF, writes one into an empty folder.
  /// Null for others.
  std::function<ReadResult(std::span<const NamedBytes> files, const std::filesystem::path& folder,
                           const ReadOptions& options)>
      readFolder{};
  std::function<WriteReport(const Brdf& brdf, const std::filesystem::path& folder)> writeFolder{};
  /// Writes what a material has besides its front reflection, too; `front` is null where it has none. Null for formats
  /// of one distribution.
  std::function<WriteReport(const Brdf* front, const Components& components, const std::filesystem::path& path)>
      writeMaterial{};
  /// Holds colours, no spectra: writeMeasured() reduces spectral data to linear sRGB before `write` sees them.
  bool coloursOnly = false;
  /// What the writer can be told, and the format with its writer told so: each key once, of those listed. Throws
  /// Error::Kind::Usage about a value. Null where there is nothing to tell.
  std::vector<WriteSetting> settings{};
  std::function<Format(const std::map<std::string, std::string>& values)> configured{};
};

/// All formats; ours first, then those registered from outside.
BRDF_EXPORT std::span<const Format> allFormats();
/// Adds a format; replaces one of the same name.
BRDF_EXPORT void registerFormat(Format format);
/// The format called `name`, or throws Error::Kind::Value with the allowed names.
BRDF_EXPORT const Format& findFormat(std::string_view name);
/// The format that `text` means: a name, or a name and settings, as in "radiance_tree:depth=5,tolerance=0.02". Throws
/// Error::Kind::Value for the name and Error::Kind::Usage for a setting, with what is allowed.
BRDF_EXPORT Format configuredFormat(std::string_view text);

/// Reads a measured file of any registered format, recognised by content. Throws Error::Kind::Format when no format
/// recognises it, and Error::Kind::Value for an option that the format does not take. A folder is read when a format of
/// one file an incidence recognises every file in it (hidden ones left out). What lint() finds is among the warnings.
BRDF_EXPORT ReadResult readMeasured(const std::filesystem::path& path, const ReadOptions& options = {});

/// Writes `brdf` to `path`, replacing it only when complete. `format` empty: chosen by the extension of `path`;
/// else as configuredFormat() takes it. A format of one file an incidence writes a folder when `path` is an empty one
/// or ends with '/'. `colour`: how spectral data become colours where the format has no spectra (Format::coloursOnly).
BRDF_EXPORT WriteReport writeMeasured(const Brdf& brdf, const std::filesystem::path& path, std::string_view format = {},
                                      const ColourSettings& colour = {});
/// The same with the components that came with `brdf` (ReadResult); what the format does not take is a loss.
BRDF_EXPORT WriteReport writeMeasured(const Brdf& brdf, const Components& components, const std::filesystem::path& path,
                                      std::string_view format = {}, const ColourSettings& colour = {});

}  // namespace brdf
