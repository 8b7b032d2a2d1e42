// Preloaded into a server, a disk that takes its time: while the pipe exists
// that GEODESIC_HELD_DISK names, who flushes a file or reads at a place in one
// adds a byte to PIPE.held and waits for whoever opens the pipe to write; and
// while the file exists that GEODESIC_SLOW_DISK names, either takes the
// milliseconds more that the file holds.

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace {

void TakeTime() {
  const char* const path = std::getenv("GEODESIC_SLOW_DISK");
  int milliseconds = 0;
  if (path != nullptr && std::ifstream(path) >> milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  }
}

void WaitForDisk() {
  TakeTime();
  const char* const path = std::getenv("GEODESIC_HELD_DISK");
  if (path == nullptr || access(path, F_OK) != 0) return;
  const std::string count = std::string(path) + ".held";
  const int held = open(count.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
  if (write(held, "", 1) != 1) std::abort();
  close(held);
  close(open(path, O_RDONLY));
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) int fsync(int file) {
  static const auto flush =
      reinterpret_cast<int (*)(int)>(dlsym(RTLD_NEXT, "fsync"));
  WaitForDisk();
  return flush(file);
}

__attribute__((visibility("default"))) ssize_t pread(int file, void* bytes,
                                                     size_t size,
                                                     off_t offset) {
  static const auto read =
      reinterpret_cast<ssize_t (*)(int, void*, size_t, off_t)>(
          dlsym(RTLD_NEXT, "pread"));
  WaitForDisk();
  return read(file, bytes, size, offset);
}
}
