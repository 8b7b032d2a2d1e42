#include "server/periodic.h"

#include <sys/stat.h>

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <tuple>
#include <utility>

namespace geodesic::server {
namespace {

// A value that changes when the file does, or who may read it. All zero if
// there is no file.
auto Stamp(const std::string& path) {
  struct stat file = {};
  if (stat(path.c_str(), &file) != 0) file = {};
  return std::tuple(file.st_dev, file.st_ino, file.st_ctim.tv_sec,
                    file.st_ctim.tv_nsec);
}

}  // namespace

std::jthread Every(std::chrono::seconds interval,
                   std::function<void()> action) {
  return std::jthread(
      [interval, action = std::move(action)](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any stopped;
        std::unique_lock lock(mutex);
        for (;;) {
          stopped.wait_for(lock, stop, interval, [] { return false; });
          if (stop.stop_requested()) return;
          action();
        }
      });
}

std::jthread WatchFile(const std::string& path, std::function<void()> changed) {
  return Every(std::chrono::seconds(1), [path, changed = std::move(changed),
                                         last = Stamp(path)]() mutable {
    const auto now = Stamp(path);
    if (std::exchange(last, now) != now) changed();
  });
}

}  // namespace geodesic::server
