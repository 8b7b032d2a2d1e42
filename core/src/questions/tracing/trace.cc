// Polthier and Schmies, "Straightest geodesics on polyhedral surfaces", 1998.
//
// Invariant: the heading's place lies in the closed face of its half-edge h, A
// -> B with apex C, in whose frame place and direction are; the line goes on
// into that face.

#include "geodesic/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"
#include "solver/work_meter.h"
#include "surface/compass.h"
#include "tolerances.h"

namespace geodesic {
namespace {

PlanePoint operator+(const PlanePoint& a, const PlanePoint& b) {
  return {a.x + b.x, a.y + b.y};
}
PlanePoint operator*(double factor, const PlanePoint& a) {
  return {factor * a.x, factor * a.y};
}
// A quarter turn to the left.
PlanePoint Left(const PlanePoint& a) { return {-a.y, a.x}; }
PlanePoint Unit(const PlanePoint& a) { return (1 / Norm(a)) * a; }

// Side or corner number i of a face begins at the start of this half-edge.
HalfEdge Turned(HalfEdge h, int i) {
  return i == 0 ? h : i == 1 ? Next(h) : Prev(h);
}

class Walker {
 public:
  Walker(const Mesh& mesh, double length, Checkpoint& checkpoint)
      : mesh_(mesh), rest_(length), checkpoint_(checkpoint) {}

  absl::Status Go(const SurfacePoint& place, const Heading& start) {
    const auto poll = [this] {
      return checkpoint_.Poll(
          {.solver_bytes = line_.points.capacity() * sizeof(SurfacePoint) +
                           line_.positions.capacity() * sizeof(Point)});
    };
    WorkMeter meter(poll);
    Enter(start);
    absl::Status status = Add(Canonicalize(place, mesh_));
    while (status.ok() && !has_ended_) {
      if (!meter.Do(1 + std::exchange(faces_, 0))) return meter.status();
      status = Step();
    }
    return status;
  }

  // In the scaled unit.
  double length() const { return length_; }
  TracedLine Take() && { return std::move(line_); }

 private:
  // Takes a face up.
  void Enter(const Heading& heading) {
    at_ = heading;
    const HalfEdgeFrame& frame = mesh_.frame(at_.half_edge);
    corners_ = {PlanePoint{0, 0}, PlanePoint{frame.length, 0},
                PlanePoint{frame.apex_x, frame.apex_y}};
    sides_ = {PlanePoint{1, 0}, PlanePoint{frame.right_x, frame.right_y},
              PlanePoint{-frame.left_x, -frame.left_y}};
  }

  // To the other side of the face.
  absl::Status Step() {
    std::array<double, 3> left;  // how far each corner is left of the line
    for (int i = 0; i < 3; ++i) {
      left[i] = Cross(at_.direction, corners_[i] - at_.place);
    }
    if (const std::optional<int> corner = CornerAhead(left)) {
      return GoToCorner(*corner);
    }
    const std::optional<int> side = SideAhead(left);
    return side.has_value() ? GoToSide(*side) : EndAt(TraceEnd::kSingular);
  }

  // The corner that the line runs into.
  std::optional<int> CornerAhead(const std::array<double, 3>& left) const {
    std::optional<int> nearest;
    double least = 0;
    for (int i = 0; i < 3; ++i) {
      const double ahead = Dot(at_.direction, corners_[i] - at_.place);
      if (!(ahead > 0) ||
          std::abs(left[i]) > kTracedVertex * (since_vertex_ + ahead) ||
          (nearest.has_value() && ahead >= least)) {
        continue;
      }
      nearest = i;
      least = ahead;
    }
    return nearest;
  }

  // The side through which the line leaves the face: of those that end left of
  // it and begin right of it, the one that is farthest ahead. None in a face
  // without area, perhaps.
  std::optional<int> SideAhead(const std::array<double, 3>& left) const {
    std::optional<int> best;
    double most = 0;
    for (int i = 0; i < 3; ++i) {
      const double begin = left[i], end = left[(i + 1) % 3];
      if (!(begin <= 0 && end >= 0 && end > begin)) continue;
      const double ahead =
          Dot(at_.direction, Along(i, -begin / (end - begin)) - at_.place);
      if (best.has_value() && ahead <= most) continue;
      best = i;
      most = ahead;
    }
    return best;
  }

  // The point of side i at this fraction of it.
  PlanePoint Along(int i, double fraction) const {
    return (1 - fraction) * corners_[i] + fraction * corners_[(i + 1) % 3];
  }

  // Whether the line goes so far; if not, it ends in this face.
  absl::StatusOr<bool> Advance(double ahead) {
    if (ahead < rest_) {
      rest_ -= ahead;
      length_ += ahead;
      since_vertex_ += ahead;
      return true;
    }
    length_ += rest_;
    absl::Status status = Add(PointAt(at_.place + rest_ * at_.direction));
    if (!status.ok()) return status;
    End(TraceEnd::kLength);
    return false;
  }

  absl::Status GoToSide(int side) {
    const double begin = Cross(at_.direction, corners_[side] - at_.place);
    const double end =
        Cross(at_.direction, corners_[(side + 1) % 3] - at_.place);
    const double fraction =
        end > begin ? std::clamp(-begin / (end - begin), 0.0, 1.0) : 0.5;
    const PlanePoint exit = Along(side, fraction);
    const absl::StatusOr<bool> goes_on =
        Advance(std::max(Dot(at_.direction, exit - at_.place), 0.0));
    if (!goes_on.ok() || !*goes_on) return goes_on.status();
    const HalfEdge h = Turned(at_.half_edge, side);
    absl::Status status = Add(
        Canonicalize(EdgePoint{mesh_.From(h), mesh_.To(h), fraction}, mesh_));
    if (!status.ok()) return status;
    if (mesh_.IsBoundaryEdge(h)) return EndAt(TraceEnd::kBoundary);
    if (mesh_.IsNonManifoldEdge(h)) return EndAt(TraceEnd::kSingular);
    // The frame of the other face is this one turned, and for a mirrored face
    // turned over.
    const PlanePoint along = {Dot(at_.direction, sides_[side]),
                              -Dot(at_.direction, Left(sides_[side]))};
    mesh_.ForEachBeyond(h, [&](HalfEdge other, bool is_mirrored) {
      const double length = mesh_.frame(other).length;
      Enter({other,
             {(is_mirrored ? fraction : 1 - fraction) * length, 0},
             Unit({is_mirrored ? along.x : -along.x, std::max(along.y, 0.0)})});
    });
    return absl::OkStatus();
  }

  absl::Status GoToCorner(int corner) {
    const absl::StatusOr<bool> goes_on =
        Advance(Dot(at_.direction, corners_[corner] - at_.place));
    if (!goes_on.ok() || !*goes_on) return goes_on.status();
    const HalfEdge h = Turned(at_.half_edge, corner);
    const uint32_t vertex = mesh_.From(h);
    absl::Status status = Add(VertexPoint{vertex});
    if (!status.ok()) return status;
    if (mesh_.IsNonManifold(vertex)) return EndAt(TraceEnd::kSingular);
    if (mesh_.IsBoundary(vertex)) return EndAt(TraceEnd::kBoundary);
    // Back along the line, from the corner's first side.
    const PlanePoint back = {-Dot(at_.direction, sides_[corner]),
                             -Dot(at_.direction, Left(sides_[corner]))};
    return PassVertex(
        h, std::clamp(std::atan2(back.y, back.x), 0.0, AngleAt(mesh_, h)));
  }

  // Goes on from a vertex, at which the line has come in at this angle from
  // half-edge h, with as much angle on its left as on its right.
  absl::Status PassVertex(HalfEdge h, double angle) {
    double all = 0;
    HalfEdge at = h;
    do {
      ++faces_;
      all += AngleAt(mesh_, at);
      at = mesh_.Twin(Prev(at));
    } while (at != h && at != kNoHalfEdge);
    // Faces that disagree in orientation.
    if (at == kNoHalfEdge) return EndAt(TraceEnd::kSingular);
    double rest = angle + all / 2;
    for (double here; rest > (here = AngleAt(mesh_, at));) {
      rest -= here;
      at = mesh_.Twin(Prev(at));
    }
    Enter({at, {0, 0}, {std::cos(rest), std::sin(rest)}});
    since_vertex_ = 0;
    return absl::OkStatus();
  }

  SurfacePoint PointAt(const PlanePoint& place) const {
    FacePoint point{.face = mesh_.FaceOf(at_.half_edge)};
    const HalfEdgeFrame& frame = mesh_.frame(at_.half_edge);
    const double at_c =
        frame.apex_y > 0 ? std::clamp(place.y / frame.apex_y, 0.0, 1.0) : 0;
    const double at_b = std::clamp(
        frame.length > 0 ? (place.x - at_c * frame.apex_x) / frame.length : 0,
        0.0, 1 - at_c);
    point.weights[at_.half_edge % 3] = 1 - at_c - at_b;
    point.weights[Next(at_.half_edge) % 3] = at_b;
    point.weights[Prev(at_.half_edge) % 3] = at_c;
    return Canonicalize(point, mesh_);
  }

  absl::Status Add(const SurfacePoint& point) {
    if (line_.points.size() == kMostTracedPoints) {
      return InvalidField("length",
                          absl::StrCat("length: the line has more than ",
                                       kMostTracedPoints, " points"));
    }
    line_.points.push_back(NamedIn(mesh_.FaceOf(at_.half_edge), point, mesh_));
    line_.positions.push_back(PositionOf(point, mesh_));
    return absl::OkStatus();
  }

  void End(TraceEnd end) {
    line_.end = end;
    has_ended_ = true;
  }
  absl::Status EndAt(TraceEnd end) {
    End(end);
    return absl::OkStatus();
  }

  const Mesh& mesh_;
  double rest_;  // in the scaled unit, like all lengths here
  Checkpoint& checkpoint_;
  uint64_t faces_ = 0;  // looked at since the last poll
  double length_ = 0;
  double since_vertex_ = 0;
  bool has_ended_ = false;
  Heading at_;
  // Of the face of at_, in its frame: A, B, C, and the unit vectors from each
  // to the next.
  std::array<PlanePoint, 3> corners_;
  std::array<PlanePoint, 3> sides_;
  TracedLine line_;
};

// Where a list has what belongs to line `line`.
template <typename Item>
size_t PlaceOf(uint64_t line, const std::vector<Item>& list) {
  return list.size() == 1 ? 0 : line;
}

// What a question calls its directions of this kind.
const char* NameOf(const LineDirection& direction) {
  constexpr const char* kNames[] = {"angles", "vectors", "towards"};
  return kNames[direction.index()];
}

// An error of a LineTracer, with the path of the item that is at fault.
absl::Status OfItem(const absl::Status& status, const LineQuestion& question,
                    uint64_t line) {
  const std::string path = FieldPathOf(status).value_or("");
  const std::string begin = path.substr(0, path.find('.'));
  std::string item;
  if (begin == "source") {
    item = absl::StrCat("sources[", PlaceOf(line, question.sources), "]");
  } else if (begin == "direction") {
    const size_t place = PlaceOf(line, question.directions);
    item = absl::StrCat(NameOf(question.directions[place]), "[", place, "]");
  } else if (begin == "length") {
    item = absl::StrCat("lengths[", PlaceOf(line, question.lengths), "]");
  } else {
    return status;
  }
  const std::string message(status.message());
  const std::string rest = path.substr(begin.size());
  return InvalidField(item + rest, message.starts_with(begin)
                                       ? item + message.substr(begin.size())
                                       : absl::StrCat(item, ": ", message));
}

}  // namespace

absl::StatusOr<uint64_t> CountLines(const LineQuestion& question) {
  const std::pair<const char*, size_t> lists[] = {
      {"sources", question.sources.size()},
      {question.directions.empty() ? "angles" : NameOf(question.directions[0]),
       question.directions.size()},
      {"lengths", question.lengths.size()}};
  size_t lines = 1;
  for (const auto& [name, size] : lists) lines = std::max(lines, size);
  for (const auto& [name, size] : lists) {
    if (size == 1 || size == lines) continue;
    return InvalidField(name,
                        absl::StrCat(name, " are ", size, " for ", lines,
                                     " lines: name one, or one for each line"));
  }
  return lines;
}

absl::Status TraceLines(const Mesh& mesh, const LineQuestion& question,
                        uint64_t begin, uint64_t end, Checkpoint& checkpoint,
                        absl::FunctionRef<absl::Status(TracedLine line)> take) {
  std::optional<LineTracer> tracer;
  for (uint64_t line = begin; line < end; ++line) {
    const size_t source = PlaceOf(line, question.sources);
    absl::Status status;
    if (line == begin || source > 0) {
      absl::StatusOr<LineTracer> made =
          LineTracer::From(mesh, question.sources[source], checkpoint);
      status = made.status();
      if (made.ok()) tracer = *std::move(made);
    }
    if (!status.ok()) return OfItem(status, question, line);
    absl::StatusOr<TracedLine> traced = tracer->Trace(
        question.directions[PlaceOf(line, question.directions)],
        question.lengths[PlaceOf(line, question.lengths)], checkpoint);
    if (!traced.ok()) return OfItem(traced.status(), question, line);
    status = take(*std::move(traced));
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

absl::StatusOr<LineTracer> LineTracer::From(const Mesh& mesh,
                                            const SurfacePoint& place) {
  NoCheckpoint checkpoint;
  return From(mesh, place, checkpoint);
}

absl::StatusOr<LineTracer> LineTracer::From(const Mesh& mesh,
                                            const SurfacePoint& place,
                                            Checkpoint& checkpoint) {
  absl::Status status = Validate(place, mesh, "source");
  if (!status.ok()) return status;
  const SurfacePoint canonical = Canonicalize(place, mesh);
  const auto poll = [&] { return checkpoint.Poll({}); };
  WorkMeter meter(poll);
  absl::StatusOr<Compass> compass =
      Compass::At(mesh, canonical, [&meter] { return meter.Do(); });
  if (!meter.status().ok()) return meter.status();
  if (!compass.ok()) {
    return InvalidField("source", std::string(compass.status().message()));
  }
  return LineTracer(mesh, canonical,
                    std::make_unique<const Compass>(*std::move(compass)));
}

LineTracer::LineTracer(const Mesh& mesh, const SurfacePoint& place,
                       std::unique_ptr<const Compass> compass)
    : mesh_(&mesh), place_(place), compass_(std::move(compass)) {}
LineTracer::LineTracer(LineTracer&&) noexcept = default;
LineTracer& LineTracer::operator=(LineTracer&&) noexcept = default;
LineTracer::~LineTracer() = default;

absl::StatusOr<Heading> LineTracer::HeadingOf(const LineDirection& direction,
                                              WorkMeter& meter) const {
  const auto goes_on = [&meter] { return meter.Do(); };
  if (const auto* angle = std::get_if<double>(&direction)) {
    return compass_->At(*angle);
  }
  if (const auto* vector = std::get_if<Point>(&direction)) {
    return compass_->Along(*vector, goes_on);
  }
  const Point from = PositionOf(place_, *mesh_);
  Point way = PositionOf(std::get<SurfacePoint>(direction), *mesh_);
  for (int i = 0; i < 3; ++i) way[i] -= from[i];
  return compass_->Along(way, goes_on);
}

absl::StatusOr<TracedLine> LineTracer::Trace(const LineDirection& direction,
                                             double length,
                                             Checkpoint& checkpoint) const {
  if (!(length >= 0)) {
    return InvalidField(
        "length", absl::StrCat("length is ", length, "; it must be >= 0"));
  }
  const auto* place = std::get_if<SurfacePoint>(&direction);
  if (place != nullptr) {
    absl::Status valid = Validate(*place, *mesh_, "direction");
    if (!valid.ok()) return valid;
  }
  absl::Status status = checkpoint.Poll({});
  if (!status.ok()) return status;
  const auto poll = [&] { return checkpoint.Poll({}); };
  WorkMeter meter(poll);
  const absl::StatusOr<Heading> heading = HeadingOf(direction, meter);
  if (!meter.status().ok()) return meter.status();
  if (!heading.ok()) {
    return InvalidField(
        "direction",
        absl::StrCat("direction: ", std::string(heading.status().message())));
  }
  Walker walker(*mesh_, std::ldexp(length, -mesh_->scale_exponent()),
                checkpoint);
  status = walker.Go(place_, *heading);
  if (!status.ok()) return status;
  const double walked = std::ldexp(walker.length(), mesh_->scale_exponent());
  TracedLine line = std::move(walker).Take();
  line.length = line.end == TraceEnd::kLength ? length : walked;
  return line;
}

}  // namespace geodesic
