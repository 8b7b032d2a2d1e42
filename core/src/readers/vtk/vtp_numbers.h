// The numbers of one array of a .vtp file, decoded as they are asked for.

#ifndef GEODESIC_READERS_VTK_VTP_NUMBERS_H_
#define GEODESIC_READERS_VTK_VTP_NUMBERS_H_

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "readers/inflater.h"
#include "readers/vtk/vtk_numbers.h"

namespace geodesic {

// Bytes as they are, or written as base64: of that, blanks are skipped, and
// padding may stand where one run ends and another begins.
class VtpBytes {
 public:
  VtpBytes(std::string_view text, bool is_base64)
      : text_(text), is_base64_(is_base64) {}

  // Moves up to `count` bytes to `out`. How many there were.
  size_t Take(char* out, size_t count);
  // Moves past bytes; whether they are there.
  bool Skip(uint64_t count);

  // How many bytes may follow at the most.
  uint64_t most() const {
    const uint64_t rest = text_.size() - offset_;
    return is_base64_ ? decoded_end_ - decoded_begin_ + rest / 4 * 3 : rest;
  }
  // Of the text.
  size_t offset() const { return offset_; }

 private:
  bool DecodeFour();

  std::string_view text_;
  bool is_base64_;
  size_t offset_ = 0;
  // Of the last four characters, the bytes that are not taken yet.
  std::array<char, 3> decoded_ = {};
  size_t decoded_begin_ = 0;
  size_t decoded_end_ = 0;
};

// How the arrays of a file are written, if not as text.
struct VtpStyle {
  std::endian order = std::endian::little;
  bool has_long_headers = false;
  bool is_compressed = false;
};

// Takes memory for a block of numbers only, however many there are. Refers to
// the file's bytes.
class VtpNumbers {
 public:
  static VtpNumbers OfText(std::string_view text, const VtkType& type);
  // Errors: INVALID_ARGUMENT if the header of the bytes is not to be believed.
  static absl::StatusOr<VtpNumbers> OfBytes(const VtpBytes& bytes,
                                            const VtpStyle& style,
                                            const VtkType& type);

  // Before the first is read: how many may follow at the most.
  uint64_t MostNumbers() const;
  bool is_whole() const { return type_->is_whole; }
  // Whether fewer bytes than the numbers' may stand in the file.
  bool is_compressed() const { return inflater_ != nullptr; }

  // The next number; none at the end, where the bytes are damaged, and for one
  // that is not finite.
  std::optional<double> Real();
  std::optional<int64_t> Integer();

  // How many bytes of the file were read for it.
  uint64_t taken() const {
    return bytes_.has_value() ? bytes_->offset() : cursor_.offset();
  }

 private:
  explicit VtpNumbers(const VtkType& type) : type_(&type), cursor_("") {}

  absl::Status ReadHeader();
  absl::Status ReadBlockSizes();
  std::optional<uint64_t> HeaderNumber(VtpBytes& bytes) const;
  // Sees to it that the next number is decoded, if there is one.
  void Decode();
  size_t DecodeInto(char* out, size_t count);
  size_t Inflate(char* out, size_t count);
  bool EnterBlock();
  bool FeedInflater();

  const VtkType* type_;
  // Over the text, or over the part of buffer_ that is filled.
  VtkCursor cursor_;
  // The rest belongs to what is not text.
  std::optional<VtpBytes> bytes_;
  VtpStyle style_;
  uint64_t left_ = 0;  // bytes of numbers, still to be decoded
  std::vector<char> buffer_;

  // What is compressed comes in blocks. Their sizes, compressed, are in the
  // header; all but the last hold `block_bytes_`.
  std::unique_ptr<Inflater> inflater_;
  std::optional<VtpBytes> sizes_;
  uint64_t blocks_left_ = 0;  // behind the one at hand
  uint64_t block_bytes_ = 0;
  uint64_t last_block_bytes_ = 0;
  uint64_t block_left_ = 0;       // of the block at hand, still to come out
  uint64_t compressed_left_ = 0;  // and to go in
  std::vector<char> compressed_;
};

}  // namespace geodesic

#endif  // GEODESIC_READERS_VTK_VTP_NUMBERS_H_
