#include "questions/first_path/taut_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "solver/windows/window.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// A round moves each piece past one row of vertices. A path that needs more
// than so many is as good as straight by then, on real meshes, or winds.
constexpr int kMostRounds = 256;

// So many rounds that shorten the path by no more than this fraction together
// are the last. In a strip of faces one long piece may take up thousands of
// short ones, one a round, and gains 3e-8 at the most by each.
constexpr int kRoundsToGain = 16;
constexpr double kLeastGain = 1e-6;

// Between two polls, in half-edges: about a millisecond.
constexpr uint64_t kPollPeriod = 1 << 16;

// One direction as seen if the other is the x axis.
PlanePoint SeenFrom(const PlanePoint& axis, const PlanePoint& way) {
  return {Dot(axis, way), Cross(axis, way)};
}

}  // namespace

void TautPath::Line::Clear() {
  pieces.clear();
  portals.clear();
}

std::span<const Portal> TautPath::Line::PortalsOf(const Piece& piece) const {
  return std::span(portals).subspan(piece.first, piece.last - piece.first);
}

void TautPath::Line::Add(Piece piece, std::span<const Portal> through) {
  piece.first = static_cast<uint32_t>(portals.size());
  portals.insert(portals.end(), through.begin(), through.end());
  piece.last = static_cast<uint32_t>(portals.size());
  pieces.push_back(piece);
}

double TautPath::Line::Length() const {
  double length = 0;
  for (const Piece& piece : pieces) length += piece.length;
  return length;
}

absl::Status TautPath::Draw(const Place& begin, const Route& route,
                            const Place& end,
                            absl::FunctionRef<absl::Status()> poll) {
  length_ = std::numeric_limits<double>::infinity();
  bends_.clear();
  if (!Follow(begin, route, end)) return absl::OkStatus();
  uint64_t steps = kPollPeriod;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kMostRounds && Tighten(); ++round) {
    if (round % kRoundsToGain == 0) {
      const double now = line_.Length();
      if (now >= before * (1 - kLeastGain)) break;
      before = now;
    }
    steps += line_.pieces.size() + line_.portals.size();
    if (steps < kPollPeriod) continue;
    steps = 0;
    if (absl::Status status = poll(); !status.ok()) return status;
  }
  length_ = 0;
  for (const Piece& piece : line_.pieces) {
    if (length_ > 0) bends_.push_back({piece.begin.vertex, length_});
    length_ += piece.length;
  }
  return absl::OkStatus();
}

uint64_t TautPath::bytes() const {
  return (line_.pieces.capacity() + next_.pieces.capacity()) * sizeof(Piece) +
         (line_.portals.capacity() + next_.portals.capacity() +
          strip_.capacity()) *
             sizeof(Portal) +
         (left_.through.capacity() + right_.through.capacity()) *
             sizeof(HalfEdge) +
         bends_.capacity() * sizeof(Bend) + funnel_.bytes();
}

bool TautPath::Follow(const Place& begin, const Route& route,
                      const Place& end) {
  line_.Clear();
  Place from = begin;
  for (const Route::Step& step : route.steps) {
    const Place to = Place::At(step.to);
    if (from.vertex == to.vertex) continue;
    strip_.clear();
    for (uint32_t i = step.first; i < step.last; ++i) Append(route.portals[i]);
    if (!AddThroughStrip(from, to, line_)) return false;
    from = to;
  }
  if (end.is_vertex()) return true;
  strip_.clear();
  return AddThroughStrip(from, end, line_);
}

// A round: joins pieces where the path bends and need not. Returns whether it
// is another path.
bool TautPath::Tighten() {
  bool is_another = false;
  next_.Clear();
  for (size_t i = 0; i < line_.pieces.size();) {
    const Run run = RunFrom(i);
    const size_t before = next_.pieces.size();
    if (run.is_bent && AddThroughStrip(line_.pieces[i].begin,
                                       line_.pieces[run.last].end, next_)) {
      if (before > 0) next_.pieces[before - 1].is_settled = false;
      is_another = true;
      i = run.last + 1;
      continue;
    }
    for (; i <= run.last; ++i) {
      line_.pieces[i].is_settled = true;
      next_.Add(line_.pieces[i], line_.PortalsOf(line_.pieces[i]));
    }
  }
  std::swap(line_, next_);
  return is_another;
}

// The pieces from `first` on that meet with no more than half a turn. Leaves
// their strips and the smaller sides between them in strip_.
TautPath::Run TautPath::RunFrom(size_t first) {
  const std::vector<Piece>& pieces = line_.pieces;
  Run run{.last = first};
  strip_.clear();
  while (run.last + 1 < pieces.size() &&
         (run.is_bent || !pieces[run.last].is_settled) &&
         FindSmallerSide(pieces[run.last], pieces[run.last + 1])) {
    if (run.last == first) Append(line_.PortalsOf(pieces[first]));
    for (const HalfEdge h : left_.through) Append(h);
    Append(line_.PortalsOf(pieces[++run.last]));
    run.is_bent = run.is_bent || left_.is_bent;
  }
  return run;
}

// Leaves in left_ the side on which one piece meets the next with no more than
// half a turn; the smaller one, if neither is more.
bool TautPath::FindSmallerSide(const Piece& in, const Piece& out) {
  const bool has_left = Turn<true>(in.arrives, out.leaves, left_);
  const bool has_right = Turn<false>(in.arrives, out.leaves, right_);
  if (!has_left && !has_right) return false;
  if (!has_left || (has_right && Cross(right_.turn, left_.turn) > 0)) {
    std::swap(left_, right_);
  }
  return true;
}

// Turns from one direction at a vertex to another. False if that is more than
// half a turn, or the faces end there.
template <bool kClockwise>
bool TautPath::Turn(const Direction& from, const Direction& to,
                    Side& side) const {
  // Angles count in the sense of the turn.
  const auto between = [](const PlanePoint& a, const PlanePoint& b) {
    return kClockwise ? SeenFrom(b, a) : SeenFrom(a, b);
  };
  const auto is_straight = [](const PlanePoint& turn) {
    return turn.x < 0 && std::abs(turn.y) <= kTautAngle * -turn.x;
  };
  // The sides of a face at the vertex; a turn enters at one and leaves at the
  // other.
  const auto face_side = [this](HalfEdge spoke, bool is_left) {
    const HalfEdgeFrame& frame = mesh_.frame(spoke);
    return is_left ? PlanePoint{frame.left_x, frame.left_y} : PlanePoint{1, 0};
  };
  side.through.clear();
  if (from.spoke == to.spoke) {
    side.turn = between(from.way, to.way);
    side.is_bent = !is_straight(side.turn);
    if (side.turn.y >= 0 || !side.is_bent) return true;
  }
  side.turn = between(from.way, face_side(from.spoke, !kClockwise));
  HalfEdge spoke = from.spoke;
  for (;;) {
    const HalfEdge through = mesh_.Twin(kClockwise ? spoke : Prev(spoke));
    if (through == kNoHalfEdge) return false;
    side.through.push_back(through);
    spoke = kClockwise ? Next(through) : through;
    const bool is_last = spoke == to.spoke;
    const PlanePoint more =
        between(face_side(spoke, kClockwise),
                is_last ? to.way : face_side(spoke, !kClockwise));
    side.turn = Product(side.turn, more);
    side.is_bent = !is_straight(side.turn);
    if (side.turn.y < 0 && (side.is_bent || !is_last)) return false;
    if (spoke == from.spoke) return false;
    if (is_last) return true;
  }
}

// To strip_, without ways back.
void TautPath::Append(HalfEdge h) {
  if (strip_.empty()) {
    strip_.push_back(Portal::First(mesh_, h));
  } else if (mesh_.Twin(h) == strip_.back().half_edge) {
    strip_.pop_back();
  } else {
    strip_.push_back(Portal::After(mesh_, strip_.back().half_edge, h));
  }
}

void TautPath::Append(std::span<const Portal> portals) {
  size_t first = 0;
  for (bool is_longer = false; first < portals.size() && !is_longer; ++first) {
    const size_t before = strip_.size();
    Append(portals[first].half_edge);
    is_longer = strip_.size() > before;
  }
  // What follows on that is turned as before.
  strip_.insert(strip_.end(), portals.begin() + first, portals.end());
}

// Adds the shortest path through strip_ from one place to another. False if the
// strip does not lead there.
bool TautPath::AddThroughStrip(const Place& begin, const Place& end,
                               Line& line) {
  // What turns around the ends leads nowhere.
  while (!strip_.empty() && end.EndsAt(mesh_, strip_.back().half_edge)) {
    strip_.pop_back();
  }
  strip_.erase(strip_.begin(),
               std::ranges::find_if(strip_, [&](const Portal& portal) {
                 return !begin.EndsAt(mesh_, portal.half_edge);
               }));
  if (strip_.empty()) {
    Piece piece{.begin = begin, .end = end};
    if (!SetWithinFace(piece)) return false;
    line.Add(piece, {});
    return true;
  }
  const HalfEdge back = mesh_.Twin(strip_.front().half_edge);
  if (back == kNoHalfEdge || !begin.LiesAcross(mesh_, back) ||
      !end.LiesAcross(mesh_, strip_.back().half_edge)) {
    return false;
  }
  AddBends(begin, end, line);
  return true;
}

void TautPath::AddBends(const Place& begin, const Place& end, Line& line) {
  const std::span<const Portal> strip = strip_;
  const auto half_edge = [&](uint32_t i) { return strip[i].half_edge; };
  // From the face before it, the first portal runs the other way.
  const PlanePoint begin_at = begin.Across(mesh_, mesh_.Twin(half_edge(0)));
  funnel_.Find(strip, {strip[0].length - begin_at.x, -begin_at.y},
               end.Across(mesh_, strip.back().half_edge));
  Place from = begin;
  PlanePoint from_at = funnel_.begin();
  uint32_t first = 0;
  for (const Funnel::Bend& bend : funnel_.bends()) {
    const uint32_t last = bend.portal;
    Place to = end;
    if (last < strip.size()) {
      to = Place::At(bend.is_left ? mesh_.From(half_edge(last))
                                  : mesh_.To(half_edge(last)));
    }
    while (first < last && from.EndsAt(mesh_, half_edge(first))) ++first;
    Piece piece{.begin = from, .end = to};
    if (first == last) {
      SetWithinFace(piece);
    } else {
      const PlanePoint way = bend.at - from_at;
      piece.length = Norm(way);
      if (from.is_vertex()) {
        piece.leaves = {Prev(mesh_.Twin(half_edge(first))),
                        SeenFrom(funnel_.Right(first) - from_at, way)};
      }
      if (to.is_vertex()) {
        piece.arrives = {
            Prev(half_edge(last - 1)),
            SeenFrom(funnel_.Left(last - 1) - bend.at, from_at - bend.at)};
      }
    }
    line.Add(piece, strip.subspan(first, last - first));
    from = to;
    from_at = bend.at;
    first = last;
  }
}

// Sets what a piece through no portal has. False if its ends share no face.
bool TautPath::SetWithinFace(Piece& piece) const {
  const Place& begin = piece.begin;
  const Place& end = piece.end;
  if (begin.is_vertex() && end.is_vertex()) {
    const std::vector<HalfEdge> sides =
        SidesOf(mesh_, begin.vertex, end.vertex);
    if (sides.empty()) return false;
    const HalfEdge h = sides[0];
    const Direction along{h, {1, 0}};
    const Direction back{Next(h), ApexOf(mesh_.frame(Next(h)))};
    const bool is_forward = mesh_.From(h) == begin.vertex;
    piece.leaves = is_forward ? along : back;
    piece.arrives = is_forward ? back : along;
    piece.length = mesh_.frame(h).length;
    return true;
  }
  if (!begin.is_vertex() && !end.is_vertex()) {
    const HalfEdge h = mesh_.FirstSide(begin.point.face);
    piece.length =
        Norm(InFrame(mesh_, end.point, h) - InFrame(mesh_, begin.point, h));
    return begin.point.face == end.point.face;
  }
  const Place& vertex = begin.is_vertex() ? begin : end;
  const FacePoint& point = begin.is_vertex() ? end.point : begin.point;
  HalfEdge spoke = mesh_.FirstSide(point.face);
  for (int i = 0; i < 3 && mesh_.From(spoke) != vertex.vertex; ++i) {
    spoke = Next(spoke);
  }
  const PlanePoint way = InFrame(mesh_, point, spoke);
  (begin.is_vertex() ? piece.leaves : piece.arrives) = {spoke, way};
  piece.length = Norm(way);
  return mesh_.From(spoke) == vertex.vertex;
}

}  // namespace geodesic
