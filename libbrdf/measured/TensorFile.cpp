#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/measured/TensorFile.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace brdf {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are copied as they are");

constexpr std::size_t kHeaderBytes = 12 + 2 + 4;
constexpr std::size_t kAlignment = 8;
constexpr const char* kTypeNames[] = {"",      "uint8",  "int8",  "uint16",  "int16",   "uint32",
                                      "int32", "uint64", "int64", "float16", "float32", "float64"};
constexpr std::size_t kTypeBytes[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};

template <class T>
void append(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string shapeText(const std::vector<std::size_t>& shape) {
  std::string text;
  for (const std::size_t n : shape) text += (text.empty() ? "" : " x ") + std::to_string(n);
  return text;
}

}  // namespace

std::size_t TensorFile::Field::count() const {
  std::size_t product = 1;
  for (const std::size_t n : shape) product *= n;
  return product;
}

TensorFile::TensorFile(std::string_view bytes, const std::filesystem::path& path) : path_(path) {
  std::size_t at = 0;
  const auto bad = [&](std::string what, std::string found, std::string allowed) {
    throw Error(Error::Kind::Format, {std::move(what), path.string() + ", offset " + std::to_string(at),
                                      std::move(found), std::move(allowed)});
  };
  const auto take = [&]<class T>(T& value) {
    if (bytes.size() - at < sizeof value)
      bad("the directory of the tensor file is cut short", std::to_string(bytes.size()) + " bytes", "more");
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
  };
  if (bytes.size() < kHeaderBytes || bytes.substr(0, kMagic.size()) != kMagic)
    bad("not a tensor file", std::to_string(bytes.size()) + " bytes", "\"tensor_file\" and a header");
  at = kMagic.size();
  std::uint8_t major = 0, minor = 0;
  std::uint32_t count = 0;
  take(major);
  take(minor);
  if (major != 1 || minor != 0)
    bad("unknown version of the tensor file", std::to_string(major) + "." + std::to_string(minor), "1.0");
  take(count);
  for (std::uint32_t f = 0; f < count; ++f) {
    Field field;
    std::uint16_t length = 0, dimensions = 0;
    take(length);
    if (bytes.size() - at < length) bad("a field's name is cut short", std::to_string(length) + " bytes", "less");
    field.name = std::string(bytes.substr(at, length));
    at += length;
    take(dimensions);
    std::uint8_t type = 0;
    take(type);
    if (type < 1 || type > 11) bad("unknown type of field " + field.name, std::to_string(type), "1 to 11");
    field.type = static_cast<Type>(type);
    std::uint64_t offset = 0, size = kTypeBytes[type];
    take(offset);
    for (std::uint16_t d = 0; d < dimensions; ++d) {
      std::uint64_t n = 0;
      take(n);
      // What lies in the file bounds every product.
      if (n == 0 || n > bytes.size() || size > bytes.size() / n)
        bad("wrong shape of field " + field.name, std::to_string(n) + " in dimension " + std::to_string(d),
            "what " + std::to_string(bytes.size()) + " bytes can hold");
      size *= n;
      field.shape.push_back(static_cast<std::size_t>(n));
    }
    if (offset > bytes.size() || size > bytes.size() - offset)
      bad("the data of field " + field.name + " lie outside the file",
          std::to_string(size) + " bytes at " + std::to_string(offset), std::to_string(bytes.size()) + " bytes");
    field.data = bytes.substr(offset, size);
    fields_.push_back(std::move(field));
  }
}

bool TensorFile::has(std::string_view name) const {
  return std::ranges::find(fields_, name, &Field::name) != fields_.end();
}

void TensorFile::fail(std::string_view field, std::string what, std::string found, std::string allowed) const {
  throw Error(Error::Kind::Format, {std::move(what), path_.string() + ", field " + std::string(field), std::move(found),
                                    std::move(allowed)});
}

const TensorFile::Field& TensorFile::field(std::string_view name, Type type, std::size_t dimensions) const {
  const auto found = std::ranges::find(fields_, name, &Field::name);
  if (found == fields_.end()) {
    std::vector<std::string> names;
    for (const Field& f : fields_) names.push_back(f.name);
    fail(name, "missing field", "fields " + joined(names), std::string(name));
  }
  if (found->type != type)
    fail(name, "wrong type", kTypeNames[static_cast<std::size_t>(found->type)],
         kTypeNames[static_cast<std::size_t>(type)]);
  if (found->shape.size() != dimensions)
    fail(name, "wrong shape", shapeText(found->shape), std::to_string(dimensions) + " dimensions");
  return *found;
}

std::vector<float> TensorFile::floats(std::string_view name, std::size_t dimensions) const {
  const Field& f = field(name, Type::F32, dimensions);
  std::vector<float> values(f.count());
  std::memcpy(values.data(), f.data.data(), 4 * values.size());
  return values;
}

void TensorWriter::add(std::string name, const std::vector<std::size_t>& shape, const std::vector<float>& values) {
  fields_.push_back({std::move(name), TensorFile::Type::F32, shape,
                     std::string(reinterpret_cast<const char*>(values.data()), 4 * values.size())});
}

void TensorWriter::add(std::string name, std::string_view bytes) {
  fields_.push_back({std::move(name), TensorFile::Type::U8, {bytes.size()}, std::string(bytes)});
}

std::string TensorWriter::bytes() const {
  std::size_t directory = kHeaderBytes;
  for (const Field& f : fields_) directory += 2 + f.name.size() + 2 + 1 + 8 + 8 * f.shape.size();
  const auto aligned = [](std::size_t n) { return (n + kAlignment - 1) / kAlignment * kAlignment; };
  std::string out(TensorFile::kMagic);
  out += '\x01';
  out += '\0';
  append(out, static_cast<std::uint32_t>(fields_.size()));
  std::size_t offset = aligned(directory);
  for (const Field& f : fields_) {
    append(out, static_cast<std::uint16_t>(f.name.size()));
    out += f.name;
    append(out, static_cast<std::uint16_t>(f.shape.size()));
    append(out, static_cast<std::uint8_t>(f.type));
    append(out, static_cast<std::uint64_t>(offset));
    for (const std::size_t n : f.shape) append(out, static_cast<std::uint64_t>(n));
    offset = aligned(offset + f.data.size());
  }
  for (const Field& f : fields_) {
    out.resize(aligned(out.size()), '\0');
    out += f.data;
  }
  return out;
}

}  // namespace brdf
