#include "server/options/memory.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

namespace geodesic::server {
namespace {

namespace fs = std::filesystem;

// What this process's control group, and those around it, may have.
uint64_t GroupMemory() {
  uint64_t least = std::numeric_limits<uint64_t>::max();
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    if (!line.starts_with("0::/")) continue;
    fs::path group = "/sys/fs/cgroup" + line.substr(3);
    for (; group.string().size() > 4; group = group.parent_path()) {
      // "max" is no number.
      uint64_t most = 0;
      if (std::ifstream(group / "memory.max") >> most) {
        least = std::min(least, most);
      }
    }
  }
  return least;
}

}  // namespace

uint64_t UsualMemory() {
  constexpr uint64_t kUnit = uint64_t{1} << 28;
  const uint64_t machine = static_cast<uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                           static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
  const uint64_t all = std::min(machine, GroupMemory());
  return std::max(kLeastMemory, all / 4 * 3 / kUnit * kUnit);
}

void Divide(ServerOptions& options) {
  Limits& limits = options.limits;
  const uint64_t part = options.memory_bytes / 40;
  limits.solver_memory_bytes = 16 * part;
  limits.mesh_store_bytes = 8 * part;
  limits.upload_memory_bytes = 8 * part;
  limits.field_cache_bytes = 2 * part;
  limits.prepared_memory_bytes = 2 * part;
  options.request_memory_bytes = 2 * part;
  options.receive_memory_bytes = part;
  limits.landmark_memory_bytes = part;
  // Most formats take four times the file.
  limits.max_upload_bytes =
      std::min(limits.max_upload_bytes, limits.upload_memory_bytes / 4);
  limits.field_disk_bytes = options.disk_bytes / 5;
  limits.mesh_disk_bytes = options.disk_bytes - limits.field_disk_bytes;
}

}  // namespace geodesic::server
