// The windows from which isolines are made, kept while they may be needed.

#ifndef GEODESIC_QUESTIONS_ISOLINES_ISOLINE_BAND_H_
#define GEODESIC_QUESTIONS_ISOLINES_ISOLINE_BAND_H_

#include <cstdint>
#include <span>
#include <vector>

#include "geodesic/mesh.h"
#include "questions/isolines/way.h"
#include "solver/windows/window_observer.h"
#include "solver/windows/window_pool.h"

namespace geodesic {

// Of the face of h: nothing inside is farther from its perimeter.
double InradiusOf(const Mesh& mesh, HalfEdge h);

// Keeps the windows that enter faces which a level may cross: a window itself
// bounds the distances in its face from both sides, so windows more than about
// a face away from every level are never kept. Those of a face are dropped once
// the face has been dealt with.
class IsolineBand final : public WindowObserver {
 public:
  // `levels` are in the scaled unit, rise, and outlive this object.
  IsolineBand(const Mesh& mesh, std::span<const double> levels);

  void OnWindow(HalfEdge h, const MixedWindow& window,
                uint32_t pseudo_source) override;

  // Calls visit(way) for every window kept that enters the face of h.
  template <typename Visit>
  void ForEach(HalfEdge h, Visit visit) const {
    for (uint32_t id = first_[h]; id != kNone; id = kept_[id].next) {
      visit(kept_[id].way);
    }
  }
  bool HasWindows(uint32_t face) const {
    const HalfEdge h = mesh_.FirstSide(face);
    return first_[h] != kNone || first_[h + 1] != kNone ||
           first_[h + 2] != kNone;
  }

  // Drops the windows of a face and keeps no more of it.
  void Close(uint32_t face);
  bool IsClosed(uint32_t face) const { return is_closed_[face]; }

  // Faces that have had windows, each once, less those since closed and
  // removed.
  std::vector<uint32_t>& faces() { return faces_; }
  uint64_t size() const { return kept_.live(); }
  uint64_t bytes() const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  struct Kept {
    Way way;
    uint32_t next;  // into the same face through the same half-edge
  };

  const Mesh& mesh_;
  const std::span<const double> levels_;
  WindowPool<Kept> kept_;
  std::vector<uint32_t> first_;  // of each half-edge
  std::vector<bool> is_closed_;  // faces
  std::vector<uint32_t> faces_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_ISOLINE_BAND_H_
