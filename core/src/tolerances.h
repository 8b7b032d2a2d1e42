// Every tolerance of the solver, with its reason. Lengths are in the mesh's
// scaled unit unless a ratio is named.

#ifndef GEODESIC_TOLERANCES_H_
#define GEODESIC_TOLERANCES_H_

namespace geodesic {

// A vertex whose angle exceeds 2 pi (at a boundary: pi) by no more than this is
// flat: the rounding of a hundred angles. It hides a wedge of that angle from
// the windows that pass it. What lies in there they miss narrowly (kNearMiss),
// and it is reached all the same. That would do for larger angles too, but each
// such vertex would open windows in all directions, not only in the wedge.
inline constexpr double kFlatAngle = 1e-13;

// A face whose height over its longest edge is below this fraction of that edge
// lets no ray of any width through along itself: one rounding of its middle
// corner's place turns such a ray by more than kFanMargin. Its corners become
// pseudo-sources, so that paths pass through them and along its edges; one that
// is no higher over the opposite edge than this lies on it.
inline constexpr double kCollapsedFace = 1e-10;

// A pseudo-source that lies on an edge in this sense is taken to see all that
// lies beyond the edge, if an end of the edge hides a wedge of no more than
// this angle. A line through the wedge is shorter than the way round the end by
// half the square of the angle.
inline constexpr double kHiddenWedge = 1e-7;

// Least distance of an apex or a pseudo-source from an edge's line. It keeps
// quotients defined on faces without area. Its square vanishes, so it adds
// nothing to any distance.
inline constexpr double kLeastHeight = 1e-170;

// A window narrower than this fraction of its edge is dropped. It is a few
// thousand roundings of a position, and no vertex is lost with it: vertices
// are relaxed through the nearest end of a window that misses them narrowly.
inline constexpr double kLeastWidth = 1e-12;

// A window whose pseudo-source lies beside the edge is dropped only if it is
// narrow beside the way from there too (a vertex 1e-12 above the edge sees half
// a plane through a gap no wider), or narrower than this fraction of the edge:
// some roundings of a position.
inline constexpr double kRoundedWidth = 1e-15;

// A window that misses the apex by no more than this fraction of its reach (the
// edge and the way from the pseudo-source), seen across the ray, relaxes it
// through its nearest end, which is a real path, longer by the square of this.
// Nobody else may reach the apex: on regular grids rays run exactly into
// vertices, and rounding, which goes with the reach, puts them on either side;
// and where paths by way of two pseudo-sources tie over a whole interval
// (kTie), as on plates that are all but flat, their rays part at the point up
// to which either of them holds it, by up to sqrt(8 kTie), 1e-7, and a few
// times that where one of the pseudo-sources is much nearer.
inline constexpr double kNearMiss = 2e-7;

// A vertex that is missed so by more than this fraction of the least height of
// the faces around it is a pseudo-source, whatever its angle: some of those
// faces may lie whole in the gap that the windows leave, where only this vertex
// is left to pass anything on. By less, the gap is too narrow for a face, and
// the direction of the ray is off by less than kFanMargin.
inline constexpr double kMissedFaces = 1e-7;

// The same where sources are curves. A segment and the point in which it ends
// share the ray that bounds both their windows; in either it is off by the
// rounding of the end's place over its distance from the nearest vertex, 1e-7
// where that is 1e-9 of an edge, and nothing else fills the gap. A path through
// the nearest end of a window is longer by the square of this.
inline constexpr double kNearMissOfCurves = 1e-6;

// A weight of a surface point that is no larger is 0: it moves the point by far
// less than one rounding of its face's corners, but leaves distances of 1e-200
// beside others of 0, which no relative tolerance can compare.
inline constexpr double kLeastWeight = 1e-18;

// A source no farther from a vertex than this fraction of the longest edge
// there lets paths bend at the vertex, like a saddle. Its place is rounded by
// about 1e-16 of that edge, so the directions in which it sees what lies behind
// the vertex may be off by more than kNearMiss; the way through the vertex is
// longer only by the square of that.
inline constexpr double kNearVertex = 1e-5;

// A way from a pseudo-source that is no longer than this is held against the
// straight line through space. Some dozen roundings, those of a few faces laid
// into the plane, are 1e-14, and more than a part in 1e10 of such a way.
inline constexpr double kShortWay = 1e-4;

// By how much the fan behind a pseudo-source is widened on either side, in
// radians. Directions are kept in single precision, 3e-8; the paths of this
// margin are longer by the square of it.
inline constexpr double kFanMargin = 1e-6;

// A distance is replaced only when it improves by more than this fraction:
// one rounding. Equal paths found twice would otherwise restart propagation.
inline constexpr double kImprovement = 1e-15;

// A window is discarded as dominated only when it loses by more than this
// fraction. Equality happens by construction (a window that bounds a vertex's
// own distance), and must not discard it.
inline constexpr double kDominance = 1e-12;

// Two neighbouring windows are merged only if they end and begin at one place,
// with one distance, up to this fraction of the least distance of either, and
// if the merged one is farther nowhere by more than that: some hundred
// roundings. Where they differ by more a window was lost in between, or is
// late.
inline constexpr double kAgreed = 1e-13;

// A merged window lies between two rays, whose directions follow from distances
// along the edge. These are rounded, so directions are off by a rounding of the
// distance over the width of the beam, seen along it. Beams narrower than this
// fraction of the distance (or of the edge) are not merged: that keeps
// directions good to 1e-9, far below kNearMiss.
inline constexpr double kLeastBeam = 1e-7;

// The origin of a merged window is no farther away than this many times the
// distance of the edge: its own rounding is then far below kAgreed, and rays
// are as good as parallel.
inline constexpr double kFarthestMerged = 64;

// How far an account is off for each merge, as a fraction of the distances that
// come in: a dozen roundings.
inline constexpr double kMergedRounding = 2e-15;

// A merge may spend this part of what an account may hold in all: so the path
// to a far vertex has something left for each of the edges that it crosses. It
// spends no more than this part of its label either: what is off by more loses
// to other windows here and there, which makes more windows than are saved.
inline constexpr double kPartOfAccount = 1.0 / 32;
inline constexpr double kMostOfLabel = 1e-4;

// Looser tolerances are answered within this one. There half-edges hold little
// more than one window, so nothing is left to merge; and the more paths to
// vertices may be off, the more windows that lose to them are kept: a looser
// account makes 5 % fewer windows at the most (a terrain of 500,000 faces), and
// 40 % more on a dragon of 1.6 million.
inline constexpr double kLoosestOfUse = 2e-3;

// Answers lie above lower bounds by this part of what accounts leave open. Each
// merge charges the most that it may be off, so the truth is low: on average at
// 0.02 to 0.3 of an account, on four meshes and tolerances of 1e-6 to 1e-2. At
// most a half: what is certified is the rest.
inline constexpr double kAnswerInAccount = 0.25;

// Two rays into an apex whose leans (sines) differ by no more than this may be
// one ray: unfolded positions carry up to 1e-13 of rounding. Nothing is pruned
// then, which costs windows on regular grids only.
inline constexpr double kSameRay = 1e-9;

// Two windows on an edge whose distances differ by no more than this fraction
// at a point are tied there; WonByNewer says which keeps the point.
inline constexpr double kTie = 1e-15;

// They are tied too where they differ by no more than this fraction of the
// point's distance from the edge's begin, which is how well its place is known.
// Otherwise a window that goes round a source at a vertex, through faces of
// hardly any angle there, would win by such roundings without end.
inline constexpr double kRoundedPosition = 0x1p-52;

// A window between two pieces of another goes if it is tied with that one by
// this many times either: where windows differ by one tie, rounding has cut the
// pieces.
inline constexpr double kFragmentTies = 2;

// On meshes with faces without area, a tie by this fraction of the edge and the
// distances as well. Windows can go round a loop of such faces at no length,
// and rounding, which goes with the edges, would make them a little nearer
// every time, without end. They tie with ways through an edge's ends by this,
// too, but there by the longest edge of the face, whose rounding shows on short
// ones beside it, and by no more than kAlongEdge of their least distance. Nor
// is a vertex nearer by so little.
inline constexpr double kLoopTie = 4e-15;

// Where two windows change over, their distances agree within this many times
// kTie. Closer is not worth an iteration: the closed form's rounding alone
// gives a few.
inline constexpr double kCrossingRoundings = 8;

// Vertices whose distances differ by no more than this fraction tie for
// farthest: a symmetric mesh gives equal distances with different roundings,
// and samples should not depend on these.
inline constexpr double kTiedSamples = 1e-12;

// A path that passes a vertex no farther than this fraction of its reach (as
// for kNearMiss) is led through it, if that makes it no longer: rays that run
// into vertices pass them by rounding.
inline constexpr double kPassedVertex = 4e-9;

// The same where a path is not found otherwise. The straight line to a vertex
// that a window missed narrowly may pass the vertex that bounds the window on
// the wrong side, by as much as the miss, and there the surface unfolds
// differently.
inline constexpr double kPassedNarrowly = 4 * kNearMiss;

// A vertex whose distance is within this fraction of a level lies at it: on
// regular grids whole rows do, and rounding would otherwise scatter the
// crossings around them.
inline constexpr double kAtLevel = 1e-12;

// Fronts of a level that meet on an edge, and lie over each other there by no
// more than this part of the level and the edge, touch in a point, and rounding
// decides whether they are one. Isolines are then drawn beside the level, by
// these parts of it: more than rounding, and less than distances that are exact
// within 1e-10 tell.
inline constexpr double kMeetingPoint = 4e-12;
inline constexpr double kBesideLevel[] = {-8e-12, 8e-12, -4e-11, 4e-11};

// A straight piece of a path is as long as the distances of its ends say within
// this fraction of them. Pieces that are followed rightly agree to 1e-13.
inline constexpr double kAsLong = 1e-11;

// A piece of a path whose way rounding has bent misses the distances of its
// ends by no more than this, beside kAsLong: some dozen roundings of
// coordinates, which are about 1 at the most.
inline constexpr double kRoundedPlace = 1e-14;

// A walk back along a path has gone astray where a vertex is farther, by this
// fraction of the path, than along the walk: far more than rounding, far less
// than an edge. Beside kRoundedPlace, for paths of hardly any length.
inline constexpr double kAstray = 1e-6;

// A stretch between two points of a path that is shorter than this fraction of
// the path gives it no direction there: its ends are off by about 1e-15 of it.
// Asked only beside faces without area, which have no plane to tell it.
inline constexpr double kDirectionless = 1e-9;

// A face whose height is less than this fraction of its longest edge is thin:
// windows may miss vertices beside it. Where all faces were 1e-4 as high or
// higher, none was missed in a million searches on random strips and tubes.
inline constexpr double kThinFace = 1e-3;

// A vertex that is farther than the way along an edge from a neighbour by more
// than this fraction was missed by windows. It is below what distances are
// promised to be good to, and far above the rounding of one edge.
inline constexpr double kAlongEdge = 1e-11;

// A lower bound on the rest of a way is lowered by this: some roundings of
// coordinates and distances, which are about 1.
inline constexpr double kGoalRounding = 1e-14;

// A directed search goes on until what is pending exceeds the distance of its
// target by this fraction, and drops what exceeds it: the error that distances
// are promised to stay below.
inline constexpr double kGoalMargin = 1e-10;

// A first path that lacks no more than this to half a turn at a vertex, in
// radians, is straight there: around it a path is shorter by less than the
// square of this, and half-edges would be swapped for the sake of rounding.
inline constexpr double kTautAngle = 1e-7;

// Directions that differ by no more than this, in radians, are the same but for
// the rounding of the angles that they are sums of, at a vertex of some
// thousand faces.
inline constexpr double kRoundedAngle = 1e-12;

// A straight line that passes a vertex no farther than this fraction of its way
// since the last one runs into it: each edge that it crosses turns it by a
// rounding.
inline constexpr double kTracedVertex = 1e-13;

// Distances from landmarks are kept as whole steps of 1.5e-5 to 3e-5 of the
// mesh's size. Bounds allow for this part of a step beside: half of it for
// fields whose distances differ along an edge by more than its length, half,
// 7e-9 of the mesh, for the rounding of all that they are made of.
inline constexpr double kLandmarkRounding = 0x1p-10;

// A source's offset in sizes of the mesh may not exceed this. Labels are sums
// with it: a part in 2^53 of it is their grain, and what is shorter is a tie.
// From 1e8 on ties multiply the windows of the Chen-Han rules on meshes with
// short edges; from 1e15 on, where an edge is a grain, no rule comes to an end.
inline constexpr double kMostOffset = 1e6;

// Of the heat method: where a face's two shorter sides together exceed its
// longest by less than this fraction of the mean edge length, all edges are
// made longer by what is missing. Cotangents then stay below a million or so,
// and distances change by about this fraction of an edge for each edge on their
// way, far less than the method is off (Sharp and Crane 2020 take the same).
inline constexpr double kMollified = 1e-5;

// An edge is turned only if the cotangents opposite to it sum to less than
// minus this, or rounding would turn edges of squares to and fro.
inline constexpr double kNotDelaunay = 1e-9;

// Arcs of the saddle vertex graph are rounded to single precision, by 6e-8 of
// them at the most. A directed search goes on until what is pending exceeds the
// distance of its target by this fraction.
inline constexpr double kArcRounding = 2e-7;

// Two places that were computed in two ways, such as the ends of a circle, and
// are the same differ by this many roundings of the mesh's extent: sin 2 pi is
// 1.5 roundings of the radius in single precision.
inline constexpr double kComputedTwice = 1;

// Two equal places differ by one unit of the last digit along an axis, where
// they were rounded to either side of it; the rest is for the difference's own
// rounding.
inline constexpr double kWrittenTwice = 1.01;

// Vertices farther from the middle of a mesh than this many times the extent of
// its middle half do not count for the rounding of the others.
inline constexpr double kFarOff = 100;

// Programs that round to decimal numbers leave a unit of the last digit that is
// a smaller part of the mesh than this. A unit that is larger is a distance
// that somebody has chosen.
inline constexpr double kMostDecimalRounding = 1e-5;

// The rounding of the largest coordinate counts along the other axes, too, as
// where a mesh was turned far from the origin, but no more of it than this part
// of the mesh.
inline constexpr double kMostTurnedRounding = 1e-5;

// Boundary edges are one only if their ends are closer than this part of them
// by rounding, and this part where a distance is named: an edge that is not
// longer than what is joined could be joined to its neighbour.
inline constexpr double kMostRounded = 1.0 / 8;
inline constexpr double kMostWelded = 1.0 / 2;

// Boundary edges that lie as close to each other as this part of their length,
// and of the mean length of all, are told: they were perhaps meant to be one.
inline constexpr double kSuspicious = 1.0 / 50;

// A boundary edge lies along another edge if it is no farther from it than this
// part of the shorter one: more than rounding to single precision leaves, less
// than the sides of most slivers are apart.
inline constexpr double kTouching = 1e-4;

// Of polygons before they are triangles, in a unit in which their largest
// coordinate is 1 to 2: a corner no farther than this from a line lies on it,
// and what is no longer has no direction. Some dozen roundings of coordinates,
// as turning a drawing in space leaves them.
inline constexpr double kStraightCorner = 1e-14;

}  // namespace geodesic

#endif  // GEODESIC_TOLERANCES_H_
