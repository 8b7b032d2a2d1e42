#include "questions/isolines/isoline_band.h"

#include <algorithm>

namespace geodesic {
namespace {

// No point of the face of h is farther than this, given a window on h: the ends
// of h are at most as far as through the window and along h, and so on around
// the face and from there inside. What vertex distances tell later is never
// more (beside rounding), so no face counts as crossed of which windows were
// not kept.
double FarthestIn(const Mesh& mesh, HalfEdge h, const MixedWindow& window) {
  const double length = mesh.frame(h).length;
  const double from = window.begin_distance + window.interval.begin;
  const double to = window.end_distance + (length - window.interval.end);
  return (std::max({(from + to + length) / 2, from + mesh.frame(Prev(h)).length,
                    to + mesh.frame(Next(h)).length}) +
          InradiusOf(mesh, h)) *
         (1 + 8 * kAtLevel);
}

}  // namespace

double InradiusOf(const Mesh& mesh, HalfEdge h) {
  const HalfEdgeFrame& frame = mesh.frame(h);
  return frame.length * frame.apex_y /
         (frame.length + mesh.frame(Next(h)).length +
          mesh.frame(Prev(h)).length);
}

IsolineBand::IsolineBand(const Mesh& mesh, std::span<const double> levels)
    : mesh_(mesh),
      levels_(levels),
      first_(mesh.half_edge_count(), kNone),
      is_closed_(mesh.face_count()) {}

void IsolineBand::OnWindow(HalfEdge h, const MixedWindow& window, uint32_t) {
  const auto level = std::ranges::upper_bound(levels_, window.Label());
  if (level == levels_.end() || *level > FarthestIn(mesh_, h, window)) {
    return;
  }
  const uint32_t face = mesh_.FaceOf(h);
  if (is_closed_[face]) return;
  if (!HasWindows(face)) faces_.push_back(face);
  first_[h] = kept_.Allocate({{window.interval, window.origin}, first_[h]});
}

void IsolineBand::Close(uint32_t face) {
  is_closed_[face] = true;
  const HalfEdge first = mesh_.FirstSide(face);
  for (HalfEdge h = first; h < first + 3; ++h) {
    for (uint32_t id = first_[h]; id != kNone;) {
      const uint32_t next = kept_[id].next;
      kept_.Free(id);
      id = next;
    }
    first_[h] = kNone;
  }
}

uint64_t IsolineBand::bytes() const {
  return kept_.bytes() + first_.capacity() * sizeof(uint32_t) +
         is_closed_.capacity() / 8 + faces_.capacity() * sizeof(uint32_t);
}

}  // namespace geodesic
