#include "geodesic/join_seams.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/container/flat_hash_set.h"
#include "absl/functional/function_ref.h"
#include "absl/strings/str_cat.h"
#include "mesh/boundary_edges.h"
#include "mesh/close_edges.h"
#include "mesh/disjoint_sets.h"
#include "mesh/locality.h"
#include "mesh/rounding.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// The seams of a soup.
class Seams {
 public:
  // REQUIRES: `boundary` has edges.
  Seams(TriangleSoup& soup, const BoundaryEdges& boundary,
        Checkpoint& checkpoint)
      : soup_(soup),
        boundary_(boundary),
        checkpoint_(checkpoint),
        vertices_(static_cast<uint32_t>(boundary.vertices().size())),
        edges_(static_cast<uint32_t>(boundary.edges().size())) {}

  // Joins edges whose ends are equal.
  absl::Status JoinEqual() {
    // The number of each place, and the first edge between two of them.
    absl::flat_hash_map<Point, uint32_t> places;
    absl::flat_hash_map<std::pair<uint32_t, uint32_t>, uint32_t> firsts;
    std::vector<uint32_t> points;  // edges without length
    const auto place_of = [&](uint32_t v) {
      return places
          .try_emplace(soup_.positions[v], static_cast<uint32_t>(places.size()))
          .first->second;
    };
    for (uint32_t i = 0; i < edge_count(); ++i) {
      if (absl::Status status = Poll(i); !status.ok()) return status;
      const auto& [low, high] = boundary_.edges()[i];
      const uint32_t from = place_of(low), to = place_of(high);
      if (from == to) {
        points.push_back(i);
        continue;
      }
      const auto [first, is_new] = firsts.try_emplace(std::minmax(from, to), i);
      if (is_new) continue;
      Join(i, first->second,
           from != place_of(boundary_.edges()[first->second].low));
    }
    if (points.empty()) return absl::OkStatus();
    // The ends of a side without length are one corner, and its face is left
    // out. If no other face has that corner, it is part of any where it lies.
    for (const uint32_t i : points) {
      JoinVertices(boundary_.edges()[i].low, boundary_.edges()[i].high);
    }
    const std::vector<bool> is_on_face = CornersOfFaces();
    absl::flat_hash_map<uint32_t, uint32_t> corner_of;  // by the place
    for (const auto& [low, high] : boundary_.edges()) {
      for (const uint32_t v : {low, high}) {
        if (is_on_face[SetOf(v)]) corner_of.try_emplace(place_of(v), v);
      }
    }
    // Sets change their numbers once the first is joined.
    std::erase_if(points, [&](uint32_t i) {
      return is_on_face[SetOf(boundary_.edges()[i].low)];
    });
    for (const uint32_t i : points) {
      const uint32_t low = boundary_.edges()[i].low;
      const auto corner = corner_of.find(place_of(low));
      if (corner != corner_of.end()) JoinVertices(low, corner->second);
    }
    return absl::OkStatus();
  }

  // Joins what is left where it differs by rounding alone: edges whose ends are
  // one, then what is left of rings that are points.
  absl::Status JoinRounded() {
    const Rounding rounding(soup_, boundary_.vertices());
    if (rounding.distance() == 0) return absl::OkStatus();
    const auto are_one = [&](uint32_t a, uint32_t b) {
      return rounding.Allows(soup_.positions[a], soup_.positions[b]);
    };
    absl::Status status =
        JoinClose({rounding.distance(), kMostRounded}, are_one);
    if (!status.ok()) return status;
    return JoinRings(rounding.distance() / kMostRounded, are_one);
  }

  // Joins what is left to edges whose ends are within a distance.
  absl::Status JoinWithin(double distance) {
    return JoinClose({distance, kMostWelded},
                     [](uint32_t, uint32_t) { return true; });
  }

  // Writes what was joined into the soup.
  void Finish() {
    std::vector<bool> is_joined(edge_count());
    for (uint32_t i = 0; i < edge_count(); ++i) {
      const uint32_t first = edges_.Find(i);
      if (first == i || is_joined[first]) continue;
      is_joined[first] = true;
      ++soup_.reading.seam_edges;
    }
    const std::vector<uint32_t>& outer = boundary_.vertices();
    if (vertices_.count() == outer.size()) return;
    for (uint32_t i = 0; i < outer.size(); ++i) {
      if (const uint32_t into = vertices_.Find(i); into != i) {
        soup_.reading.joined.push_back({outer[i], outer[into]});
      }
    }
  }

 private:
  static constexpr uint32_t kBetweenPolls = 1 << 14;

  // Joins the vertices of boundaries all around which the ends of edges are one
  // by `are_one`, in faces whose other sides are longer than `least`: the pole
  // of a sphere is a ring where its radius is sin pi.
  absl::Status JoinRings(double least,
                         absl::FunctionRef<bool(uint32_t, uint32_t)> are_one) {
    absl::flat_hash_map<uint32_t, uint32_t> degrees;  // by the number of a set
    absl::flat_hash_set<std::pair<uint32_t, uint32_t>> sides;
    for (uint32_t i = 0; i < edge_count(); ++i) {
      const auto& [low, high] = boundary_.edges()[i];
      if (edges_.Find(i) != i || !are_one(low, high)) continue;
      const uint32_t from = SetOf(low), to = SetOf(high);
      if (from == to) continue;
      sides.emplace(low, high);
      ++degrees[from];
      ++degrees[to];
    }
    if (sides.empty()) return absl::OkStatus();
    DisjointSets rings(static_cast<uint32_t>(boundary_.vertices().size()));
    for (const auto& [low, high] : sides) rings.Join(SetOf(low), SetOf(high));
    absl::flat_hash_set<uint32_t> open;
    for (const auto& [set, degree] : degrees) {
      if (degree != 2) open.insert(rings.Find(set));
    }
    absl::erase_if(sides, [&](const auto& side) {
      return open.contains(rings.Find(SetOf(side.first)));
    });
    if (sides.empty()) return absl::OkStatus();
    const auto is_long = [&](uint32_t a, uint32_t b) {
      return Distance(soup_.positions[a], soup_.positions[b]) > least;
    };
    for (uint32_t face = 0; face < soup_.triangles.size(); ++face) {
      if (absl::Status status = Poll(face); !status.ok()) return status;
      const Triangle& corners = soup_.triangles[face];
      for (int corner = 0; corner < 3; ++corner) {
        const uint32_t a = corners[corner], b = corners[(corner + 1) % 3],
                       c = corners[(corner + 2) % 3];
        if (sides.contains(std::minmax(a, b)) && is_long(b, c) &&
            is_long(c, a)) {
          JoinVertices(a, b);
        }
      }
    }
    return absl::OkStatus();
  }

  // Joins what is left to edges whose ends are close, and one by `are_one`,
  // until none is: those that were joined lie where the first of them does.
  absl::Status JoinClose(const Closeness& closeness,
                         absl::FunctionRef<bool(uint32_t, uint32_t)> are_one) {
    for (uint64_t before = 0; before != vertices_.count();) {
      before = vertices_.count();
      absl::Status status = JoinCloseOnce(closeness, are_one);
      if (!status.ok()) return status;
    }
    return absl::OkStatus();
  }

  absl::Status JoinCloseOnce(
      const Closeness& closeness,
      absl::FunctionRef<bool(uint32_t, uint32_t)> are_one) {
    // One of each set, between the vertices that take the places of its ends.
    std::vector<VertexPair> edges;
    std::vector<uint32_t> numbers;
    std::vector<bool> is_joined(edge_count());
    const auto place_of = [&](uint32_t v) {
      return boundary_.vertices()[SetOf(v)];
    };
    for (uint32_t i = 0; i < edge_count(); ++i) {
      if (edges_.Find(i) != i) {
        is_joined[edges_.Find(i)] = true;
        continue;
      }
      const auto& [low, high] = boundary_.edges()[i];
      edges.push_back({place_of(low), place_of(high)});
      numbers.push_back(i);
    }
    if (std::ranges::all_of(numbers,
                            [&](uint32_t i) { return is_joined[i]; })) {
      return absl::OkStatus();
    }
    absl::StatusOr<CloseEdges> grid =
        CloseEdges::Make(soup_.positions, edges, closeness, checkpoint_);
    if (!grid.ok()) return grid.status();
    std::vector<ClosePair> pairs;
    for (uint32_t i = 0; i < edges.size(); ++i) {
      if (absl::Status status = Poll(i); !status.ok()) return status;
      if (is_joined[numbers[i]]) continue;
      pairs.clear();
      absl::Status status = grid->Find(i, checkpoint_, pairs);
      if (!status.ok()) return status;
      for (const ClosePair& pair : pairs) {
        auto [low, high] = edges[pair.second];
        if (pair.is_turned) std::swap(low, high);
        if (!are_one(edges[i].low, low) || !are_one(edges[i].high, high)) {
          continue;
        }
        Join(numbers[pair.first], numbers[pair.second], pair.is_turned);
      }
    }
    return absl::OkStatus();
  }

  uint32_t edge_count() const {
    return static_cast<uint32_t>(boundary_.edges().size());
  }

  absl::Status Poll(uint32_t i) const {
    return i % kBetweenPolls == 0 ? checkpoint_.Poll({}) : absl::OkStatus();
  }

  void Join(uint32_t a, uint32_t b, bool is_turned) {
    VertexPair from = boundary_.edges()[a];
    const VertexPair& to = boundary_.edges()[b];
    if (is_turned) std::swap(from.low, from.high);
    // A face would lose a side.
    if (boundary_.AreNeighbours(from.low, to.low) ||
        boundary_.AreNeighbours(from.high, to.high)) {
      return;
    }
    JoinVertices(from.low, to.low);
    JoinVertices(from.high, to.high);
    edges_.Join(a, b);
  }

  // Of the vertices at the boundary, by the numbers of their sets: which have a
  // face of three corners.
  std::vector<bool> CornersOfFaces() {
    std::vector<bool> is_on_face(boundary_.vertices().size());
    const auto joined = [&](uint32_t v) {
      return boundary_.Has(v)
                 ? boundary_.vertices()[vertices_.Find(boundary_.NumberOf(v))]
                 : v;
    };
    for (const auto& [a, b, c] : soup_.triangles) {
      const Triangle corners = {joined(a), joined(b), joined(c)};
      if (RepeatsVertex(corners)) continue;
      for (const uint32_t v : corners) {
        if (boundary_.Has(v)) is_on_face[boundary_.NumberOf(v)] = true;
      }
    }
    return is_on_face;
  }

  // The number of the set of a vertex at the boundary.
  uint32_t SetOf(uint32_t v) { return vertices_.Find(boundary_.NumberOf(v)); }

  void JoinVertices(uint32_t a, uint32_t b) {
    vertices_.Join(boundary_.NumberOf(a), boundary_.NumberOf(b));
  }

  TriangleSoup& soup_;
  const BoundaryEdges& boundary_;
  Checkpoint& checkpoint_;
  DisjointSets vertices_;  // by their numbers at the boundary
  DisjointSets edges_;     // those that are joined
};

// At the most, with what BoundaryEdges holds: the sets and what was joined; the
// sets, the places, the edges between these, the corners, and the grid, in
// tables that are at least 7/16 full.
constexpr uint64_t kBytesAVertex = 4 + 4 + 4 + sizeof(JoinedVertex);
constexpr uint64_t kBytesAnEdge = 24 + 4 + 2 * (32 + 16) + 16 + 2 * 40 + 2 * 20;

// Tells of a soup's bytes, too, where it tells of bytes.
class WithSoup final : public Checkpoint {
 public:
  WithSoup(const TriangleSoup& soup, Checkpoint& next)
      : bytes_(soup.positions.size() * sizeof(Point) +
               soup.triangles.size() * sizeof(Triangle)),
        next_(next) {}

  absl::Status Poll(const Progress& progress) override {
    Progress all = progress;
    if (all.solver_bytes > 0) all.solver_bytes += bytes_;
    return next_.Poll(all);
  }

 private:
  const uint64_t bytes_;
  Checkpoint& next_;
};

}  // namespace

absl::Status Validate(const Welding& welding) {
  if (welding.kind == Welding::Kind::kWithin &&
      !(welding.distance >= 0 && std::isfinite(welding.distance))) {
    return absl::InvalidArgumentError(
        absl::StrCat("the distance ", welding.distance,
                     " within which edges are joined is not a finite number "
                     ">= 0"));
  }
  return absl::OkStatus();
}

absl::Status JoinSeams(const Welding& welding, TriangleSoup& soup,
                       Checkpoint& asked) {
  if (absl::Status status = Validate(welding); !status.ok()) return status;
  if (welding.kind == Welding::Kind::kNone) return absl::OkStatus();
  WithSoup checkpoint(soup, asked);
  const absl::StatusOr<BoundaryEdges> boundary =
      BoundaryEdges::Find(soup, checkpoint);
  // Such a soup is refused when the mesh is built.
  if (absl::IsOutOfRange(boundary.status())) return absl::OkStatus();
  if (!boundary.ok()) return boundary.status();
  if (boundary->edges().empty()) return absl::OkStatus();
  absl::Status status = checkpoint.Poll(
      {.solver_bytes = soup.positions.size() * sizeof(uint32_t) +
                       boundary->vertices().size() * kBytesAVertex +
                       boundary->edges().size() * kBytesAnEdge});
  if (!status.ok()) return status;
  Seams seams(soup, *boundary, checkpoint);
  status = seams.JoinEqual();
  if (!status.ok()) return status;
  const bool is_within = welding.kind == Welding::Kind::kWithin;
  if (!is_within || welding.distance > 0) status = seams.JoinRounded();
  if (status.ok() && is_within && welding.distance > 0) {
    status = seams.JoinWithin(welding.distance);
  }
  if (status.ok()) seams.Finish();
  return status;
}

absl::Status JoinSeams(const Welding& welding, TriangleSoup& soup) {
  NoCheckpoint checkpoint;
  return JoinSeams(welding, soup, checkpoint);
}

}  // namespace geodesic
