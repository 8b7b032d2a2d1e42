#include "geodesic/join_seams.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/strings/str_cat.h"
#include "mesh/boundary_edges.h"
#include "mesh/close_edges.h"
#include "mesh/disjoint_sets.h"
#include "mesh/locality.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// What the coordinates of some vertices are made of.
class Coordinates {
 public:
  void Add(const Point& point) {
    for (const double x : point) {
      largest_ = std::max(largest_, std::abs(x));
      float_error_ =
          std::max(float_error_, std::abs(x - static_cast<float>(x)));
    }
  }
  // Of some of them.
  void AddDigits(const Point& point) {
    for (const double x : point) {
      if (x != 0) AddDigits(x);
    }
  }

  // How far apart places may be that are one: along an axis, by what computing
  // them in a mesh of this extent and writing them down adds.
  double Rounding(double extent, bool is_single) const {
    if (largest_ == 0) return 0;
    const double unit = DecimalUnit(extent);
    const bool are_floats = float_error_ <= kWrittenTwice * unit / 2;
    const double epsilon = is_single || are_floats
                               ? std::numeric_limits<float>::epsilon()
                               : std::numeric_limits<double>::epsilon();
    return kWrittenTwice * std::max({kComputedTwice * extent * epsilon,
                                     largest_ * epsilon, unit});
  }

 private:
  // Digits of a double that differ from those of its neighbours.
  static constexpr int kAllDigits = std::numeric_limits<double>::digits10;
  static constexpr int kMostDecimals = 40;

  // A unit of the last digit, if the numbers were rounded to decimal ones: then
  // most of them have as many digits, or as many behind the point, as any. 0
  // where such digits were chosen, or the numbers are binary.
  double DecimalUnit(double extent) const {
    if (count_ == 0) return 0;
    const auto last_used = [](const auto& counts) {
      return static_cast<int>(std::find_if(counts.rbegin(), counts.rend(),
                                           [](auto n) { return n > 0; }) -
                              counts.rbegin());
    };
    const int digits = kAllDigits + 2 - last_used(by_digits_);
    const int decimals = kMostDecimals - last_used(by_decimals_);
    double unit = 0;
    if (digits > kAllDigits) {
      return 0;
    }
    if (2 * by_decimals_[decimals] >= count_) {
      unit = std::pow(10.0, -decimals);
    } else if (2 * by_digits_[digits] >= count_) {
      const double first = std::floor(std::log10(largest_));
      unit = std::pow(10.0, first + 1 - digits);
    }
    return unit <= kMostDecimalRounding * extent ? unit : 0;
  }

  // Of the shortest decimal number that reads as x: the one that a text has
  // holds no fewer.
  void AddDigits(double x) {
    if (has_all_digits_) return;  // so there is no unit
    std::array<char, 32> text;
    const char* const end =
        std::to_chars(text.data(), text.data() + text.size(), std::abs(x),
                      std::chars_format::scientific)
            .ptr;
    const char* const exponent = std::find<const char*>(text.data(), end, 'e');
    // Without the point.
    const int digits =
        std::max(static_cast<int>(exponent - text.data()) - 1, 1);
    int power = 0;
    // from_chars knows no plus.
    std::from_chars(exponent + (exponent[1] == '+' ? 2 : 1), end, power);
    ++count_;
    has_all_digits_ = digits > kAllDigits;
    ++by_digits_[std::min(digits, kAllDigits + 2)];
    ++by_decimals_[std::clamp(digits - 1 - power, 0, kMostDecimals)];
  }

  uint64_t count_ = 0;  // whose digits are known
  double largest_ = 0;
  bool has_all_digits_ = false;  // one of them
  double float_error_ = 0;       // of the one that single precision holds worst
  // How many have so many significant digits, and so many behind the point.
  std::array<uint64_t, kAllDigits + 3> by_digits_{};
  std::array<uint64_t, kMostDecimals + 1> by_decimals_{};
};

struct Box {
  Point least;
  Point most;

  void Add(const Point& point) {
    for (int axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], point[axis]);
      most[axis] = std::max(most[axis], point[axis]);
    }
  }
  double Extent() const {
    return std::max(
        {most[0] - least[0], most[1] - least[1], most[2] - least[2]});
  }
};

// Where most of a soup lies, by a sample of it. A few vertices far off would
// make the rounding of their own places that of all.
class UsualBox {
 public:
  // REQUIRES: the soup has faces.
  explicit UsualBox(const TriangleSoup& soup) {
    const size_t faces = soup.triangles.size();
    std::vector<Point> sample(std::min<size_t>(faces, kSample));
    for (size_t i = 0; i < sample.size(); ++i) {
      const Triangle& corners = soup.triangles[i * faces / sample.size()];
      sample[i] = soup.positions[corners[i % 3]];
    }
    std::vector<double> sorted(sample.size());
    const size_t quarter = sample.size() / 4;
    for (int axis = 0; axis < 3; ++axis) {
      std::ranges::transform(
          sample, sorted.begin(),
          [axis](const Point& point) { return point[axis]; });
      std::ranges::sort(sorted);
      middle_[axis] = sorted[sorted.size() / 2];
      spread_ = std::max(spread_,
                         sorted[sorted.size() - 1 - quarter] - sorted[quarter]);
    }
    box_ = {middle_, middle_};
    for (const Point& point : sample) {
      if (Holds(point)) box_.Add(point);
    }
  }

  bool Holds(const Point& point) const {
    if (spread_ == 0) return true;
    const double most = kFarOff * spread_;
    return std::abs(point[0] - middle_[0]) <= most &&
           std::abs(point[1] - middle_[1]) <= most &&
           std::abs(point[2] - middle_[2]) <= most;
  }

  const Box& box() const { return box_; }

 private:
  static constexpr size_t kSample = 256;

  Point middle_{};
  double spread_ = 0;  // of the middle half of all
  Box box_{};
};

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
    const auto set_of = [&](uint32_t v) {
      return vertices_.Find(boundary_.NumberOf(v));
    };
    absl::flat_hash_map<uint32_t, uint32_t> corner_of;  // by the place
    for (const auto& [low, high] : boundary_.edges()) {
      for (const uint32_t v : {low, high}) {
        if (is_on_face[set_of(v)]) corner_of.try_emplace(place_of(v), v);
      }
    }
    // Sets change their numbers once the first is joined.
    std::erase_if(points, [&](uint32_t i) {
      return is_on_face[set_of(boundary_.edges()[i].low)];
    });
    for (const uint32_t i : points) {
      const uint32_t low = boundary_.edges()[i].low;
      const auto corner = corner_of.find(place_of(low));
      if (corner != corner_of.end()) JoinVertices(low, corner->second);
    }
    return absl::OkStatus();
  }

  // Joins what is left to edges whose ends are close.
  absl::Status JoinClose(const Closeness& closeness) {
    // One of each set, and whether it is alone.
    std::vector<VertexPair> edges;
    std::vector<uint32_t> numbers;
    std::vector<bool> is_joined(edge_count());
    for (uint32_t i = 0; i < edge_count(); ++i) {
      if (edges_.Find(i) != i) {
        is_joined[edges_.Find(i)] = true;
        continue;
      }
      edges.push_back(boundary_.edges()[i]);
      numbers.push_back(i);
    }
    if (std::ranges::all_of(numbers,
                            [&](uint32_t i) { return is_joined[i]; })) {
      return absl::OkStatus();
    }
    CloseEdges grid(soup_.positions, edges, closeness);
    std::vector<ClosePair> pairs;
    for (uint32_t i = 0; i < edges.size(); ++i) {
      if (absl::Status status = Poll(i); !status.ok()) return status;
      if (is_joined[numbers[i]]) continue;
      pairs.clear();
      absl::Status status = grid.Find(i, checkpoint_, pairs);
      if (!status.ok()) return status;
      for (const ClosePair& pair : pairs) {
        Join(numbers[pair.first], numbers[pair.second], pair.is_turned);
      }
    }
    return absl::OkStatus();
  }

  // How far apart the ends of edges may be that are one.
  double Rounding() const {
    const UsualBox usual(soup_);
    Coordinates coordinates;
    Box box = usual.box();
    const std::vector<uint32_t>& vertices = boundary_.vertices();
    const size_t step = vertices.size() / kSampledDigits + 1;
    for (size_t i = 0; i < vertices.size(); ++i) {
      const Point& point = soup_.positions[vertices[i]];
      if (!usual.Holds(point)) continue;
      coordinates.Add(point);
      if (i % step == 0) coordinates.AddDigits(point);
      box.Add(point);
    }
    const double extent = box.Extent();
    // Along each axis.
    return std::sqrt(3.0) *
           coordinates.Rounding(extent, soup_.is_single_precision);
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

  void JoinVertices(uint32_t a, uint32_t b) {
    vertices_.Join(boundary_.NumberOf(a), boundary_.NumberOf(b));
  }

  // Writing digits takes longer than all else.
  static constexpr size_t kSampledDigits = 512;

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
  const Closeness closeness = welding.kind == Welding::Kind::kWithin
                                  ? Closeness{welding.distance, kMostWelded}
                                  : Closeness{seams.Rounding(), kMostRounded};
  if (closeness.distance > 0) status = seams.JoinClose(closeness);
  if (status.ok()) seams.Finish();
  return status;
}

absl::Status JoinSeams(const Welding& welding, TriangleSoup& soup) {
  NoCheckpoint checkpoint;
  return JoinSeams(welding, soup, checkpoint);
}

}  // namespace geodesic
