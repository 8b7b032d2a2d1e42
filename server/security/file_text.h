// The text of a small file: tokens, certificates.

#ifndef GEODESIC_SERVER_SECURITY_FILE_TEXT_H_
#define GEODESIC_SERVER_SECURITY_FILE_TEXT_H_

#include <string>

#include "absl/status/statusor.h"

namespace geodesic::server {

// What comes of a pipe until its writers have closed it; nothing if there are
// none. Errors: as errno says, naming the path; EFBIG beyond 4 MiB;
// DEADLINE_EXCEEDED if nothing comes of a pipe for a second.
absl::StatusOr<std::string> ReadFileText(const std::string& path);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_FILE_TEXT_H_
