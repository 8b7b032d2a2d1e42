// The limits that few servers set, all by one flag: --limit NAME=VALUE.

#ifndef GEODESIC_SERVER_OPTIONS_LIMIT_FLAGS_H_
#define GEODESIC_SERVER_OPTIONS_LIMIT_FLAGS_H_

#include <string>
#include <vector>

#include "server/options/options.h"

namespace geodesic::server {

// Takes "max-pairs=100" and the like.
// Errors: throws CLI::ValidationError naming the limit.
void SetLimits(const std::vector<std::string>& chosen, ServerOptions& options);

// All limits with what they are in `options`, for --help.
std::string ExplainLimits(ServerOptions options);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPTIONS_LIMIT_FLAGS_H_
