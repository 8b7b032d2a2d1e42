// SHA-256 of a stream of bytes, by OpenSSL.
//
//   Sha256 hash;
//   hash.Update("some ");
//   hash.Update("bytes");
//   std::string digest = hash.FinishHex();

#ifndef GEODESIC_DIGEST_SHA256_H_
#define GEODESIC_DIGEST_SHA256_H_

#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace geodesic {

// Not thread-safe.
class Sha256 {
 public:
  Sha256();

  void Update(std::string_view bytes);

  // 64 lower-case hexadecimal digits. REQUIRES: not called before.
  std::string FinishHex();

 private:
  struct FreeContext {
    void operator()(evp_md_ctx_st* context) const;
  };
  std::unique_ptr<evp_md_ctx_st, FreeContext> context_;
};

// The digest of `bytes`, as FinishHex.
std::string Sha256Hex(std::string_view bytes);

// Whether `text` is 64 lower-case hexadecimal digits.
bool IsSha256Hex(std::string_view text);

}  // namespace geodesic

#endif  // GEODESIC_DIGEST_SHA256_H_
