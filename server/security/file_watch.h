// Tells when a file has changed.

#ifndef GEODESIC_SERVER_SECURITY_FILE_WATCH_H_
#define GEODESIC_SERVER_SECURITY_FILE_WATCH_H_

#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace geodesic::server {

// Looks every second, from a thread of its own: unlike a notification of the
// kernel that works for files that are replaced, linked and mounted.
class FileWatch {
 public:
  // `changed` is called from the thread when the file at `path` is another one
  // than at the last look, or was written to.
  FileWatch(std::string path, std::function<void()> changed);

 private:
  std::jthread thread_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_FILE_WATCH_H_
