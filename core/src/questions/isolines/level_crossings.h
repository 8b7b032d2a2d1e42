// Where levels of the distance cross the edges of a mesh, and which crossings
// are joined across its faces.

#ifndef GEODESIC_QUESTIONS_ISOLINES_LEVEL_CROSSINGS_H_
#define GEODESIC_QUESTIONS_ISOLINES_LEVEL_CROSSINGS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/status/status.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "questions/isolines/face_regions.h"
#include "questions/isolines/face_ways.h"
#include "questions/isolines/isoline_band.h"
#include "questions/isolines/way.h"
#include "solver/curve_segment.h"
#include "surface/anchors.h"

namespace geodesic {

// A polyline through edge crossings, as surface points.
struct LevelCurve {
  std::vector<SurfacePoint> points;
  bool is_closed = false;
};

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

  // The curves of each level, open ones first. REQUIRES: Finish is OK.
  std::vector<std::vector<LevelCurve>> Curves() const;

  uint64_t bytes() const;

 private:
  struct Crossing {
    uint32_t level;
    HalfEdge edge;  // the lowest half-edge of the edge
    double x;       // from the end with the lower number
  };
  // A range of crossings_: those of an edge, by level, in order along it.
  struct EdgeRange {
    size_t begin = 0;
    size_t end = 0;
  };
  struct PlacedPoint {
    FacePoint point;
    double sigma;
  };
  struct PlacedSegment {
    CurveSegment segment;
    double sigma;
  };
  // What starts in one face.
  struct Within {
    std::vector<PlacedPoint> points;
    std::vector<PlacedSegment> segments;
  };

  // Levels [begin, end) that may be found on an edge.
  struct LevelRange {
    size_t begin;
    size_t end;
  };

  double Farthest(HalfEdge h, std::span<const double> distances) const;
  LevelRange LevelsOn(HalfEdge h, std::span<const double> distances) const;
  EdgeRange CrossingsOf(HalfEdge h, std::span<const double> distances);
  // All ways to the points of an edge but those along it from its ends, as seen
  // from its end `from`.
  std::vector<Way> WaysTo(std::span<const HalfEdge> sides, uint32_t from,
                          std::span<const double> distances) const;
  absl::Status DealWith(uint32_t face, std::span<const double> distances,
                        const Poll& poll);
  void JoinCrossings(uint32_t face, uint32_t level,
                     const std::array<EdgeRange, 3>& ranges,
                     std::span<const double> distances);
  FaceWays WaysInto(uint32_t face, std::span<const double> distances) const;
  std::vector<LevelCurve> CurvesOf(std::span<const uint32_t> crossings,
                                   const std::vector<Segment>& segments) const;
  SurfacePoint PointAt(const Crossing& crossing) const;

  const Mesh& mesh_;
  const std::span<const double> levels_;
  IsolineBand& band_;
  // Sources that are no vertices, in the faces around them.
  absl::flat_hash_map<uint32_t, Within> within_;
  absl::flat_hash_map<HalfEdge, EdgeRange> edges_;
  std::vector<Crossing> crossings_;
  uint64_t dealt_with_ = 0;                     // faces
  std::vector<std::vector<Segment>> segments_;  // of each level
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_LEVEL_CROSSINGS_H_
