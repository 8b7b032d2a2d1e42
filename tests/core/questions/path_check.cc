#include "tests/core/questions/path_check.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic_types/algorithms.h"
#include "tests/support/field_check.h"
#include "tests/support/surface_points.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

// A bend below this is none, where rounding lets it be seen.
constexpr Real kStraight = 1e-6;

Vec3 PositionAt(const Mesh& mesh, const SurfacePoint& point) {
  const auto at = [&](uint32_t v) { return ToVec3(mesh.positions()[v]); };
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    return at(vertex->vertex);
  }
  if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    return at(edge->from) + Real{edge->t} * (at(edge->to) - at(edge->from));
  }
  const auto& [face, weights] = std::get<FacePoint>(point);
  const auto& [a, b, c] = mesh.triangle(face);
  return at(a) + Real{weights[1]} * (at(b) - at(a)) +
         Real{weights[2]} * (at(c) - at(a));
}

// How far the directions to the points before and after an edge point are from
// being opposite in the plane that both faces are laid into.
Real BendAtEdge(const Mesh& mesh, const EdgePoint& edge, const Vec3& before,
                const Vec3& at, const Vec3& after) {
  const auto along = [&](uint32_t v) { return ToVec3(mesh.positions()[v]); };
  const Vec3 direction = along(edge.to) - along(edge.from);
  const Vec3 in = before - at, out = after - at;
  // Angles, not cosines, which cannot tell small ones.
  const auto angle = [&](const Vec3& v) {
    return std::atan2(Norm(Cross(direction, v)), Dot(direction, v));
  };
  return std::abs(angle(in) + angle(out) - std::numbers::pi_v<Real>);
}

// Angles around a vertex, counterclockwise.
class FanAngles {
 public:
  FanAngles(const Mesh& mesh, uint32_t v) : mesh_(mesh), vertex_(v) {
    const std::span<const HalfEdge> outgoing = mesh.Outgoing(v);
    auto start = std::ranges::find_if(
        outgoing, [&](HalfEdge h) { return mesh.Twin(h) == kNoHalfEdge; });
    is_open_ = start != outgoing.end();
    HalfEdge h = is_open_ ? *start : outgoing[0];
    const HalfEdge first = h;
    do {
      begin_.push_back({mesh.FaceOf(h), h, total_});
      total_ += Angle(Towards(mesh.To(h)), Towards(mesh.Apex(h)));
      h = mesh.Twin(Prev(h));
    } while (h != kNoHalfEdge && h != first);
  }

  // The angle between the directions to two points of faces at the vertex, on
  // the side where it is nearest to pi.
  Real SideNearestToPi(const SurfacePoint& a, const SurfacePoint& b) const {
    const Real one = std::abs(At(a) - At(b)), other = total_ - one;
    constexpr Real kPi = std::numbers::pi_v<Real>;
    return is_open_ || std::abs(one - kPi) < std::abs(other - kPi) ? one
                                                                   : other;
  }

 private:
  struct Sector {
    uint32_t face;
    HalfEdge half_edge;
    Real begin;
  };

  static Real Angle(const Vec3& a, const Vec3& b) {
    return std::atan2(Norm(Cross(a, b)), Dot(a, b));
  }
  Vec3 Towards(uint32_t v) const {
    return ToVec3(mesh_.positions()[v]) - ToVec3(mesh_.positions()[vertex_]);
  }
  Real At(const SurfacePoint& point) const {
    const std::set<uint32_t> faces = FacesAt(mesh_, point);
    for (const Sector& sector : begin_) {
      if (!faces.contains(sector.face)) continue;
      return sector.begin + Angle(Towards(mesh_.To(sector.half_edge)),
                                  PositionAt(mesh_, point) -
                                      ToVec3(mesh_.positions()[vertex_]));
    }
    ADD_FAILURE() << Name(point) << " does not lie around vertex " << vertex_;
    return 0;
  }

  const Mesh& mesh_;
  const uint32_t vertex_;
  bool is_open_ = false;
  Real total_ = 0;
  std::vector<Sector> begin_;
};

Real BendAtVertex(const Mesh& mesh, uint32_t v, const SurfacePoint& before,
                  const SurfacePoint& after) {
  // Fans are walked on oriented surfaces only.
  if (mesh.IsPseudoSource(v) || mesh.HasIrregularEdges()) return 0;
  return std::abs(FanAngles(mesh, v).SideNearestToPi(before, after) -
                  std::numbers::pi_v<Real>);
}

testing::AssertionResult NoBends(const Mesh& mesh, const GeodesicPath& path) {
  // How far from its place a point of the path may be. It lies by so much over
  // the length of its shorter piece in another direction.
  const Real misplaced = 128 * CoordinateRounding(path.positions) +
                         1e-13L * static_cast<Real>(path.length);
  for (size_t i = 1; i + 1 < path.points.size(); ++i) {
    const Vec3 before = PositionAt(mesh, path.points[i - 1]),
               at = PositionAt(mesh, path.points[i]),
               after = PositionAt(mesh, path.points[i + 1]);
    const Real shorter = std::min(Norm(before - at), Norm(after - at));
    const Real allowed = kStraight + misplaced / shorter;
    const auto* edge = std::get_if<EdgePoint>(&path.points[i]);
    const Real bend =
        edge != nullptr
            ? BendAtEdge(mesh, *edge, before, at, after)
            : BendAtVertex(mesh, std::get<VertexPoint>(path.points[i]).vertex,
                           path.points[i - 1], path.points[i + 1]);
    if (bend <= allowed) continue;
    return testing::AssertionFailure()
           << "the path bends by " << static_cast<double>(bend)
           << " (allowed: " << static_cast<double>(allowed) << ") at point "
           << i << " of " << path.points.size() << ", " << Name(path.points[i]);
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult EndsAre(const Mesh& mesh, const GeodesicPath& path,
                                 const SurfacePoint& from,
                                 const SurfacePoint& to) {
  if (path.points.empty()) {
    return testing::AssertionFailure() << "the path has no points";
  }
  if (path.points.front() != from || path.points.back() != to) {
    return testing::AssertionFailure()
           << "the path runs from " << Name(path.points.front()) << " to "
           << Name(path.points.back()) << ", not from " << Name(from) << " to "
           << Name(to);
  }
  if (path.positions.size() != path.points.size()) {
    return testing::AssertionFailure()
           << path.positions.size() << " positions for " << path.points.size()
           << " points";
  }
  for (size_t i = 0; i < path.points.size(); ++i) {
    const Real apart =
        Norm(PositionAt(mesh, path.points[i]) - ToVec3(path.positions[i]));
    if (apart <= 16 * CoordinateRounding(path.positions)) continue;
    return testing::AssertionFailure()
           << "position " << i << " is not that of " << Name(path.points[i]);
  }
  return testing::AssertionSuccess();
}

}  // namespace

std::set<uint32_t> FacesAt(const Mesh& mesh, const SurfacePoint& point) {
  const auto around = [&](uint32_t v) {
    std::set<uint32_t> faces;
    for (const HalfEdge h : mesh.Outgoing(v)) faces.insert(mesh.FaceOf(h));
    return faces;
  };
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    return around(vertex->vertex);
  }
  if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    std::set<uint32_t> both;
    std::ranges::set_intersection(around(edge->from), around(edge->to),
                                  std::inserter(both, both.end()));
    return both;
  }
  return {std::get<FacePoint>(point).face};
}

bool ShareAFace(const Mesh& mesh, const SurfacePoint& a,
                const SurfacePoint& b) {
  std::vector<uint32_t> both;
  std::ranges::set_intersection(FacesAt(mesh, a), FacesAt(mesh, b),
                                std::back_inserter(both));
  return !both.empty();
}

DistanceField SolveTraced(const Mesh& mesh, const Query& query) {
  Query traced = query;
  traced.trace = true;
  return SolveOrFail(mesh, traced);
}

PathTracer TracerOf(const Mesh& mesh, const Query& query,
                    const DistanceField& field) {
  return PathTracer::Create(mesh, Valid(mesh, query), field).value();
}

testing::AssertionResult IsShortestPath(const Mesh& mesh,
                                        const GeodesicPath& path,
                                        const SurfacePoint& from,
                                        const SurfacePoint& to, double length,
                                        const PathCheckOptions& options) {
  if (auto ends = EndsAre(mesh, path, from, to); !ends) return ends;
  Real sum = 0;
  for (size_t i = 1; i < path.points.size(); ++i) {
    if (!ShareAFace(mesh, path.points[i - 1], path.points[i])) {
      return testing::AssertionFailure()
             << Name(path.points[i - 1]) << " and " << Name(path.points[i])
             << " lie in no common face";
    }
    sum += Norm(PositionAt(mesh, path.points[i]) -
                PositionAt(mesh, path.points[i - 1]));
  }
  for (const Real got : {sum, Real{path.length}}) {
    if (std::abs(got - length) <= kRelativeTolerance * length + options.slack) {
      continue;
    }
    return testing::AssertionFailure()
           << "the path is " << static_cast<double>(sum) << " long and says "
           << path.length << ", which is " << static_cast<double>(got - length)
           << " more than " << length;
  }
  if (!options.check_bends) return testing::AssertionSuccess();
  return NoBends(mesh, path);
}

void CheckAllPaths(const std::string& name, const Mesh& mesh, Query query,
                   const PathCheckOptions& options, uint32_t stride) {
  query.trace = true;
  const DistanceField field = SolveTraced(mesh, query);
  const PathTracer tracer = TracerOf(mesh, query, field);
  int failures = 0;
  const auto check = [&](const absl::StatusOr<GeodesicPath>& path,
                         const SurfacePoint& target, double distance) {
    constexpr int kMostReported = 5;
    testing::AssertionResult result = testing::AssertionSuccess();
    if (!path.ok()) {
      result = testing::AssertionFailure() << path.status();
    } else if (path->distance != distance) {
      result = testing::AssertionFailure()
               << "the path tells a distance of " << path->distance;
    } else if (std::isinf(distance)) {
      if (!path->points.empty() || path->length != distance) {
        result = testing::AssertionFailure()
                 << "a path to where none leads, " << path->length << " long";
      }
    } else if (path->source >= query.sources.size()) {
      result = testing::AssertionFailure() << "no source " << path->source;
    } else if (path->points.empty()) {
      result = testing::AssertionFailure() << "the path has no points";
    } else {
      const Source& source = query.sources[path->source];
      // On a curve it may start anywhere.
      const SurfacePoint from = IsCurve(source)
                                    ? path->points[0]
                                    : Canonicalize(PointOf(source), mesh);
      result = IsShortestPath(mesh, *path, from, Canonicalize(target, mesh),
                              distance - source.offset, options);
    }
    if (!result && ++failures <= kMostReported) {
      ADD_FAILURE() << name << ", " << AlgorithmName(query.algorithm) << ", to "
                    << Name(target) << " at " << distance << ": "
                    << result.message();
    }
  };
  for (uint32_t v = 0; v < mesh.vertex_count(); v += stride) {
    check(tracer.ToVertex(v), VertexPoint{v}, field.distances[v]);
  }
  for (uint32_t t = 0; t < query.targets.size(); ++t) {
    check(tracer.ToTarget(t), query.targets[t], field.target_distances[t]);
  }
  EXPECT_EQ(failures, 0) << name << ": paths that are wrong";
}

}  // namespace geodesic::test
