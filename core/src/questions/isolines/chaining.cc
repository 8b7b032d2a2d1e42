#include "questions/isolines/chaining.h"

#include <utility>

namespace geodesic {
namespace {

class Chaining {
 public:
  Chaining(uint32_t crossing_count, std::span<const Segment> segments)
      : segments_(segments),
        begin_(crossing_count + 1, 0),
        incident_(2 * segments.size()),
        is_used_(segments.size()) {
    for (const Segment& s : segments) {
      ++begin_[s.from + 1];
      ++begin_[s.to + 1];
    }
    for (uint32_t c = 0; c < crossing_count; ++c) begin_[c + 1] += begin_[c];
    std::vector<uint32_t> fill(begin_.begin(), begin_.end() - 1);
    for (uint32_t s = 0; s < segments.size(); ++s) {
      incident_[fill[segments[s].from]++] = s;
      incident_[fill[segments[s].to]++] = s;
    }
  }

  std::vector<Chain> Run() {
    const auto count = static_cast<uint32_t>(begin_.size() - 1);
    for (const bool outgoing_alone : {true, false}) {
      for (uint32_t c = 0; c < count; ++c) {
        if (Incident(c).size() != 2) WalkFrom(c, outgoing_alone);
      }
    }
    for (const bool outgoing_alone : {true, false}) {
      for (uint32_t c = 0; c < count; ++c) WalkFrom(c, outgoing_alone);
    }
    return std::move(chains_);
  }

 private:
  std::span<const uint32_t> Incident(uint32_t crossing) const {
    return std::span(incident_).subspan(
        begin_[crossing], begin_[crossing + 1] - begin_[crossing]);
  }

  // Walks along each segment that is left here.
  void WalkFrom(uint32_t start, bool outgoing_alone) {
    for (const uint32_t first : Incident(start)) {
      if (is_used_[first]) continue;
      if (outgoing_alone && segments_[first].from != start) continue;
      Walk(start, first);
    }
  }

  void Walk(uint32_t start, uint32_t segment) {
    Chain& chain = chains_.emplace_back();
    chain.crossings = {start};
    for (uint32_t at = start;;) {
      is_used_[segment] = true;
      const Segment& along = segments_[segment];
      const bool is_forward = at == along.from;
      chain.links.push_back({segment, is_forward});
      at = is_forward ? along.to : along.from;
      if (at == start) {
        chain.is_closed = true;
        return;
      }
      chain.crossings.push_back(at);
      const std::span<const uint32_t> incident = Incident(at);
      if (incident.size() != 2) return;
      segment = incident[0] == segment ? incident[1] : incident[0];
    }
  }

  std::span<const Segment> segments_;
  std::vector<uint32_t> begin_;  // into incident_, of each crossing
  std::vector<uint32_t> incident_;
  std::vector<bool> is_used_;
  std::vector<Chain> chains_;
};

}  // namespace

std::vector<Chain> ChainsOf(uint32_t crossing_count,
                            std::span<const Segment> segments) {
  return Chaining(crossing_count, segments).Run();
}

}  // namespace geodesic
