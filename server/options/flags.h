// The flags of geodesicd.

#ifndef GEODESIC_SERVER_OPTIONS_FLAGS_H_
#define GEODESIC_SERVER_OPTIONS_FLAGS_H_

#include <CLI/CLI.hpp>

#include "server/options/options.h"

namespace geodesic::server {

// Adds every setting but --config, with its bounds, in the order of the help.
// The disk budgets' defaults are for the help; without --data-dir they are 0.
void AddFlags(CLI::App& app, ServerOptions& options);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPTIONS_FLAGS_H_
