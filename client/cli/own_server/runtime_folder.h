// The folder of what belongs to this user's running programs.

#ifndef GEODESIC_CLIENT_CLI_OWN_SERVER_RUNTIME_FOLDER_H_
#define GEODESIC_CLIENT_CLI_OWN_SERVER_RUNTIME_FOLDER_H_

#include <string>

#include "absl/status/statusor.h"

namespace geodesic::client {

// The folder geodesic in $XDG_RUNTIME_DIR, or /tmp/geodesic-UID if that names
// no folder of this user's; made if it is missing. Nobody but this user (and
// root) can look into it or put anything there.
// Errors: FAILED_PRECONDITION naming the folder if it is a link, another
// user's, or open to others; those of mkdir.
absl::StatusOr<std::string> RuntimeFolder();

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_OWN_SERVER_RUNTIME_FOLDER_H_
