#include "client/picture/png_writer.h"

#include <gtest/gtest.h>
#include <png.h>

namespace geodesic::client {
namespace {

TEST(PngWriterTest, LibpngReadsTheSamePixels) {
  Image image(3, 2, Rgb8{1, 2, 3});
  image.At(2, 0) = {255, 128, 0};
  image.At(0, 1) = {9, 8, 7};
  absl::StatusOr<std::string> bytes = EncodePng(image);
  ASSERT_TRUE(bytes.ok()) << bytes.status();

  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_NE(
      png_image_begin_read_from_memory(&header, bytes->data(), bytes->size()),
      0);
  EXPECT_EQ(header.width, 3);
  EXPECT_EQ(header.height, 2);
  header.format = PNG_FORMAT_RGB;
  std::vector<Rgb8> pixels(6);
  ASSERT_NE(png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr),
            0);
  EXPECT_EQ(pixels, image.pixels);
}

}  // namespace
}  // namespace geodesic::client
