#include "geodesic/mesh_summary.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "geodesic/checkpoint.h"
#include "mesh/close_edges.h"
#include "mesh/disjoint_sets.h"
#include "mesh/locality.h"
#include "mesh/touching_edges.h"
#include "polygons/pace.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// Whether faces can be turned over so that all agree. O(F). Says anything once
// the pace has stopped.
bool IsOrientable(const Mesh& mesh, Pace& pace) {
  if (!mesh.HasIrregularEdges()) return true;
  enum : uint8_t { kUnseen, kAsIs, kTurned };
  const uint32_t faces = mesh.half_edge_count() / 3;
  std::vector<uint8_t> sides(faces, kUnseen);
  std::vector<uint32_t> stack;
  bool is_orientable = true;
  for (uint32_t start = 0; start < faces && pace.Goes(); ++start) {
    if (sides[start] != kUnseen) continue;
    sides[start] = kAsIs;
    stack.push_back(start);
    while (!stack.empty() && is_orientable && pace.Goes()) {
      const uint32_t face = stack.back();
      stack.pop_back();
      for (HalfEdge h = 3 * face; h < 3 * face + 3; ++h) {
        if (mesh.IsNonManifoldEdge(h)) continue;
        mesh.ForEachBeyond(h, [&](HalfEdge other, bool is_mirrored) {
          const uint8_t side =
              is_mirrored ? kAsIs + kTurned - sides[face] : sides[face];
          uint8_t& there = sides[other / 3];
          if (there == kUnseen) {
            there = side;
            stack.push_back(other / 3);
          }
          is_orientable = is_orientable && there == side;
        });
      }
    }
  }
  return is_orientable;
}

// Fans of faces around vertices: one for an ordinary vertex, more where parts
// of the surface touch in a point.
class Fans {
 public:
  // Of no use once the pace has stopped.
  Fans(const Mesh& mesh, Pace& pace) : mesh_(mesh) {
    bool has_several = false;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      count_ += !mesh.Outgoing(v).empty();
      has_several = has_several || mesh.IsNonManifold(v);
    }
    if (has_several) Join(pace);
  }

  uint64_t count() const { return count_; }

  // Names the fan that the face of h is in around the vertex that h leaves.
  HalfEdge Of(HalfEdge h) {
    return joined_.has_value() ? joined_->Find(h)
                               : mesh_.Outgoing(mesh_.From(h))[0];
  }

 private:
  void Join(Pace& pace) {
    joined_.emplace(mesh_.half_edge_count());
    for (HalfEdge h = 0; h < mesh_.half_edge_count() && pace.Goes(); ++h) {
      if (mesh_.IsNonManifoldEdge(h)) continue;
      mesh_.ForEachBeyond(h, [&](HalfEdge other, bool is_mirrored) {
        joined_->Join(h, is_mirrored ? other : Next(other));
        joined_->Join(Next(h), is_mirrored ? Next(other) : other);
      });
    }
    count_ = joined_->count();
  }

  const Mesh& mesh_;
  uint64_t count_ = 0;
  // Outgoing half-edges, one a face and corner. Only where a vertex has several
  // fans: elsewhere the vertex names its only one.
  std::optional<DisjointSets> joined_;
};

// Boundary edges follow each other where they bound the same fan. Says anything
// once the pace has stopped.
uint64_t CountBoundaryLoops(const Mesh& mesh,
                            std::span<const HalfEdge> boundary, Fans& fans,
                            Pace& pace) {
  if (boundary.empty()) return 0;
  DisjointSets loops(mesh.half_edge_count());
  for (HalfEdge h : boundary) {
    if (!pace.Goes()) return 0;
    loops.Join(fans.Of(h), fans.Of(Next(h)));
  }
  // Each loop is counted where its name is seen first.
  std::vector<bool> is_named(mesh.half_edge_count());
  uint64_t count = 0;
  for (HalfEdge h : boundary) {
    if (!pace.Goes()) return 0;
    const uint32_t name = loops.Find(fans.Of(h));
    count += !is_named[name];
    is_named[name] = true;
  }
  return count;
}

// What one walk over the faces and their sides tells.
class Survey {
 public:
  Survey(const Mesh& mesh, MeshSummary& summary)
      : mesh_(mesh), summary_(summary), pieces_(mesh.half_edge_count() / 3) {}

  absl::Status Run(Checkpoint& checkpoint) {
    Pace pace(&checkpoint);
    double anisotropy_sum = 0;
    const uint32_t faces = mesh_.half_edge_count() / 3;
    for (uint32_t f = 0; f < faces; ++f) {
      if (!pace.Goes()) return pace.status();
      anisotropy_sum += MeasureFace(f);
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) CountSide(h);
    }
    const uint64_t with_area = faces - summary_.degenerate_faces;
    if (with_area > 0) {
      summary_.anisotropy = anisotropy_sum / static_cast<double>(with_area);
    }
    summary_.boundary_edges = boundary_.size();
    pieces_through_edges_ = pieces_.count();
    // Faces around any other vertex hang together by their edges.
    for (uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (!mesh_.IsNonManifold(v)) continue;
      const std::span<const HalfEdge> outgoing = mesh_.Outgoing(v);
      for (HalfEdge h : outgoing) {
        if (!pace.Goes()) return pace.status();
        pieces_.Join(h / 3, outgoing[0] / 3);
      }
    }
    summary_.components = pieces_.count();
    return checkpoint.Poll({});
  }

  std::span<const HalfEdge> boundary() const { return boundary_; }
  // Connected by edges: a shared vertex alone does not connect.
  uint64_t pieces_through_edges() const { return pieces_through_edges_; }

 private:
  // Its anisotropy; 0, and counted, if it has no area.
  double MeasureFace(uint32_t f) {
    const HalfEdgeFrame& frame = mesh_.frame(3 * f);
    const double a = frame.length, b = mesh_.frame(3 * f + 1).length,
                 c = mesh_.frame(3 * f + 2).length;
    const double area = frame.length * frame.apex_y / 2;
    const double longest = std::max({a, b, c});
    if (area <= kLeastHeight * longest) {
      ++summary_.degenerate_faces;
      return 0;
    }
    return (a + b + c) / 2 * longest / (2 * std::sqrt(3.0) * area);
  }

  void CountSide(HalfEdge h) {
    const HalfEdge first = mesh_.FirstOfEdge(h);
    if (first != h) {
      pieces_.Join(h / 3, first / 3);
      return;
    }
    ++summary_.edges;
    if (mesh_.IsBoundaryEdge(h)) {
      boundary_.push_back(h);
    } else if (mesh_.IsIrregularEdge(h)) {
      ++(mesh_.IsNonManifoldEdge(h) ? summary_.non_manifold_edges
                                    : summary_.inconsistent_edges);
    }
  }

  const Mesh& mesh_;
  MeshSummary& summary_;
  DisjointSets pieces_;
  uint64_t pieces_through_edges_ = 0;
  std::vector<HalfEdge> boundary_;
};

}  // namespace

namespace {

// Three digits that are no less.
double RoundedUp(double x) {
  if (x == 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 2);
  return std::ceil(x / unit) * unit;
}

// Where more edges lie together than this, some that are close may go untold.
constexpr uint32_t kMostCompared = 64;

// O(the lesser valence), or O(1) for a vertex and itself, which may be a hub.
bool AreNeighbours(const Mesh& mesh, uint32_t a, uint32_t b) {
  return a != b && VisitSides(mesh, a, b, [](HalfEdge) { return true; });
}

// Counts boundary edges that were perhaps meant to be joined.
// Errors: whatever `checkpoint` returns.
absl::Status CountCloseEdges(const Mesh& mesh,
                             std::span<const HalfEdge> boundary,
                             Checkpoint& checkpoint, MeshSummary& summary) {
  std::vector<HalfEdge> sides;
  std::vector<VertexPair> edges;
  edges.reserve(boundary.size());
  double length = 0;
  for (const HalfEdge h : boundary) {
    // No seam is made of sides without length.
    if (mesh.frame(h).length == 0) continue;
    const auto [low, high] = std::minmax({mesh.From(h), mesh.To(h)});
    sides.push_back(h);
    edges.push_back({low, high});
    length += std::ldexp(mesh.frame(h).length, mesh.scale_exponent());
  }
  if (edges.empty()) return absl::OkStatus();
  const Closeness closeness = {
      .distance = kSuspicious * length / static_cast<double>(edges.size()),
      .part = kSuspicious};
  absl::StatusOr<CloseEdges> grid =
      CloseEdges::Make(mesh.positions(), edges, closeness, checkpoint);
  if (!grid.ok()) return grid.status();
  std::vector<ClosePair> pairs;
  std::vector<HalfEdge> others;
  for (uint32_t i = 0; i < edges.size(); ++i) {
    pairs.clear();
    absl::Status status = grid->Find(i, checkpoint, pairs, kMostCompared);
    if (!status.ok()) return status;
    // Neighbours are not joined: a face would lose a side.
    std::erase_if(pairs, [&](const ClosePair& pair) {
      VertexPair from = edges[pair.first];
      const VertexPair& to = edges[pair.second];
      if (pair.is_turned) std::swap(from.low, from.high);
      return AreNeighbours(mesh, from.low, to.low) ||
             AreNeighbours(mesh, from.high, to.high);
    });
    if (pairs.empty()) {
      others.push_back(sides[i]);
      continue;
    }
    ++summary.close_edges;
    summary.close_edge_distance =
        std::max(summary.close_edge_distance,
                 std::ranges::min(pairs, {}, &ClosePair::distance).distance);
  }
  absl::StatusOr<uint64_t> touching =
      CountTouchingEdges(mesh, others, checkpoint);
  if (touching.ok()) summary.touching_edges = *touching;
  return touching.status();
}

// Fills in what SummarizeReading promises.
absl::Status TellOfReading(const Mesh& mesh, std::span<const HalfEdge> boundary,
                           Checkpoint& checkpoint, MeshSummary& summary) {
  const Reading& reading = mesh.reading();
  summary.left_out_faces = mesh.left_out_face_count();
  summary.seam_edges = reading.seam_edges;
  summary.joined_vertices = reading.joined.size();
  summary.crossing_polygons = reading.crossing_polygons;
  summary.first_crossing_polygon = reading.first_crossing_polygon;
  return CountCloseEdges(mesh, boundary, checkpoint, summary);
}

}  // namespace

MeshSummary SummarizeReading(const Mesh& mesh) {
  std::vector<HalfEdge> boundary;
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.IsBoundaryEdge(h)) boundary.push_back(h);
  }
  MeshSummary summary;
  NoCheckpoint goes_on;
  (void)TellOfReading(mesh, boundary, goes_on, summary);
  return summary;
}

MeshSummary Summarize(const Mesh& mesh) {
  NoCheckpoint goes_on;
  return *Summarize(mesh, goes_on);
}

absl::StatusOr<MeshSummary> Summarize(const Mesh& mesh,
                                      Checkpoint& checkpoint) {
  MeshSummary summary;
  summary.vertices = mesh.vertex_count();
  summary.faces = mesh.face_count();

  summary.mean_edge_length =
      std::ldexp(mesh.mean_edge_length(), mesh.scale_exponent());
  Survey survey(mesh, summary);
  absl::Status status = survey.Run(checkpoint);
  if (!status.ok()) return status;
  status = TellOfReading(mesh, survey.boundary(), checkpoint, summary);
  if (!status.ok()) return status;
  Pace pace(&checkpoint);
  summary.is_orientable = IsOrientable(mesh, pace);
  Fans fans(mesh, pace);
  summary.boundary_loops =
      CountBoundaryLoops(mesh, survey.boundary(), fans, pace);
  if (!pace.status().ok()) return pace.status();
  if (status = checkpoint.Poll({}); !status.ok()) return status;
  if (summary.is_orientable && summary.non_manifold_edges == 0) {
    // Euler's formula for the surface with touching fans pulled apart.
    summary.genus =
        (2 * static_cast<int64_t>(survey.pieces_through_edges()) -
         static_cast<int64_t>(summary.boundary_loops + fans.count() +
                              mesh.half_edge_count() / 3) +
         static_cast<int64_t>(summary.edges)) /
        2;
  }

  const auto [low, high] = BoxAround(mesh.positions());
  summary.bounding_box_min = low;
  summary.bounding_box_max = high;
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    summary.isolated_vertices += mesh.Outgoing(v).empty();
    summary.saddle_vertices += mesh.IsSaddle(v);
    summary.non_manifold_vertices += mesh.IsNonManifold(v);
  }
  summary.isolated_vertices -= summary.joined_vertices;
  return summary;
}

std::vector<std::string> Notes(const MeshSummary& summary) {
  // "1 seam edge", "646 seam edges".
  const auto counted = [](uint64_t count, absl::string_view thing) {
    return absl::StrCat(count, " ", thing, count == 1 ? "" : "s");
  };
  std::vector<std::string> notes;
  if (summary.seam_edges > 0) {
    notes.push_back("joined " + counted(summary.seam_edges, "seam edge"));
  }
  if (summary.left_out_faces > 0) {
    notes.push_back(absl::StrCat("left out ",
                                 counted(summary.left_out_faces, "triangle"),
                                 ", where a vertex is named twice"));
  }
  if (summary.crossing_polygons > 0) {
    notes.push_back(absl::StrCat(
        "cut ", counted(summary.crossing_polygons, "polygon"),
        summary.crossing_polygons == 1 ? " that crosses itself"
                                       : " that cross themselves",
        " into triangles that lie over each other; the first is face ",
        summary.first_crossing_polygon, " of the file"));
  }
  if (summary.close_edges > 0) {
    notes.push_back(absl::StrCat(
        counted(summary.close_edges, "boundary edge"),
        summary.close_edges == 1 ? " lies within " : " lie within ",
        RoundedUp(summary.close_edge_distance),
        " of others and are not joined; --weld ",
        RoundedUp(summary.close_edge_distance), " (weld) joins them"));
  }
  if (summary.touching_edges > 0) {
    notes.push_back(absl::StrCat(
        counted(summary.touching_edges, "boundary edge"),
        summary.touching_edges == 1 ? " lies" : " lie",
        " along other edges and cannot be joined: corners lie inside edges, "
        "or a sheet begins inside another one"));
  }
  return notes;
}

}  // namespace geodesic
