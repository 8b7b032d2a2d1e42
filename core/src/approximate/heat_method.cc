// Crane, Weischedel, Wardetzky: Geodesics in heat. ACM TOG 32(5), 2013.
//
//   paper             here
//   A, L_C            masses_, laplacian_ (positive semidefinite: -L_C)
//   t = m h^2         time_, with m = HeatOptions::lambda
//   u, X              heat; its gradient, turned and made a unit, face by face
//   Delta phi = div X the Poisson system, at one pinned vertex a component

#include "geodesic/approximate/heat_method.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "approximate/cholesky.h"
#include "approximate/intrinsic_triangulation.h"
#include "approximate/seeds.h"
#include "geodesic_types/field_path.h"
#include "mesh/file_unit.h"
#include "solver/work_meter.h"
#include "surface/surface_location.h"

namespace geodesic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// How much heat a source starts with: doubles then leave it 580 decades to fall
// through. Directions do not depend on it.
constexpr double kHeat = 1e280;
// Below this it has too few bits left to tell directions.
constexpr double kLeastHeat = 1e-300;

// For each vertex the lowest vertex of its component.
std::vector<uint32_t> ComponentsOf(const Mesh& mesh) {
  std::vector<uint32_t> parents(mesh.vertex_count());
  std::iota(parents.begin(), parents.end(), 0);
  const auto root = [&](uint32_t v) {
    while (parents[v] != v) v = parents[v] = parents[parents[v]];
    return v;
  };
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    const uint32_t a = root(mesh.From(h)), b = root(mesh.To(h));
    parents[std::max(a, b)] = std::min(a, b);
  }
  for (uint32_t v = 0; v < parents.size(); ++v) parents[v] = root(v);
  return parents;
}

// Where a source lets heat out and what it says of distances there.
struct HeatSource {
  FacePoint place;  // any face around it
  std::array<uint32_t, 3> corners;
};

}  // namespace

// All that is prepared.
class HeatMethod::Systems {
 public:
  Systems(const Mesh& mesh, const HeatOptions& options)
      : mesh_(mesh),
        components_(ComponentsOf(mesh)),
        time_(options.lambda * mesh.mean_edge_length() *
              mesh.mean_edge_length()) {}

  absl::Status Prepare(bool intrinsic_delaunay, Checkpoint& checkpoint);
  absl::StatusOr<std::vector<double>> Distances(const ValidQuery& query,
                                                Checkpoint& checkpoint) const;
  const Mesh& mesh() const { return mesh_; }
  uint64_t bytes() const {
    return faces_.capacity() * sizeof(Face) + pattern_bytes() +
           (laplacian_.capacity() + masses_.capacity()) * sizeof(double) +
           components_.capacity() * sizeof(uint32_t) +
           (heat_.has_value() ? heat_->bytes() : 0) +
           (poisson_.has_value() ? poisson_->bytes() : 0);
  }

 private:
  using Face = IntrinsicTriangulation::Face;

  uint64_t pattern_bytes() const {
    return (pattern_.column_begin.capacity() + pattern_.rows.capacity()) *
           sizeof(int32_t);
  }
  Progress Preparing() const {
    return {.vertices = mesh_.vertex_count(), .solver_bytes = bytes()};
  }
  absl::Status PollPreparing(Checkpoint& checkpoint) const {
    return checkpoint.Poll(Preparing());
  }
  // Heat, the right side, distances, shifts and counts.
  Progress Solving() const {
    return {.vertices = mesh_.vertex_count(),
            .solver_bytes = mesh_.vertex_count() * 5 * sizeof(double)};
  }
  absl::Status PollSolving(Checkpoint& checkpoint) const {
    return checkpoint.Poll(Solving());
  }
  absl::Status BuildMatrices(Checkpoint& checkpoint);
  // The Laplacian, with the rows and columns of some vertices those of the
  // identity.
  std::vector<double> Pinned(const std::vector<bool>& is_pinned) const;
  // The right side of the pinned system: moves what is known there.
  void MoveToRight(const std::vector<bool>& is_pinned,
                   const std::vector<double>& values,
                   std::vector<double>& right) const;
  std::vector<HeatSource> SourcesOf(const ValidQuery& query) const;
  absl::StatusOr<std::vector<double>> SpreadHeat(
      const std::vector<HeatSource>& sources, Checkpoint& checkpoint) const;
  // The divergence of the unit field along which heat flows, integrated around
  // each vertex.
  std::vector<double> Divergence(const std::vector<double>& heat) const;

  const Mesh& mesh_;
  const std::vector<uint32_t> components_;
  const double time_;
  std::vector<Face> faces_;
  double face_weight_ = 1;  // 1 / sheets
  SymmetricPattern pattern_;
  std::vector<double> laplacian_;  // by row of the pattern
  std::vector<double> masses_;     // by vertex
  std::shared_ptr<const Cholesky::Order> order_;
  std::optional<Cholesky> heat_;
  std::optional<Cholesky> poisson_;  // the lowest vertices pinned
};

absl::Status HeatMethod::Systems::Prepare(bool intrinsic_delaunay,
                                          Checkpoint& checkpoint) {
  if (absl::Status status = PollPreparing(checkpoint); !status.ok())
    return status;
  {
    IntrinsicTriangulation triangulation(mesh_);
    if (intrinsic_delaunay) {
      absl::Status status = triangulation.FlipToDelaunay(mesh_, checkpoint);
      if (!status.ok()) return status;
    }
    face_weight_ = 1.0 / triangulation.sheets();
    faces_.reserve(triangulation.face_count());
    const auto poll = [&] { return PollPreparing(checkpoint); };
    WorkMeter meter(poll);
    for (uint32_t f = 0; f < triangulation.face_count(); ++f) {
      if (!meter.Do()) return meter.status();
      faces_.push_back(triangulation.FaceAt(f));
    }
  }
  if (absl::Status status = BuildMatrices(checkpoint); !status.ok()) {
    return status;
  }
  auto order = Cholesky::Analyze(pattern_, checkpoint, Preparing());
  if (!order.ok()) return order.status();
  order_ = *std::move(order);
  if (absl::Status status = PollPreparing(checkpoint); !status.ok())
    return status;

  std::vector<double> values(laplacian_.size());
  std::ranges::transform(laplacian_, values.begin(),
                         [this](double entry) { return time_ * entry; });
  for (uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
    values[pattern_.column_begin[v + 1] - 1] += masses_[v];
  }
  auto heat =
      Cholesky::Factorize(pattern_, *order_, values, checkpoint, Preparing());
  if (!heat.ok()) return heat.status();
  heat_ = *std::move(heat);
  if (absl::Status status = PollPreparing(checkpoint); !status.ok())
    return status;

  std::vector<bool> is_lowest(mesh_.vertex_count());
  for (const uint32_t v : components_) is_lowest[v] = true;
  auto poisson = Cholesky::Factorize(pattern_, *order_, Pinned(is_lowest),
                                     checkpoint, Preparing());
  if (!poisson.ok()) return poisson.status();
  poisson_ = *std::move(poisson);
  return PollPreparing(checkpoint);
}

absl::Status HeatMethod::Systems::BuildMatrices(Checkpoint& checkpoint) {
  const uint32_t n = mesh_.vertex_count();
  masses_.assign(n, 0);
  const auto poll = [&] { return PollPreparing(checkpoint); };
  WorkMeter meter(poll);
  struct Entry {
    int32_t row;
    double value;
  };
  // Of each column, those above the diagonal; a face gives three.
  std::vector<uint32_t> begin(n + 1, 0);
  // False if told to stop.
  const auto for_each_side = [&](auto visit) {
    for (const Face& face : faces_) {
      const auto [a, b, c] = face.corners;
      const double twice_area = face.length * face.y;
      const double weight = face_weight_ / (2 * twice_area);
      // Half the cotangents of the angles at the corners.
      const double at_a = weight * face.length * face.x;
      const double at_b = weight * face.length * (face.length - face.x);
      const double at_c =
          weight * (face.y * face.y - face.x * (face.length - face.x));
      visit(a, b, at_c);
      visit(b, c, at_a);
      visit(c, a, at_b);
      if (!meter.Do()) return false;
    }
    return true;
  };
  if (!for_each_side([&](uint32_t a, uint32_t b, double) {
        if (a != b) ++begin[std::max(a, b) + 1];
      })) {
    return meter.status();
  }
  for (uint32_t v = 0; v < n; ++v) begin[v + 1] += begin[v];
  std::vector<Entry> entries(begin[n]);
  std::vector<double> diagonal(n, 0);
  std::vector<uint32_t> next(begin.begin(), begin.end() - 1);
  if (!for_each_side([&](uint32_t a, uint32_t b, double cotangent) {
        if (a == b) return;
        entries[next[std::max(a, b)]++] = {static_cast<int32_t>(std::min(a, b)),
                                           -cotangent};
        diagonal[a] += cotangent;
        diagonal[b] += cotangent;
      })) {
    return meter.status();
  }
  for (const Face& face : faces_) {
    if (!meter.Do()) return meter.status();
    for (const uint32_t v : face.corners) {
      masses_[v] += face_weight_ * face.length * face.y / 6;
    }
  }
  pattern_.column_begin.assign(1, 0);
  for (uint32_t column = 0; column < n; ++column) {
    const auto first = entries.begin() + begin[column];
    const auto last = entries.begin() + begin[column + 1];
    if (!meter.Do(1 + begin[column + 1] - begin[column])) return meter.status();
    // Stable, so that sums do not depend on the library.
    std::stable_sort(first, last, [](const Entry& a, const Entry& b) {
      return a.row < b.row;
    });
    const size_t column_begin = pattern_.rows.size();
    for (auto entry = first; entry != last; ++entry) {
      if (pattern_.rows.size() > column_begin &&
          pattern_.rows.back() == entry->row) {
        laplacian_.back() += entry->value;
      } else {
        pattern_.rows.push_back(entry->row);
        laplacian_.push_back(entry->value);
      }
    }
    pattern_.rows.push_back(static_cast<int32_t>(column));
    laplacian_.push_back(diagonal[column]);
    pattern_.column_begin.push_back(static_cast<int32_t>(pattern_.rows.size()));
    // A vertex without faces keeps what it is given.
    if (masses_[column] == 0) masses_[column] = 1;
  }
  return absl::OkStatus();
}

std::vector<double> HeatMethod::Systems::Pinned(
    const std::vector<bool>& is_pinned) const {
  std::vector<double> values = laplacian_;
  for (size_t column = 0; column < pattern_.size(); ++column) {
    for (int32_t i = pattern_.column_begin[column];
         i < pattern_.column_begin[column + 1]; ++i) {
      const auto row = static_cast<size_t>(pattern_.rows[i]);
      if (is_pinned[row] || is_pinned[column]) values[i] = row == column;
    }
  }
  return values;
}

void HeatMethod::Systems::MoveToRight(const std::vector<bool>& is_pinned,
                                      const std::vector<double>& values,
                                      std::vector<double>& right) const {
  for (size_t column = 0; column < pattern_.size(); ++column) {
    for (int32_t i = pattern_.column_begin[column];
         i < pattern_.column_begin[column + 1]; ++i) {
      const auto row = static_cast<size_t>(pattern_.rows[i]);
      if (is_pinned[row] && !is_pinned[column]) {
        right[column] -= laplacian_[i] * values[row];
      } else if (is_pinned[column] && !is_pinned[row]) {
        right[row] -= laplacian_[i] * values[column];
      }
    }
  }
  for (size_t v = 0; v < right.size(); ++v) {
    if (is_pinned[v]) right[v] = values[v];
  }
}

std::vector<HeatSource> HeatMethod::Systems::SourcesOf(
    const ValidQuery& query) const {
  std::vector<HeatSource> sources;
  for (const Source& source : query->sources) {
    const auto& point = std::get<SurfacePoint>(source.place);
    const auto* at = std::get_if<VertexPoint>(&point);
    if (at != nullptr && mesh_.Outgoing(at->vertex).empty()) {
      sources.push_back(
          {{.weights = {1, 0, 0}}, {at->vertex, at->vertex, at->vertex}});
    } else {
      const FacePoint place = FirstFaceAround(mesh_, point);
      sources.push_back({place, mesh_.triangle(place.face)});
    }
  }
  return sources;
}

absl::StatusOr<std::vector<double>> HeatMethod::Systems::SpreadHeat(
    const std::vector<HeatSource>& sources, Checkpoint& checkpoint) const {
  std::vector<double> right(mesh_.vertex_count(), 0);
  std::vector<bool> has_source(mesh_.vertex_count());
  for (const HeatSource& source : sources) {
    has_source[components_[source.corners[0]]] = true;
    for (uint32_t i = 0; i < 3; ++i) {
      right[source.corners[i]] += kHeat * source.place.weights[i];
    }
  }
  absl::StatusOr<std::vector<double>> heat =
      heat_->Solve(right, checkpoint, Solving());
  if (!heat.ok()) return heat;
  for (uint32_t v = 0; v < heat->size(); ++v) {
    if (has_source[components_[v]] && !(std::abs((*heat)[v]) > kLeastHeat)) {
      return absl::FailedPreconditionError(absl::StrCat(
          "heat vanishes before it reaches vertex ", v,
          ": it spreads for lambda h^2; a larger lambda reaches farther"));
    }
  }
  return heat;
}

std::vector<double> HeatMethod::Systems::Divergence(
    const std::vector<double>& heat) const {
  std::vector<double> divergence(mesh_.vertex_count(), 0);
  for (const auto& [corners, length, x, y] : faces_) {
    // Times twice the area; without a division.
    const double rise = heat[corners[1]] - heat[corners[0]];
    double gx = rise * y;
    double gy = (heat[corners[2]] - heat[corners[0]]) * length - rise * x;
    const double largest = std::max(std::abs(gx), std::abs(gy));
    if (!(largest > 0)) continue;  // as warm at all corners
    gx /= largest;
    gy /= largest;
    const double norm = std::sqrt(gx * gx + gy * gy);
    const double half = face_weight_ / (2 * norm);
    gx *= -half;
    gy *= -half;
    // The areas times the gradients of the corners' hat functions.
    divergence[corners[0]] += -y * gx + (x - length) * gy;
    divergence[corners[1]] += y * gx - x * gy;
    divergence[corners[2]] += length * gy;
  }
  return divergence;
}

absl::StatusOr<std::vector<double>> HeatMethod::Systems::Distances(
    const ValidQuery& query, Checkpoint& checkpoint) const {
  const absl::StatusOr<std::vector<Seed>> seeds =
      SeedsOf(query, mesh_, ApproximateMethod::kHeat, checkpoint);
  if (!seeds.ok()) return seeds.status();
  const std::vector<HeatSource> sources = SourcesOf(query);
  if (absl::Status status = PollSolving(checkpoint); !status.ok())
    return status;
  const absl::StatusOr<std::vector<double>> heat =
      SpreadHeat(sources, checkpoint);
  if (!heat.ok()) return heat.status();
  std::vector<double> right = Divergence(*heat);
  if (absl::Status status = PollSolving(checkpoint); !status.ok())
    return status;

  // What each component's distances start from.
  std::vector<uint32_t> sources_on(mesh_.vertex_count(), 0);
  bool has_several = false;
  for (const HeatSource& source : sources) {
    has_several |= ++sources_on[components_[source.corners[0]]] > 1;
  }
  std::vector<bool> is_pinned(mesh_.vertex_count());
  for (const uint32_t v : components_) is_pinned[v] = true;
  std::vector<double> values(mesh_.vertex_count(), 0);
  absl::StatusOr<std::vector<double>> distances;
  if (has_several) {
    for (const Seed& seed : *seeds) {
      if (sources_on[components_[seed.vertex]] < 2) continue;
      is_pinned[components_[seed.vertex]] = false;
    }
    for (const Seed& seed : *seeds) {
      if (sources_on[components_[seed.vertex]] < 2) continue;
      is_pinned[seed.vertex] = true;
      values[seed.vertex] = seed.distance;
    }
    const auto pinned = Cholesky::Factorize(
        pattern_, *order_, Pinned(is_pinned), checkpoint, Solving());
    if (!pinned.ok()) return pinned.status();
    MoveToRight(is_pinned, values, right);
    distances = pinned->Solve(right, checkpoint, Solving());
  } else {
    for (const uint32_t v : components_) right[v] = 0;
    distances = poisson_->Solve(right, checkpoint, Solving());
  }
  if (!distances.ok()) return distances;

  std::vector<double> shifts(mesh_.vertex_count(), 0);
  for (const HeatSource& source : sources) {
    if (sources_on[components_[source.corners[0]]] != 1) continue;
    double& shift = shifts[components_[source.corners[0]]];
    for (uint32_t i = 0; i < 3; ++i) {
      const double weight = source.place.weights[i];
      if (weight == 0) continue;
      const double straight =
          weight == 1 ? 0 : DistanceToCorner(mesh_, source.place, i);
      shift += weight * (straight - (*distances)[source.corners[i]]);
    }
  }
  for (uint32_t v = 0; v < distances->size(); ++v) {
    double& d = (*distances)[v];
    d = sources_on[components_[v]] == 0
            ? kInfinity
            : std::max(ToFileUnit(mesh_, d + shifts[components_[v]]), 0.0);
  }
  if (absl::Status status = PollSolving(checkpoint); !status.ok())
    return status;
  return distances;
}

HeatMethod::HeatMethod(std::unique_ptr<const Systems> systems)
    : PreparedMethod(systems->mesh()), systems_(std::move(systems)) {}
HeatMethod::~HeatMethod() = default;

absl::Status HeatMethod::Check(const HeatOptions& options) {
  if (options.lambda > 0 && std::isfinite(options.lambda)) {
    return absl::OkStatus();
  }
  return InvalidField("lambda", absl::StrCat("heat: lambda ", options.lambda,
                                             " is not a finite number > 0"));
}

absl::StatusOr<std::shared_ptr<const HeatMethod>> HeatMethod::Prepare(
    const Mesh& mesh, const HeatOptions& options, Checkpoint& checkpoint) {
  absl::Status status = Check(options);
  if (!status.ok()) return status;
  auto systems = std::make_unique<Systems>(mesh, options);
  status = systems->Prepare(options.intrinsic_delaunay, checkpoint);
  if (!status.ok()) return status;
  return std::shared_ptr<const HeatMethod>(new HeatMethod(std::move(systems)));
}

ApproximateMethod HeatMethod::method() const {
  return ApproximateMethod::kHeat;
}

absl::StatusOr<std::vector<double>> HeatMethod::Compute(
    const ValidQuery& query, Checkpoint& checkpoint) const {
  return systems_->Distances(query, checkpoint);
}

uint64_t HeatMethod::bytes() const { return systems_->bytes(); }

}  // namespace geodesic
