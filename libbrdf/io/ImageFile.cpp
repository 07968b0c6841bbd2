#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/io/ImageFile.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfVersion.h>

#include <array>
#include <cstring>
#include <stdexcept>

namespace brdf {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void formatError(const fs::path& path, std::string what, std::string found = {},
                              std::string allowed = {}) {
  throw Error(Error::Kind::Format, {std::move(what), path.string(), std::move(found), std::move(allowed)});
}

/// Names of the channels wanted, in the order of Image; throws where the file has neither colour nor luminance.
std::vector<std::string> wantedChannels(const Imf::ChannelList& list, const fs::path& path) {
  std::vector<std::string> names;
  if (list.findChannel("R") && list.findChannel("G") && list.findChannel("B")) {
    names = {"R", "G", "B"};
    if (list.findChannel("A")) names.emplace_back("A");
  } else if (list.findChannel("Y") && !list.findChannel("RY")) {
    names = {"Y"};
  } else {
    std::string found;
    for (auto channel = list.begin(); channel != list.end(); ++channel) {
      if (found.size() > 200) break;
      found += (found.empty() ? "" : ", ") + std::string(channel.name());
    }
    formatError(path, "unsupported channels in OpenEXR file", found, "R, G, B with or without A; Y");
  }
  for (const auto& name : names) {
    const Imf::Channel& channel = *list.findChannel(name);
    if (channel.xSampling != 1 || channel.ySampling != 1)
      formatError(path, "subsampled channel " + name + " in OpenEXR file",
                  std::to_string(channel.xSampling) + " x " + std::to_string(channel.ySampling), "1 x 1");
  }
  return names;
}

/// Bytes in memory, as OpenEXR reads them.
class MemoryStream : public Imf::IStream {
 public:
  MemoryStream(std::string_view bytes, const fs::path& path) : Imf::IStream(path.c_str()), bytes_(bytes) {}

  bool read(char to[], int count) override {
    if (count < 0 || position_ > bytes_.size() || static_cast<std::size_t>(count) > bytes_.size() - position_)
      throw std::runtime_error("the file ends early");
    std::memcpy(to, bytes_.data() + position_, static_cast<std::size_t>(count));
    position_ += static_cast<std::size_t>(count);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::string_view bytes_;
  std::uint64_t position_ = 0;
};

Image readExr(std::string_view content, const fs::path& path) try {
  MemoryStream stream(content, path);
  Imf::InputFile file(stream);
  const Imath::Box2i window = file.header().dataWindow();
  const auto width = std::int64_t{window.max.x} - window.min.x + 1;
  const auto height = std::int64_t{window.max.y} - window.min.y + 1;
  if (width < 1 || height < 1 || width > std::int64_t{kMaximumImageSide} || height > std::int64_t{kMaximumImageSide} ||
      width * height > std::int64_t{kMaximumImagePixels})
    formatError(path, "picture size", std::to_string(width) + " x " + std::to_string(height),
                "1 to " + std::to_string(kMaximumImageSide) + " a side, at most " +
                    std::to_string(kMaximumImagePixels) + " pixels");
  // No compression of OpenEXR packs a pixel into less than some 1/100000 of its bytes: a tiny file with a huge header
  // is refused before memory is taken for it.
  const auto bytes = static_cast<std::int64_t>(content.size());
  if (width * height > bytes * 50000)
    formatError(path, "picture larger than its file can hold", std::to_string(width) + " x " + std::to_string(height));

  const auto names = wantedChannels(file.header().channels(), path);
  Image image(static_cast<std::size_t>(width), static_cast<std::size_t>(height), names.size());
  Imf::FrameBuffer buffer;
  const std::size_t pixelBytes = names.size() * sizeof(float), rowBytes = pixelBytes * image.width;
  for (std::size_t channel = 0; channel < names.size(); ++channel)
    buffer.insert(names[channel],
                  Imf::Slice::Make(Imf::FLOAT, image.values.data() + channel, window, pixelBytes, rowBytes));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return image;
} catch (const Error&) {
  throw;
} catch (const std::exception& error) {
  formatError(path, "broken OpenEXR file", error.what());
}

}  // namespace

Image readImage(const fs::path& path) { return readImage(readFile(path), path); }

Image readImage(std::string_view bytes, const fs::path& path) {
  if (bytes.empty()) formatError(path, "empty file", "0 bytes", "OpenEXR, Radiance .hdr");
  if (bytes.size() >= 4 && Imf::isImfMagic(bytes.data())) return readExr(bytes, path);
  if (bytes.starts_with("#?")) return readRadianceHdr(bytes, path);
  formatError(path, "not a picture of a known format", {}, "OpenEXR, Radiance .hdr");
}

void writeExr(const Image& image, const fs::path& path) {
  static constexpr std::array<const char*, 4> colourNames{"R", "G", "B", "A"};
  if (image.width == 0 || image.height == 0 || image.values.size() != image.width * image.height * image.channels ||
      (image.channels != 1 && image.channels != 3 && image.channels != 4))
    throw Error(Error::Kind::Value, {"picture cannot be written", path.string(),
                                     std::to_string(image.width) + " x " + std::to_string(image.height) + " x " +
                                         std::to_string(image.channels),
                                     "1, 3 or 4 channels, at least one pixel"});
  AtomicFile target(path);
  try {
    Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer buffer;
    const std::size_t pixelBytes = image.channels * sizeof(float);
    for (std::size_t channel = 0; channel < image.channels; ++channel) {
      const char* name = image.channels == 1 ? "Y" : colourNames[channel];
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      // OpenEXR's Slice is one type for reading and writing; writing leaves the pixels as they are.
      char* base = reinterpret_cast<char*>(const_cast<float*>(image.values.data() + channel));
      buffer.insert(name, Imf::Slice(Imf::FLOAT, base, pixelBytes, pixelBytes * image.width));
    }
    Imf::OutputFile file(target.temporaryPath().c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(static_cast<int>(image.height));
  } catch (const std::exception& error) {
    throw Error(Error::Kind::File, {"cannot be written", path.string(), error.what(), {}});
  }
  target.commit();
}

}  // namespace brdf
