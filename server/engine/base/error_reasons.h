// The reasons of errors, for programs. They never change their meaning; the
// message beside them is for people. docs/protocol.md lists them.

#ifndef GEODESIC_SERVER_ENGINE_BASE_ERROR_REASONS_H_
#define GEODESIC_SERVER_ENGINE_BASE_ERROR_REASONS_H_

#include <string_view>

namespace geodesic::server {

namespace reason {

// INVALID_ARGUMENT
inline constexpr std::string_view kInvalidRequest = "INVALID_REQUEST";
// NOT_FOUND
inline constexpr std::string_view kMeshNotResident = "MESH_NOT_RESIDENT";
inline constexpr std::string_view kFieldNotKept = "FIELD_NOT_KEPT";
// RESOURCE_EXHAUSTED: for good, or until others are done
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
// Of the code's own name
inline constexpr std::string_view kDeadlineExceeded = "DEADLINE_EXCEEDED";
inline constexpr std::string_view kCancelled = "CANCELLED";
inline constexpr std::string_view kInternal = "INTERNAL";

}  // namespace reason

inline constexpr std::string_view kErrorReasons[] = {
    reason::kInvalidRequest,   reason::kMeshNotResident, reason::kFieldNotKept,
    reason::kLimitExceeded,    reason::kQueueFull,       reason::kMemoryFull,
    reason::kTooManyRequests,  reason::kServerFull,      reason::kQuotaExceeded,
    reason::kTokenMissing,     reason::kTokenUnknown,    reason::kTokenExpired,
    reason::kScopeMissing,     reason::kShuttingDown,    reason::kUnavailable,
    reason::kDeadlineExceeded, reason::kCancelled,       reason::kInternal,
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_BASE_ERROR_REASONS_H_
