// How much memory a server takes, and what for.

#ifndef GEODESIC_SERVER_OPTIONS_MEMORY_H_
#define GEODESIC_SERVER_OPTIONS_MEMORY_H_

#include <cstdint>

#include "server/options/options.h"

namespace geodesic::server {

// The messages that come in need as much.
inline constexpr uint64_t kLeastMemory = uint64_t{512} << 20;

// Three quarters of the machine's memory, or of what this process's control
// group may have (version 2); at least kLeastMemory.
uint64_t UsualMemory();

// Divides memory_bytes and disk_bytes among the budgets, and has the largest
// upload fit its budget.
void Divide(ServerOptions& options);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPTIONS_MEMORY_H_
