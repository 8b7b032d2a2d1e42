#include "paths/straight_piece.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "scaled_difference.h"
#include "tolerances.h"
#include "windows/window.h"

namespace geodesic {
namespace {

PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) {
  return {a.x - b.x, a.y - b.y};
}
double Dot(const PlanePoint& a, const PlanePoint& b) {
  return a.x * b.x + a.y * b.y;
}
double Cross(const PlanePoint& a, const PlanePoint& b) {
  return a.x * b.y - a.y * b.x;
}
double Norm(const PlanePoint& a) { return std::sqrt(Dot(a, a)); }
using geodesic::Norm;

// The line back from a piece's end, in the frame of some half-edge: where the
// end lies, and the way from there towards the pseudo-source.
struct BackLine {
  PlanePoint end;
  PlanePoint way;
};

// The frame of the same edge seen from beyond.
BackLine TurnAround(const BackLine& line, double length) {
  return {{length - line.end.x, -line.end.y}, {-line.way.x, -line.way.y}};
}

// From the frame of a half-edge into that of its face's side C -> A.
BackLine IntoLeft(const BackLine& line, const HalfEdgeFrame& frame,
                  double left_length) {
  const auto turn = [&](const PlanePoint& v) {
    return PlanePoint{-(v.x * frame.left_x + v.y * frame.left_y),
                      v.x * frame.left_y - v.y * frame.left_x};
  };
  BackLine turned{turn(line.end), turn(line.way)};
  turned.end.x += left_length;
  return turned;
}

// From the frame of a half-edge into that of its face's side B -> C.
BackLine IntoRight(const BackLine& line, const HalfEdgeFrame& frame) {
  const auto turn = [&](const PlanePoint& v) {
    return PlanePoint{v.x * frame.right_x + v.y * frame.right_y,
                      v.y * frame.right_x - v.x * frame.right_y};
  };
  return {turn(line.end - PlanePoint{frame.length, 0}), turn(line.way)};
}

class BackWalk {
 public:
  BackWalk(const TracedField& field, const PathEnd& end)
      : field_(field), mesh_(field.mesh()), end_(end), last_(end.point) {}

  absl::StatusOr<StraightPiece> Walk() {
    const uint32_t pseudo_source = end_.arrival.pseudo_source;
    if (pseudo_source == kNoPseudoSource) {
      return absl::InternalError("the trace leads to where no path arrives");
    }
    const bool arrives = end_.arrival.entry == kNoHalfEdge
                             ? GoWithinFace(pseudo_source)
                             : GoThroughFaces(pseudo_source);
    if (!arrives) {
      return absl::InternalError(absl::StrCat(
          "the trace does not lead back to pseudo-source ", pseudo_source,
          " through half-edge ", end_.arrival.entry, ", where a path arrives"));
    }
    return std::move(piece_);
  }

 private:
  SurfacePoint PointOf(uint32_t pseudo_source) const {
    if (field_.IsVertex(pseudo_source)) return VertexPoint{pseudo_source};
    return field_.AnchorOf(pseudo_source).begin;
  }

  // Adds the way within `face` from the last point to the next.
  void GoTo(const SurfacePoint& next, uint32_t face) {
    if (next == last_) return;
    const HalfEdge first = 3 * face;
    piece_.length +=
        Norm(InFrame(mesh_, *WithinFace(mesh_, next, face), first) -
             InFrame(mesh_, *WithinFace(mesh_, last_, face), first));
    last_ = next;
    piece_.points.push_back(next);
  }

  // Ends the piece at its start, `way` back from the end in the frame of h.
  void StartAt(uint32_t start, HalfEdge h, const PlanePoint& way) {
    piece_.start = start;
    piece_.frame = h;
    piece_.direction = {-way.x, -way.y};
  }

  // The piece from a pseudo-source in a face around the end.
  bool GoWithinFace(uint32_t pseudo_source);
  // The piece that enters its last face through an edge.
  bool GoThroughFaces(uint32_t pseudo_source);
  // Ends the piece at `vertex`, which lies at `at`, if the path passes there.
  bool PassesThrough(uint32_t vertex, const PlanePoint& at,
                     const BackLine& line, HalfEdge h);

  const TracedField& field_;
  const Mesh& mesh_;
  const PathEnd& end_;
  SurfacePoint last_;
  double nearness_ = 0;  // to a vertex at which the path passes it
  StraightPiece piece_;
};

bool BackWalk::GoWithinFace(uint32_t pseudo_source) {
  const SurfacePoint start = PointOf(pseudo_source);
  piece_.start = pseudo_source;
  if (start == last_) return true;
  const auto* from = std::get_if<VertexPoint>(&start);
  const auto* to = std::get_if<VertexPoint>(&last_);
  if (from != nullptr && to != nullptr) {
    // Along an edge; its face would take a search around a vertex.
    const ScaledDifference difference(mesh_.scale_exponent());
    piece_.length = Norm(difference(mesh_.positions()[from->vertex],
                                    mesh_.positions()[to->vertex]));
    piece_.points.push_back(start);
    return true;
  }
  // Around a point that is not a vertex there are few faces.
  const bool from_vertex = from != nullptr;
  for (const FacePoint& near :
       FacesAround(mesh_, from_vertex ? last_ : start)) {
    const std::optional<FacePoint> far =
        WithinFace(mesh_, from_vertex ? start : last_, near.face);
    if (!far.has_value()) continue;
    const HalfEdge h = 3 * near.face;
    const PlanePoint way = InFrame(mesh_, *far, h) - InFrame(mesh_, near, h);
    StartAt(pseudo_source, h, from_vertex ? way : PlanePoint{-way.x, -way.y});
    GoTo(start, near.face);
    return true;
  }
  return false;
}

bool BackWalk::GoThroughFaces(uint32_t pseudo_source) {
  const auto& [entry_source, entry, x, depth] = end_.arrival;
  const std::optional<FacePoint> end = WithinFace(mesh_, end_.point, entry / 3);
  if (!end.has_value()) return false;
  const SurfacePoint start = PointOf(pseudo_source);
  BackLine line{.end = InFrame(mesh_, *end, entry)};
  line.way = PlanePoint{x, -depth} - line.end;
  nearness_ = kPassedVertex * (mesh_.frame(entry).length + std::abs(x) + depth);
  if (PassesThrough(mesh_.From(entry), {0, 0}, line, entry) ||
      PassesThrough(mesh_.To(entry), {mesh_.frame(entry).length, 0}, line,
                    entry)) {
    return true;
  }
  HalfEdge h = entry;
  // A shortest path enters a face once at most.
  for (uint32_t faces = 0; faces < mesh_.face_count(); ++faces) {
    const double length = mesh_.frame(h).length;
    const double crossing =
        line.way.y < 0 ? line.end.x - line.way.x * line.end.y / line.way.y
                       : line.end.x;
    GoTo(Canonicalize(EdgePoint{mesh_.From(h), mesh_.To(h),
                                std::clamp(crossing / length, 0.0, 1.0)},
                      mesh_),
         h / 3);
    const HalfEdge beyond = mesh_.Twin(h);
    if (beyond == kNoHalfEdge) return false;
    const HalfEdgeFrame& frame = mesh_.frame(beyond);
    line = TurnAround(line, length);
    if (WithinFace(mesh_, start, beyond / 3).has_value()) {
      StartAt(pseudo_source, beyond, line.way);
      GoTo(start, beyond / 3);
      return true;
    }
    const PlanePoint apex{frame.apex_x, frame.apex_y};
    if (PassesThrough(mesh_.Apex(beyond), apex, line, beyond)) return true;
    // No window has crossed a side without length.
    const double left_length = mesh_.frame(Prev(beyond)).length;
    const bool goes_right =
        mesh_.frame(Next(beyond)).length > 0 &&
        (left_length == 0 || Cross(line.way, apex - line.end) > 0);
    line = goes_right ? IntoRight(line, frame)
                      : IntoLeft(line, frame, left_length);
    h = goes_right ? Next(beyond) : Prev(beyond);
  }
  return false;
}

bool BackWalk::PassesThrough(uint32_t vertex, const PlanePoint& at,
                             const BackLine& line, HalfEdge h) {
  const double distance = field_.VertexDistance(vertex);
  // Nearer than the end, or the way back would lead in circles.
  if (!(distance < end_.distance)) return false;
  const PlanePoint way = at - line.end;
  if (Dot(way, line.way) <= 0 ||
      std::abs(Cross(line.way, way)) > nearness_ * Norm(line.way) ||
      Exceeds(distance + Norm(way), end_.distance + field_.rounding())) {
    return false;
  }
  StartAt(vertex, h, way);
  GoTo(VertexPoint{vertex}, h / 3);
  return true;
}

}  // namespace

absl::StatusOr<StraightPiece> FollowBack(const TracedField& field,
                                         const PathEnd& end) {
  return BackWalk(field, end).Walk();
}

}  // namespace geodesic
