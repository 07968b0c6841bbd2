#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/render/GltfCheck.h>
#include <brdf/render/MeshFileChecks.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace brdf {
namespace {

constexpr std::uint64_t kMaximumCount = std::uint64_t{1} << 26;  // points, or polygons
constexpr std::uint64_t kMaximumBytes = std::uint64_t{1} << 30;

[[noreturn]] void refuse(const std::string& where, const char* what, std::string found = {}, std::string allowed = {}) {
  throw Error(Error::Kind::Format, {what, where, std::move(found), std::move(allowed)});
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t at = 0; at < line.size();) {
    while (at < line.size() && std::isspace(static_cast<unsigned char>(line[at]))) ++at;
    const std::size_t start = at;
    while (at < line.size() && !std::isspace(static_cast<unsigned char>(line[at]))) ++at;
    if (at > start) result.push_back(line.substr(start, at - start));
  }
  return result;
}

/// A count as a file writes it, up to `most`.
std::uint64_t countFrom(std::string_view text, std::uint64_t most, const std::string& where) {
  const auto number = parseNumber(text);
  if (!number || *number < 0 || *number != std::floor(*number) || *number > double(most))
    refuse(where, "not a count that the file can hold", std::string(text), "0 to " + std::to_string(most));
  return static_cast<std::uint64_t>(*number);
}

struct PlyProperty {
  std::size_t size, countSize;  ///< bytes of a value; of the count of a list, or 0
};
struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;
};

std::size_t plySize(std::string_view type, const std::string& where) {
  for (const auto& [name, size] : {std::pair{"char", 1},
                                   {"uchar", 1},
                                   {"int8", 1},
                                   {"uint8", 1},
                                   {"short", 2},
                                   {"ushort", 2},
                                   {"int16", 2},
                                   {"uint16", 2},
                                   {"int", 4},
                                   {"uint", 4},
                                   {"int32", 4},
                                   {"uint32", 4},
                                   {"float", 4},
                                   {"float32", 4},
                                   {"double", 8},
                                   {"float64", 8}})
    if (type == name) return static_cast<std::size_t>(size);
  refuse(where, "unknown type of a property", std::string(type), "a type of the PLY format");
}

std::uint64_t plyListCount(const char* bytes, std::size_t size, bool bigEndian) {
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < size; ++k)
    value |= std::uint64_t{static_cast<unsigned char>(bytes[bigEndian ? size - 1 - k : k])} << 8 * k;
  return value;
}

void checkPly(const std::string& bytes, const std::string& path) {
  std::vector<PlyElement> elements;
  std::string format;
  std::size_t at = 0, line = 0;
  for (;;) {
    const std::size_t end = bytes.find('\n', at);
    ++line;
    const std::string where = path + ", line " + std::to_string(line);
    if (end == std::string::npos || end > std::size_t{1} << 20) refuse(where, "the header has no end");
    const auto text = words(std::string_view(bytes).substr(at, end - at));
    at = end + 1;
    if (line == 1 && (text.empty() || text[0] != "ply")) refuse(where, "not a PLY file");
    if (text.empty()) continue;
    if (text[0] == "end_header") break;
    if (text[0] == "format" && text.size() > 1) format = text[1];
    if (text[0] == "element") {
      if (text.size() != 3) refuse(where, "malformed element");
      elements.push_back(
          {std::string(text[1]), countFrom(text[2], std::min<std::uint64_t>(kMaximumCount, bytes.size()), where), {}});
    }
    if (text[0] != "property") continue;
    if (elements.empty()) refuse(where, "a property of no element");
    const bool list = text.size() == 5 && text[1] == "list";
    if (!list && text.size() != 3) refuse(where, "malformed property");
    elements.back().properties.push_back(
        {plySize(text[list ? 3 : 1], where), list ? plySize(text[2], where) : std::size_t{0}});
  }
  const bool ascii = format == "ascii", bigEndian = format == "binary_big_endian";
  if (!ascii && !bigEndian && format != "binary_little_endian")
    refuse(path, "unknown format of a PLY file", format, "ascii, binary_little_endian, binary_big_endian");
  for (const PlyElement& element : elements)
    for (std::uint64_t k = 0; k < element.count; ++k) {
      const auto where = [&] { return path + ", " + element.name + " " + std::to_string(k); };
      if (at >= bytes.size()) refuse(where(), "the file ends early");
      if (ascii) {
        const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
        const auto text = words(std::string_view(bytes).substr(at, end - at));
        at = end + 1;
        std::size_t used = 0;
        for (const PlyProperty& property : element.properties) {
          if (used >= text.size()) refuse(where(), "numbers are missing");
          used += 1 + (property.countSize ? countFrom(text[used], text.size() - used - 1, where()) : 0);
        }
        continue;
      }
      for (const PlyProperty& property : element.properties) {
        std::uint64_t values = 1;
        if (property.countSize) {
          if (bytes.size() - at < property.countSize) refuse(where(), "the file ends early");
          values = plyListCount(bytes.data() + at, property.countSize, bigEndian);
          at += property.countSize;
        }
        if (values > (bytes.size() - at) / property.size) refuse(where(), "the file ends early");
        at += values * property.size;
      }
    }
}

void checkObj(const std::string& bytes, const std::string& path) {
  std::array<std::uint64_t, 3> counts{};  // of v, vt, vn
  const auto lines = split(bytes, '\n');
  for (const std::string_view text : lines) {
    if (text.starts_with("v ") || text.starts_with("v\t")) ++counts[0];
    if (text.starts_with("vt")) ++counts[1];
    if (text.starts_with("vn")) ++counts[2];
  }
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const auto text = words(lines[line]);
    if (text.empty() || (text[0] != "f" && text[0] != "l" && text[0] != "p")) continue;
    for (std::size_t k = 1; k < text.size(); ++k) {
      const auto indices = split(text[k], '/');
      for (std::size_t i = 0; i < std::min<std::size_t>(indices.size(), 3); ++i) {
        if (indices[i].empty()) continue;
        const auto number = parseNumber(indices[i]);
        if (!number || *number == 0 || std::abs(*number) > double(counts[i]) || *number != std::floor(*number))
          refuse(path + ", line " + std::to_string(line + 1), "a corner is none of the points before or after it",
                 std::string(indices[i]), "1 to " + std::to_string(counts[i]));
      }
    }
  }
}

void checkStl(const std::string& bytes, const std::string& path) {
  if (bytes.size() < 84) {
    if (!bytes.starts_with("solid")) refuse(path, "neither a text nor a binary STL file");
    return;
  }
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  const bool fits = 84 + std::uint64_t{50} * count <= bytes.size();
  if (!fits && !bytes.starts_with("solid"))
    refuse(path, "more triangles than the file holds", std::to_string(count), std::to_string((bytes.size() - 84) / 50));
}

void checkVtp(const std::string& bytes, const std::string& path) {
  constexpr std::string_view key = "NumberOf";
  for (std::size_t at = 0; (at = bytes.find(key, at)) != std::string::npos; ++at) {
    const std::size_t open = bytes.find('"', at), close = bytes.find('"', open + 1);
    if (open == std::string::npos || close == std::string::npos || open - at > 40) continue;
    countFrom(trimmed(std::string_view(bytes).substr(open + 1, close - open - 1)), kMaximumCount,
              path + ", " + bytes.substr(at, open - at));
  }
}

}  // namespace

void checkMeshFile(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::string bytes = readFile(path, kMaximumBytes);
  if (ending == ".ply") checkPly(bytes, path.string());
  if (ending == ".obj") checkObj(bytes, path.string());
  if (ending == ".stl") checkStl(bytes, path.string());
  if (ending == ".vtp") checkVtp(bytes, path.string());
  if (ending == ".gltf" || ending == ".glb") checkGltf(bytes, path);
}

}  // namespace brdf
