// Copies of the files of TLS, in memory, that gRPC can follow.

#ifndef GEODESIC_SERVER_SECURITY_TLS_COPIES_H_
#define GEODESIC_SERVER_SECURITY_TLS_COPIES_H_

#include <utility>

#include "absl/status/statusor.h"
#include "server/security/tls_files.h"
#include "server/store/posix_file.h"

namespace geodesic::server {

// gRPC reads what it follows at any time, also while somebody writes it. A copy
// changes at once, and only to what was checked. Not thread-safe.
class TlsCopies {
 public:
  // REQUIRES: files.enabled(). Errors: as ReadTlsFiles and DiskError.
  static absl::StatusOr<TlsCopies> Make(TlsFiles files);

  // Where the copies are. They end with this object.
  TlsFiles paths() const;
  // What is in them.
  const TlsTexts& texts() const { return texts_; }

  // Reads the files again. Whether they, and so the copies, have changed.
  // Errors: as Make; the copies stay as they were.
  absl::StatusOr<bool> Refresh();

 private:
  explicit TlsCopies(TlsFiles files) : files_(std::move(files)) {}

  TlsFiles files_;
  TlsTexts texts_;
  FileDescriptor certificate_, key_, client_authorities_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_TLS_COPIES_H_
