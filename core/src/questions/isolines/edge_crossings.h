// Where a level of the distance crosses one edge.

#ifndef GEODESIC_QUESTIONS_ISOLINES_EDGE_CROSSINGS_H_
#define GEODESIC_QUESTIONS_ISOLINES_EDGE_CROSSINGS_H_

#include <vector>

#include "questions/isolines/way.h"

namespace geodesic {

// Collects the parts of an edge from P to Q that are nearer than a level; the
// level crosses the edge where their union begins and ends. P and Q are nearer
// or not by their own distances alone, so around any cycle of edges as many
// crossings lead in as out, whatever rounding does.
class EdgeCrossings {
 public:
  // Lengths are measured from P; p, q: the distances of the two ends.
  EdgeCrossings(double level, double length, double p, double q);

  void Add(const Way& way);

  // The crossings in order from P to Q. Two in a row differ. One next to an end
  // that is at the level is put there.
  std::vector<double> Find();

 private:
  const double level_;
  const double length_;
  const double p_, q_;
  // Within [0, length], but for the part of a nearer end, which begins or ends
  // at infinity.
  std::vector<Interval> parts_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_EDGE_CROSSINGS_H_
