#include "server/options/options.h"

#include <CLI/CLI.hpp>

#include "absl/strings/str_cat.h"
#include "server/options/flag_types.h"
#include "server/options/flags.h"
#include "server/options/limit_flags.h"
#include "server/options/memory.h"
#include "server/options/setting_sources.h"
#include "server/security/tls_files.h"

namespace geodesic::server {
namespace {

constexpr int kUsageError = 2;

std::string CheckTogether(const ServerOptions& options) {
  const TlsFiles& tls = options.tls;
  if (tls.certificate.empty() != tls.key.empty()) {
    return "--tls-cert and --tls-key belong together";
  }
  if (!tls.client_authorities.empty() && !tls.enabled()) {
    return "--tls-client-ca needs --tls-cert and --tls-key";
  }
  if (!tls.enabled() && !options.insecure_listen &&
      !IsLoopback(options.listen)) {
    return absl::StrCat("--listen ", options.listen,
                        " would serve other machines in clear: give --tls-cert "
                        "and --tls-key, or --insecure-listen if that is meant");
  }
  if (!options.web_listen.empty() && !tls.client_authorities.empty()) {
    return "--web cannot ask browsers for certificates, so it does not go with "
           "--tls-client-ca";
  }
  if (!options.web_listen.empty() && !tls.enabled() &&
      !options.insecure_listen && !IsLoopback(options.web_listen)) {
    return absl::StrCat("--web ", options.web_listen,
                        " would serve other machines in clear: give --tls-cert "
                        "and --tls-key, put a proxy with TLS in front of a "
                        "loopback address, or give --insecure-listen if that "
                        "is meant");
  }
  const Limits& limits = options.limits;
  struct Pair {
    const char* part;
    uint64_t bytes;
    const char* whole;
    uint64_t room;
  };
  for (const auto& [part, bytes, whole, room] :
       {Pair{"--limit max-message-bytes", options.max_message_bytes,
             "receive-memory", options.receive_memory_bytes},
        Pair{"--limit max-message-bytes", options.max_message_bytes,
             "request-memory", options.request_memory_bytes},
        Pair{"--limit max-upload-bytes", limits.max_upload_bytes,
             "upload-memory", limits.upload_memory_bytes}}) {
    if (bytes <= room) continue;
    return absl::StrCat(part, " (", InUnits(bytes), ") must not exceed ", whole,
                        " (", InUnits(room), ")");
  }
  return "";
}

// Gives `app` all settings, which write into `options`.
void AddAll(const std::string& version, CLI::App& app, ServerOptions& options) {
  app.name("geodesicd");
  app.description(
      "Serves exact geodesic distances on triangle meshes over gRPC.");
  app.set_version_flag("--version", "geodesicd " + version);
  AddFile(app);
  AddFlags(app, options);
  AddVariables(app);
  ServerOptions divided = options;
  Divide(divided);
  app.footer(absl::StrCat(
      ExplainLimits(divided),
      "\nBYTES take a unit: B, KiB, MiB, GiB, or KB, MB, GB. A setting comes\n"
      "from its flag, else from its environment variable, else from the file,\n"
      "where it has the flag's name without dashes in front:\n"
      "  listen = \"0.0.0.0:50051\"\n"
      "  memory = \"16GiB\"\n"
      "  limit = [\"max-pairs=1000000\", \"mesh-store=8GiB\"]\n\n"
      "Exit codes: 0 stopped in order; 1 could not start; 2 wrong usage;\n"
      "3 stopped, but requests had to be cancelled."));
}

}  // namespace

CommandLine ParseCommandLine(int argc, const char* const* argv,
                             const std::string& version) {
  CommandLine result;
  ServerOptions& options = result.options;

  CLI::App app;
  AddAll(version, app, options);

  try {
    app.parse(ArgumentsInReverse(argc, argv));
    TakeVariables(app);
    Divide(options);
    SetLimits(options.chosen_limits, options);
    if (const std::string error = CheckTogether(options); !error.empty()) {
      throw CLI::ValidationError(error);
    }
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    result.exit_code = code == 0 ? 0 : kUsageError;
  }
  if (options.data_dir.empty()) {
    options.limits.mesh_disk_bytes = 0;
    options.limits.field_disk_bytes = 0;
  }
  return result;
}

manual::Page ProgramPage() {
  ServerOptions options;
  CLI::App app;
  AddAll("", app, options);
  return manual::Describe(app);
}

}  // namespace geodesic::server
