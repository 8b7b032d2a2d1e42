// Which crossings around a face an isoline joins inside of it.

#ifndef GEODESIC_QUESTIONS_ISOLINES_FACE_REGIONS_H_
#define GEODESIC_QUESTIONS_ISOLINES_FACE_REGIONS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace geodesic {

// A piece of an isoline between two crossings, by number. What is nearer lies
// to its left (where faces run anticlockwise).
struct Segment {
  uint32_t from = 0;
  uint32_t to = 0;
};

// A crossing on a face's perimeter.
struct PerimeterCrossing {
  double at = 0;  // side + fraction of the side, in [0, 3]
  uint32_t crossing = 0;
};

// Crossings cut the perimeter into arcs that are nearer than the level, and
// others in between. Each nearer arc is a region of its own at first; regions
// that hang together inside the face are joined. An isoline leads from the end
// of each arc to the beginning of the next one of the same region: around each
// region, and never across another isoline.
class FaceRegions {
 public:
  // `crossings` are in order along the perimeter, an even number.
  // starts_nearer: whether the perimeter's beginning is nearer than the level.
  FaceRegions(std::vector<PerimeterCrossing> crossings, bool starts_nearer);

  size_t arc_count() const { return regions_.size(); }
  // The nearer arc that holds a place of the perimeter, if one does.
  std::optional<size_t> ArcAt(double at) const;
  bool AreJoined(size_t arc, size_t other) const {
    return regions_[arc] == regions_[other];
  }
  void Join(size_t arc, size_t other);

  // Joins what would cross (in the plane, a region between two others that hang
  // together belongs to them), and gives one segment an arc.
  std::vector<Segment> Segments();

 private:
  void JoinInterleaved();
  uint32_t BeginOf(size_t arc) const;
  uint32_t EndOf(size_t arc) const;

  std::vector<PerimeterCrossing> crossings_;
  bool starts_nearer_;
  std::vector<size_t> regions_;  // of each arc: the number of one of its arcs
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_FACE_REGIONS_H_
