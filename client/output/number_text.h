// Converts numbers from and to text, independent of the locale, and makes CSV
// lines.

#ifndef GEODESIC_CLIENT_OUTPUT_NUMBER_TEXT_H_
#define GEODESIC_CLIENT_OUTPUT_NUMBER_TEXT_H_

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace geodesic::client {

// Parses `text`. Returns false unless all of it is one number.
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

// Builds lines of comma-separated values. Numbers have the fewest digits that
// give the same number again; infinity is "inf". Texts are not escaped, since
// none holds a comma except places in a face, which are quoted.
class CsvLine {
 public:
  template <typename Value>
  CsvLine& Number(Value value) {
    line_.append(NumberText(value)).push_back(',');
    return *this;
  }

  CsvLine& Text(std::string_view text) {
    const bool quote = text.find(',') != std::string_view::npos;
    if (quote) line_.push_back('"');
    line_.append(text);
    if (quote) line_.push_back('"');
    line_.push_back(',');
    return *this;
  }

  // Returns the line with its newline and begins the next one.
  // REQUIRES: the line is not empty.
  std::string End() {
    line_.back() = '\n';
    return std::exchange(line_, {});
  }

 private:
  std::string line_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_NUMBER_TEXT_H_
