// Watches a wavefront through its queue.

#ifndef GEODESIC_BENCH_PAPER_RECORDING_QUEUE_H_
#define GEODESIC_BENCH_PAPER_RECORDING_QUEUE_H_

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "queues/queue.h"

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
// labels of the windows that wait. Vertex events are left out; windows that MMP
// has trimmed to nothing are not, for a queue is not told which they are.
template <WindowQueue Inner>
class RecordingQueue {
 public:
  explicit RecordingQueue(const QueueTuning& tuning) : inner_(tuning) {}

  void Push(uint32_t id, double label) {
    if (!(id & kVertexEvent)) {
      if (id >= labels_.size()) labels_.resize(id + 1, kPopped);
      labels_[id] = label;
    }
    inner_.Push(id, label);
  }

  uint32_t Pop() {
    if (popped_ >= next_sample_) Sample();
    const uint32_t id = inner_.Pop();
    if (!(id & kVertexEvent)) {
      labels_[id] = kPopped;
      ++popped_;
    }
    return id;
  }

  uint32_t Upcoming(uint32_t k) const { return inner_.Upcoming(k); }
  void MarkVoid() { inner_.MarkVoid(); }
  void DropVoid() { inner_.DropVoid(); }
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
  static constexpr double kPopped = std::numeric_limits<double>::quiet_NaN();

  void Sample() {
    WavefrontSample sample{.popped = popped_};
    if constexpr (requires(const Inner& queue) { queue.least(); }) {
      sample.k = static_cast<double>(inner_.least());
    }
    double sum = 0;
    for (const double label : labels_) {
      if (std::isnan(label)) continue;
      ++sample.windows;
      sum += label;
    }
    const double windows = static_cast<double>(sample.windows);
    sample.mean_label = sample.windows > 0 ? sum / windows : 0;
    double squares = 0;
    for (const double label : labels_) {
      if (std::isnan(label)) continue;
      squares += (label - sample.mean_label) * (label - sample.mean_label);
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
  std::vector<double> labels_;  // by id; kPopped if it does not wait
  std::vector<WavefrontSample> samples_;
  uint64_t popped_ = 0;
  uint64_t next_sample_ = 1;
  uint64_t period_ = 64;
};

}  // namespace geodesic::paper

#endif  // GEODESIC_BENCH_PAPER_RECORDING_QUEUE_H_
