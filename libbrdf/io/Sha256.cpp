#include <brdf/base/Error.h>
#include <brdf/io/Sha256.h>
#include <openssl/evp.h>

namespace brdf {

std::string sha256(std::string_view bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest, &length, EVP_sha256(), nullptr) != 1)
    throw Error(Error::Kind::Device, {"SHA-256 is not available from OpenSSL", {}, {}, {}});
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (unsigned i = 0; i < length; ++i) {
    text += digits[digest[i] >> 4];
    text += digits[digest[i] & 15];
  }
  return text;
}

}  // namespace brdf
