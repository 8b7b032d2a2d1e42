// Numbers, tables and JSON as people read them.

#ifndef GEODESIC_CLIENT_CLI_TERMINAL_TEXT_H_
#define GEODESIC_CLIENT_CLI_TERMINAL_TEXT_H_

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace geodesic::client {

// "96,966".
std::string GroupedNumber(uint64_t number);

// "512 B", "1.5 KiB", "30.2 MiB".
std::string ByteCount(uint64_t bytes);

// "0.1234", six significant digits.
std::string ShortNumber(double number);

// Three of them, with spaces between.
std::string ShortNumbers(const std::array<double, 3>& numbers);

// "12.3 ms", "4.56 s".
std::string Seconds(double seconds);

// The text without what a terminal would take for a command: control characters
// are shown as "\x1b". UTF-8 stays as it is.
std::string Printable(std::string_view text);

// "name   value", a line each, the values in one column. Printable,
// likewise for tables.
using Fact = std::pair<std::string, std::string>;
void PrintFacts(const std::vector<Fact>& facts, std::ostream* out);

// Columns wide enough for their cells; the first to the left, the others to the
// right. REQUIRES: rows as long as the header.
void PrintTable(const std::vector<std::string>& header,
                std::vector<std::vector<std::string>> rows, std::ostream* out);

// What --json prints. Keys keep their order, so that people can read it too.
using Json = nlohmann::ordered_json;
void PrintJson(const Json& json, std::ostream* out);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_TERMINAL_TEXT_H_
