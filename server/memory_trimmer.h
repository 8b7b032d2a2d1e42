// Gives memory that the process no longer uses back to the machine.

#ifndef GEODESIC_SERVER_MEMORY_TRIMMER_H_
#define GEODESIC_SERVER_MEMORY_TRIMMER_H_

#include <thread>

namespace geodesic::server {

// glibc by itself gives back what lies at the end of a heap. After a exit of
// readers, thousands of free messages lie between smaller things that stay, so
// it would keep their gigabyte for good. Looks every five seconds, from a
// thread of its own: a look takes less than a millisecond when there is little
// to give back, and some ten for each hundred MiB.
class MemoryTrimmer {
 public:
  MemoryTrimmer();

 private:
  std::jthread thread_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_MEMORY_TRIMMER_H_
