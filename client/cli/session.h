// What a command works with.

#ifndef GEODESIC_CLIENT_CLI_SESSION_H_
#define GEODESIC_CLIENT_CLI_SESSION_H_

#include <ostream>

#include "client/cli/arguments.h"
#include "client/cli/json.h"
#include "client/cli/progress_display.h"
#include "geodesic_client/client.h"

namespace geodesic::client {

struct Session {
  const Arguments& arguments;
  Client& client;
  // Timeout and Ctrl-C, for every call.
  CallOptions call;
  // Results, and everything else.
  std::ostream& out;
  std::ostream& err;
  ProgressDisplay::Style progress_style = ProgressDisplay::Style::kNone;
  int terminal_width = 80;
};

// Prints one JSON object.
inline void PrintJson(const Json& json, std::ostream* out) {
  *out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_SESSION_H_
