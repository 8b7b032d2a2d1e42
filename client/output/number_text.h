// Numbers from and to text, without a locale.

#ifndef GEODESIC_CLIENT_OUTPUT_NUMBER_TEXT_H_
#define GEODESIC_CLIENT_OUTPUT_NUMBER_TEXT_H_

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

namespace geodesic::client {

// Whether all of `text` is a number.
template <typename Number>
bool ParseNumber(std::string_view text, Number* number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, *number);
  return error == std::errc() && stop == end;
}

// The fewest digits that give the same number again.
template <typename Number>
std::string NumberText(Number number) {
  char text[32];
  return std::string(text,
                     std::to_chars(text, text + sizeof(text), number).ptr);
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_NUMBER_TEXT_H_
