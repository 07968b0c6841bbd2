#pragma once
#include <brdf/io/ImageDifference.h>

#include <filesystem>
#include <string>
#include <vector>

namespace brdf::app {

/// One picture of a suite, and how far from its baseline it may be.
struct BaselinePicture {
  std::string file;                  ///< name.png (layout) or name.exr (radiance), beside the suite
  std::vector<std::string> command;  ///< words after `brdf`, without --out; files are relative to the suite's folder
  ImageTolerance radiance;           ///< of an .exr
  double layout = 0;                 ///< of a .png: share of the picture, 0 to 1
};

/// Reads a suite: {"pictures": [{"file": ..., "command": [...], ...}]}. Throws Error::Kind::File and ::Format.
std::vector<BaselinePicture> readBaselineSuite(const std::filesystem::path& path);

/// A suite to start from, as text.
std::string exampleBaselineSuite();

}  // namespace brdf::app
