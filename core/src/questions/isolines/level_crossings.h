// Where levels of the distance cross a mesh, gathered face by face.

#ifndef GEODESIC_QUESTIONS_ISOLINES_LEVEL_CROSSINGS_H_
#define GEODESIC_QUESTIONS_ISOLINES_LEVEL_CROSSINGS_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/isolines.h"
#include "geodesic/mesh.h"
#include "questions/isolines/chaining.h"
#include "questions/isolines/face_sources.h"
#include "questions/isolines/face_ways.h"
#include "questions/isolines/isoline_band.h"
#include "questions/isolines/level_tracer.h"
#include "questions/isolines/way.h"
#include "solver/curve_segment.h"
#include "surface/anchors.h"

namespace geodesic {

// Where levels cross the edges of a mesh, and the isolines inside its faces.
//
// Deals with each face as soon as it is settled. All lengths are in the mesh's
// scaled unit.
class LevelCrossings {
 public:
  struct Accuracy {
    double chord_error = 0;  // of each level; relative to it if `is_relative`
    bool is_relative = false;
    // How far windows of two faces may be apart on their edge, as a part of the
    // level.
    double share = 0;
  };

  // `levels` rise and outlive this object, as does `band`, which hears of all
  // windows.
  LevelCrossings(const Mesh& mesh, std::vector<Anchor> anchors,
                 std::span<const double> levels, const Accuracy& accuracy,
                 IsolineBand& band);

  // Called after every few faces, levels in a face, ways in it and samples.
  using Poll = std::function<absl::Status()>;

  // Deals with the faces that have windows and lie wholly within `settled`,
  // and lets the band forget them.
  // Errors: INVALID_ARGUMENT for too many samples; whatever `poll` returns.
  // This object is of no use then.
  absl::Status Settle(std::span<const double> distances, double settled,
                      const Poll& poll);

  // Deals with all other faces. Distances above the last level may be missing
  // (infinite).
  // Errors: as Settle.
  absl::Status Finish(std::span<const double> distances, const Poll& poll);

  // The isolines, level by level; of each the open ones first, and those inside
  // a face last. `file_levels` are the levels in the unit of the file.
  // REQUIRES: Finish is OK.
  // Errors: whatever `poll` returns.
  absl::StatusOr<std::vector<Isoline>> Isolines(
      std::span<const double> file_levels, const Poll& poll);

  // Why isolines may have lost a piece.
  enum class Doubt : uint8_t {
    kNone,
    kRounded,  // rounding has decided how one runs through a face
    kMeeting   // fronts touch in a point
  };
  // Of each level, the greatest.
  const std::vector<Doubt>& doubts() const { return doubts_; }

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
  // A crossing on a face's perimeter.
  struct Place {
    PlanePoint place;
    uint32_t crossing = 0;
    bool is_taken = false;
  };
  // An isoline inside a face.
  struct Loop {
    uint32_t face = 0;
    uint32_t first_sample = 0;
    uint32_t sample_count = 0;
  };

  absl::Status Work(uint64_t amount, const Poll& poll);
  double Farthest(HalfEdge h, std::span<const double> distances) const;
  // The levels that may be found on an edge, or in a face but for edges.
  Range LevelsOn(HalfEdge h, std::span<const double> distances) const;
  Range LevelsIn(uint32_t face, std::span<const double> distances) const;
  absl::StatusOr<Range> CrossingsOf(HalfEdge h,
                                    std::span<const double> distances,
                                    const Poll& poll);
  // Adds all ways to the points of an edge by its side h but those along it
  // from its ends, as seen from its end `from`.
  void AddWaysTo(HalfEdge h, uint32_t from, std::span<const double> distances,
                 std::vector<Way>& ways) const;
  absl::Status AddWays(uint32_t face, std::span<const double> distances,
                       FaceWays& ways, const Poll& poll);

  absl::Status DealWith(uint32_t face, std::span<const double> distances,
                        const Poll& poll);
  // Those of a range of crossings_ that are at the level.
  Range AtLevel(const Range& range, uint32_t level) const;
  // The crossings of a level around a face: where the isoline enters it and
  // where it leaves.
  std::array<std::vector<Place>, 2> Perimeter(
      const FaceWays& ways, uint32_t face, uint32_t level,
      const std::array<Range, 3>& ranges,
      std::span<const double> distances) const;
  // Whether a chord is known to be near enough to the only isoline in a face.
  // `directions`: of all ways that may have a front there.
  absl::StatusOr<bool> IsChordEnough(FaceWays& ways, uint32_t level,
                                     const DirectionCone& directions,
                                     const Place& entry, const Place& exit,
                                     const FaceWays::Step& step) const;
  absl::Status DrawLevel(FaceWays& ways, uint32_t face, uint32_t level,
                         std::vector<Place> entries, std::vector<Place> exits,
                         const Poll& poll);
  double ChordError(uint32_t level) const {
    return accuracy_.chord_error * (accuracy_.is_relative ? levels_[level] : 1);
  }
  void SetDoubt(size_t level, Doubt doubt) {
    doubts_[level] = std::max(doubts_[level], doubt);
  }
  void Join(uint32_t level, const Place& entry, Place& exit,
            uint32_t first_sample);

  // The numbers of crossings in order of levels, of edges and along these.
  absl::StatusOr<std::vector<uint32_t>> InOrder(const Poll& poll);
  SurfacePoint PointAt(const Crossing& crossing) const;
  SurfacePoint PointAt(const FacePoint& sample) const;
  void AddIsoline(double level, std::vector<SurfacePoint> points,
                  bool is_closed, std::vector<Isoline>& isolines);
  // Those that `segments` make between the crossings of one level.
  absl::Status AddIsolines(double level, std::span<const uint32_t> of_level,
                           std::span<const Segment> segments, const Poll& poll,
                           std::vector<Isoline>& isolines);

  const Mesh& mesh_;
  const std::span<const double> levels_;
  const Accuracy accuracy_;
  IsolineBand& band_;
  const std::vector<Anchor> anchors_;
  const FaceSources sources_;
  absl::flat_hash_map<HalfEdge, Range> edges_;
  std::vector<Crossing> crossings_;
  uint64_t work_ = 0;
  // Inside faces; of segments and loops, each of which has some in a row. They
  // are too many to be moved in one go.
  std::deque<FacePoint> samples_;
  std::vector<std::vector<Segment>> segments_;  // of each level
  std::vector<std::vector<Loop>> loops_;        // of each level
  std::vector<Doubt> doubts_;                   // of each level
  uint64_t isoline_bytes_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_LEVEL_CROSSINGS_H_
