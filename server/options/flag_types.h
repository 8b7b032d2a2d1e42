// Flags by the type of their value, with their bounds.

#ifndef GEODESIC_SERVER_OPTIONS_FLAG_TYPES_H_
#define GEODESIC_SERVER_OPTIONS_FLAG_TYPES_H_

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <string>

namespace geodesic::server {

inline constexpr uint64_t kMaxBytes = uint64_t{1} << 50;

// In the largest unit that has no fraction: "2GiB".
std::string InUnits(uint64_t bytes);

// What `value` is before is the default, which the help shows.
void AddBytes(CLI::App& app, const std::string& flag, uint64_t& value,
              const std::string& help, uint64_t most = kMaxBytes,
              uint64_t least = 1);
CLI::Option& AddCount(CLI::App& app, const std::string& flag, uint64_t& value,
                      uint64_t most, const std::string& help,
                      uint64_t least = 1);
void AddSeconds(CLI::App& app, const std::string& flag,
                std::chrono::seconds& value, int64_t least,
                const std::string& help, int64_t most = 86400);
CLI::Option& AddText(CLI::App& app, const std::string& flag, std::string& value,
                     const std::string& type, const std::string& help);

// Each says what is wrong with a value; nothing if it is well-formed.
// HOST:PORT:
std::string CheckAddress(const std::string& address);
// HOST:PORT, or unix:PATH where a server can listen:
std::string CheckListen(const std::string& address);
// HOST:PORT, or unix:PATH of another program:
std::string CheckShared(const std::string& address);
// https://HOST or https://HOST:PORT:
std::string CheckOrigin(const std::string& origin);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPTIONS_FLAG_TYPES_H_
