#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/io/ImageFile.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace brdf {
namespace {

/// The bytes of a picture, read from front to back.
class Reader {
 public:
  Reader(std::string_view bytes, const std::filesystem::path& path) : bytes_(bytes), path_(path) {}

  [[noreturn]] void fail(std::string what, std::string found = {}, std::string allowed = {}) const {
    throw Error(Error::Kind::Format, {std::move(what), path_.string() + ", byte " + std::to_string(position_),
                                      std::move(found), std::move(allowed)});
  }

  std::size_t remaining() const { return bytes_.size() - position_; }

  std::uint8_t byte() {
    if (position_ >= bytes_.size()) fail("truncated Radiance picture");
    return static_cast<std::uint8_t>(bytes_[position_++]);
  }

  std::uint8_t peek(std::size_t ahead) const {
    return position_ + ahead < bytes_.size() ? static_cast<std::uint8_t>(bytes_[position_ + ahead]) : 0;
  }

  void skip(std::size_t count) { position_ += count; }

  /// The next line without its end.
  std::string_view line() {
    const std::size_t end = bytes_.find('\n', position_);
    if (end == std::string_view::npos) fail("Radiance header does not end");
    const std::string_view text = trimmed(bytes_.substr(position_, end - position_));
    position_ = end + 1;
    return text;
  }

 private:
  std::string_view bytes_;
  const std::filesystem::path& path_;
  std::size_t position_ = 0;
};

/// Header lines up to the empty one; the product of the exposures.
double readHeader(Reader& in) {
  double exposure = 1;
  in.line();  // #?RADIANCE or #?RGBE
  for (std::string_view text = in.line(); !text.empty(); text = in.line()) {
    if (text.starts_with("FORMAT=") && text != "FORMAT=32-bit_rle_rgbe")
      in.fail("unsupported Radiance format", std::string(text.substr(7)), "32-bit_rle_rgbe");
    if (!text.starts_with("EXPOSURE=")) continue;
    const auto value = parseNumber(text.substr(9));
    if (!value || !(*value > 0) || !std::isfinite(*value))
      in.fail("exposure in Radiance header", std::string(text.substr(9)), "a positive number");
    exposure *= *value;
  }
  return exposure;
}

Image readResolution(Reader& in) {
  const std::string_view text = in.line();
  const auto words = split(text, ' ');
  std::optional<double> height, width;
  if (words.size() == 4 && words[0] == "-Y" && words[2] == "+X") {
    height = parseNumber(words[1]);
    width = parseNumber(words[3]);
  }
  const auto valid = [](const std::optional<double>& side) {
    return side && *side >= 1 && *side <= double(kMaximumImageSide) && *side == std::floor(*side);
  };
  if (!valid(width) || !valid(height) || *width * *height > double(kMaximumImagePixels))
    in.fail("picture size", std::string(text.substr(0, 60)),
            "-Y height +X width, each 1 to " + std::to_string(kMaximumImageSide) + ", at most " +
                std::to_string(kMaximumImagePixels) + " pixels");
  // A run of 127 (new coding) or 255 (old coding, nested at most twice in practice) pixels takes at least 2 bytes a
  // row.
  if (*height * 4 > double(in.remaining()) || *width * *height > double(in.remaining()) * 256 * 256)
    in.fail("picture larger than its file can hold", std::string(text));
  return Image(static_cast<std::size_t>(*width), static_cast<std::size_t>(*height), 3);
}

using Rgbe = std::uint8_t[4];

/// One row in the coding of 1991: four planes, each of runs (count > 128) and literals.
void readPlanes(Reader& in, Rgbe* row, std::size_t width) {
  in.skip(4);
  for (std::size_t plane = 0; plane < 4; ++plane) {
    for (std::size_t x = 0; x < width;) {
      const std::uint8_t code = in.byte();
      const bool run = code > 128;
      const std::size_t count = run ? code - 128 : code;
      if (count == 0 || x + count > width) in.fail("broken run in Radiance picture");
      std::uint8_t value = run ? in.byte() : 0;
      for (std::size_t end = x + count; x < end; ++x) row[x][plane] = run ? value : in.byte();
    }
  }
}

/// One row of plain pixels, where (1, 1, 1, n) repeats the pixel before, n shifted by 8 for each repetition in turn.
void readPixels(Reader& in, Rgbe* row, std::size_t width) {
  unsigned shift = 0;
  for (std::size_t x = 0; x < width;) {
    std::uint8_t pixel[4];
    for (auto& value : pixel) value = in.byte();
    if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
      const std::size_t count = shift > 16 ? width + 1 : std::size_t{pixel[3]} << shift;
      if (x == 0 || x + count > width) in.fail("broken run in Radiance picture");
      for (std::size_t end = x + count; x < end; ++x) std::copy_n(row[x - 1], 4, row[x]);
      shift += 8;
    } else {
      std::copy_n(pixel, 4, row[x++]);
      shift = 0;
    }
  }
}

}  // namespace

Image readRadianceHdr(std::string_view bytes, const std::filesystem::path& path) {
  Reader in(bytes, path);
  if (!bytes.starts_with("#?")) in.fail("not a Radiance picture", {}, "a first line that starts with #?");
  const double exposure = readHeader(in);
  Image image = readResolution(in);
  std::vector<std::uint8_t> row(4 * image.width);
  auto* const pixels = reinterpret_cast<Rgbe*>(row.data());
  for (std::size_t y = 0; y < image.height; ++y) {
    const bool planes = image.width >= 8 && image.width < 32768 && in.peek(0) == 2 && in.peek(1) == 2 &&
                        std::size_t{in.peek(2)} * 256 + in.peek(3) == image.width;
    if (planes)
      readPlanes(in, pixels, image.width);
    else
      readPixels(in, pixels, image.width);
    float* out = image.pixel(0, y);
    for (std::size_t x = 0; x < image.width; ++x, out += 3) {
      const std::uint8_t* rgbe = pixels[x];
      const double unit = rgbe[3] == 0 ? 0 : std::ldexp(1.0, int{rgbe[3]} - 136) / exposure;
      for (std::size_t channel = 0; channel < 3; ++channel)
        out[channel] = static_cast<float>((rgbe[channel] + 0.5) * unit);
    }
  }
  return image;
}

}  // namespace brdf
