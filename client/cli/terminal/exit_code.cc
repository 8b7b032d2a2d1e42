#include "client/cli/terminal/exit_code.h"

#include "absl/strings/cord.h"
#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

constexpr char kFilePayload[] = "geodesic.client/file-error";
constexpr char kNoServerPayload[] = "geodesic.client/no-server";
constexpr char kNoneRunsPayload[] = "geodesic.client/none-runs";
constexpr char kNoPathPayload[] = "geodesic.client/no-path";
constexpr char kInterruptedPayload[] = "geodesic.client/interrupted";

// Whether gRPC gave up before a server answered.
bool NeverConnected(std::string_view message) {
  return message.find("failed to connect") != std::string_view::npos ||
         message.find("DNS resolution failed") != std::string_view::npos ||
         message.find("Connection refused") != std::string_view::npos;
}

// Whether a server was there, but the two could not agree on TLS.
bool TlsFailed(std::string_view message) {
  return message.find("SSL") != std::string_view::npos ||
         message.find("handshak") != std::string_view::npos ||
         message.find("Hostname Verification") != std::string_view::npos ||
         message.find("in peer certificate") != std::string_view::npos;
}

// Whether somebody was there, and hung up before any call.
bool HungUp(std::string_view message) {
  return NeverConnected(message) &&
         (message.find("Socket closed") != std::string_view::npos ||
          message.find("Connection reset") != std::string_view::npos);
}

// Whether gRPC never dialled. It does not with files of TLS that it cannot use,
// and gives no reason.
bool NeverDialled(std::string_view message) {
  return message.find("empty address list") != std::string_view::npos;
}

}  // namespace

std::string_view ExitCodeHelp() {
  return "Exit codes:\n"
         "  0    done\n"
         "  1    geodesic server status: no server runs\n"
         "  2    the command line is wrong\n"
         "  3    a file on this machine cannot be read or written\n"
         "  4    no path leads to what was asked for\n"
         "  5    the server refused: malformed mesh, unknown mesh, a limit, "
         "...\n"
         "  6    the time given by --timeout is over\n"
         "  7    no server can be reached, or it is shutting down\n"
         "  130  interrupted\n";
}

absl::Status FileError(absl::Status status) {
  // NOT_FOUND is for what the server does not have.
  if (absl::IsNotFound(status)) {
    status = absl::InvalidArgumentError(status.message());
  }
  if (!status.ok()) status.SetPayload(kFilePayload, absl::Cord());
  return status;
}

absl::Status Interrupted() {
  absl::Status status = absl::CancelledError("interrupted");
  status.SetPayload(kInterruptedPayload, absl::Cord());
  return status;
}

absl::Status NoServer(absl::Status status) {
  if (!status.ok()) status.SetPayload(kNoServerPayload, absl::Cord());
  return status;
}

absl::Status NoneRuns(std::string_view message) {
  absl::Status status = absl::UnavailableError(std::string(message));
  status.SetPayload(kNoneRunsPayload, absl::Cord());
  return status;
}

absl::Status NoPath(std::string_view message) {
  absl::Status status = absl::NotFoundError(std::string(message));
  status.SetPayload(kNoPathPayload, absl::Cord());
  return status;
}

ExitCode ExitCodeOf(const absl::Status& status) {
  if (status.GetPayload(kFilePayload).has_value()) return ExitCode::kFile;
  if (status.GetPayload(kInterruptedPayload).has_value()) {
    return ExitCode::kInterrupted;
  }
  if (status.GetPayload(kNoServerPayload).has_value()) {
    return ExitCode::kNoServer;
  }
  if (status.GetPayload(kNoPathPayload).has_value()) return ExitCode::kNoPath;
  if (status.GetPayload(kNoneRunsPayload).has_value()) {
    return ExitCode::kNoneRuns;
  }
  switch (status.code()) {
    case absl::StatusCode::kUnavailable:
    case absl::StatusCode::kCancelled:
      return ExitCode::kNoServer;
    case absl::StatusCode::kDeadlineExceeded:
      return ExitCode::kTimeout;
    default:
      return ExitCode::kRefused;
  }
}

std::string Explain(const absl::Status& status, std::string_view server) {
  const std::string at(server);
  const std::string message(status.message());
  switch (ExitCodeOf(status)) {
    case ExitCode::kNoServer:
      if (status.GetPayload(kNoServerPayload).has_value()) return message;
      if (absl::IsCancelled(status)) {
        return absl::StrCat("the server at ", at, " ended the call: ", message,
                            "; try again in a moment");
      }
      if (TlsFailed(message)) {
        return absl::StrCat("no TLS connection to ", at, ": ", message,
                            "; see --tls-ca, --tls-cert and --tls-server-name");
      }
      if (HungUp(message)) {
        return absl::StrCat(
            at,
            " hung up at once, as servers with TLS do: --tls-ca speaks TLS to "
            "them, and some want a certificate (--tls-cert, --tls-key) that "
            "their --tls-client-ca knows");
      }
      if (NeverDialled(message)) {
        return absl::StrCat(
            "no connection to ", at,
            " was tried: a file of TLS cannot be used; --tls-ca has to hold "
            "certificates, and --tls-key the key of --tls-cert");
      }
      return NeverConnected(message)
                 ? absl::StrCat("cannot reach a server at ", at,
                                ": start one with geodesicd, or name one with "
                                "--server")
                 : absl::StrCat("the server at ", at,
                                " is not available: ", message,
                                "; try again in a moment");
    case ExitCode::kTimeout:
      return absl::StrCat("out of time: ", message,
                          "; give it longer with --timeout");
    case ExitCode::kRefused:
      if (absl::IsUnauthenticated(status)) {
        return absl::StrCat(message,
                            "; name a token with --token-file or "
                            "GEODESIC_TOKEN");
      }
      if (absl::IsNotFound(status)) {
        return absl::StrCat(message,
                            "; `geodesic meshes` lists what is resident, "
                            "`geodesic upload FILE` adds to it");
      }
      // gRPC refuses such a message, in these words, before the server can.
      if (message.find("Received message larger than max") !=
          std::string::npos) {
        return absl::StrCat(
            "the request is larger than the server's "
            "max_message_bytes (",
            message,
            "): ask for fewer sources, targets or levels at a "
            "time");
      }
      if (absl::IsUnimplemented(status)) {
        return absl::StrCat("the server at ", at,
                            " does not speak geodesic.v1, or is older than "
                            "this question");
      }
      return message;
    default:
      return message;
  }
}

}  // namespace geodesic::client
