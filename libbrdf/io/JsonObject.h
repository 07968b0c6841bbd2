#pragma once
#include <brdf/base/JsonText.h>
#include <brdf/brdf_export.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// An object of a JSON file that people write. It knows where it stands in the file, so that errors do; finish()
/// refuses keys that nobody asked for. Throws Error::Kind::Format (JSON that does not parse, a value of another kind, a
/// missing or unknown key). Its header needs nlohmann/json.hpp.
class BRDF_EXPORT JsonObject {
 public:
  /// Reads a file whose outermost value is an object; at most 64 MiB.
  static JsonObject read(const std::filesystem::path& path);

  const std::string& where() const { return where_; }
  bool has(const std::string& key) const;

  double number(const std::string& key) const;
  double number(const std::string& key, double otherwise) const;
  /// A whole number of `least` or more.
  std::size_t count(const std::string& key, std::size_t otherwise, std::size_t least = 0) const;
  bool flag(const std::string& key, bool otherwise) const;
  std::string text(const std::string& key) const;
  std::string text(const std::string& key, const std::string& otherwise) const;
  std::array<double, 3> triple(const std::string& key) const;
  std::array<double, 3> triple(const std::string& key, const std::array<double, 3>& otherwise) const;
  /// Texts of an array, or the one text that stands for it.
  std::vector<std::string> texts(const std::string& key) const;
  /// The object under `key`, or empty when the key is missing.
  std::optional<JsonObject> object(const std::string& key) const;
  /// Objects of the array under `key`; none when the key is missing.
  std::vector<JsonObject> objects(const std::string& key) const;
  /// Names of the object's own keys, in the file's order: for objects whose keys are names. All count as asked for.
  std::vector<std::string> names() const;

  /// Throws for a key that nothing above asked for, naming the nearest that was.
  void finish() const;

  [[noreturn]] void fail(std::string what, const std::string& key, std::string found, std::string allowed) const;

 private:
  JsonObject(std::shared_ptr<const Json> root, const Json* value, std::string where);
  const Json* find(const std::string& key) const;
  const Json& need(const std::string& key, const char* allowed) const;
  std::string pathTo(const std::string& key) const;

  std::shared_ptr<const Json> root_;
  const Json* value_;
  std::string where_;
  mutable std::set<std::string> asked_;
};

}  // namespace brdf
