// Compressed files.

#ifndef GEODESIC_TESTS_SUPPORT_GZIP_FILE_H_
#define GEODESIC_TESTS_SUPPORT_GZIP_FILE_H_

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

namespace geodesic::test {

// What zlib makes of the text: a file of gzip in one piece.
inline std::string Gzip(const std::string& text) {
  z_stream stream{};
  EXPECT_EQ(
      deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY),
      Z_OK);
  std::string bytes(deflateBound(&stream, text.size()) + 64, '\0');
  std::string input = text;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_GZIP_FILE_H_
