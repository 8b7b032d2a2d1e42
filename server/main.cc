// geodesicd: the geodesic query server.

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <memory>
#include <string>

#include "server/memory_trimmer.h"
#include "server/options.h"
#include "server/process_signals.h"
#include "server/server.h"

namespace geodesic::server {
namespace {

constexpr int kCannotStart = 1;
constexpr int kRequestsCancelled = 3;

bool WritePort(const std::string& path, int port) {
  std::ofstream file(path);
  file << port << '\n' << std::flush;
  return file.good();
}

int Run(const ServerOptions& options) {
  BlockProcessSignals();
  // A file that may not grow is an error of the write, not the server's end.
  std::signal(SIGXFSZ, SIG_IGN);
  const std::shared_ptr<spdlog::logger> logger =
      spdlog::stderr_color_mt("geodesicd");
  logger->set_level(spdlog::level::from_str(options.log_level));

  Server server(options, logger);
  if (const absl::Status status = server.Start(); !status.ok()) {
    logger->critical("{}", status.ToString());
    return kCannotStart;
  }
  if (!options.port_file.empty() &&
      !WritePort(options.port_file, server.port())) {
    logger->critical("cannot write --port-file {}", options.port_file);
    return kCannotStart;
  }
  const size_t colon = options.listen.rfind(':');
  logger->info("geodesicd {} serves on {}:{} {}", ServerVersion(),
               options.listen.substr(0, colon), server.port(),
               options.tls.enabled() ? "over TLS" : "in clear");
  const MemoryTrimmer trimmer;
  const ProcessSignals signals([&](int signal) {
    if (signal == SIGHUP) {
      server.Reload();
    } else {
      server.Shutdown(options.drain);
    }
  });
  return server.Wait() ? EXIT_SUCCESS : kRequestsCancelled;
}

}  // namespace
}  // namespace geodesic::server

int main(int argc, char** argv) {
  using geodesic::server::CommandLine;
  const CommandLine command_line = geodesic::server::ParseCommandLine(
      argc, argv, std::string(geodesic::server::ServerVersion()));
  if (command_line.exit_code) return *command_line.exit_code;
  try {
    return geodesic::server::Run(command_line.options);
  } catch (const std::exception& error) {
    spdlog::critical("geodesicd: {}", error.what());
    return geodesic::server::kCannotStart;
  }
}
