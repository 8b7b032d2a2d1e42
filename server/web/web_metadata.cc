#include "server/web/web_metadata.h"

#include <grpc/grpc.h>
#include <grpc/slice.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include "absl/strings/ascii.h"
#include "absl/strings/escaping.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "server/web/grpc_web.h"

namespace geodesic::server {
namespace {

constexpr std::string_view kBinary = "-bin";

// Of the connection, the body, the page or the browser.
constexpr std::string_view kNotMetadata[] = {"accept",
                                             "accept-charset",
                                             "accept-encoding",
                                             "accept-language",
                                             "cache-control",
                                             "connection",
                                             "content-encoding",
                                             "content-length",
                                             "content-type",
                                             "cookie",
                                             "dnt",
                                             "expect",
                                             "host",
                                             "keep-alive",
                                             "origin",
                                             "pragma",
                                             "priority",
                                             "proxy-authorization",
                                             "proxy-connection",
                                             "referer",
                                             "te",
                                             "trailer",
                                             "transfer-encoding",
                                             "upgrade",
                                             "user-agent",
                                             "via",
                                             "x-grpc-web",
                                             "x-user-agent"};
constexpr std::string_view kNotMetadataPrefixes[] = {"grpc-", "sec-",
                                                     "access-control-"};

bool IsMetadata(const std::string& name) {
  return std::ranges::find(kNotMetadata, name) == std::end(kNotMetadata) &&
         std::ranges::none_of(
             kNotMetadataPrefixes,
             [&](std::string_view prefix) { return name.starts_with(prefix); });
}

grpc_slice Borrowed(const std::string& text) {
  return grpc_slice_from_static_buffer(text.data(), text.size());
}

// As gRPC has it: a name that is nothing but the ending is one of text.
bool IsBinary(std::string_view name) {
  return name.size() > kBinary.size() && name.ends_with(kBinary);
}

// gRPC ends the process when it is handed what these refuse.
bool IsLegalName(const std::string& name) {
  return grpc_header_key_is_legal(Borrowed(name)) != 0;
}
bool IsLegalText(const std::string& value) {
  return grpc_header_nonbin_value_is_legal(Borrowed(value)) != 0;
}

absl::Status Malformed(const std::string& name) {
  return absl::InvalidArgumentError(
      absl::StrCat("the header \"", name, "\" is malformed"));
}

absl::Status AddBytes(const std::string& name, const std::string& value,
                      grpc::ClientContext& context) {
  // Browsers join headers of one name with commas, which base64 has not.
  for (const absl::string_view part : absl::StrSplit(value, ',')) {
    std::string bytes;
    if (!absl::Base64Unescape(absl::StripAsciiWhitespace(part), &bytes)) {
      return Malformed(name);
    }
    context.AddMetadata(name, bytes);
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status AddMetadata(const HttpHeaders& headers,
                         grpc::ClientContext& context) {
  for (const auto& [original, value] : headers) {
    const std::string name = absl::AsciiStrToLower(original);
    if (name == "grpc-timeout") {
      const std::optional<std::chrono::nanoseconds> timeout =
          ParseTimeout(value);
      if (!timeout) return Malformed(name);
      context.set_deadline(
          std::chrono::system_clock::now() +
          std::chrono::ceil<std::chrono::system_clock::duration>(*timeout));
      continue;
    }
    if (!IsMetadata(name)) continue;
    if (!IsLegalName(name)) return Malformed(name);
    if (IsBinary(name)) {
      absl::Status status = AddBytes(name, value, context);
      if (!status.ok()) return status;
    } else if (IsLegalText(value)) {
      context.AddMetadata(name, value);
    } else {
      return Malformed(name);
    }
  }
  return absl::OkStatus();
}

HttpHeaders ToHeaders(
    const std::multimap<grpc::string_ref, grpc::string_ref>& metadata) {
  HttpHeaders headers;
  for (const auto& [key, data] : metadata) {
    std::string name(key.data(), key.size());
    std::string value(data.data(), data.size());
    if (IsBinary(name)) value = absl::Base64Escape(value);
    headers.emplace_back(std::move(name), std::move(value));
  }
  return headers;
}

}  // namespace geodesic::server
