// ReadTlsFiles and ReadTokenFile.

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "geodesic_client/connection_options.h"

namespace geodesic::client {
namespace {

absl::StatusOr<std::string> ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  // To insert nothing, as of an empty file, would count as a failure.
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad() || !text) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot read ", path));
  }
  return std::move(text).str();
}

// Reads the file if there is one.
absl::Status ReadPem(const std::string& path, std::string* pem) {
  if (path.empty()) return absl::OkStatus();
  absl::StatusOr<std::string> text = ReadFile(path);
  if (!text.ok()) return text.status();
  if (text->find("-----BEGIN ") == std::string::npos) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, " holds nothing in PEM form"));
  }
  *pem = *std::move(text);
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<TlsOptions> ReadTlsFiles(const TlsPaths& paths) {
  if (paths.certificate.empty() != paths.key.empty()) {
    return absl::InvalidArgumentError(
        "a certificate and its key belong together");
  }
  TlsOptions tls;
  absl::Status status = ReadPem(paths.authorities, &tls.authorities);
  if (status.ok()) status = ReadPem(paths.certificate, &tls.certificate);
  if (status.ok()) status = ReadPem(paths.key, &tls.key);
  if (!status.ok()) return status;
  return tls;
}

bool IsToken(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return absl::ascii_isgraph(c);
  });
}

absl::StatusOr<std::string> ReadTokenFile(const std::string& path) {
  absl::StatusOr<std::string> text = ReadFile(path);
  if (!text.ok()) return text.status();
  std::string token = text->substr(0, text->find('\n'));
  absl::StripAsciiWhitespace(&token);
  if (!IsToken(token)) {
    return absl::InvalidArgumentError(
        absl::StrCat("the first line of ", path, " is no token"));
  }
  return token;
}

}  // namespace geodesic::client
