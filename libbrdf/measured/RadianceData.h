#pragma once
// The parts of a Radiance / WINDOW6 XML file. Internal to libbrdf/measured.
#include <brdf/material/Components.h>
#include <brdf/material/PatchBasis.h>
#include <brdf/material/TensorTree.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::radiance {

/// A file being read, for messages that name the line.
struct Source {
  std::string_view bytes;
  std::filesystem::path path;

  std::size_t lineAt(std::ptrdiff_t offset) const;
  /// Throws Error::Kind::Format at the node's line.
  [[noreturn]] void fail(const pugi::xml_node& node, std::string what, std::string found = {},
                         std::string allowed = {}) const;
};

/// Whether two texts are the same but for case and blanks at their ends, as Radiance compares names.
bool sameText(std::string_view a, std::string_view b);

/// What the numbers of the data were.
struct Counts {
  std::uint64_t negative = 0, notFinite = 0;  ///< both became 0
};

/// The angle bases that a DataDefinition defines.
std::vector<PatchBasis> readBases(const Source& source, const pugi::xml_node& definition);

/// The numbers of a ScatteringData, exactly `count` of them.
std::vector<double> readNumbers(const Source& source, const pugi::xml_node& data, std::size_t count, Counts& counts);
/// The tensor tree of a ScatteringData.
TensorTree readTree(const Source& source, const pugi::xml_node& data, int rank, Counts& counts);
/// The text of a tree's channel, the numbers with `digits` significant digits: 0 for all. Subtrees of one depth are
/// written as a grid, those of one number as that.
std::string treeText(const TensorTree& tree, std::size_t channel, int digits);

/// Colours where a grey has X = Y = Z: Radiance's own white is that of equal energy.
std::array<double, 3> rgbFromTristimulus(double x, double y, double z);
std::array<double, 3> tristimulusFromRgb(double red, double green, double blue);

}  // namespace brdf::radiance
