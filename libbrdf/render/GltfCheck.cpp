#include <brdf/base/Error.h>
#include <brdf/base/JsonText.h>
#include <brdf/render/GltfCheck.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace brdf {
namespace {

constexpr std::uint64_t kMaximumCount = std::uint64_t{1} << 26;

/// One file; names follow the specification (Khronos Group, "glTF 2.0 Specification", sections 3.4 to 3.7 and 4.4).
class Gltf {
 public:
  Gltf(const std::string& bytes, const std::filesystem::path& path) : path_(path) {
    std::string_view text = bytes;
    if (bytes.starts_with("glTF")) {
      const std::uint32_t length = word(bytes, 12);
      if (length > bytes.size() - 20) fail("chunk 0", "the file ends early", std::to_string(length));
      text = text.substr(20, length);
      const std::uint64_t next = 20 + std::uint64_t{length};
      if (bytes.size() >= next + 8) {
        binary_ = word(bytes, next);
        if (binary_ > bytes.size() - next - 8) fail("chunk 1", "the file ends early", std::to_string(binary_));
      }
    }
    root_ = parseJson(text, path.string());
    if (!root_.is_object()) fail("", "no object", shortened(root_));
  }

  void check() {
    const Json& buffers = list(root_, "buffers");
    for (std::size_t k = 0; k < buffers.size(); ++k) checkBuffer(buffers[k], at("buffers", k));
    const Json& views = list(root_, "bufferViews");
    for (std::size_t k = 0; k < views.size(); ++k) checkView(views[k], at("bufferViews", k));
    const Json& accessors = list(root_, "accessors");
    for (std::size_t k = 0; k < accessors.size(); ++k) checkAccessor(accessors[k], at("accessors", k));
    checkIndices(root_, "");
    checkTrees();
  }

 private:
  [[noreturn]] void fail(const std::string& where, const char* what, std::string found = {},
                         std::string allowed = {}) const {
    throw Error(Error::Kind::Format,
                {what, path_.string() + (where.empty() ? "" : ": " + where), std::move(found), std::move(allowed)});
  }
  static std::string at(const std::string& name, std::size_t k) { return name + "[" + std::to_string(k) + "]"; }

  std::uint32_t word(const std::string& bytes, std::uint64_t offset) const {
    if (bytes.size() < 20 || offset > bytes.size() - 4) fail("", "the file ends early");
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, 4);
    return value;
  }

  const Json& list(const Json& object, const char* key) const {
    static const Json none = Json::array();
    const auto found = object.find(key);
    if (found == object.end()) return none;
    if (!found->is_array()) fail(key, "no array", shortened(*found), "[...]");
    return *found;
  }

  std::uint64_t number(const Json& object, const char* key, const std::string& where, std::uint64_t otherwise) const {
    if (!object.is_object()) fail(where, "no object", shortened(object), "{...}");
    const auto found = object.find(key);
    if (found == object.end()) return otherwise;
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() > std::uint64_t{1} << 40)
      fail(where + "." + key, "not a whole number of 0 or more", shortened(*found));
    return found->get<std::uint64_t>();
  }

  void checkBuffer(const Json& buffer, const std::string& where) const {
    const std::uint64_t length = number(buffer, "byteLength", where, 0);
    const auto uri = buffer.find("uri");
    std::uint64_t there = binary_;
    if (uri != buffer.end()) {
      if (!uri->is_string()) fail(where + ".uri", "no text", shortened(*uri));
      const auto& text = uri->get_ref<const std::string&>();
      if (text.starts_with("data:")) {
        const std::size_t comma = text.find(',');
        there = comma == std::string::npos ? 0 : (text.size() - comma - 1) / 4 * 3;
      } else {
        std::error_code error;
        there = std::filesystem::file_size(path_.parent_path() / text, error);
        if (error) throw Error(Error::Kind::File, {"cannot be read", (path_.parent_path() / text).string(), "", ""});
      }
    }
    if (length > there)
      fail(where, "a buffer shorter than it says", std::to_string(there) + " bytes", std::to_string(length));
  }

  void checkView(const Json& view, const std::string& where) const {
    const Json& buffers = list(root_, "buffers");
    const std::uint64_t buffer = number(view, "buffer", where, 0), offset = number(view, "byteOffset", where, 0),
                        length = number(view, "byteLength", where, 0), stride = number(view, "byteStride", where, 0);
    if (buffer >= buffers.size()) fail(where + ".buffer", "no such buffer", std::to_string(buffer));
    if (offset + length > number(buffers[buffer], "byteLength", at("buffers", buffer), 0))
      fail(where, "a view past the end of its buffer", std::to_string(offset + length));
    if (stride > 252) fail(where + ".byteStride", "out of range", std::to_string(stride), "at most 252");
  }

  void checkAccessor(const Json& accessor, const std::string& where) const {
    static const std::map<std::uint64_t, std::uint64_t> sizes{{5120, 1}, {5121, 1}, {5122, 2},
                                                              {5123, 2}, {5125, 4}, {5126, 4}};
    static const std::map<std::string, std::uint64_t> components{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                                 {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    const std::uint64_t type = number(accessor, "componentType", where, 0), count = number(accessor, "count", where, 0);
    const auto kind = accessor.find("type");
    if (!sizes.contains(type)) fail(where + ".componentType", "unknown", std::to_string(type), "5120 to 5126");
    if (kind == accessor.end() || !kind->is_string() || !components.contains(kind->get<std::string>()))
      fail(where + ".type", "unknown", kind == accessor.end() ? "" : shortened(*kind), "SCALAR, VEC2 to MAT4");
    if (count < 1 || count > kMaximumCount)
      fail(where + ".count", "out of range", std::to_string(count), "1 to " + std::to_string(kMaximumCount));
    if (accessor.contains("sparse")) fail(where, "sparse accessors are not read");
    const Json& views = list(root_, "bufferViews");
    const std::uint64_t view = number(accessor, "bufferView", where, views.size());
    if (view >= views.size()) fail(where + ".bufferView", "no such view", std::to_string(view));
    const std::uint64_t element = sizes.at(type) * components.at(kind->get<std::string>());
    const std::uint64_t given = number(views[view], "byteStride", where, 0), stride = given > 0 ? given : element;
    if (number(accessor, "byteOffset", where, 0) + (count - 1) * stride + element >
        number(views[view], "byteLength", where, 0))
      fail(where, "an accessor past the end of its view", std::to_string(count) + " elements");
  }

  void checkIndex(const Json& value, const std::string& where, const char* of) const {
    const std::size_t count = list(root_, of).size();
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= count)
      fail(where, "an index of nothing", shortened(value), "below " + std::to_string(count) + " (" + of + ")");
  }

  /// Every index of the file, by the names that the specification gives them.
  void checkIndices(const Json& value, const std::string& where) const {
    static const std::map<std::string, const char*> ones{{"buffer", "buffers"},    {"bufferView", "bufferViews"},
                                                         {"mesh", "meshes"},       {"skin", "skins"},
                                                         {"camera", "cameras"},    {"material", "materials"},
                                                         {"indices", "accessors"}, {"inverseBindMatrices", "accessors"},
                                                         {"source", "images"},     {"input", "accessors"},
                                                         {"output", "accessors"},  {"skeleton", "nodes"},
                                                         {"node", "nodes"},        {"scene", "scenes"}};
    if (value.is_array())
      for (std::size_t k = 0; k < value.size(); ++k) checkIndices(value[k], at(where, k));
    if (!value.is_object()) return;
    for (const auto& [key, entry] : value.items()) {
      if (key == "extras" || key == "extensions") continue;
      const std::string here = where.empty() ? key : where + "." + key;
      const bool nodes = (key == "nodes" && !where.empty()) || key == "children" || key == "joints";
      if (const auto one = ones.find(key); one != ones.end() && !entry.is_object())
        checkIndex(entry, here, one->second);
      else if (key == "index" && where.ends_with("Texture"))
        checkIndex(entry, here, "textures");
      else if (nodes && entry.is_array())
        for (std::size_t k = 0; k < entry.size(); ++k) checkIndex(entry[k], at(here, k), "nodes");
      else if (key == "attributes" && entry.is_object())
        for (const auto& [name, accessor] : entry.items()) checkIndex(accessor, here + "." + name, "accessors");
      else
        checkIndices(entry, here);
    }
  }

  /// Section 3.5.2: nodes have one parent at most and are not their own ancestors.
  void checkTrees() const {
    const Json& nodes = list(root_, "nodes");
    std::vector<std::size_t> parent(nodes.size(), nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (const Json& child : list(nodes[k], "children")) {
        const auto index = child.get<std::size_t>();
        if (parent[index] != nodes.size()) fail(at("nodes", index), "a node with two parents");
        parent[index] = k;
      }
    constexpr std::size_t deepest = 256;  // readers recurse
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      std::size_t depth = 0;
      for (std::size_t up = k; up != nodes.size(); up = parent[up])
        if (++depth > deepest) fail(at("nodes", k), "nodes nested in a circle, or too deep", "", "at most 256 levels");
    }
  }

  const std::filesystem::path& path_;
  Json root_;
  std::uint64_t binary_ = 0;  ///< bytes of a .glb's own buffer
};

}  // namespace

void checkGltf(const std::string& bytes, const std::filesystem::path& path) { Gltf(bytes, path).check(); }

}  // namespace brdf
