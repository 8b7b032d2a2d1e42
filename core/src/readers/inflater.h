// zlib's state while it decompresses.

#ifndef GEODESIC_READERS_INFLATER_H_
#define GEODESIC_READERS_INFLATER_H_

#include <zlib.h>

#include <cstdint>

namespace geodesic {

// Deflate turns no byte into more than these.
inline constexpr uint64_t kMostInflation = 1032;

class Inflater {
 public:
  // `window_bits` as inflateInit2 has them.
  explicit Inflater(int window_bits) {
    is_ready_ = inflateInit2(&stream_, window_bits) == Z_OK;
  }
  ~Inflater() {
    if (is_ready_) inflateEnd(&stream_);
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // False if there was no memory.
  bool is_ready() const { return is_ready_; }
  z_stream& stream() { return stream_; }

 private:
  z_stream stream_{};
  bool is_ready_ = false;
};

}  // namespace geodesic

#endif  // GEODESIC_READERS_INFLATER_H_
