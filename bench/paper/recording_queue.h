// Watches a wavefront through its queue.

#ifndef GEODESIC_BENCH_PAPER_RECORDING_QUEUE_H_
#define GEODESIC_BENCH_PAPER_RECORDING_QUEUE_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/queues/queue.h"

namespace geodesic::paper {

// The wavefront at one moment.
struct WavefrontSample {
  uint64_t popped = 0;  // windows so far
  uint64_t windows = 0;
  double k = 1;  // of the iteration; 1 where windows come one by one
  double mean_label = 0;
  double label_deviation = 0;  // standard deviation
};

// A queue that passes everything on to another and now and then looks at the
// labels of what waits: windows with the Chen-Han rule or a strict queue,
// half-edges with pending windows otherwise. Vertex events are left out.
template <WindowQueue Inner>
class RecordingQueue {
 public:
  static constexpr bool kStrict = Inner::kStrict;

  explicit RecordingQueue(const Tuning& tuning) : inner_(tuning) {}

  void Push(uint32_t id, double label) {
    if (!(id & kVertexEvent)) {
      if (id >= labels_.size()) labels_.resize(id + 1);
      labels_[id].push_back(label);
    }
    inner_.Push(id, label);
  }

  uint32_t Pop() {
    if (popped_ >= next_sample_) Sample();
    const uint32_t id = inner_.Pop();
    if (!(id & kVertexEvent)) {
      Forget(labels_[id]);
      ++popped_;
    }
    return id;
  }

  double popped_label() const requires kStrict { return inner_.popped_label(); }
  uint32_t Upcoming(uint32_t k) const { return inner_.Upcoming(k); }
  void Restart() { inner_.Restart(); }
  double SettledRadius() const { return inner_.SettledRadius(); }
  uint64_t size() const { return inner_.size(); }
  uint64_t iterations() const { return inner_.iterations(); }
  uint64_t bytes() const { return inner_.bytes(); }

  uint64_t popped() const { return popped_; }
  // At least kMostSamples / 2 of a long run, evenly spaced.
  const std::vector<WavefrontSample>& samples() const { return samples_; }

 private:
  static constexpr size_t kMostSamples = 250;

  // A strict queue gives the entries of an id one by one, the least first; with
  // any other all that waits under an id goes with it.
  void Forget(std::vector<double>& labels) {
    if constexpr (kStrict) {
      labels.erase(std::ranges::min_element(labels));
    } else {
      labels.clear();
    }
  }

  void Sample() {
    WavefrontSample sample{.popped = popped_};
    if constexpr (requires(const Inner& queue) { queue.least(); }) {
      sample.k = static_cast<double>(inner_.least());
    }
    double sum = 0;
    for (const std::vector<double>& labels : labels_) {
      sample.windows += labels.size();
      for (const double label : labels) sum += label;
    }
    const double windows = static_cast<double>(sample.windows);
    sample.mean_label = sample.windows > 0 ? sum / windows : 0;
    double squares = 0;
    for (const std::vector<double>& labels : labels_) {
      for (const double label : labels) {
        squares += (label - sample.mean_label) * (label - sample.mean_label);
      }
    }
    sample.label_deviation =
        sample.windows > 0 ? std::sqrt(squares / windows) : 0;
    samples_.push_back(sample);
    if (samples_.size() == kMostSamples) Thin();
    next_sample_ = popped_ + period_;
  }

  // How long a run will be is not known: every other sample goes, and from
  // there they are taken half as often.
  void Thin() {
    for (size_t i = 0; 2 * i < samples_.size(); ++i) {
      samples_[i] = samples_[2 * i];
    }
    samples_.resize((samples_.size() + 1) / 2);
    period_ *= 2;
  }

  Inner inner_;
  std::vector<std::vector<double>> labels_;  // that wait, by id
  std::vector<WavefrontSample> samples_;
  uint64_t popped_ = 0;
  uint64_t next_sample_ = 1;
  uint64_t period_ = 64;
};

}  // namespace geodesic::paper

#endif  // GEODESIC_BENCH_PAPER_RECORDING_QUEUE_H_
