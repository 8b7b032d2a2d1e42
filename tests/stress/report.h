// What a run has checked and found.

#ifndef GEODESIC_TESTS_STRESS_REPORT_H_
#define GEODESIC_TESTS_STRESS_REPORT_H_

#include <cstdint>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace geodesic::stress {

class Report {
 public:
  // `options`: what a violated case is run again with, beside its seed.
  explicit Report(std::string options = "") : options_(std::move(options)) {}

  // The case that follows; `seed` draws it again.
  void StartCase(uint64_t seed, std::string description) {
    seed_ = seed;
    description_ = std::move(description);
    ++cases_;
  }

  // Counts a check of a law; prints `details` (streamed) if it does not hold.
  template <typename... Details>
  bool Check(bool holds, std::string_view law, const Details&... details) {
    ++all_checks_;
    ++checks_[std::string(law)];
    if (holds) return true;
    ++violations_;
    std::ostringstream text;
    text << std::setprecision(17);
    (text << ... << details);
    std::cout << "VIOLATION " << law << ": " << text.str() << "\n  "
              << description_ << "\n  again: stress --cases 1 --seed " << seed_
              << options_ << "\n"
              << std::flush;
    return false;
  }

  // The same of all numbers below `count`; names the first for which `holds` is
  // false.
  template <typename Holds, typename... Details>
  bool CheckAll(size_t count, Holds holds, std::string_view law,
                const Details&... details) {
    size_t i = 0;
    while (i < count && holds(i)) ++i;
    return Check(i == count, law, "at ", i, ": ", details...);
  }

  uint64_t cases() const { return cases_; }
  uint64_t violations() const { return violations_; }
  uint64_t checks() const { return all_checks_; }
  const std::map<std::string, uint64_t>& checks_by_law() const {
    return checks_;
  }

 private:
  const std::string options_;
  uint64_t seed_ = 0;
  std::string description_;
  uint64_t cases_ = 0;
  uint64_t all_checks_ = 0;
  uint64_t violations_ = 0;
  std::map<std::string, uint64_t> checks_;
};

}  // namespace geodesic::stress

#endif  // GEODESIC_TESTS_STRESS_REPORT_H_
