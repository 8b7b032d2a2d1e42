#include "mesh/connectivity.h"

#include <algorithm>

#include "mesh/large_pages.h"

namespace geodesic {
namespace {

// How many half-edges ahead their faces are fetched: around a vertex they may
// lie anywhere.
constexpr size_t kAhead = 24;

class EdgeMatcher {
 public:
  explicit EdgeMatcher(const Incidence& incidence)
      : incidence_(incidence), arrivals_(incidence.vertex_count()) {
    result_.exits = MakeLargeVector<Exit>(3 * incidence.triangles.size());
    result_.is_closed_fan.resize(incidence.vertex_count());
  }

  Connectivity Match() && {
    for (uint32_t v = 0; v < incidence_.vertex_count(); ++v) MatchAt(v);
    std::ranges::sort(irregular_ends_);
    irregular_ends_.erase(
        std::unique(irregular_ends_.begin(), irregular_ends_.end()),
        irregular_ends_.end());
    for (const uint32_t lower : irregular_ends_) FindIrregularEdges(lower);
    return std::move(result_);
  }

 private:
  // The half-edge that was last seen to arrive from some vertex, and where.
  struct Arrival {
    uint32_t at = kNoHalfEdge;
    HalfEdge half_edge = kNoHalfEdge;
  };

  // A side of a face, filed under the lower of its two vertices.
  struct Side {
    uint32_t upper;
    HalfEdge half_edge;

    friend auto operator<=>(const Side&, const Side&) = default;
  };

  // Gives the half-edges that leave v their exits: those that arrive from where
  // they lead. Then walks around v.
  void MatchAt(uint32_t v) {
    const std::span<const HalfEdge> all = incidence_.outgoing;
    for (uint32_t i = incidence_.outgoing_begin[v];
         i < incidence_.outgoing_begin[v + 1]; ++i) {
      if (i + kAhead < all.size()) {
        __builtin_prefetch(&incidence_.triangles[all[i + kAhead] / 3]);
      }
      const HalfEdge arriving = Prev(all[i]);
      const uint32_t from = incidence_.From(arriving);
      // Of two half-edges from one vertex to another neither is the exit of the
      // other way, and any edge of three faces has two.
      if (arrivals_[from].at == v) irregular_ends_.push_back(std::min(from, v));
      arrivals_[from] = {v, arriving};
    }
    const std::span<const HalfEdge> outgoing = incidence_.Outgoing(v);
    for (const HalfEdge h : outgoing) {
      const Arrival& arrival = arrivals_[incidence_.From(Next(h))];
      result_.exits[h] = arrival.at == v ? arrival.half_edge : kNoHalfEdge;
    }
    result_.is_closed_fan[v] = IsClosedFan(outgoing);
  }

  // Whether from one to the next across exits a walk comes to all of the
  // half-edges that leave a vertex and back. Irregular edges still have the
  // exits of one of their pairs; no such walk crosses them, for it would miss a
  // face.
  bool IsClosedFan(std::span<const HalfEdge> outgoing) const {
    if (outgoing.empty()) return false;
    HalfEdge h = outgoing[0];
    for (size_t faces = 1; faces <= outgoing.size(); ++faces) {
      if (result_.exits[h] == kNoHalfEdge) return false;
      h = Next(result_.exits[h]);
      if (h == outgoing[0]) return faces == outgoing.size();
    }
    return false;
  }

  // Files the irregular edges from `lower` to higher vertices.
  void FindIrregularEdges(uint32_t lower) {
    std::vector<Side> sides;
    for (const HalfEdge h : incidence_.Outgoing(lower)) {
      for (const auto& [upper, side] :
           {Side{incidence_.From(Next(h)), h},
            Side{incidence_.From(Prev(h)), Prev(h)}}) {
        if (upper > lower) sides.push_back({upper, side});
      }
    }
    std::ranges::sort(sides);
    for (std::span<const Side> rest = sides; !rest.empty();) {
      const auto end = std::ranges::find_if(
          rest, [&](const Side& side) { return side.upper != rest[0].upper; });
      const std::span<const Side> edge(rest.begin(), end);
      rest = {end, rest.end()};
      if (IsRegular(edge)) continue;
      if (incidence_.named.empty()) {
        AddIrregularEdge(edge);
      } else {
        AddEdgesApart(edge);
      }
    }
  }

  // Sides that have the same ends by what was joined: edges inside sheets, by
  // the ends that they had, and one seam of all that were boundaries.
  void AddEdgesApart(std::span<const Side> sides) {
    std::vector<Side> by_name(sides.begin(), sides.end());
    const auto named_ends = [this](const Side& side) {
      return incidence_.NamedEnds(side.half_edge);
    };
    std::ranges::stable_sort(by_name, {}, named_ends);
    std::vector<Side> seam;
    for (std::span<const Side> rest = by_name; !rest.empty();) {
      const auto end = std::ranges::find_if(rest, [&](const Side& side) {
        return named_ends(side) != named_ends(rest[0]);
      });
      const std::span<const Side> edge(rest.begin(), end);
      rest = {end, rest.end()};
      if (edge.size() > 1) {
        AddEdge(edge);
      } else {
        seam.push_back(edge[0]);
      }
    }
    std::ranges::sort(seam);
    if (!seam.empty()) AddEdge(seam);
  }

  void AddEdge(std::span<const Side> edge) {
    if (!IsRegular(edge)) {
      AddIrregularEdge(edge);
    } else if (edge.size() == 1) {
      result_.exits[edge[0].half_edge] = kNoHalfEdge;
    } else {
      result_.exits[edge[0].half_edge] = edge[1].half_edge;
      result_.exits[edge[1].half_edge] = edge[0].half_edge;
    }
  }

  bool IsRegular(std::span<const Side> edge) const {
    return edge.size() == 1 ||
           (edge.size() == 2 && incidence_.From(edge[0].half_edge) !=
                                    incidence_.From(edge[1].half_edge));
  }

  void AddIrregularEdge(std::span<const Side> edge) {
    if (result_.irregular_begin.empty()) result_.irregular_begin.push_back(0);
    const Exit exit =
        kIrregularExit + static_cast<Exit>(result_.irregular_begin.size() - 1);
    for (const Side& side : edge) {
      result_.exits[side.half_edge] = exit;
      result_.irregular_half_edges.push_back(side.half_edge);
    }
    result_.irregular_begin.push_back(
        static_cast<uint32_t>(result_.irregular_half_edges.size()));
  }

  const Incidence& incidence_;
  std::vector<Arrival> arrivals_;         // by the vertex that they leave
  std::vector<uint32_t> irregular_ends_;  // lower ends of irregular edges
  Connectivity result_;
};

}  // namespace

Connectivity FindConnectivity(const Incidence& incidence) {
  return EdgeMatcher(incidence).Match();
}

}  // namespace geodesic
