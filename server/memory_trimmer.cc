#include "server/memory_trimmer.h"

#include <malloc.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>

namespace geodesic::server {
namespace {

constexpr std::chrono::seconds kInterval{5};

}  // namespace

MemoryTrimmer::MemoryTrimmer()
    : thread_([](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any stopped;
        std::unique_lock lock(mutex);
        while (!stopped.wait_for(lock, stop, kInterval,
                                 [&] { return stop.stop_requested(); })) {
          malloc_trim(0);
        }
      }) {}

}  // namespace geodesic::server
