// No exception may leave a job: the thread and the server live on.

#ifndef GEODESIC_SERVER_ENGINE_BASE_GUARDED_H_
#define GEODESIC_SERVER_ENGINE_BASE_GUARDED_H_

#include <exception>
#include <new>
#include <string_view>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace geodesic::server {

// What `work` returns, an absl::Status or StatusOr; RESOURCE_EXHAUSTED for
// bad_alloc and INTERNAL for any other exception, saying that it came while the
// server `what`, e.g. "built a mesh".
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

#endif  // GEODESIC_SERVER_ENGINE_BASE_GUARDED_H_
