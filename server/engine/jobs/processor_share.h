// How much of a busy processor a thread gets.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_PROCESSOR_SHARE_H_
#define GEODESIC_SERVER_ENGINE_JOBS_PROCESSOR_SHARE_H_

#include <chrono>

#include "server/engine/base/clock.h"

namespace geodesic::server {

// Work that has run for longer makes way for what has not.
inline constexpr Duration kYoung = std::chrono::microseconds(12'500);

// From kYoung on the calling thread's share is a third of what others get, and
// four times later a ninth; no less, since other programs may want processors,
// too. A share does not grow again: without privileges Linux takes no nice
// value back. Does nothing where the system refuses.
void ShareByAge(Duration ran);

// Whether ShareByAge made the calling thread's share smaller.
bool HasSmallShare();

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_PROCESSOR_SHARE_H_
