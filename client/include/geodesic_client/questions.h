// The questions beside fields, as a client asks them and receives the answers.
//
// A member without a comment means what it does in FieldQuery (field.h).
// docs/questions.md says what each question costs.

#ifndef GEODESIC_CLIENT_QUESTIONS_H_
#define GEODESIC_CLIENT_QUESTIONS_H_

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "geodesic_client/answer.h"
#include "geodesic_client/mesh.h"
#include "geodesic_types/places.h"
#include "geodesic_types/trace_end.h"

namespace geodesic::client {

// A line on the surface. It runs straight from each point to the next, through
// the inside of one face or along one edge.
struct Polyline {
  std::vector<SurfacePoint> points;
  // The same points in space, in the unit of the mesh's file.
  std::vector<Point> positions;
};

// Shortest paths.
struct PathQuery {
  std::string mesh_digest;
  // At least one source and one target. A path leads to each target from its
  // nearest source.
  std::vector<Source> sources;
  std::vector<SurfacePoint> targets;
  std::string algorithm = {};
  // Targets farther than this count as not reached. DEFAULT: no limit.
  std::optional<double> radius = {};
  Priority priority = Priority::kInteractive;
};

// A shortest path from a source to a target.
struct GeodesicPath {
  // Number of the source where the path starts; nothing if there is no path.
  std::optional<uint64_t> source;
  // The sum of the source's offset and `length`.
  double distance = std::numeric_limits<double>::infinity();
  double length = std::numeric_limits<double>::infinity();
  // Leads from the source to the target. It crosses edges straight and bends
  // only at saddle and boundary vertices. It has one point if source and target
  // coincide, and none if there is no path.
  Polyline line;
};

// The paths to all targets.
struct PathAnswer {
  AnswerInfo info;
  std::vector<GeodesicPath> paths;  // one per target
};

// Lines of equal distance.
struct IsolineQuery {
  std::string mesh_digest;
  std::vector<Source> sources;
  // Distances in any order; at least one, each finite and above 0. Equal ones
  // count once.
  std::vector<double> levels;
  std::string algorithm = {};
  double tolerance = 0;
  // No chord between two points of a line is farther from the isoline than
  // this, in the unit of the mesh. +infinity: crossings of edges alone, but for
  // lines that stay inside a face. DEFAULT: 0, a thousandth of each level.
  double chord_error = 0;
  Priority priority = Priority::kInteractive;
};

// A line on which the distance is the same everywhere.
struct Isoline {
  double level = 0;
  // Whether the last point leads back to the first; open ones end at a
  // boundary.
  bool is_closed = false;
  // The line's points are exact crossings of edges, and points inside faces as
  // chord_error asks for; or within the tolerance of the query.
  Polyline line;
};

// The lines of all levels.
struct IsolineAnswer {
  AnswerInfo info;
  // In order of level.
  std::vector<Isoline> isolines;
};

// A block of the matrix of all distances, received row by row.
struct MatrixQuery {
  std::string mesh_digest;
  // Each source is a row; at least one.
  std::vector<Source> sources;
  // Each target is a column. DEFAULT: empty, every vertex is a column.
  std::vector<SurfacePoint> targets = {};
  std::string algorithm = {};
  Approximation approximation = {};
  double tolerance = 0;
  ValueType value_type = ValueType::kFloat64;
  std::optional<double> radius = {};
  // Whether to send only the finite values, with their columns.
  bool sparse = false;
  Priority priority = Priority::kInteractive;
};

// How many values a matrix has.
struct MatrixShape {
  uint64_t rows = 0;
  uint64_t columns = 0;
};

// The distances from one source.
struct MatrixRow {
  uint64_t row = 0;
  // The columns of `values`, ascending. Empty in a matrix that is not sparse:
  // its rows hold a value for every column, which is +infinity where no path
  // leads or the search did not get.
  std::span<const uint32_t> columns;
  std::span<const double> values;
};

// Takes the rows of a matrix. If a function returns an error, the call ends
// with it. One row is in memory at a time. A slow receiver slows the server
// down.
struct MatrixReceiver {
  // Called once, first. May be empty.
  std::function<absl::Status(const MatrixShape&)> on_shape;
  // Called for every row, in order; the spans are valid during the call.
  std::function<absl::Status(const MatrixRow&)> on_row;
  // May be empty.
  CountProgressCallback on_progress;
};

// The nearest members of a set.
struct NearestQuery {
  std::string mesh_digest;
  // At least one. Each gets its own nearest targets.
  std::vector<Source> sources;
  // The members of the set; at least one.
  std::vector<SurfacePoint> targets;
  // How many to find for each source; at least 1.
  uint64_t count = 1;
  std::string algorithm = {};
  Approximation approximation = {};
  double tolerance = 0;
  // Targets farther than this are not found. DEFAULT: no limit.
  std::optional<double> radius = {};
  Priority priority = Priority::kInteractive;
};

// A member of the set, and how far it is.
struct NearestTarget {
  // Its number in the query.
  uint64_t target = 0;
  double distance = 0;

  friend bool operator==(const NearestTarget&, const NearestTarget&) = default;
};

// The nearest members for each source.
struct NearestAnswer {
  AnswerInfo info;
  // For each source, its nearest targets ordered by distance and at a tie by
  // number; fewer than asked for where no more can be reached.
  std::vector<std::vector<NearestTarget>> found;
};

// Vertices far from each other.
struct SampleQuery {
  std::string mesh_digest;
  // At least one. The first sample is the vertex farthest from them.
  std::vector<Source> sources;
  // At least 1.
  uint64_t count = 1;
  std::string algorithm = {};
  double tolerance = 0;
  Priority priority = Priority::kInteractive;
};

// A sample, and how far it is from those before it.
struct FarthestSample {
  uint64_t vertex = 0;
  // Measured from the sources and all earlier samples; +infinity for the first
  // sample on a component without any.
  double distance = 0;
};

// The samples, in order.
struct SampleAnswer {
  AnswerInfo info;
  // Only vertices of faces are sampled. There are fewer than asked for if every
  // such vertex is at distance 0 already.
  std::vector<FarthestSample> samples;
};

// The log map lays the surface around a point into the plane by direction and
// distance.
struct LogMapQuery {
  std::string mesh_digest;
  SurfacePoint source;
  std::string algorithm = {};
  ValueType value_type = ValueType::kFloat64;
  // The map ends here. DEFAULT: no limit.
  std::optional<double> radius = {};
  Priority priority = Priority::kInteractive;
};

// The map of a mesh around one of its points.
struct LogMap {
  AnswerInfo info;
  // One per vertex: the distance times (cos, sin) of the angle at which the
  // shortest path leaves the source. NaN where no path leads or beyond the map.
  std::vector<std::array<double, 2>> coordinates;
  // The unit vector in space that has angle 0. Angles grow counterclockwise
  // seen from outside; around a vertex they are scaled to 2 pi for a full turn.
  Point zero_direction{};
};

// Lines that run straight on. Of sources, directions and lengths there is one
// for all lines, or one for each.
struct LineQuery {
  std::string mesh_digest;
  std::vector<SurfacePoint> sources;
  // All of one kind: angles in the log map of the source; or vectors in space,
  // of any length: a line starts in the direction of the surface that makes the
  // least angle with its vector; or places to which such vectors lead.
  std::variant<std::vector<double>, std::vector<Point>,
               std::vector<SurfacePoint>>
      directions;
  // +infinity: to where the line ends.
  std::vector<double> lengths;
  std::string algorithm = {};
  Priority priority = Priority::kInteractive;
};

// A line, straight across edges and past vertices.
struct StraightLine {
  Polyline line;
  double length = 0;
  TraceEnd end = TraceEnd::kLength;
};

// The lines, in order.
struct LineAnswer {
  AnswerInfo info;
  std::vector<StraightLine> lines;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_QUESTIONS_H_
