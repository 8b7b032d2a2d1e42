// What solve and reach measure, and how solve hands out fields.

#ifndef GEODESIC_BENCH_MEASURED_H_
#define GEODESIC_BENCH_MEASURED_H_

#include <string>
#include <vector>

#include "absl/status/status.h"

namespace geodesic {

// REQUIRES: there are values.
double Median(std::vector<double> values);

// Of this process, so far.
double PeakRssMb();

// As raw little-endian doubles. Errors: UNAVAILABLE with the path.
absl::Status WriteField(const std::string& path,
                        const std::vector<double>& values);

struct RelativeErrors {
  double mean = 0;
  double largest = 0;
};

// Over the distances that are finite and not 0. Infinite if the two differ in
// which are finite. REQUIRES: as many of both.
RelativeErrors CompareDistances(const std::vector<double>& distances,
                                const std::vector<double>& exact);

}  // namespace geodesic

#endif  // GEODESIC_BENCH_MEASURED_H_
