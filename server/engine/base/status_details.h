// What the engine tells besides a code, a message and the path of a field
// (geodesic/field_path.h), carried as payloads of absl::Status so that it
// survives every layer in between.

#ifndef GEODESIC_SERVER_ENGINE_BASE_STATUS_DETAILS_H_
#define GEODESIC_SERVER_ENGINE_BASE_STATUS_DETAILS_H_

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace geodesic::server {

// Says that the same request may succeed after `delay`. OK stays OK.
absl::Status WithRetryAfter(absl::Status status,
                            std::chrono::milliseconds delay);

std::optional<std::chrono::milliseconds> RetryAfter(const absl::Status& status);

// A stable reason, one of error_reasons.h. OK stays OK.
absl::Status WithReason(absl::Status status, std::string_view reason);

// The reason that was given, else the usual one of the status's code.
// REQUIRES: not OK.
std::string ReasonOf(const absl::Status& status);

// Says whose quota was exceeded, e.g. "client:ci", with reason QUOTA_EXCEEDED.
absl::Status WithQuotaFailure(absl::Status status, std::string_view subject);

std::optional<std::string> QuotaSubject(const absl::Status& status);

// Names the mesh, by its digest, that is not there.
absl::Status WithMesh(absl::Status status, std::string_view digest);

std::optional<std::string> MeshAtFault(const absl::Status& status);

// UNAVAILABLE: the server ends.
absl::Status ShuttingDown();

// The message in printable ASCII: bytes of a file or request that it quotes
// beyond that are escaped.
std::string PrintableMessage(const absl::Status& status);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_BASE_STATUS_DETAILS_H_
