// The page of the server that `geodesic` started, for this user alone.
//
// The page is served on a port of this machine, which its other users reach,
// too. So the server asks for a token there, which is made for it at random and
// kept in the user's runtime folder. It goes to the browser behind the # of the
// page's address, which browsers send to no server; and that address goes to
// the browser in a file of this user's, since everybody sees the arguments of
// programs.

#ifndef GEODESIC_CLIENT_CLI_OWN_SERVER_PAGE_FILES_H_
#define GEODESIC_CLIENT_CLI_OWN_SERVER_PAGE_FILES_H_

#include <optional>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace geodesic::client {

// Knows names only, and can be copied.
class PageFiles {
 public:
  // `stem` is the path of the server's files, without their endings.
  explicit PageFiles(std::string stem) : stem_(std::move(stem)) {}

  // Written by the server when it serves the page.
  std::string port_path() const { return stem_ + ".web-port"; }
  // The hash of the token, as the server's --web-token-file wants it.
  std::string hash_path() const { return stem_ + ".web-token.json"; }

  // Forgets a server that ended.
  void Remove() const;

  // Draws a token for a server that is about to start. Errors: of the files.
  absl::Status Prepare() const;

  // The page's address, with the token; nothing if the server that runs does
  // not serve it.
  std::optional<std::string> Url() const;

  // Writes a file that leads the browser that opens it to `url`; returns its
  // path. Errors: of the file.
  absl::StatusOr<std::string> WriteLink(const std::string& url) const;

 private:
  std::string token_path() const { return stem_ + ".web-token"; }

  std::string stem_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_OWN_SERVER_PAGE_FILES_H_
