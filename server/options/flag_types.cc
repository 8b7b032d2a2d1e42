#include "server/options/flag_types.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "server/unix_socket.h"
#include "server/web/origin_policy.h"

namespace geodesic::server {

std::string InUnits(uint64_t bytes) {
  for (const auto& [shift, unit] :
       {std::pair{30, "GiB"}, {20, "MiB"}, {10, "KiB"}}) {
    const uint64_t size = uint64_t{1} << shift;
    if (bytes >= size && bytes % size == 0) {
      return absl::StrCat(bytes / size, unit);
    }
  }
  return absl::StrCat(bytes, "B");
}

void AddBytes(CLI::App& app, const std::string& flag, uint64_t& value,
              const std::string& help, uint64_t most, uint64_t least) {
  app.add_option(flag, value, help)
      ->transform(CLI::AsSizeValue(/*kb_is_1000=*/true).description(""))
      ->check(CLI::Range(least, most).description(""))
      ->default_str(InUnits(value))
      ->type_name("BYTES");
}

CLI::Option& AddCount(CLI::App& app, const std::string& flag, uint64_t& value,
                      uint64_t most, const std::string& help, uint64_t least) {
  return *app.add_option(flag, value, help)
              ->check(CLI::Range(least, most).description(""))
              ->capture_default_str()
              ->type_name("N");
}

void AddSeconds(CLI::App& app, const std::string& flag,
                std::chrono::seconds& value, int64_t least,
                const std::string& help, int64_t most) {
  app.add_option_function<int64_t>(
         flag, [&value](int64_t count) { value = std::chrono::seconds(count); },
         help)
      ->check(CLI::Range(least, most).description(""))
      ->default_str(std::to_string(value.count()))
      ->type_name("SECONDS");
}

CLI::Option& AddText(CLI::App& app, const std::string& flag, std::string& value,
                     const std::string& type, const std::string& help) {
  return *app.add_option(flag, value, help)->type_name(type);
}

std::string CheckAddress(const std::string& address) {
  const size_t colon = address.rfind(':');
  const std::string port =
      colon == std::string::npos ? "" : address.substr(colon + 1);
  const bool digits =
      !port.empty() && port.size() <= 5 &&
      std::all_of(port.begin(), port.end(), absl::ascii_isdigit);
  return digits && colon > 0 && std::stoi(port) <= 65535
             ? std::string()
             : absl::StrCat("\"", address, "\" is not HOST:PORT");
}

std::string CheckListen(const std::string& address) {
  const std::optional<std::string> path = SocketPath(address);
  if (!path) return CheckAddress(address);
  const absl::Status status = CheckSocketPath(*path);
  return absl::IsInvalidArgument(status) ? std::string(status.message()) : "";
}

std::string CheckShared(const std::string& address) {
  return SocketPath(address) ? "" : CheckAddress(address);
}

std::string CheckOrigin(const std::string& origin) {
  return IsOrigin(origin) ? ""
                          : absl::StrCat("\"", origin,
                                         "\" is not https://HOST or "
                                         "https://HOST:PORT");
}

}  // namespace geodesic::server
