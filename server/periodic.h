// What the process does again and again, on threads of its own.

#ifndef GEODESIC_SERVER_PERIODIC_H_
#define GEODESIC_SERVER_PERIODIC_H_

#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace geodesic::server {

// A thread that calls `action` after each interval, until it is stopped.
std::jthread Every(std::chrono::seconds interval, std::function<void()> action);

// A thread that calls `changed` when the file at `path` is another one than a
// second before, or was written to. Unlike a notification of the kernel that
// works for files that are replaced, linked and mounted.
std::jthread WatchFile(const std::string& path, std::function<void()> changed);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_PERIODIC_H_
