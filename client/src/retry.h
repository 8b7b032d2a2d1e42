// When a call that gRPC does not repeat is worth repeating.

#ifndef GEODESIC_CLIENT_RETRY_H_
#define GEODESIC_CLIENT_RETRY_H_

#include <stop_token>

#include "absl/status/status.h"

namespace geodesic::client {

// As the channel's own policy has it.
inline constexpr int kMaxAttempts = 4;

// Waits before the next attempt, as long as the server suggests or twice as
// long each time; `attempts` have failed, the last with `status`. False, at
// once or when `stop` asks for it, if there is to be none: the error would come
// again, or it was tried often enough.
bool WaitToRetry(const absl::Status& status, int attempts,
                 std::stop_token stop);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_RETRY_H_
