#include "server/security/file_watch.h"

#include <sys/stat.h>

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <tuple>
#include <utility>

namespace geodesic::server {
namespace {

constexpr std::chrono::seconds kInterval{1};

// What changes when the file does. All zero for none.
auto Stamp(const std::string& path) {
  struct stat file = {};
  if (stat(path.c_str(), &file) != 0) file = {};
  return std::tuple(file.st_dev, file.st_ino, file.st_size, file.st_mtim.tv_sec,
                    file.st_mtim.tv_nsec);
}

}  // namespace

FileWatch::FileWatch(std::string path, std::function<void()> changed)
    : thread_([path = std::move(path), changed = std::move(changed),
               last = Stamp(path)](const std::stop_token& stop) mutable {
        std::mutex mutex;
        std::condition_variable_any stopped;
        std::unique_lock lock(mutex);
        for (;;) {
          stopped.wait_for(lock, stop, kInterval, [] { return false; });
          if (stop.stop_requested()) return;
          const auto now = Stamp(path);
          if (std::exchange(last, now) != now) changed();
        }
      }) {}

}  // namespace geodesic::server
