#include "tests/core/questions/isoline_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "tests/core/questions/path_check.h"
#include "tests/support/random.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

using Edge = std::pair<uint32_t, uint32_t>;  // the lower vertex first

// Distances of points anywhere, by solving with them as targets.
std::vector<double> DistancesOrFail(const Mesh& mesh, Query query,
                                    const std::vector<SurfacePoint>& points) {
  query.targets = points;
  query.tolerance = 0;
  return SolveOrFail(mesh, query).target_distances;
}

class IsolineCheck {
 public:
  IsolineCheck(const NamedMesh& named, const Mesh& mesh, const Query& query,
               const std::vector<double>& levels, double slack)
      : name_(named.name),
        soup_(named.soup),
        mesh_(mesh),
        query_(query),
        slack_(slack),
        isolines_(IsolinesOrFail(mesh, query, levels)) {}

  void ExpectPointsAtLevel() const {
    std::vector<SurfacePoint> points;
    for (const Isoline& isoline : isolines_) {
      points.insert(points.end(), isoline.points.begin(), isoline.points.end());
    }
    const std::vector<double> distances =
        DistancesOrFail(mesh_, query_, points);
    ASSERT_EQ(distances.size(), points.size());
    size_t i = 0;
    for (const Isoline& isoline : isolines_) {
      ASSERT_EQ(isoline.positions.size(), isoline.points.size());
      for (size_t p = 0; p < isoline.points.size(); ++p, ++i) {
        ASSERT_NEAR(distances[i], isoline.level,
                    Within(kRelativeTolerance, isoline.level))
            << name_ << " at " << Name(points[i]);
        ASSERT_EQ(isoline.positions[p], PositionOf(points[i], mesh_));
      }
    }
  }

  void ExpectChords() const {
    std::vector<SurfacePoint> middles;
    std::vector<double> levels;
    for (const Isoline& isoline : isolines_) {
      const std::vector<SurfacePoint>& points = isoline.points;
      for (size_t p = 0; p + 1 < points.size() + isoline.is_closed; ++p) {
        middles.push_back(MiddleOf(points[p], points[(p + 1) % points.size()]));
        levels.push_back(isoline.level);
      }
    }
    const std::vector<double> distances =
        DistancesOrFail(mesh_, query_, middles);
    for (size_t i = 0; i < middles.size(); ++i) {
      // The chord and, within a tolerance, the points at its ends are off.
      EXPECT_NEAR(distances[i], levels[i],
                  (1.0001e-3 + query_.tolerance) * levels[i] + slack_)
          << name_ << " at " << Name(middles[i]);
    }
  }

  void ExpectCurves() const {
    std::set<std::pair<double, SurfacePoint>> seen;
    for (const Isoline& isoline : isolines_) {
      const std::vector<SurfacePoint>& points = isoline.points;
      ASSERT_GE(points.size(), 2u) << name_;
      for (size_t p = 0; p < points.size(); ++p) {
        // Only vertices may be passed more than once, and ends only where
        // three faces meet.
        if (std::holds_alternative<EdgePoint>(points[p]) &&
            FacesAt(mesh_, points[p]).size() <= 2) {
          EXPECT_TRUE(seen.emplace(isoline.level, points[p]).second)
              << name_ << ", level " << isoline.level << ": " << Name(points[p])
              << " comes twice";
        }
        if (p + 1 == points.size() && !isoline.is_closed) break;
        const SurfacePoint& next = points[(p + 1) % points.size()];
        EXPECT_NE(points[p], next) << name_;
        EXPECT_TRUE(ShareAFace(mesh_, points[p], next))
            << name_ << ": " << Name(points[p]) << " and " << Name(next);
      }
      if (isoline.is_closed) continue;
      for (const SurfacePoint& end : {points.front(), points.back()}) {
        EXPECT_TRUE(MayEndAt(end)) << name_ << ", level " << isoline.level
                                   << ": an end at " << Name(end);
      }
    }
  }

  // The side of points on edges, by their distances and by the crossings
  // between them and the edge's ends.
  void ExpectSeparation(const std::vector<double>& levels,
                        uint32_t samples) const {
    std::map<std::pair<double, Edge>, std::vector<double>> crossings;
    for (const Isoline& isoline : isolines_) {
      for (const SurfacePoint& point : isoline.points) {
        if (const auto* at = std::get_if<EdgePoint>(&point)) {
          crossings[{isoline.level, {at->from, at->to}}].push_back(at->t);
        }
      }
    }
    std::vector<SurfacePoint> points;
    for (uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
      points.push_back(VertexPoint{v});
    }
    std::set<Edge> distinct;
    for (HalfEdge h = 0; h < mesh_.half_edge_count(); ++h) {
      distinct.insert(std::minmax({mesh_.From(h), mesh_.To(h)}));
    }
    const std::vector<Edge> edges(distinct.begin(), distinct.end());
    Random random(7);
    std::vector<EdgePoint> sampled;
    for (uint32_t i = 0; i < samples; ++i) {
      const auto& [from, to] =
          edges[random.Below(static_cast<uint32_t>(edges.size()))];
      sampled.push_back({from, to, random.Uniform(0.001, 0.999)});
    }
    points.insert(points.end(), sampled.begin(), sampled.end());
    const std::vector<double> distances =
        DistancesOrFail(mesh_, query_, points);
    ASSERT_EQ(distances.size(), points.size());

    for (const double level : levels) {
      const auto is_clear = [&](double distance) {
        return std::abs(distance - level) > Within(1e-9, level);
      };
      const auto crossings_before = [&](const Edge& edge, double t) {
        const auto found = crossings.find({level, edge});
        if (found == crossings.end()) return std::ptrdiff_t{0};
        return std::ranges::count_if(found->second,
                                     [&](double c) { return c < t; });
      };
      for (const Edge& edge : edges) {
        const double from = distances[edge.first], to = distances[edge.second];
        if (!is_clear(from) || !is_clear(to)) continue;
        EXPECT_EQ((from < level) != (to < level),
                  crossings_before(edge, 2) % 2 == 1)
            << name_ << ", level " << level << ": edge " << edge.first << " - "
            << edge.second << ", distances " << from << " and " << to;
      }
      for (size_t i = 0; i < sampled.size(); ++i) {
        const auto& [from, to, t] = sampled[i];
        const double at = distances[mesh_.vertex_count() + i];
        if (!is_clear(at) || !is_clear(distances[from])) continue;
        EXPECT_EQ((distances[from] < level) != (at < level),
                  crossings_before({from, to}, t) % 2 == 1)
            << name_ << ", level " << level << ": " << Name(sampled[i])
            << ", distance " << at << ", from " << distances[from];
      }
    }
  }

 private:
  // Of two points that share a face.
  SurfacePoint MiddleOf(const SurfacePoint& a, const SurfacePoint& b) const {
    for (const Place& at_a : PlacesOf(soup_, a)) {
      for (const Place& at_b : PlacesOf(soup_, b)) {
        if (at_a.face != at_b.face) continue;
        FacePoint middle{.face = at_a.face};
        for (int i = 0; i < 3; ++i) {
          middle.weights[i] =
              static_cast<double>((at_a.weights[i] + at_b.weights[i]) / 2);
        }
        return middle;
      }
    }
    ADD_FAILURE() << name_ << ": " << Name(a) << " and " << Name(b);
    return a;
  }

  // How far distances may be from a level, for exact isolines this part of it.
  double Within(double part, double level) const {
    return std::max(part, query_.tolerance) * level + slack_;
  }

  // At the boundary or where more than two faces meet.
  bool MayEndAt(const SurfacePoint& point) const {
    if (std::holds_alternative<EdgePoint>(point)) {
      return FacesAt(mesh_, point).size() != 2;
    }
    if (std::holds_alternative<FacePoint>(point)) return false;
    const uint32_t vertex = std::get<VertexPoint>(point).vertex;
    return mesh_.IsBoundary(vertex) || mesh_.IsNonManifold(vertex);
  }

  const std::string name_;
  const TriangleSoup& soup_;
  const Mesh& mesh_;
  const Query& query_;
  const double slack_;
  const std::vector<Isoline> isolines_;
};

}  // namespace

std::vector<Isoline> IsolinesOrFail(const Mesh& mesh, const Query& query,
                                    const std::vector<double>& levels,
                                    double chord_error) {
  NoCheckpoint checkpoint;
  return ComputeIsolines(mesh, Valid(mesh, query), {levels, chord_error}, {},
                         checkpoint)
      .value();
}

double Length(const Isoline& isoline) {
  const std::vector<Point>& p = isoline.positions;
  Real length = isoline.is_closed ? Distance(p.back(), p.front()) : 0;
  for (size_t i = 1; i < p.size(); ++i) length += Distance(p[i - 1], p[i]);
  return static_cast<double>(length);
}

double Length(const std::vector<Isoline>& isolines) {
  double length = 0;
  for (const Isoline& isoline : isolines) length += Length(isoline);
  return length;
}

void ExpectIsolines(const NamedMesh& named, const Query& query,
                    const std::vector<double>& levels, uint32_t samples,
                    double slack) {
  const auto mesh = BuildOrFail(named);
  const IsolineCheck check(named, *mesh, query, levels, slack);
  check.ExpectPointsAtLevel();
  check.ExpectChords();
  check.ExpectCurves();
  check.ExpectSeparation(levels, samples);
}

}  // namespace geodesic::test
