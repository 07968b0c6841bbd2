#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/io/JsonObject.h>

#include <cmath>

namespace brdf {
JsonObject::JsonObject(std::shared_ptr<const Json> root, const Json* value, std::string where)
    : root_(std::move(root)), value_(value), where_(std::move(where)) {
  if (!value_->is_object()) throw Error(Error::Kind::Format, {"no object", where_, shortened(*value_), "{...}"});
}

JsonObject JsonObject::read(const std::filesystem::path& path) {
  constexpr std::uint64_t kMaximumBytes = std::uint64_t{64} << 20;
  const auto root = std::make_shared<const Json>(parseJson(readFile(path, kMaximumBytes), path.string()));
  return JsonObject(root, root.get(), path.string());
}

std::string JsonObject::pathTo(const std::string& key) const {
  return where_ + (where_.find(": ") == std::string::npos ? ": " : ".") + key;
}

void JsonObject::fail(std::string what, const std::string& key, std::string found, std::string allowed) const {
  throw Error(Error::Kind::Format, {std::move(what), pathTo(key), std::move(found), std::move(allowed)});
}

const Json* JsonObject::find(const std::string& key) const {
  asked_.insert(key);
  const auto at = value_->find(key);
  return at == value_->end() ? nullptr : &*at;
}

const Json& JsonObject::need(const std::string& key, const char* allowed) const {
  if (const Json* value = find(key)) return *value;
  fail("missing", key, {}, allowed);
}

bool JsonObject::has(const std::string& key) const { return find(key) != nullptr; }

double JsonObject::number(const std::string& key) const {
  const Json& value = need(key, "a number");
  if (!value.is_number() || !std::isfinite(value.get<double>())) fail("no number", key, shortened(value), "a number");
  return value.get<double>();
}
double JsonObject::number(const std::string& key, double otherwise) const { return has(key) ? number(key) : otherwise; }

std::size_t JsonObject::count(const std::string& key, std::size_t otherwise, std::size_t least) const {
  if (!has(key)) return otherwise;
  const double value = number(key);
  if (value != std::floor(value) || value < static_cast<double>(least) || value > 9e15)
    fail("no count", key, shortened(*find(key)), "a whole number, " + std::to_string(least) + " or more");
  return static_cast<std::size_t>(value);
}

bool JsonObject::flag(const std::string& key, bool otherwise) const {
  const Json* value = find(key);
  if (!value) return otherwise;
  if (!value->is_boolean()) fail("neither true nor false", key, shortened(*value), "true, false");
  return value->get<bool>();
}

std::string JsonObject::text(const std::string& key) const {
  const Json& value = need(key, "a text");
  if (!value.is_string()) fail("no text", key, shortened(value), "\"...\"");
  return value.get<std::string>();
}
std::string JsonObject::text(const std::string& key, const std::string& otherwise) const {
  return has(key) ? text(key) : otherwise;
}

std::array<double, 3> JsonObject::triple(const std::string& key) const {
  const Json& value = need(key, "[x, y, z]");
  std::array<double, 3> numbers{};
  if (!value.is_array() || value.size() != 3) fail("not three numbers", key, shortened(value), "[x, y, z]");
  for (std::size_t k = 0; k < 3; ++k) {
    if (!value[k].is_number() || !std::isfinite(value[k].get<double>()))
      fail("not three numbers", key, shortened(value), "[x, y, z]");
    numbers[k] = value[k].get<double>();
  }
  return numbers;
}
std::array<double, 3> JsonObject::triple(const std::string& key, const std::array<double, 3>& otherwise) const {
  return has(key) ? triple(key) : otherwise;
}

std::vector<std::string> JsonObject::texts(const std::string& key) const {
  const Json& value = need(key, "a text or an array of texts");
  if (value.is_string()) return {value.get<std::string>()};
  std::vector<std::string> result;
  if (value.is_array())
    for (const Json& item : value) {
      if (!item.is_string()) fail("no text", key, shortened(item), "\"...\"");
      result.push_back(item.get<std::string>());
    }
  if (result.empty()) fail("no texts", key, shortened(value), "a text or an array of texts");
  return result;
}

std::optional<JsonObject> JsonObject::object(const std::string& key) const {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  return JsonObject(root_, value, pathTo(key));
}

std::vector<JsonObject> JsonObject::objects(const std::string& key) const {
  std::vector<JsonObject> result;
  const Json* value = find(key);
  if (!value) return result;
  if (!value->is_array()) fail("no array", key, shortened(*value), "[{...}, ...]");
  for (std::size_t k = 0; k < value->size(); ++k)
    result.push_back(JsonObject(root_, &(*value)[k], pathTo(key + "[" + std::to_string(k) + "]")));
  return result;
}

std::vector<std::string> JsonObject::names() const {
  std::vector<std::string> result;
  for (const auto& [key, value] : value_->items()) {
    asked_.insert(key);
    result.push_back(key);
  }
  return result;
}

void JsonObject::finish() const {
  for (const auto& [key, value] : value_->items()) {
    if (asked_.contains(key)) continue;
    const std::string near = closestName(key, asked_);
    std::string allowed;
    for (const std::string& name : asked_) allowed += (allowed.empty() ? "" : ", ") + name;
    throw Error(Error::Kind::Format,
                {"unknown key", where_,
                 "\"" + key.substr(0, 40) + "\"" + (near.empty() ? "" : " (did you mean \"" + near + "\"?)"), allowed});
  }
}

}  // namespace brdf
