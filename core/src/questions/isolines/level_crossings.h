// Where levels of the distance cross the edges of a mesh, and which crossings
// are joined across its faces.

#ifndef GEODESIC_QUESTIONS_ISOLINES_LEVEL_CROSSINGS_H_
#define GEODESIC_QUESTIONS_ISOLINES_LEVEL_CROSSINGS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/status/status.h"
#include "geodesic/isolines.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "questions/isolines/face_regions.h"
#include "questions/isolines/face_ways.h"
#include "questions/isolines/isoline_band.h"
#include "questions/isolines/way.h"
#include "solver/curve_segment.h"
#include "surface/anchors.h"

namespace geodesic {

// Gathers the crossings face by face, as soon as a face is settled. All lengths
// are in the mesh's scaled unit.
class LevelCrossings {
 public:
  // `levels` rise and outlive this object, as does `band`, which hears of all
  // windows.
  LevelCrossings(const Mesh& mesh, std::span<const Anchor> anchors,
                 std::span<const double> levels, IsolineBand& band);

  // Called after every few faces.
  using Poll = std::function<absl::Status()>;

  // Deals with the faces that have windows and lie wholly within `settled`,
  // and lets the band forget them.
  // Errors: whatever `poll` returns; this object is of no use then.
  absl::Status Settle(std::span<const double> distances, double settled,
                      const Poll& poll);

  // Deals with all other faces. Distances above the last level may be missing
  // (infinite).
  // Errors: as Settle.
  absl::Status Finish(std::span<const double> distances, const Poll& poll);

  // The isolines, level by level; of each the open ones first. `file_levels`
  // are the levels in the unit of the file. REQUIRES: Finish is OK.
  std::vector<Isoline> Isolines(std::span<const double> file_levels) const;

  uint64_t bytes() const;

 private:
  struct Crossing {
    uint32_t level;
    HalfEdge edge;  // the lowest half-edge of the edge
    double x;       // from the end with the lower number
  };
  // Of crossings_: those of an edge, by level, in order along it. Or of
  // levels_.
  struct Range {
    size_t begin = 0;
    size_t end = 0;
  };
  // What starts in one face, and its distance there.
  struct Within {
    std::vector<std::pair<FacePoint, double>> points;
    std::vector<std::pair<CurveSegment, double>> segments;
  };

  double Farthest(HalfEdge h, std::span<const double> distances) const;
  // The levels that may be found on an edge.
  Range LevelsOn(HalfEdge h, std::span<const double> distances) const;
  Range CrossingsOf(HalfEdge h, std::span<const double> distances);
  // All ways to the points of an edge but those along it from its ends, as seen
  // from its end `from`.
  std::vector<Way> WaysTo(std::span<const HalfEdge> sides, uint32_t from,
                          std::span<const double> distances) const;
  absl::Status DealWith(uint32_t face, std::span<const double> distances,
                        const Poll& poll);
  void JoinCrossings(uint32_t face, uint32_t level,
                     const std::array<Range, 3>& ranges,
                     std::span<const double> distances);
  FaceWays WaysInto(uint32_t face, std::span<const double> distances) const;
  // Adds the isolines that `segments` make between the crossings of one level.
  void AddIsolines(double level, std::span<const uint32_t> of_level,
                   std::span<const Segment> segments,
                   std::vector<Isoline>& isolines) const;
  SurfacePoint PointAt(const Crossing& crossing) const;

  const Mesh& mesh_;
  const std::span<const double> levels_;
  IsolineBand& band_;
  // Sources that are no vertices, in the faces around them.
  absl::flat_hash_map<uint32_t, Within> within_;
  absl::flat_hash_map<HalfEdge, Range> edges_;
  std::vector<Crossing> crossings_;
  uint64_t dealt_with_ = 0;                     // faces
  std::vector<std::vector<Segment>> segments_;  // of each level
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_LEVEL_CROSSINGS_H_
