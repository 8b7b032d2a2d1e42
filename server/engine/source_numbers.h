// How a client numbers the sources of a query.

#ifndef GEODESIC_SERVER_ENGINE_SOURCE_NUMBERS_H_
#define GEODESIC_SERVER_ENGINE_SOURCE_NUMBERS_H_

#include <cstdint>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/mesh.h"
#include "geodesic/query.h"

namespace geodesic::server {

// A client numbers points and curves together, in its own order; a Query has
// them apart. Empty lists mean that the client numbers as a Query does.
struct SourceNumbers {
  std::vector<uint32_t> points;  // of query.sources[i]
  std::vector<uint32_t> curves;  // of query.curves[j]
  // The request has a single one, called "source".
  bool is_single = false;
};

// The client's numbers of the sources of the canonical form of `query`, as
// query.h numbers those; of equal sources, the client's first.
std::vector<uint32_t> NumberCanonical(const Query& query,
                                      const SourceNumbers& numbers,
                                      const Query& canonical, const Mesh& mesh);

// Validate(query, mesh), but the message uses the client's numbers, and the
// field at fault (status_details.h) is named.
absl::Status ValidateAsNumbered(const Query& query,
                                const SourceNumbers& numbers, const Mesh& mesh);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_SOURCE_NUMBERS_H_
