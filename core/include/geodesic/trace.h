// Straightest geodesics: lines that start at a place in some direction and run
// straight on.
//
//   absl::StatusOr<LineTracer> tracer = LineTracer::From(mesh, VertexPoint{0});
//   absl::StatusOr<TracedLine> line = tracer->Trace(1.5, 10.0, checkpoint);

#ifndef GEODESIC_TRACE_H_
#define GEODESIC_TRACE_H_

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "geodesic_types/trace_end.h"

namespace geodesic {

class Compass;
struct Heading;
class WorkMeter;

// The first direction of a line: an angle in the map that ComputeLogMap makes
// around its place; or a vector in space, of any length: the line then starts
// in the direction of the surface that makes the least angle with it; or a
// place, to which such a vector leads.
using LineDirection = std::variant<double, Point, SurfacePoint>;

// A line that runs straight from each point to the next, through the inside of
// one face or along one edge.
struct TracedLine {
  // Where it starts, where it crosses edges and vertices, and where it ends.
  std::vector<SurfacePoint> points;
  // The same points in space, in the unit of the mesh's file.
  std::vector<Point> positions;
  double length = 0;  // in that unit
  TraceEnd end = TraceEnd::kLength;
};

// Lines of more points are refused: one that runs around a closed surface has
// no end.
inline constexpr uint64_t kMostTracedPoints = 10'000'000;

// Follows lines from one place. Thread-safe.
class LineTracer {
 public:
  // `mesh` outlives the object. O(faces around the place).
  // Errors: INVALID_ARGUMENT, with the path "source": a place that is not on
  // the mesh, or around which the surface is not one oriented disk or
  // half-disk; whatever `checkpoint` returns.
  static absl::StatusOr<LineTracer> From(const Mesh& mesh,
                                         const SurfacePoint& place,
                                         Checkpoint& checkpoint);
  // Not to be stopped.
  static absl::StatusOr<LineTracer> From(const Mesh& mesh,
                                         const SurfacePoint& place);
  LineTracer(LineTracer&&) noexcept;
  LineTracer& operator=(LineTracer&&) noexcept;
  ~LineTracer();

  // Follows a line for `length`, in the unit of the mesh's file, or to where it
  // ends before. It crosses edges straight when the faces on both sides are
  // laid into one plane, and passes vertices with equal angles on its left and
  // right (Polthier and Schmies, "Straightest geodesics on polyhedral
  // surfaces", 1998). Where no other path to its end is shorter, `length` is
  // the distance, and the log map of the place maps the end to this direction
  // and length.
  //
  // O(edges crossed + faces at vertices passed). Polls the checkpoint first and
  // then at least every few thousand of these, with the bytes of the line.
  // Errors: INVALID_ARGUMENT, with the path "direction" or "length": an angle
  // that leads out of the surface, a vector at right angles to it or away from
  // it, a place that is not on the mesh ("direction.vertex"), a length that is
  // negative or NaN, more than kMostTracedPoints; the checkpoint's.
  absl::StatusOr<TracedLine> Trace(const LineDirection& direction,
                                   double length, Checkpoint& checkpoint) const;

 private:
  LineTracer(const Mesh& mesh, const SurfacePoint& place,
             std::unique_ptr<const Compass> compass);
  // REQUIRES: a place is on the mesh. Errors: the compass's.
  absl::StatusOr<Heading> HeadingOf(const LineDirection& direction,
                                    WorkMeter& meter) const;

  const Mesh* mesh_;
  SurfacePoint place_;
  std::unique_ptr<const Compass> compass_;
};

// Many lines. Of sources, directions and lengths there is one for all lines, or
// one for each.
struct LineQuestion {
  std::vector<SurfacePoint> sources;
  std::vector<LineDirection> directions;
  std::vector<double> lengths;
};

// How many lines a question is about. Errors: INVALID_ARGUMENT naming the list
// that is empty or of another length.
absl::StatusOr<uint64_t> CountLines(const LineQuestion& question);

// Calls `take` with the lines from number `begin` up to `end`, in order, as by
// a LineTracer from each source. Thread-safe. REQUIRES: there are so many.
// Errors: as LineTracer, with paths like "sources[2].face" and "lengths[0]";
// those of `take`.
absl::Status TraceLines(const Mesh& mesh, const LineQuestion& question,
                        uint64_t begin, uint64_t end, Checkpoint& checkpoint,
                        absl::FunctionRef<absl::Status(TracedLine line)> take);

}  // namespace geodesic

#endif  // GEODESIC_TRACE_H_
