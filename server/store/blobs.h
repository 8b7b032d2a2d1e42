// Places where blobs are put and got from by their names, which are digests:
// the disk of one server (BlobStore), or memory that several servers share
// (RedisBlobs).
//
//   absl::Status status = blobs.Put(name, metadata, {head, body});
//   status = blobs.Read(name, [&](std::string_view metadata, BlobBody& body) {
//     return body.Read(into);
//   });

#ifndef GEODESIC_SERVER_STORE_BLOBS_H_
#define GEODESIC_SERVER_STORE_BLOBS_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "digest/sha256.h"

namespace geodesic::server {

// A body that is being read, from its first byte to its last. The bytes may
// only be used when Blobs::Read has returned OK.
class BlobBody {
 public:
  BlobBody(const BlobBody&) = delete;
  BlobBody& operator=(const BlobBody&) = delete;

  uint64_t bytes_left() const { return bytes_left_; }

  // Fills `bytes` with the next bytes.
  // Errors: DATA_LOSS if fewer are left; UNAVAILABLE, RESOURCE_EXHAUSTED (they
  // cannot be read now).
  absl::Status Read(std::span<char> bytes);

  // Whether all was read and has this digest. Errors: INTERNAL, DATA_LOSS.
  // REQUIRES: nothing is read afterwards.
  absl::Status Finish(const std::string& sha256);

 protected:
  explicit BlobBody(uint64_t bytes) : bytes_left_(bytes) {}
  ~BlobBody() = default;

 private:
  virtual absl::Status ReadNext(std::span<char> bytes) = 0;

  uint64_t bytes_left_;
  Sha256 hash_;
};

// Looks at the metadata and reads the whole body, or fails. What it has read
// from one place it must be ready to forget when another is tried.
using TakeBlob =
    absl::FunctionRef<absl::Status(std::string_view metadata, BlobBody& body)>;

// Thread-safe.
class Blobs {
 public:
  virtual ~Blobs() = default;

  // Hands a blob to `take`. Nothing that `take` was given may be used unless
  // this returns OK: the digests are checked at the end.
  // Errors: NOT_FOUND; DATA_LOSS (it was damaged, and is no longer there);
  // UNAVAILABLE, RESOURCE_EXHAUSTED (it cannot be read now); those of `take`.
  virtual absl::Status Read(const std::string& name, TakeBlob take) = 0;

  // Whether a blob of this size would be taken. Returns at once, and counts one
  // that would not. Errors: RESOURCE_EXHAUSTED.
  virtual absl::Status Admit(uint64_t body_bytes, uint64_t metadata_bytes) = 0;

  // Keeps a blob whose body is given in parts, in place of the one with this
  // name, if there is one.
  // Errors: as Admit; UNAVAILABLE, INTERNAL.
  // REQUIRES: IsSha256Hex(name).
  virtual absl::Status Put(const std::string& name, std::string_view metadata,
                           std::span<const std::string_view> body) = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_BLOBS_H_
