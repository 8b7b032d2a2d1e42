#include "readers/text_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>

#include "absl/strings/charconv.h"

namespace geodesic {
namespace {

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

// std::from_chars knows no leading '+'. A sign after it is left to fail.
std::string_view WithoutPlus(std::string_view token) {
  const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
  return plus ? token.substr(1) : token;
}

}  // namespace

LineScanner::LineScanner(std::string_view bytes) : bytes_(bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) offset_ = 3;
  next_lf_ = std::min(bytes_.find('\n', offset_), bytes_.size());
  next_cr_ = std::min(bytes_.find('\r', offset_), bytes_.size());
}

bool LineScanner::Next() {
  if (offset_ == bytes_.size()) {
    line_ = {};
    return false;
  }
  if (next_lf_ < offset_) {
    next_lf_ = std::min(bytes_.find('\n', offset_), bytes_.size());
  }
  if (next_cr_ < offset_) {
    next_cr_ = std::min(bytes_.find('\r', offset_), bytes_.size());
  }
  const size_t end = std::min(next_lf_, next_cr_);
  line_ = bytes_.substr(offset_, end - offset_);
  ++line_number_;
  if (end == bytes_.size()) {
    line_end_ = LineEnd::kNone;
    offset_ = end;
  } else if (bytes_[end] == '\n') {
    line_end_ = LineEnd::kLf;
    offset_ = end + 1;
  } else if (bytes_.substr(end, 2) == "\r\n") {
    line_end_ = LineEnd::kCrLf;
    offset_ = end + 2;
  } else {
    line_end_ = LineEnd::kCr;
    offset_ = end + 1;
  }
  return true;
}

bool LineScanner::NextNonBlank() {
  while (Next()) {
    if (!std::all_of(line_.begin(), line_.end(), IsBlank)) return true;
  }
  return false;
}

std::string_view TakeToken(std::string_view& text) {
  const char* first = text.data();
  const char* const last = first + text.size();
  while (first != last && IsBlank(*first)) ++first;
  const char* end = first;
  while (end != last && !IsBlank(*end)) ++end;
  const std::string_view token(first, end - first);
  text = std::string_view(end, last - end);
  return token;
}

std::optional<double> ParseFinite(std::string_view token) {
  token = WithoutPlus(token);
  const char* const last = token.data() + token.size();
  double value = 0;
  const std::from_chars_result result =
      std::from_chars(token.data(), last, value);
  if (result.ptr != last || result.ec == std::errc::invalid_argument) {
    return std::nullopt;
  }
  if (result.ec == std::errc::result_out_of_range) {
    // std::from_chars does not say whether the number is too large or too
    // small; Abseil's stores the nearest double.
    absl::from_chars(token.data(), last, value);
    if (std::abs(value) > 1) return std::nullopt;
  }
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<int64_t> ParseInteger(std::string_view token) {
  token = WithoutPlus(token);
  const char* const last = token.data() + token.size();
  int64_t value = 0;
  const std::from_chars_result result =
      std::from_chars(token.data(), last, value);
  if (result.ptr != last || result.ec != std::errc()) return std::nullopt;
  return value;
}

}  // namespace geodesic
