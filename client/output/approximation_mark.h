// How files, tables and pictures say that their distances are approximate, or
// hold within a tolerance, so that nobody takes them for exact.

#ifndef GEODESIC_CLIENT_OUTPUT_APPROXIMATION_MARK_H_
#define GEODESIC_CLIENT_OUTPUT_APPROXIMATION_MARK_H_

#include <string>

#include "geodesic_client/answer.h"

namespace geodesic::client {

// "heat, lambda 80": the algorithm and the parameters that are set.
std::string AlgorithmText(const std::string& algorithm,
                          const Approximation& approximation);

// "approximate: heat, lambda 80"; empty for an exact algorithm.
std::string ApproximationMark(const std::string& algorithm,
                              const Approximation& approximation);

// "within 0.001 (relative error)"; empty for the tolerance 0.
std::string ToleranceMark(double tolerance);
bool IsToleranceMark(const std::string& mark);

// Whether it is one of the two.
bool IsMark(const std::string& text);

// The name of values, such as "distances", under this mark:
// "approximate_distances", or "distances_within_tolerance".
std::string MarkedName(const std::string& exact, const std::string& mark);

// The name of a distance, such as "distance" or "geodesic_distance", under this
// mark: with one it is that of "distance".
inline std::string DistanceName(const std::string& exact,
                                const std::string& mark) {
  return mark.empty() ? exact : MarkedName("distance", mark);
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_APPROXIMATION_MARK_H_
