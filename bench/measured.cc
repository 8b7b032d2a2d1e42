#include "bench/measured.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>

namespace geodesic {

double Median(std::vector<double> values) {
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double PeakRssMb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

absl::Status WriteField(const std::string& path,
                        const std::vector<double>& values) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(double)));
  if (!file.flush()) return absl::UnavailableError("cannot write " + path);
  return absl::OkStatus();
}

RelativeErrors CompareDistances(const std::vector<double>& distances,
                                const std::vector<double>& exact) {
  RelativeErrors errors;
  uint64_t count = 0;
  for (size_t v = 0; v < exact.size(); ++v) {
    if (exact[v] == 0 || (std::isinf(exact[v]) && std::isinf(distances[v]))) {
      continue;
    }
    const double error = std::abs(distances[v] / exact[v] - 1);
    errors.mean += error;
    errors.largest = std::max(errors.largest, error);
    ++count;
  }
  if (count > 0) errors.mean /= static_cast<double>(count);
  return errors;
}

}  // namespace geodesic
