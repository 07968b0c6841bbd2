#include <brdf/base/File.h>
#include <brdf/fit/StoredFit.h>
#include <brdf/io/Container.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>

#include "Samples.h"

namespace fs = std::filesystem;
using brdf::Container;
using samples::errorOf;
using samples::freshFolder;

namespace {

/// A container with small arrays (in object headers) and, with many samples, large ones (compressed chunks).
std::string containerBytes(std::size_t count) {
  const fs::path path = freshFolder("damaged") / "a.vtkhdf";
  brdf::writeContainer(path, "a", *samples::scattered(count), {});
  return brdf::readFile(path);
}

/// Reads everything in the container; whether all of it is as it was written.
bool readsAsWritten(std::string_view bytes, std::size_t count) {
  const Container container = Container::fromBytes(bytes, "damaged.vtkhdf");
  return container.entries().size() == 1 && container.provenance(0).date.empty() &&
         samples::sameSamples(*container.load(0), *samples::scattered(count));
}

void expectErrorOrTruth(std::string_view bytes, std::size_t count, const std::string& what) {
  try {
    EXPECT_TRUE(readsAsWritten(bytes, count)) << what << ": read something else without an error";
  } catch (const brdf::Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << what << ": " << error.what();
  }
}

/// A container whose entry 0 `change` has tampered with, through HDF5's own interface (so that checksums are right).
fs::path tampered(const char* name, const std::function<void(hid_t entry)>& change) {
  const fs::path path = freshFolder(name) / "a.vtkhdf";
  brdf::writeContainer(path, "a", *samples::scattered(), {});
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t entry = H5Gopen2(file, "/BRDFLab/0", H5P_DEFAULT);
  change(entry);
  H5Gclose(entry);
  H5Fclose(file);
  return path;
}

void replaceArray(hid_t entry, const char* name, hid_t type, std::vector<hsize_t> dimensions,
                  const std::function<void(hid_t properties)>& configure) {
  H5Ldelete(entry, name, H5P_DEFAULT);
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  configure(properties);
  const hid_t space = H5Screate_simple(static_cast<int>(dimensions.size()), dimensions.data(), nullptr);
  H5Dclose(H5Dcreate2(entry, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT));
  H5Sclose(space);
  H5Pclose(properties);
}

void chunked(hid_t properties) {
  const hsize_t chunk[2] = {1000, 3};
  H5Pset_chunk(properties, 2, chunk);
}

}  // namespace

TEST(DamagedContainer, AFlippedBitIsAnErrorOrHarmless) {
  for (const std::size_t count : {20, 1200}) {
    const std::string bytes = containerBytes(count);
    ASSERT_TRUE(readsAsWritten(bytes, count));
    const std::size_t step = count == 20 ? 3 : 53;
    for (std::size_t i = 0; i < bytes.size(); i += step) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << (i % 8)));
      expectErrorOrTruth(damaged, count, "byte " + std::to_string(i));
    }
  }
}

TEST(DamagedContainer, AnOverwrittenStretchIsAnErrorOrHarmless) {
  const std::string bytes = containerBytes(1200);
  for (const char fill : {'\0', '\xff', 'x'}) {
    for (std::size_t i = 0; i + 64 < bytes.size(); i += 1501) {
      std::string damaged = bytes;
      damaged.replace(i, 64, 64, fill);
      expectErrorOrTruth(damaged, 1200, "64 bytes from " + std::to_string(i));
    }
  }
}

TEST(DamagedContainer, ATruncatedFileIsAnError) {
  const std::string bytes = containerBytes(1200);
  for (std::size_t size = 0; size < bytes.size(); size += 97)
    EXPECT_THROW(Container::fromBytes(std::string_view(bytes).substr(0, size), "cut.vtkhdf"), brdf::Error) << size;
}

TEST(DamagedContainer, FilesOfAnotherKindAreErrorsThatNameTheFile) {
  const fs::path folder = freshFolder("otherkind");
  brdf::writeFile(folder / "empty.vtkhdf", "");
  brdf::writeFile(folder / "text.vtkhdf", "Lambertian");
  H5Fclose(H5Fcreate((folder / "hdf5.vtkhdf").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  for (const char* name : {"empty.vtkhdf", "text.vtkhdf", "hdf5.vtkhdf", "missing.vtkhdf", "."}) {
    const std::string error = errorOf([&] { Container(folder / name); });
    EXPECT_NE(error.find((folder / name).string()), std::string::npos) << name << ": " << error;
  }
}

TEST(DamagedContainer, AnArrayThatClaimsMoreThanTheFileHoldsTakesNoMemory) {
  for (const hsize_t count : {hsize_t{100000000}, hsize_t{1} << 40, hsize_t{1} << 62}) {
    const fs::path path = tampered("claims", [&](hid_t entry) {
      replaceArray(entry, "wi", H5T_IEEE_F64LE, {count, 3}, chunked);
    });
    const std::string error = errorOf([&] { Container(path).load(0); });
    EXPECT_TRUE(error.find("claims more than the file holds") != std::string::npos ||
                error.find("array too large") != std::string::npos)
        << error;
    EXPECT_NE(error.find("/BRDFLab/0/wi"), std::string::npos) << error;
  }
}

TEST(DamagedContainer, AnArrayThatRunsBeyondTheEndOfTheFileTakesNoMemory) {
  // HDF5's first format has no checksums, and HDF5 believes an array's stored size until it reads it.
  const fs::path path = freshFolder("beyond") / "a.vtkhdf";
  const std::string intact = containerBytes(20);
  brdf::writeFile(path, intact);
  const fs::path old = path.parent_path() / "old.vtkhdf";
  const hid_t from = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t file = H5Fcreate(old.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  H5Ocopy(from, "BRDFLab", file, "BRDFLab", H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(from);
  constexpr hsize_t count = 40'000'000;  // 960 MB of directions
  const hid_t entry = H5Gopen2(file, "/BRDFLab/0", H5P_DEFAULT);
  replaceArray(entry, "wi", H5T_IEEE_F64LE, {count, 3}, [](hid_t properties) {
    H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY);
    H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER);
  });
  const hid_t array = H5Dopen2(entry, "wi", H5P_DEFAULT);
  const haddr_t start = H5Dget_offset(array);
  H5Dclose(array);
  H5Gclose(entry);
  H5Fclose(file);
  ASSERT_GT(start, 2048u);
  std::string cut = brdf::readFileHead(old, static_cast<std::size_t>(start));
  for (int i = 0; i < 8; ++i) cut[40 + i] = static_cast<char>(start >> (8 * i));  // end of file in the superblock
  brdf::writeFile(old, cut);
  const std::string error = errorOf([&] { Container(old).load(0); });
  // HDF5 1.14 finds it by itself, before us.
  EXPECT_TRUE(error.find("array claims more than the file holds") != std::string::npos ||
              error.find("wi: array damaged; found invalid dataset size") != std::string::npos)
      << error;
}

TEST(DamagedContainer, MissingChannelsAndFitsOfNothingAreErrors) {
  const fs::path missing = tampered("channels", [](hid_t entry) { H5Ldelete(entry, "value_2", H5P_DEFAULT); });
  EXPECT_NE(errorOf([&] { Container(missing).load(0); }).find("value_2"), std::string::npos);
  const fs::path path = freshFolder("fitofnothing") / "a.vtkhdf";
  brdf::ContainerWriter writer(path);
  brdf::storeFit(writer.add("a", *samples::scattered(), {}), {});
  writer.commit();
  EXPECT_NE(errorOf([&] { brdf::loadFit(Container(path), 0); }).find("no sum of lobes"), std::string::npos);
}

TEST(DamagedContainer, ArraysOutsideTheFileAreRefused) {
  const auto external = [](hid_t properties) { H5Pset_external(properties, "/etc/passwd", 0, 40 * 3 * 8); };
  const fs::path outside = tampered("external", [&](hid_t entry) {
    replaceArray(entry, "wi", H5T_IEEE_F64LE, {40, 3}, external);
  });
  EXPECT_NE(errorOf([&] { Container(outside).load(0); }).find("must lie in the file itself"), std::string::npos);

  const fs::path linked = tampered("linked", [&](hid_t entry) {
    H5Ldelete(entry, "wi", H5P_DEFAULT);
    H5Lcreate_external("other.h5", "/wi", entry, "wi", H5P_DEFAULT, H5P_DEFAULT);
  });
  EXPECT_NE(errorOf([&] { Container(linked).load(0); }).find("must lie in the file itself"), std::string::npos);
}

TEST(DamagedContainer, ArraysOfAnotherShapeOrTypeAreErrors) {
  const auto plain = [](hid_t) {};
  const auto error = [&](hid_t type, std::vector<hsize_t> dimensions) {
    const fs::path path =
        tampered("shape", [&](hid_t entry) { replaceArray(entry, "valid", type, std::move(dimensions), plain); });
    return errorOf([&] { Container(path).load(0); });
  };
  EXPECT_NE(error(H5T_STD_U8LE, {39}), "");
  EXPECT_NE(error(H5T_STD_U8LE, {40, 1}), "");
  EXPECT_NE(error(H5T_IEEE_F64LE, {40}), "");
}

TEST(DamagedContainer, MissingOrWrongAttributesAreErrors) {
  for (const char* name : {"Kind", "Name", "Channels", "Isotropic"}) {
    const fs::path missing = tampered("attribute", [&](hid_t entry) { H5Adelete(entry, name); });
    EXPECT_NE(errorOf([&] { Container(missing).load(0); }), "") << name;
    const fs::path number = tampered("attribute", [&](hid_t entry) {
      H5Adelete(entry, name);
      const hid_t space = H5Screate(H5S_SCALAR);
      H5Aclose(H5Acreate2(entry, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT));
      H5Sclose(space);
    });
    EXPECT_NE(errorOf([&] { Container(number).load(0); }), "") << name;
  }
}

TEST(DamagedContainer, OneDamagedEntryLeavesTheOthersReadable) {
  const fs::path path = tampered("partial", [](hid_t entry) { H5Ldelete(entry, "wi", H5P_DEFAULT); });
  brdf::ContainerWriter writer(path, brdf::ContainerWriter::Mode::Append);
  writer.add("b", *samples::scattered(11), {});
  writer.commit();
  const Container container(path);
  EXPECT_THROW(container.load(0), brdf::Error);
  EXPECT_TRUE(samples::sameSamples(*container.load(1), *samples::scattered(11)));
}
