#include "solver/curve_segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/surface_location.h"

namespace geodesic {
namespace {

// A direction in the plane and a length in it.
struct Run {
  double x, y, length;
};

Run RunFrom(const PlanePoint& a, const PlanePoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  return {dx / length, dy / length, length};
}

}  // namespace

CurveSegment::CurveSegment(const Mesh& mesh, const FacePoint& begin,
                           const FacePoint& end)
    : mesh_(mesh), begin_(begin), end_(end) {}

double CurveSegment::DistanceTo(const PlanePoint& place) const {
  const HalfEdge first = mesh_.FirstSide(face());
  const PlanePoint a = InFrame(mesh_, begin_, first);
  const Run run = RunFrom(a, InFrame(mesh_, end_, first));
  const double dx = place.x - a.x, dy = place.y - a.y;
  const double along = dx * run.x + dy * run.y;
  return along >= 0 && along <= run.length
             ? std::abs(dx * run.y - dy * run.x)
             : std::numeric_limits<double>::infinity();
}

std::optional<CurveSegment::Beam> CurveSegment::BeamAcross(HalfEdge h) const {
  if (SharedSide(mesh_, begin_, end_) == h) return std::nullopt;
  const PlanePoint a = InFrame(mesh_, begin_, h), b = InFrame(mesh_, end_, h);
  const Run run = RunFrom(a, b);
  // The normal that points out across h: downward in its frame.
  const double sign = run.x > 0 ? 1 : -1;
  const double normal_x = sign * run.y, normal_y = -sign * run.x;
  if (!(normal_y < 0)) return std::nullopt;  // rays run beside the side
  const double length = mesh_.frame(h).length;
  const auto landing = [&](const PlanePoint& from) {
    return std::clamp(from.x - from.y * normal_x / normal_y, 0.0, length);
  };
  const auto [low, high] = std::minmax({landing(a), landing(b)});
  if (!(low < high)) return std::nullopt;
  // At (x, 0) the distance is (x - a.x) * normal_x - a.y * normal_y.
  return Beam{.origin = {.x = -normal_x,
                         .depth = -normal_y,
                         .sigma = (length - a.x) * normal_x - a.y * normal_y,
                         .is_segment = true},
              .interval = Mirror(Interval{low, high}, length)};
}

std::vector<CurveSegment> SegmentsOf(const Mesh& mesh, const Anchor& anchor) {
  std::vector<CurveSegment> segments;
  VisitSharedFaces(mesh, anchor.begin, anchor.end,
                   [&](const FacePoint& begin, const FacePoint& end) {
                     segments.emplace_back(mesh, begin, end);
                     return false;
                   });
  return segments;
}

}  // namespace geodesic
