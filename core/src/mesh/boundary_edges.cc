#include "mesh/boundary_edges.h"

#include <algorithm>
#include <cstddef>

namespace geodesic {
namespace {

// Some milliseconds.
constexpr size_t kFacesBetweenPolls = size_t{1} << 16;

// Spreads a number over 64 bits (the finalizer of splitmix64).
uint64_t Mixed(uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Calls visit(corners) for each face that has three vertices.
// Errors: whatever `checkpoint` returns.
template <typename Visit>
absl::Status ForEachFace(const TriangleSoup& soup, Checkpoint& checkpoint,
                         const Progress& progress, Visit visit) {
  for (size_t face = 0; face < soup.triangles.size(); ++face) {
    if (face % kFacesBetweenPolls == 0) {
      absl::Status status = checkpoint.Poll(progress);
      if (!status.ok()) return status;
    }
    if (!RepeatsVertex(soup.triangles[face])) visit(soup.triangles[face]);
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<BoundaryEdges> BoundaryEdges::Find(const TriangleSoup& soup,
                                                  Checkpoint& checkpoint) {
  const size_t vertices = soup.positions.size();
  Progress progress = {.solver_bytes = vertices * sizeof(uint64_t)};
  // Where the faces around a vertex close, each neighbour follows in one and
  // precedes in another, and what they add up to is 0. Elsewhere it is not, but
  // for one chance in 2^64.
  std::vector<uint64_t> balance;
  absl::Status status = checkpoint.Poll(progress);
  if (!status.ok()) return status;
  balance.resize(vertices, 0);
  status = ForEachFace(
      soup, checkpoint, progress, [&balance](const Triangle& corners) {
        const uint64_t a = Mixed(corners[0]), b = Mixed(corners[1]),
                       c = Mixed(corners[2]);
        balance[corners[0]] += b - c;
        balance[corners[1]] += c - a;
        balance[corners[2]] += a - b;
      });
  if (!status.ok()) return status;
  BoundaryEdges found;
  if (std::ranges::count(balance, 0u) == std::ssize(balance)) return found;

  // Sides between vertices at the boundary, by their low ends.
  const auto visit_sides = [&balance](const Triangle& corners, auto visit) {
    for (int i = 0; i < 3; ++i) {
      const uint32_t a = corners[i], b = corners[(i + 1) % 3];
      if (balance[a] != 0 && balance[b] != 0) {
        visit(std::min(a, b), std::max(a, b));
      }
    }
  };
  std::vector<uint32_t>& begin = found.begin_;
  begin.resize(vertices + 1, 0);
  status =
      ForEachFace(soup, checkpoint, progress, [&](const Triangle& corners) {
        visit_sides(corners, [&](uint32_t low, uint32_t) { ++begin[low + 1]; });
      });
  if (!status.ok()) return status;
  for (size_t v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
  progress.solver_bytes +=
      vertices * sizeof(uint32_t) +
      uint64_t{begin.back()} * (sizeof(uint32_t) + sizeof(VertexPair));
  status = checkpoint.Poll(progress);
  if (!status.ok()) return status;
  found.highs_.resize(begin.back());
  // Filled from the back, which moves the beginnings to where they belong.
  status =
      ForEachFace(soup, checkpoint, progress, [&](const Triangle& corners) {
        visit_sides(corners, [&](uint32_t low, uint32_t high) {
          found.highs_[--begin[low + 1]] = high;
        });
      });
  if (!status.ok()) return status;
  begin.erase(begin.begin());
  begin.push_back(static_cast<uint32_t>(found.highs_.size()));
  for (uint32_t low = 0; low < vertices; ++low) {
    if (low % kFacesBetweenPolls == 0) {
      status = checkpoint.Poll(progress);
      if (!status.ok()) return status;
    }
    const auto first = found.highs_.begin() + begin[low];
    const auto last = found.highs_.begin() + begin[low + 1];
    std::sort(first, last);
    for (auto high = first; high != last;) {
      const auto end = std::upper_bound(high, last, *high);
      if (end - high == 1) found.edges_.push_back({low, *high});
      high = end;
    }
  }
  return found;
}

bool BoundaryEdges::AreNeighbours(uint32_t a, uint32_t b) const {
  const auto [low, high] = std::minmax(a, b);
  return std::binary_search(highs_.begin() + begin_[low],
                            highs_.begin() + begin_[low + 1], high);
}

}  // namespace geodesic
