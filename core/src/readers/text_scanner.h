// Lines, tokens and numbers of text held in memory, without copies.

#ifndef GEODESIC_READERS_TEXT_SCANNER_H_
#define GEODESIC_READERS_TEXT_SCANNER_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace geodesic {

enum class LineEnd { kNone, kLf, kCr, kCrLf };

// Walks the lines of `bytes`; LF, CR LF and CR alone each end a line. A UTF-8
// byte order mark at the front is skipped.
//
//   LineScanner scanner(bytes);
//   while (scanner.Next()) Use(scanner.line_number(), scanner.line());
class LineScanner {
 public:
  explicit LineScanner(std::string_view bytes);

  // Moves to the next line; false once there is none. All calls together are
  // linear in the size of the bytes.
  bool Next();
  // Moves to the next line that holds more than blanks.
  bool NextNonBlank();

  // The current line without its end.
  std::string_view line() const { return line_; }
  LineEnd line_end() const { return line_end_; }
  // Of the current line, from 1; 0 before the first.
  uint64_t line_number() const { return line_number_; }
  // Where the next line begins, and the bytes from there on.
  size_t offset() const { return offset_; }
  size_t remaining() const { return bytes_.size() - offset_; }

 private:
  std::string_view bytes_;
  std::string_view line_;
  LineEnd line_end_ = LineEnd::kNone;
  uint64_t line_number_ = 0;
  size_t offset_ = 0;
  // The first line feed and carriage return at or after offset_, remembered so
  // that a file with only one kind is not searched for the other at each line.
  size_t next_lf_ = 0;
  size_t next_cr_ = 0;
};

// Takes the next run of non-blank bytes off the front of `text`; empty when
// none is left.
std::string_view TakeToken(std::string_view& text);

// The double nearest to a decimal number ("-1.5e3", "+.5", "5."); too small a
// number is 0 or subnormal. Nothing for anything else, infinities, NaN and
// numbers beyond the range of double included.
std::optional<double> ParseFinite(std::string_view token);

// A decimal integer with an optional sign. Nothing for anything else or beyond
// 64 bits.
std::optional<int64_t> ParseInteger(std::string_view token);

}  // namespace geodesic

#endif  // GEODESIC_READERS_TEXT_SCANNER_H_
