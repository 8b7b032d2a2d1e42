// SHA-256 of a stream of bytes.

#ifndef GEODESIC_CLIENT_SHA256_H_
#define GEODESIC_CLIENT_SHA256_H_

#include <cstddef>
#include <memory>
#include <string>

struct evp_md_ctx_st;

namespace geodesic::client {

// Not thread-safe.
class Sha256 {
 public:
  Sha256();

  void Update(const void* bytes, size_t size);

  // 64 lower-case hexadecimal digits. REQUIRES: not called before.
  std::string FinishHex();

 private:
  struct FreeContext {
    void operator()(evp_md_ctx_st* context) const;
  };
  std::unique_ptr<evp_md_ctx_st, FreeContext> context_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_SHA256_H_
