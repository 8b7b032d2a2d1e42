// One walk back, face after face.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include "mesh/scaled_difference.h"
#include "questions/tracing/straight_piece.h"
#include "solver/windows/window.h"
#include "solver/work_meter.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// The line back from a piece's end, in the frame of some half-edge: where the
// end lies, and the way from there to the pseudo-source (towards it, where that
// is a segment).
struct BackLine {
  PlanePoint end;
  PlanePoint way;
};

// Where the line, followed back along `way` to the piece's start, crosses AB;
// below its end if it runs along it. Not beyond the start: where that lies on
// AB, and all but in the line, rounding would have the line cross anywhere.
double CrossingOf(const PlanePoint& end, const PlanePoint& way) {
  return way.y < 0 ? end.x + way.x * std::min(end.y / -way.y, 1.0) : end.x;
}

// On the other side of AB.
PlanePoint Opposite(const PlanePoint& at) { return {at.x, -at.y}; }

// A face beyond an edge, by its half-edge there. A mirrored one runs along the
// edge in the same direction, so that its frame is turned over.
struct FaceBeyond {
  HalfEdge half_edge;
  bool is_mirrored;
};

// From the frame of a half-edge into that of a face beyond.
BackLine Enter(const FaceBeyond& face, const BackLine& line, double length) {
  if (face.is_mirrored) {
    return {Opposite(line.end), Opposite(line.way)};
  }
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

// What turns and stretches `from` into `to`, as a complex number. Squares of
// lengths may vanish (kLeastHeight).
PlanePoint Quotient(const PlanePoint& to, const PlanePoint& from) {
  const double norm = std::hypot(from.x, from.y);
  if (norm == 0) return {1, 0};
  const PlanePoint unit{from.x / norm, from.y / norm};
  return {Dot(unit, to) / norm, Cross(unit, to) / norm};
}

class Walker {
 public:
  Walker(const TracedField& field, const PathEnd& end, std::vector<Fork>& forks,
         WorkMeter& meter, double nearness)
      : field_(field),
        mesh_(field.mesh()),
        end_(end),
        forks_(forks),
        meter_(meter),
        relative_nearness_(nearness),
        last_(end.point) {}

  std::optional<StraightPiece> Walk() {
    const uint32_t pseudo_source = end_.arrival.pseudo_source;
    const bool arrives = end_.arrival.entry == kNoHalfEdge
                             ? GoWithinFace(pseudo_source)
                             : GoThroughFaces(pseudo_source);
    if (!arrives) return std::nullopt;
    return std::move(piece_);
  }

 private:
  uint32_t Choose(uint32_t ways) {
    if (passed_forks_ == forks_.size()) forks_.push_back({ways, 0});
    return forks_[passed_forks_++].taken;
  }

  // The face beyond h to go on in along `line`; nothing at a boundary, nor at
  // an edge of several that was crossed before: no shortest path crosses an
  // edge twice. O(faces at the edge).
  std::optional<FaceBeyond> Beyond(HalfEdge h, const BackLine& line) {
    if (const HalfEdge twin = mesh_.Twin(h); twin != kNoHalfEdge) {
      return FaceBeyond{twin, false};
    }
    const std::span<const HalfEdge> all = mesh_.HalfEdgesAt(h);
    if (all.empty() || !crossed_irregular_.insert(all[0]).second) {
      return std::nullopt;
    }
    // Into a face that is given twice it is the same way, but to a place within
    // it; nor does a path go from one of the two into the other, but to a place
    // on the edge between them.
    const bool is_behind_end = crossed_.size() > 1;
    std::unordered_set<uint32_t> apexes;
    if (is_behind_end) apexes.insert(mesh_.Apex(h));
    // First those in which the walk may end: those behind may be very many, all
    // as good.
    std::vector<FaceBeyond> faces, others;
    mesh_.ForEachBeyond(h, [&](HalfEdge other, bool is_mirrored) {
      if (!meter_.Do()) return;
      const FaceBeyond face{other, is_mirrored};
      const bool is_known = !apexes.insert(mesh_.Apex(other)).second;
      if (is_known && !MayStartWithin(mesh_.FaceOf(other))) return;
      const BackLine there = Enter(face, line, mesh_.frame(h).length);
      if (MayEndIn(other, there)) {
        faces.push_back(face);
      } else if (LeadsOn(other, there)) {
        others.push_back(face);
      }
    });
    faces.insert(faces.end(), others.begin(), others.end());
    // Where it was told to stop not all are there, of which one was chosen.
    if (faces.empty() || !meter_.status().ok()) return std::nullopt;
    if (faces.size() == 1) return faces[0];
    return faces[Choose(static_cast<uint32_t>(faces.size()))];
  }

  // Whether a walk that enters the face of h along a line may end there.
  bool MayEndIn(HalfEdge h, const BackLine& line) const {
    return StartWithin(end_.arrival.pseudo_source, h, line.end).has_value() ||
           PassesAt(mesh_.Apex(h), ApexOf(mesh_.frame(h)), line);
  }

  // Whether one that does not comes out on another side and is not astray: few
  // do of very many at an edge.
  bool LeadsOn(HalfEdge h, const BackLine& line) const {
    if (!mesh_.HasNonManifoldEdges()) return true;
    const PlanePoint apex = ApexOf(mesh_.frame(h));
    if (IsAstray(h, line)) return false;
    if (RunsInto(apex, line)) return true;
    const bool goes_right = GoesRight(h, line);
    const HalfEdge exit = goes_right ? Next(h) : Prev(h);
    if (mesh_.IsBoundaryEdge(exit)) return false;
    const BackLine there = Through(h, goes_right, line);
    const PlanePoint crossing{CrossingOf(there.end, there.way), 0};
    return !IsFarther(mesh_.From(exit), {0, 0}, there, crossing) &&
           !IsFarther(mesh_.To(exit), {mesh_.frame(exit).length, 0}, there,
                      crossing);
  }

  // Whether a line that enters the face of h leaves it on the right. No window
  // has crossed a side without length.
  bool GoesRight(HalfEdge h, const BackLine& line) const {
    if (!(mesh_.frame(Next(h)).length > 0)) return false;
    return !(mesh_.frame(Prev(h)).length > 0) ||
           Cross(line.way, ApexOf(mesh_.frame(h)) - line.end) > 0;
  }

  // From the frame of h into that of the side on which it leaves the face.
  BackLine Through(HalfEdge h, bool goes_right, const BackLine& line) const {
    const HalfEdgeFrame& frame = mesh_.frame(h);
    return goes_right ? IntoRight(line, frame)
                      : IntoLeft(line, frame, mesh_.frame(Prev(h)).length);
  }

  // Whether the pseudo-source may lie in a face, elsewhere than at its corners.
  bool MayStartWithin(uint32_t face) const {
    const uint32_t pseudo_source = end_.arrival.pseudo_source;
    if (field_.IsVertex(pseudo_source)) return false;
    const Anchor& anchor = field_.AnchorOf(pseudo_source);
    return WithinFace(mesh_, anchor.begin, face).has_value() &&
           WithinFace(mesh_, anchor.end, face).has_value();
  }

  // Where the path to a place in the frame of h starts, if its pseudo-source
  // lies in the face of h.
  std::optional<SurfacePoint> StartWithin(uint32_t pseudo_source, HalfEdge h,
                                          const PlanePoint& place) const {
    if (field_.IsVertex(pseudo_source)) {
      const VertexPoint start{pseudo_source};
      if (!WithinFace(mesh_, start, mesh_.FaceOf(h)).has_value())
        return std::nullopt;
      return start;
    }
    const Anchor& anchor = field_.AnchorOf(pseudo_source);
    const std::optional<FacePoint> foot = FootOf(mesh_, anchor, h, place);
    if (!foot.has_value()) return std::nullopt;
    if (!anchor.is_segment) return anchor.begin;
    return Canonicalize(*foot, mesh_);
  }

  // An edge that the line crosses, seen from the face that it leaves.
  struct CrossedEdge {
    HalfEdge half_edge;
    BackLine line;
    bool is_mirrored;
  };

  // Adds the way over the edges crossed so far, as a line crosses them whose
  // way is `turn` times theirs, as complex numbers in the present frame.
  void GoOverEdges(const PlanePoint& turn) {
    for (const auto& [h, line, is_mirrored] : crossed_) {
      const PlanePoint here =
          is_mirrored == is_mirrored_ ? turn : PlanePoint{turn.x, -turn.y};
      const double crossing = CrossingOf(line.end, Product(line.way, here));
      const double length = mesh_.frame(h).length;
      GoTo(Canonicalize(
               EdgePoint{
                   mesh_.From(h), mesh_.To(h),
                   length > 0 ? std::clamp(crossing / length, 0.0, 1.0) : 0},
               mesh_),
           mesh_.FaceOf(h));
    }
  }

  // Adds the way within `face` from the last point to the next.
  void GoTo(const SurfacePoint& next, uint32_t face) {
    if (next == last_) return;
    const HalfEdge first = mesh_.FirstSide(face);
    piece_.length +=
        Norm(InFrame(mesh_, *WithinFace(mesh_, next, face), first) -
             InFrame(mesh_, *WithinFace(mesh_, last_, face), first));
    last_ = next;
    piece_.points.push_back(NamedIn(face, next, mesh_));
  }

  // Ends the piece at its start, `way` back from the end in the frame of h.
  void StartAt(uint32_t start, HalfEdge h, const PlanePoint& way) {
    piece_.start = start;
    piece_.frame = h;
    piece_.direction = {-way.x, -way.y};
  }

  // The piece from a pseudo-source in a face around the end.
  bool GoWithinFace(uint32_t pseudo_source) {
    piece_.start = pseudo_source;
    const auto* to = std::get_if<VertexPoint>(&last_);
    const bool from_vertex = field_.IsVertex(pseudo_source);
    if (from_vertex && to != nullptr) {
      // Along an edge; its face would take a search around a vertex.
      const ScaledDifference difference(mesh_.scale_exponent());
      piece_.length = Norm(difference(mesh_.positions()[pseudo_source],
                                      mesh_.positions()[to->vertex]));
      piece_.points.push_back(VertexPoint{pseudo_source});
      return true;
    }
    const SurfacePoint anchored = from_vertex
                                      ? SurfacePoint(VertexPoint{pseudo_source})
                                      : field_.AnchorOf(pseudo_source).begin;
    if (anchored == last_ && !from_vertex &&
        !field_.AnchorOf(pseudo_source).is_segment) {
      return true;
    }
    const SurfacePoint end = last_;
    bool arrives = false;
    VisitSharedFaces(
        mesh_, anchored, end, [&](const FacePoint&, const FacePoint& at) {
          const HalfEdge h = mesh_.FirstSide(at.face);
          const PlanePoint place = InFrame(mesh_, at, h);
          const std::optional<SurfacePoint> start =
              StartWithin(pseudo_source, h, place);
          if (!start.has_value()) return !meter_.Do();
          arrives = true;
          if (*start == end) return true;
          StartAt(
              pseudo_source, h,
              InFrame(mesh_, *WithinFace(mesh_, *start, at.face), h) - place);
          GoTo(*start, at.face);
          return true;
        });
    return arrives;
  }

  // The piece that enters its last face through an edge.
  bool GoThroughFaces(uint32_t pseudo_source) {
    const auto& [entry_source, entry, x, depth] = end_.arrival;
    const std::optional<FacePoint> end =
        WithinFace(mesh_, end_.point, mesh_.FaceOf(entry));
    if (!end.has_value()) return false;
    BackLine line{.end = InFrame(mesh_, *end, entry)};
    const bool is_segment = !field_.IsVertex(pseudo_source) &&
                            field_.AnchorOf(pseudo_source).is_segment;
    line.way =
        is_segment ? PlanePoint{-x, -depth} : PlanePoint{x, -depth} - line.end;
    nearness_ = relative_nearness_ *
                (mesh_.frame(entry).length +
                 (is_segment ? end_.distance : std::abs(x) + depth));
    if (PassesThrough(mesh_.From(entry), {0, 0}, line, entry) ||
        PassesThrough(mesh_.To(entry), {mesh_.frame(entry).length, 0}, line,
                      entry)) {
      return true;
    }
    HalfEdge h = entry;
    // A shortest path enters a face once at most.
    for (uint32_t faces = 0; faces < mesh_.face_count() && meter_.Do();
         ++faces) {
      crossed_.push_back({h, line, is_mirrored_});
      const std::optional<FaceBeyond> face = Beyond(h, line);
      if (!face.has_value()) return false;
      const HalfEdge beyond = face->half_edge;
      line = Enter(*face, line, mesh_.frame(h).length);
      is_mirrored_ ^= face->is_mirrored;
      if (const std::optional<SurfacePoint> start =
              StartWithin(pseudo_source, beyond, line.end)) {
        const uint32_t face_there = mesh_.FaceOf(beyond);
        const PlanePoint way =
            InFrame(mesh_, *WithinFace(mesh_, *start, face_there), beyond) -
            line.end;
        StartAt(pseudo_source, beyond, line.way);
        GoOverEdges(Quotient(way, line.way));
        GoTo(*start, face_there);
        return true;
      }
      const PlanePoint apex = ApexOf(mesh_.frame(beyond));
      if (PassesThrough(mesh_.Apex(beyond), apex, line, beyond)) return true;
      if (IsAstray(beyond, line)) return false;
      bool goes_right = GoesRight(beyond, line);
      if (mesh_.frame(Next(beyond)).length > 0 &&
          mesh_.frame(Prev(beyond)).length > 0 && RunsInto(apex, line) &&
          Choose(2) == 1) {
        goes_right = !goes_right;
      }
      line = Through(beyond, goes_right, line);
      h = goes_right ? Next(beyond) : Prev(beyond);
    }
    return false;
  }

  // Whether the line has entered a face, of several beyond an edge, that the
  // path has not come through: one of its corners is farther than a path that
  // came along the line would be there.
  bool IsAstray(HalfEdge beyond, const BackLine& line) const {
    if (!mesh_.HasNonManifoldEdges()) return false;
    const HalfEdgeFrame& frame = mesh_.frame(beyond);
    const PlanePoint crossing{
        CrossingOf(Opposite(line.end), Opposite(line.way)), 0};
    return IsFarther(mesh_.From(beyond), {0, 0}, line, crossing) ||
           IsFarther(mesh_.To(beyond), {frame.length, 0}, line, crossing) ||
           IsFarther(mesh_.Apex(beyond), ApexOf(frame), line, crossing);
  }

  // Whether a vertex is farther than a path would be there that came along the
  // line as far as `crossing`.
  bool IsFarther(uint32_t v, const PlanePoint& at, const BackLine& line,
                 const PlanePoint& crossing) const {
    const double left = end_.distance - Norm(line.end - crossing);
    const double slack = kAstray * end_.distance + kRoundedPlace;
    const double distance = field_.VertexDistance(v);
    return std::isfinite(distance) &&
           distance > left + Norm(at - crossing) + slack;
  }

  // Whether the line passes a place as near as rounding.
  bool RunsInto(const PlanePoint& at, const BackLine& line) const {
    return std::abs(Cross(line.way, at - line.end)) <=
           nearness_ * Norm(line.way);
  }
  // Whether the path passes at `vertex`, which lies at `at`.
  bool PassesAt(uint32_t vertex, const PlanePoint& at,
                const BackLine& line) const {
    const double distance = field_.VertexDistance(vertex);
    // Nearer than the end, or the way back would lead in circles.
    if (!(distance < end_.distance) || Coincide(mesh_, end_.point, vertex)) {
      return false;
    }
    const PlanePoint way = at - line.end;
    return Dot(way, line.way) > 0 && RunsInto(at, line) &&
           !Exceeds(distance + Norm(way), end_.distance + field_.rounding());
  }

  // Ends the piece at `vertex` if the path passes there.
  bool PassesThrough(uint32_t vertex, const PlanePoint& at,
                     const BackLine& line, HalfEdge h) {
    if (!PassesAt(vertex, at, line)) return false;
    const PlanePoint way = at - line.end;
    StartAt(vertex, h, way);
    GoOverEdges(Quotient(way, line.way));
    GoTo(VertexPoint{vertex}, mesh_.FaceOf(h));
    return true;
  }

  const TracedField& field_;
  const Mesh& mesh_;
  const PathEnd& end_;
  std::vector<Fork>& forks_;
  WorkMeter& meter_;
  size_t passed_forks_ = 0;
  std::unordered_set<HalfEdge> crossed_irregular_;  // the first at each edge
  const double relative_nearness_;
  SurfacePoint last_;
  double nearness_ = 0;  // to a vertex at which the path passes it
  std::vector<CrossedEdge> crossed_;
  bool is_mirrored_ = false;  // whether the present frame is turned over
  StraightPiece piece_;
};

}  // namespace

std::optional<StraightPiece> WalkBack(const TracedField& field,
                                      const PathEnd& end,
                                      std::vector<Fork>& forks,
                                      WorkMeter& meter, double nearness) {
  return Walker(field, end, forks, meter, nearness).Walk();
}

bool Coincide(const Mesh& mesh, const SurfacePoint& point, uint32_t vertex) {
  const auto* at = std::get_if<VertexPoint>(&point);
  return at != nullptr &&
         mesh.positions()[at->vertex] == mesh.positions()[vertex];
}

}  // namespace geodesic
