// Details of an error besides code, message and field path
// (geodesic_types/field_path.h). They are payloads of absl::Status, so all
// layers keep them.

#ifndef GEODESIC_SERVER_ENGINE_BASE_STATUS_DETAILS_H_
#define GEODESIC_SERVER_ENGINE_BASE_STATUS_DETAILS_H_

#include <chrono>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace geodesic::server {

// The reasons of errors, for programs. They never change their meaning; the
// message beside them is for people. docs/protocol.md lists them.
namespace reason {

// INVALID_ARGUMENT
inline constexpr std::string_view kInvalidRequest = "INVALID_REQUEST";
// NOT_FOUND
inline constexpr std::string_view kMeshNotResident = "MESH_NOT_RESIDENT";
inline constexpr std::string_view kAnswerNotKept = "ANSWER_NOT_KEPT";
// RESOURCE_EXHAUSTED, either for good or until other requests have ended
inline constexpr std::string_view kLimitExceeded = "LIMIT_EXCEEDED";
inline constexpr std::string_view kQueueFull = "QUEUE_FULL";
inline constexpr std::string_view kMemoryFull = "MEMORY_FULL";
inline constexpr std::string_view kTooManyRequests = "TOO_MANY_REQUESTS";
inline constexpr std::string_view kServerFull = "SERVER_FULL";
inline constexpr std::string_view kQuotaExceeded = "QUOTA_EXCEEDED";
// UNAUTHENTICATED
inline constexpr std::string_view kTokenMissing = "TOKEN_MISSING";
inline constexpr std::string_view kTokenUnknown = "TOKEN_UNKNOWN";
inline constexpr std::string_view kTokenExpired = "TOKEN_EXPIRED";
// PERMISSION_DENIED
inline constexpr std::string_view kScopeMissing = "SCOPE_MISSING";
// UNAVAILABLE
inline constexpr std::string_view kShuttingDown = "SHUTTING_DOWN";
inline constexpr std::string_view kUnavailable = "UNAVAILABLE";
// The reasons named like their codes
inline constexpr std::string_view kFailedPrecondition = "FAILED_PRECONDITION";
inline constexpr std::string_view kDeadlineExceeded = "DEADLINE_EXCEEDED";
inline constexpr std::string_view kCancelled = "CANCELLED";
inline constexpr std::string_view kInternal = "INTERNAL";

}  // namespace reason

inline constexpr std::string_view kErrorReasons[] = {
    reason::kInvalidRequest,     reason::kMeshNotResident,
    reason::kAnswerNotKept,      reason::kLimitExceeded,
    reason::kQueueFull,          reason::kMemoryFull,
    reason::kTooManyRequests,    reason::kServerFull,
    reason::kQuotaExceeded,      reason::kTokenMissing,
    reason::kTokenUnknown,       reason::kTokenExpired,
    reason::kScopeMissing,       reason::kShuttingDown,
    reason::kUnavailable,        reason::kDeadlineExceeded,
    reason::kCancelled,          reason::kInternal,
    reason::kFailedPrecondition,
};

// After which a refusal says to try again, where nobody knows how long it
// takes.
inline constexpr std::chrono::milliseconds kRetryDelay{1000};

// Says that the same request may succeed after `delay`. OK stays OK.
absl::Status WithRetryAfter(absl::Status status,
                            std::chrono::milliseconds delay);

std::optional<std::chrono::milliseconds> RetryAfter(const absl::Status& status);

// Adds a reason, one of those above. OK stays OK.
absl::Status WithReason(absl::Status status, std::string_view reason);

// The status's reason; without one, the usual reason for its code.
// REQUIRES: not OK.
std::string ReasonOf(const absl::Status& status);

// Says whose quota was exceeded, e.g. "client:ci", with reason QUOTA_EXCEEDED.
absl::Status WithQuotaFailure(absl::Status status, std::string_view subject);

std::optional<std::string> QuotaSubject(const absl::Status& status);

// Adds the digest of the mesh that was not found.
absl::Status WithMesh(absl::Status status, std::string_view digest);

std::optional<std::string> MeshAtFault(const absl::Status& status);

// UNAVAILABLE: the server is shutting down.
absl::Status ShuttingDown();

// The message in printable ASCII. Other bytes, which it may quote from a file
// or request, are escaped.
std::string PrintableMessage(const absl::Status& status);

// Runs `work` in a job, where an exception must not end the thread or the
// server. Returns what `work` returns, an absl::Status or StatusOr. Errors:
// RESOURCE_EXHAUSTED for bad_alloc, INTERNAL for other exceptions; the message
// says that it came while the server `what`, e.g. "built a mesh".
template <typename Work>
auto Guarded(std::string_view what, Work work) -> decltype(work()) {
  const absl::string_view name(what.data(), what.size());
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError(
        absl::StrCat("the server ran out of memory while it ", name));
  } catch (const std::exception& error) {
    return absl::InternalError(
        absl::StrCat("exception while the server ", name, ": ", error.what()));
  }
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_BASE_STATUS_DETAILS_H_
