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

// Three short numbers, separated by spaces.
std::string ShortNumbers(const std::array<double, 3>& numbers);

// "12.3 ms", "4.56 s".
std::string Seconds(double seconds);

// The text with control characters, which a terminal could take for commands,
// shown as in "\x1b". UTF-8 stays as it is.
std::string Printable(std::string_view text);

// Prints a line "name   value" for each fact, with the values in one column.
// Facts, and the cells of tables, are made Printable.
using Fact = std::pair<std::string, std::string>;
void PrintFacts(const std::vector<Fact>& facts, std::ostream* out);

// Prints a table. The first column is aligned to the left, the others to the
// right.
// REQUIRES: rows are as long as the header.
void PrintTable(const std::vector<std::string>& header,
                std::vector<std::vector<std::string>> rows, std::ostream* out);

// The type of what --json prints. Keys keep their order, for people who read
// it.
using Json = nlohmann::ordered_json;
void PrintJson(const Json& json, std::ostream* out);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_TERMINAL_TEXT_H_
