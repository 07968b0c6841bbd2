#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/Hdf5.h>
#include <brdf/material/Brdf.h>
#include <brdf/material/Components.h>
#include <brdf/measured/Format.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// A `.vtkhdf` file: one HDF5 file that keeps any number of BRDFs (entries) and what is known about them, and that
/// vtkHDFReader (VTK 9.1) and ParaView (5.11) open as an image.
///
///   /BRDFLab             attribute Format = 1, Program
///   /BRDFLab/0, 1, ...   one group an entry; attributes Name, Kind, Description; the BRDF as io/StoredBrdf.h says;
///                        groups Provenance; Components where the material has any (io/StoredComponents.h); for a
///                        fit, Fit (fit/StoredFit.h)
///   /VTKHDF              soft link to one table or grid; missing when the file holds none of two cells or more along
///                        each axis of its image
///
/// Entries are numbered from 0. Names are unique.

/// Where an entry comes from.
struct Provenance {
  ReadReport read;      ///< of the file that it was made from: path, reader, counts, assumptions, metadata
  std::string sha256;   ///< of that file's bytes, hexadecimal; empty when there is none
  std::string options;  ///< how it was made, e.g. the command's options
  std::string program;  ///< name and version that wrote the entry
  std::string date;     ///< ISO 8601, UTC, e.g. "2026-11-22T05:49:26Z"
};

/// Provenance of something made now, by this program, from the file that `read` tells of (its source, where that is a
/// readable file, is hashed).
BRDF_EXPORT Provenance makeProvenance(const ReadReport& read, std::string options = {});

/// Reads a container. Only what is asked for is read: opening reads the list, load(i) entry i. Throws
/// Error::Kind::File when the file cannot be opened and Error::Kind::Format where it is damaged or not a container.
class BRDF_EXPORT Container {
 public:
  struct Entry {
    std::string name;
    std::string kind;         ///< "table", "grid", "patches", "tree", "scattered" or "analytic"
    std::string description;  ///< one line, Brdf::description()
    bool isFit = false;       ///< whether a fit's report is stored with it
  };

  explicit Container(const std::filesystem::path& path);
  /// A container in memory; `where` is for messages.
  static Container fromBytes(std::string_view bytes, const std::string& where);

  /// Whether `head`, the first bytes of a file, are those of an HDF5 file.
  static bool recognises(std::string_view head);

  const std::vector<Entry>& entries() const { return entries_; }
  /// The entry that `which`, a number from 0 or a name, means; throws Error::Kind::Value with what there is.
  std::size_t find(std::string_view which) const;

  BrdfPointer load(std::size_t index) const;
  /// What the material of an entry has besides.
  Components components(std::size_t index) const;
  Provenance provenance(std::size_t index) const;
  /// The entry's group, for other modules' parts of it.
  const h5::Group& group(std::size_t index) const { return groups_.at(index); }

 private:
  explicit Container(const h5::Group& root);

  std::string where_;
  std::vector<Entry> entries_;
  std::vector<h5::Group> groups_;
};

/// Makes a container in memory; `commit` writes it. A file on disk is only ever replaced by a complete one.
class BRDF_EXPORT ContainerWriter {
 public:
  enum class Mode {
    Replace,  ///< a new file
    Append    ///< the present file's entries stay, in their order; a missing file is a new one
  };
  explicit ContainerWriter(std::filesystem::path path, Mode mode = Mode::Replace);
  ~ContainerWriter();

  /// Adds an entry and returns its group, for other modules' parts of it (of no use after `commit`). The first table
  /// or grid of a file becomes the one that VTK shows. Throws Error::Kind::Value for a name that is empty, a number,
  /// taken, or has a '#', and for a BRDF that cannot be kept (see storeBrdf).
  h5::Group add(const std::string& name, const Brdf& brdf, const Provenance& provenance,
                const Components& components = {});
  /// Makes the table called `name` the one that VTK shows.
  void show(std::string_view name);
  /// Writes the file; the writer is used up. Throws Error::Kind::File and leaves the old file alone when it cannot.
  void commit();
  /// The file as bytes, which are not written; the writer is used up.
  std::string finish();

 private:
  std::filesystem::path path_;
  h5::Builder builder_;
  std::vector<Container::Entry> entries_;
};

/// Writes `brdf` as the only entry of a new container.
BRDF_EXPORT void writeContainer(const std::filesystem::path& path, const std::string& name, const Brdf& brdf,
                                const Provenance& provenance, const Components& components = {});

}  // namespace brdf
