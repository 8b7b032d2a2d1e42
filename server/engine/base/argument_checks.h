// Checks of a request's names and counts, before memory is allocated for them.

#ifndef GEODESIC_SERVER_ENGINE_BASE_ARGUMENT_CHECKS_H_
#define GEODESIC_SERVER_ENGINE_BASE_ARGUMENT_CHECKS_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace geodesic::server {

// Errors: INVALID_ARGUMENT naming `field` unless it is a digest's 64 digits.
absl::Status CheckDigest(std::string_view field, const std::string& digest);

// Errors: RESOURCE_EXHAUSTED naming the things and the limit, e.g.
// ("targets", 12, "max_targets", 10).
absl::Status CheckCount(std::string_view things, uint64_t count,
                        std::string_view limit_name, uint64_t limit,
                        std::string_view who = "the request has");

// NOT_FOUND: the answer to be resumed is no longer kept, or was replaced.
absl::Status AnswerNotKept();

absl::Status NotResident(const std::string& digest);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_BASE_ARGUMENT_CHECKS_H_
