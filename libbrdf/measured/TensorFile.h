#pragma once
#include <brdf/brdf_export.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// The container of the RGL and KAIST databases: named arrays. Layout, little-endian: "tensor_file" and NUL, u8 1, u8
/// 0, u32 number of fields, then for each: u16 length of the name, the name, u16 number of dimensions, u8 type, u64
/// offset of its data from the start of the file, u64 for each dimension. Data are in C order (last index fastest).
class BRDF_EXPORT TensorFile {
 public:
  enum class Type : std::uint8_t { U8 = 1, I8, U16, I16, U32, I32, U64, I64, F16, F32, F64 };
  struct Field {
    std::string name;
    Type type = Type::U8;
    std::vector<std::size_t> shape;
    std::string_view data;  ///< of the bytes read
    std::size_t count() const;
  };

  static constexpr std::string_view kMagic{"tensor_file\0", 12};

  /// Reads the directory; the fields point into `bytes`, which must stay. Throws Error::Kind::Format, naming the
  /// offset, for what is cut short, an unknown type, or data that lie outside the file.
  TensorFile(std::string_view bytes, const std::filesystem::path& path);

  bool has(std::string_view name) const;
  /// Throws Error::Kind::Format where the field is missing, or not of `dimensions` dimensions, or not of the type.
  const Field& field(std::string_view name, Type type, std::size_t dimensions) const;
  /// The numbers of a float32 field.
  std::vector<float> floats(std::string_view name, std::size_t dimensions) const;
  const std::vector<Field>& fields() const { return fields_; }
  /// Throws Error::Kind::Format about a field.
  [[noreturn]] void fail(std::string_view field, std::string what, std::string found, std::string allowed) const;

 private:
  std::filesystem::path path_;
  std::vector<Field> fields_;
};

/// Collects arrays, then writes them with each one's data at a multiple of 8 bytes.
class BRDF_EXPORT TensorWriter {
 public:
  void add(std::string name, const std::vector<std::size_t>& shape, const std::vector<float>& values);
  void add(std::string name, std::string_view bytes);  ///< u8, one dimension
  std::string bytes() const;

 private:
  struct Field {
    std::string name;
    TensorFile::Type type;
    std::vector<std::size_t> shape;
    std::string data;
  };
  std::vector<Field> fields_;
};

}  // namespace brdf
