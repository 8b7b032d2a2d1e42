// Threads that do something again and again.

#ifndef GEODESIC_SERVER_PERIODIC_H_
#define GEODESIC_SERVER_PERIODIC_H_

#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace geodesic::server {

// A thread that calls `action` after each interval, until it is stopped.
std::jthread Every(std::chrono::seconds interval, std::function<void()> action);

// A thread that looks once a second whether the file at `path` was replaced or
// written to, or may be read by others, and then calls `changed`. Unlike
// inotify this also works for files that are replaced, linked or mounted.
std::jthread WatchFile(const std::string& path, std::function<void()> changed);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_PERIODIC_H_
