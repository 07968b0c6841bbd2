#pragma once
#include <brdf/base/Error.h>
#include <brdf/io/Hdf5.h>
#include <hdf5.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>

/// What the sources behind Hdf5.h share: HDF5's handles, failures and types as ours.
namespace brdf::h5 {

static_assert(sizeof(hid_t) == sizeof(std::int64_t), "HDF5 1.10 or later");

/// Silences HDF5's own printing on this thread (and gives it back), and reads the reason of the last failure.
class Quiet {
 public:
  Quiet() {
    // HDF5 keeps pieces of damaged files that it could not close, and would complain of them on standard error when the
    // process ends. Every file here is closed long before: its clean-up at exit is not needed.
    static const herr_t noCleanUpAtExit = H5dont_atexit();
    static_cast<void>(noCleanUpAtExit);
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

  static std::string reason() {
    std::string text;
    H5Ewalk2(
        H5E_DEFAULT, H5E_WALK_UPWARD,
        [](unsigned depth, const H5E_error2_t* error, void* out) -> herr_t {
          if (depth == 0 && error->desc) *static_cast<std::string*>(out) = error->desc;
          return 0;
        },
        &text);
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  }

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

[[noreturn]] inline void fail(const std::string& where, std::string what, std::string found = Quiet::reason(),
                              std::string allowed = {}) {
  throw Error(Error::Kind::Format, {std::move(what), where, std::move(found), std::move(allowed)});
}

/// A handle that closes `id` with `close`; fails with `what` when HDF5 gave none.
inline Handle own(hid_t id, herr_t (*close)(hid_t), const std::string& where, const char* what) {
  if (id < 0) fail(where, what);
  return Handle(new std::int64_t(id), [close](const std::int64_t* p) {
    const Quiet quiet;
    close(*p);
    delete p;
  });
}

inline void check(herr_t status, const std::string& where, const char* what) {
  if (status < 0) fail(where, what);
}

template <class T>
hid_t nativeType() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}
/// As stored: little-endian on every machine.
template <class T>
hid_t storedType() {
  if constexpr (std::is_same_v<T, double>) return H5T_IEEE_F64LE;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_STD_I64LE;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_STD_U8LE;
}
template <class T>
constexpr H5T_class_t kTypeClass = std::is_floating_point_v<T> ? H5T_FLOAT : H5T_INTEGER;

}  // namespace brdf::h5
