// Which places of a mesh no path reaches, and why.

#ifndef GEODESIC_CLIENT_PLACES_REACH_H_
#define GEODESIC_CLIENT_PLACES_REACH_H_

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geodesic_client/mesh.h"
#include "geodesic_types/places.h"

namespace geodesic::client {

// What can be reached from some sources. Not thread-safe.
class Reach {
 public:
  // Keeps a reference to the mesh. Near to linear in its vertices and faces.
  // REQUIRES: indices in range.
  Reach(const MeshArrays& mesh, std::span<const Source> sources);

  // Whether it is a vertex that no face of the surface has.
  bool IsIsolated(uint64_t vertex) const;

  // Why no path leads to `target`, as the end of a sentence: "it lies in
  // another component of the mesh". Where a path does lead there, which some
  // limit cut off perhaps, `otherwise`. O(V log V) for the first target of a
  // component.
  std::string WhyUnreached(const SurfacePoint& target,
                           std::string_view otherwise);

 private:
  // A vertex of what the place lies in. Places that the mesh does not have are
  // at its first.
  uint32_t VertexOf(const SurfacePoint& place) const;
  // Where `component` touches others without sharing vertices, if it does.
  std::string Seam(uint32_t component) const;

  const MeshArrays& mesh_;
  std::vector<uint32_t> components_;  // of each vertex, one of its vertices
  std::vector<bool> has_face_;
  std::vector<bool> is_reached_;  // by component
  uint32_t first_source_ = 0;     // a vertex of it
  bool all_are_isolated_ = true;
  std::map<uint32_t, std::string> seams_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PLACES_REACH_H_
