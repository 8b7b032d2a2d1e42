// The geodesicd that `geodesic` starts for its user when no server is named.
//
// It listens on a socket in RuntimeFolder, whose name has this program's
// version and a mark of the geodesicd that it would start, so that another
// build gets a server of its own. Two locks (flock) in the folder say who is
// there; the kernel frees them when a process ends, however it ends:
//   .starting  held by the command that is starting a server
//   .alive     held by the server as long as it lives
// So one server is started at a time, and never while another still ends.

#ifndef GEODESIC_CLIENT_CLI_OWN_SERVER_OWN_SERVER_H_
#define GEODESIC_CLIENT_CLI_OWN_SERVER_OWN_SERVER_H_

#include <sys/types.h>

#include <memory>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/cli/own_server/page_files.h"
#include "geodesic_client/client.h"

namespace geodesic::client {

// Knows names only, and can be copied. Thread-safe.
class OwnServer {
 public:
  // Errors: as RuntimeFolder, or FAILED_PRECONDITION if the folder's path is
  // too long for a socket; marked by FileError.
  static absl::StatusOr<OwnServer> Open();

  std::string address() const { return "unix:" + socket_path(); }
  std::string socket_path() const { return stem_ + ".sock"; }
  std::string log_path() const { return stem_ + ".log"; }

  // The process that takes connections at the socket; nothing if none does
  // within a second.
  std::optional<pid_t> Running() const;

  PageFiles page() const { return PageFiles(stem_); }

  // Starts a server unless one takes connections, and waits, at most a minute
  // or the call's timeout, until it does. If the process `ending` does, waits
  // for its end first. With `needs_page`, a server that does not serve its page
  // is asked to end, and another takes its place. Returns the server's process.
  // Errors, marked by NoServer: NOT_FOUND if there is no geodesicd; UNAVAILABLE
  // if it does not start or another does not end; CANCELLED if stopped.
  absl::StatusOr<pid_t> Start(std::optional<pid_t> ending, bool needs_page,
                              const CallOptions& call) const;

  // Asks the server to end and waits until it has. False if none runs.
  // Errors: DEADLINE_EXCEEDED if it goes on with its requests for a minute or
  // the call's timeout; UNAVAILABLE if one is there that takes no connections;
  // CANCELLED if stopped.
  absl::StatusOr<bool> Stop(const CallOptions& call) const;

 private:
  explicit OwnServer(std::string stem) : stem_(std::move(stem)) {}

  // The path of its files, without their endings.
  std::string stem_;
};

// Makes sure that a server of this version runs, starting one if need be, and
// that it answers and, with `needs_page`, serves its page. It then stays until
// it has been idle for its time. Returns its process. Errors: as
// OwnServer::Start; FAILED_PRECONDITION, marked by NoServer, if the geodesicd
// there is has another version.
absl::StatusOr<pid_t> AwaitOwnServer(const OwnServer& server, bool needs_page,
                                     const CallOptions& call);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_OWN_SERVER_OWN_SERVER_H_
