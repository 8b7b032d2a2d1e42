#include "client/cli/terminal/text.h"

#include <algorithm>
#include <cstdio>

#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

std::string Padded(const std::string& text, size_t width, bool to_the_right) {
  const std::string spaces(width - std::min(width, text.size()), ' ');
  return to_the_right ? absl::StrCat(spaces, text) : absl::StrCat(text, spaces);
}

}  // namespace

std::string GroupedNumber(uint64_t number) {
  std::string digits = absl::StrCat(number);
  for (auto i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3) {
    digits.insert(static_cast<size_t>(i), 1, ',');
  }
  return digits;
}

std::string ByteCount(uint64_t bytes) {
  constexpr std::array kUnits = {"B", "KiB", "MiB", "GiB", "TiB"};
  size_t unit = 0;
  auto amount = static_cast<double>(bytes);
  while (amount >= 1024 && unit + 1 < kUnits.size()) {
    amount /= 1024;
    ++unit;
  }
  char text[32];
  std::snprintf(text, sizeof(text), unit == 0 ? "%.0f %s" : "%.1f %s", amount,
                kUnits[unit]);
  return text;
}

std::string ShortNumber(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", number);
  return text;
}

std::string ShortNumbers(const std::array<double, 3>& numbers) {
  return absl::StrCat(ShortNumber(numbers[0]), " ", ShortNumber(numbers[1]),
                      " ", ShortNumber(numbers[2]));
}

std::string Seconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof(text), seconds < 1 ? "%.3g ms" : "%.3g s",
                seconds < 1 ? 1000 * seconds : seconds);
  return text;
}

std::string Printable(std::string_view text) {
  std::string shown;
  for (size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    // U+0080 to U+009F are control characters, too: two bytes in UTF-8.
    const bool is_long =
        byte == 0xc2 && i + 1 < text.size() && (text[i + 1] & 0xe0) == 0x80;
    if (byte < 0x20 || byte == 0x7f || is_long) {
      const unsigned code = static_cast<unsigned char>(text[i += is_long]);
      absl::StrAppend(&shown, "\\x", absl::Hex(code, absl::kZeroPad2));
    } else {
      shown.push_back(text[i]);
    }
  }
  return shown;
}

void PrintFacts(const std::vector<Fact>& facts, std::ostream* out) {
  size_t width = 0;
  for (const Fact& fact : facts) width = std::max(width, fact.first.size());
  for (const Fact& fact : facts) {
    *out << Padded(fact.first, width + 2, false) << Printable(fact.second)
         << '\n';
  }
}

void PrintTable(const std::vector<std::string>& header,
                std::vector<std::vector<std::string>> rows, std::ostream* out) {
  for (auto& row : rows) std::ranges::transform(row, row.begin(), Printable);
  std::vector<size_t> widths;
  for (size_t column = 0; column < header.size(); ++column) {
    size_t width = header[column].size();
    for (const auto& row : rows) width = std::max(width, row[column].size());
    widths.push_back(width);
  }
  const auto print = [&](const std::vector<std::string>& row) {
    for (size_t column = 0; column < row.size(); ++column) {
      *out << (column == 0 ? "" : "  ")
           << Padded(row[column], widths[column], column != 0);
    }
    *out << '\n';
  };
  print(header);
  for (const auto& row : rows) print(row);
}

void PrintJson(const Json& json, std::ostream* out) {
  *out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace geodesic::client
