#include "questions/isolines/face_regions.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace geodesic {

FaceRegions::FaceRegions(std::vector<PerimeterCrossing> crossings,
                         bool starts_nearer)
    : crossings_(std::move(crossings)),
      starts_nearer_(starts_nearer),
      regions_(crossings_.size() / 2) {
  std::iota(regions_.begin(), regions_.end(), size_t{0});
}

std::optional<size_t> FaceRegions::ArcAt(double at) const {
  const auto passed = static_cast<size_t>(
      std::ranges::upper_bound(crossings_, at, {}, &PerimeterCrossing::at) -
      crossings_.begin());
  const bool is_nearer = starts_nearer_ == (passed % 2 == 0);
  if (!is_nearer || regions_.empty()) return std::nullopt;
  // The first arc is around the perimeter's beginning if that is nearer.
  return passed / 2 % regions_.size();
}

void FaceRegions::Join(size_t arc, size_t other) {
  const size_t region = regions_[arc], joined = regions_[other];
  std::ranges::replace(regions_, joined, region);
}

uint32_t FaceRegions::BeginOf(size_t arc) const {
  const size_t count = crossings_.size();
  const size_t begin = starts_nearer_ ? (2 * arc + count - 1) % count : 2 * arc;
  return crossings_[begin].crossing;
}

uint32_t FaceRegions::EndOf(size_t arc) const {
  return crossings_[starts_nearer_ ? 2 * arc : 2 * arc + 1].crossing;
}

void FaceRegions::JoinInterleaved() {
  std::vector<size_t> last(arc_count());  // arc of each region
  for (size_t arc = 0; arc < arc_count(); ++arc) last[regions_[arc]] = arc;
  std::vector<size_t> open;  // regions begun and not yet ended, nested
  for (size_t arc = 0; arc < arc_count(); ++arc) {
    const size_t region = regions_[arc];
    if (std::ranges::find(open, region) == open.end()) open.push_back(region);
    // Regions begun within this one that go on beyond.
    for (; open.back() != region; open.pop_back()) {
      last[region] = std::max(last[region], last[open.back()]);
      std::ranges::replace(regions_, open.back(), region);
    }
    if (last[region] == arc) open.pop_back();
  }
}

std::vector<Segment> FaceRegions::Segments() {
  JoinInterleaved();
  std::vector<Segment> segments;
  for (size_t arc = 0; arc < arc_count(); ++arc) {
    size_t next = arc;
    do {
      next = (next + 1) % arc_count();
    } while (regions_[next] != regions_[arc]);
    segments.push_back({EndOf(arc), BeginOf(next)});
  }
  return segments;
}

}  // namespace geodesic
