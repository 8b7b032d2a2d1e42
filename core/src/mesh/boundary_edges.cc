#include "mesh/boundary_edges.h"

#include <algorithm>
#include <cstddef>

#include "mesh/large_pages.h"

namespace geodesic {
namespace {

// Some milliseconds.
constexpr size_t kFacesBetweenPolls = size_t{1} << 16;

// Spreads a number over 64 bits (the finalizer of splitmix64): less, and sums
// of small numbers cancel.
uint64_t Mixed(uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Calls visit(i) for each i below `count`.
// Errors: whatever `checkpoint` returns.
template <typename Visit>
absl::Status ForEach(size_t count, Checkpoint& checkpoint,
                     const Progress& progress, Visit visit) {
  for (size_t i = 0; i < count; ++i) {
    if (i % kFacesBetweenPolls == 0) {
      absl::Status status = checkpoint.Poll(progress);
      if (!status.ok()) return status;
    }
    visit(static_cast<uint32_t>(i));
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<BoundaryEdges> BoundaryEdges::Find(const TriangleSoup& soup,
                                                  Checkpoint& checkpoint) {
  struct Vertex {
    uint64_t mixed = 0;
    uint64_t balance = 0;
  };
  const size_t vertices = soup.positions.size();
  const std::vector<Triangle>& triangles = soup.triangles;
  Progress progress = {.solver_bytes = vertices * sizeof(Vertex)};
  BoundaryEdges found;
  absl::Status status = checkpoint.Poll(progress);
  if (!status.ok()) return status;
  // Where the faces around a vertex close, each neighbour follows in one and
  // precedes in another, and what they add up to is 0. Elsewhere it is not, but
  // for one chance in 2^64.
  std::vector<Vertex> around = MakeLargeVector<Vertex>(vertices);
  for (size_t v = 0; v < vertices; ++v) around[v].mixed = Mixed(v);
  bool names_others = false;
  status = ForEach(triangles.size(), checkpoint, progress, [&](uint32_t face) {
    const auto& [a, b, c] = triangles[face];
    if (std::max({a, b, c}) >= vertices) {
      names_others = true;
      return;
    }
    if (RepeatsVertex(triangles[face])) return;
    Vertex& at_a = around[a];
    Vertex& at_b = around[b];
    Vertex& at_c = around[c];
    at_a.balance += at_b.mixed - at_c.mixed;
    at_b.balance += at_c.mixed - at_a.mixed;
    at_c.balance += at_a.mixed - at_b.mixed;
  });
  if (!status.ok()) return status;
  if (names_others) {
    return absl::OutOfRangeError("a triangle names a vertex that is not there");
  }
  const uint64_t outer =
      vertices - std::ranges::count(around, uint64_t{0}, &Vertex::balance);
  if (outer == 0) return found;

  progress.solver_bytes += vertices * sizeof(uint32_t) +
                           outer * 2 * sizeof(uint32_t) +
                           triangles.size() * sizeof(uint32_t);
  status = checkpoint.Poll(progress);
  if (!status.ok()) return status;
  found.numbers_.resize(vertices);
  found.vertices_.reserve(outer);
  for (uint32_t v = 0; v < vertices; ++v) {
    if (around[v].balance == 0) continue;
    found.vertices_.push_back(v);
    found.numbers_[v] = static_cast<uint32_t>(found.vertices_.size());
  }
  std::vector<uint32_t> faces;
  status = ForEach(triangles.size(), checkpoint, progress, [&](uint32_t face) {
    int outer_corners = 0;
    for (const uint32_t v : triangles[face]) {
      outer_corners += found.numbers_[v] != 0 ? 1 : 0;
    }
    if (outer_corners >= 2 && !RepeatsVertex(triangles[face])) {
      faces.push_back(face);
    }
  });
  if (!status.ok()) return status;
  status = found.FindSides(triangles, faces, checkpoint, progress);
  if (!status.ok()) return status;
  return found;
}

absl::Status BoundaryEdges::FindSides(const std::vector<Triangle>& triangles,
                                      const std::vector<uint32_t>& faces,
                                      Checkpoint& checkpoint,
                                      Progress progress) {
  const auto for_each_side = [&](auto visit) {
    return ForEach(faces.size(), checkpoint, progress, [&](uint32_t i) {
      const Triangle& corners = triangles[faces[i]];
      for (int corner = 0; corner < 3; ++corner) {
        const uint32_t a = corners[corner], b = corners[(corner + 1) % 3];
        if (numbers_[a] != 0 && numbers_[b] != 0) {
          visit(NumberOf(std::min(a, b)), std::max(a, b));
        }
      }
    });
  };
  begin_.resize(vertices_.size() + 1, 0);
  absl::Status status =
      for_each_side([this](uint32_t low, uint32_t) { ++begin_[low + 1]; });
  if (!status.ok()) return status;
  for (size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  progress.solver_bytes +=
      uint64_t{begin_.back()} * (sizeof(uint32_t) + sizeof(VertexPair));
  status = checkpoint.Poll(progress);
  if (!status.ok()) return status;
  highs_.resize(begin_.back());
  // Filled from the back, which moves the beginnings to where they belong.
  status = for_each_side([this](uint32_t low, uint32_t high) {
    highs_[--begin_[low + 1]] = high;
  });
  if (!status.ok()) return status;
  begin_.erase(begin_.begin());
  begin_.push_back(static_cast<uint32_t>(highs_.size()));
  return ForEach(vertices_.size(), checkpoint, progress, [this](uint32_t low) {
    const auto first = highs_.begin() + begin_[low];
    const auto last = highs_.begin() + begin_[low + 1];
    std::sort(first, last);
    for (auto high = first; high != last;) {
      const auto end = std::upper_bound(high, last, *high);
      if (end - high == 1) edges_.push_back({vertices_[low], *high});
      high = end;
    }
  });
}

bool BoundaryEdges::AreNeighbours(uint32_t a, uint32_t b) const {
  const auto [low, high] = std::minmax(a, b);
  const uint32_t number = NumberOf(low);
  return std::binary_search(highs_.begin() + begin_[number],
                            highs_.begin() + begin_[number + 1], high);
}

}  // namespace geodesic
