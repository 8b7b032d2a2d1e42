#include "mesh/rounding.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "tolerances.h"

namespace geodesic {
namespace {

// Writing digits takes longer than all else.
constexpr size_t kSampledDigits = 512;

// What the coordinates of some vertices are made of.
class Coordinates {
 public:
  void Add(const Point& point) {
    for (int axis = 0; axis < 3; ++axis) {
      const double x = point[axis];
      largest_[axis] = std::max(largest_[axis], std::abs(x));
      float_error_ =
          std::max(float_error_, std::abs(x - static_cast<float>(x)));
    }
  }
  // Of some of them.
  void AddDigits(const Point& point) {
    for (const double x : point) {
      if (x != 0) AddDigits(x);
    }
  }

  // How far apart places may be along an axis that are one, by what computing
  // them in a mesh of this extent and writing them down adds.
  double Along(int axis, double extent, bool is_single) const {
    const double largest = largest_[axis];
    const double unit_of_all = DecimalUnit(std::ranges::max(largest_), extent);
    // What is chosen along one axis is chosen.
    const double unit = unit_of_all == 0 ? 0 : DecimalUnit(largest, extent);
    const bool are_floats = float_error_ <= kWrittenTwice * unit_of_all / 2;
    const double epsilon = is_single || are_floats
                               ? std::numeric_limits<float>::epsilon()
                               : std::numeric_limits<double>::epsilon();
    return kWrittenTwice * std::max({kComputedTwice * extent * epsilon,
                                     largest * epsilon, unit});
  }

 private:
  // Digits of a double that differ from those of its neighbours.
  static constexpr int kAllDigits = std::numeric_limits<double>::digits10;
  static constexpr int kMostDecimals = 40;

  // A unit of the last digit, if the numbers were rounded to decimal ones: then
  // most of them have as many digits, or as many behind the point, as any. 0
  // where such digits were chosen, or the numbers are binary. `largest`: of all
  // along an axis.
  double DecimalUnit(double largest, double extent) const {
    if (count_ == 0 || largest == 0) return 0;
    const auto last_used = [](const auto& counts) {
      return static_cast<int>(std::find_if(counts.rbegin(), counts.rend(),
                                           [](auto n) { return n > 0; }) -
                              counts.rbegin());
    };
    const int digits = kAllDigits + 2 - last_used(by_digits_);
    const int decimals = kMostDecimals - last_used(by_decimals_);
    double unit = 0;
    if (digits > kAllDigits) {
      return 0;
    }
    if (2 * by_decimals_[decimals] >= count_) {
      unit = std::pow(10.0, -decimals);
    } else if (2 * by_digits_[digits] >= count_) {
      const double first = std::floor(std::log10(largest));
      unit = std::pow(10.0, first + 1 - digits);
    }
    return unit <= kMostDecimalRounding * extent ? unit : 0;
  }

  // Of the shortest decimal number that reads as x: the one that a text has
  // holds no fewer.
  void AddDigits(double x) {
    if (has_all_digits_) return;  // so there is no unit
    std::array<char, 32> text;
    const char* const end =
        std::to_chars(text.data(), text.data() + text.size(), std::abs(x),
                      std::chars_format::scientific)
            .ptr;
    const char* const exponent = std::find<const char*>(text.data(), end, 'e');
    // Without the point.
    const int digits =
        std::max(static_cast<int>(exponent - text.data()) - 1, 1);
    int power = 0;
    // from_chars knows no plus.
    std::from_chars(exponent + (exponent[1] == '+' ? 2 : 1), end, power);
    ++count_;
    has_all_digits_ = digits > kAllDigits;
    ++by_digits_[std::min(digits, kAllDigits + 2)];
    ++by_decimals_[std::clamp(digits - 1 - power, 0, kMostDecimals)];
  }

  uint64_t count_ = 0;           // whose digits are known
  Point largest_{};              // along each axis
  bool has_all_digits_ = false;  // one of them
  double float_error_ = 0;       // of the one that single precision holds worst
  // How many have so many significant digits, and so many behind the point.
  std::array<uint64_t, kAllDigits + 3> by_digits_{};
  std::array<uint64_t, kMostDecimals + 1> by_decimals_{};
};

struct Box {
  Point least;
  Point most;

  void Add(const Point& point) {
    for (int axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], point[axis]);
      most[axis] = std::max(most[axis], point[axis]);
    }
  }
  double Extent() const {
    return std::max(
        {most[0] - least[0], most[1] - least[1], most[2] - least[2]});
  }
};

// Where most of a soup lies, by a sample of it. A few vertices far off would
// make the rounding of their own places that of all.
class UsualBox {
 public:
  // REQUIRES: the soup has faces.
  explicit UsualBox(const TriangleSoup& soup) {
    const size_t faces = soup.triangles.size();
    std::vector<Point> sample(std::min<size_t>(faces, kSample));
    for (size_t i = 0; i < sample.size(); ++i) {
      const Triangle& corners = soup.triangles[i * faces / sample.size()];
      sample[i] = soup.positions[corners[i % 3]];
    }
    std::vector<double> sorted(sample.size());
    const size_t quarter = sample.size() / 4;
    for (int axis = 0; axis < 3; ++axis) {
      std::ranges::transform(
          sample, sorted.begin(),
          [axis](const Point& point) { return point[axis]; });
      std::ranges::sort(sorted);
      middle_[axis] = sorted[sorted.size() / 2];
      spread_ = std::max(spread_,
                         sorted[sorted.size() - 1 - quarter] - sorted[quarter]);
    }
    box_ = {middle_, middle_};
    for (const Point& point : sample) {
      if (Holds(point)) box_.Add(point);
    }
  }

  bool Holds(const Point& point) const {
    if (spread_ == 0) return true;
    const double most = kFarOff * spread_;
    return std::abs(point[0] - middle_[0]) <= most &&
           std::abs(point[1] - middle_[1]) <= most &&
           std::abs(point[2] - middle_[2]) <= most;
  }

  const Box& box() const { return box_; }

 private:
  static constexpr size_t kSample = 256;

  Point middle_{};
  double spread_ = 0;  // of the middle half of all
  Box box_{};
};

}  // namespace

Rounding::Rounding(const TriangleSoup& soup,
                   std::span<const uint32_t> vertices) {
  const UsualBox usual(soup);
  Coordinates coordinates;
  Box box = usual.box();
  const size_t step = vertices.size() / kSampledDigits + 1;
  for (size_t i = 0; i < vertices.size(); ++i) {
    const Point& point = soup.positions[vertices[i]];
    if (!usual.Holds(point)) continue;
    coordinates.Add(point);
    if (i % step == 0) coordinates.AddDigits(point);
    box.Add(point);
  }
  const double extent = box.Extent();
  for (int axis = 0; axis < 3; ++axis) {
    along_[axis] = coordinates.Along(axis, extent, soup.is_single_precision);
  }
  const double most = std::min(distance(), kMostTurnedRounding * extent);
  for (double& along : along_) along = std::sqrt(3.0) * std::max(along, most);
}

}  // namespace geodesic
