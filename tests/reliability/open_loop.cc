#include "tests/reliability/open_loop.h"

#include <google/rpc/error_details.pb.h>
#include <google/rpc/status.pb.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <thread>
#include <utility>

#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

using std::chrono::steady_clock;

constexpr size_t kMostExamples = 10;

// Whether the server says that it is full and when to come again.
bool IsRefusal(const grpc::Status& status) {
  google::rpc::Status details;
  if (status.error_code() != grpc::StatusCode::RESOURCE_EXHAUSTED ||
      !details.ParseFromString(status.error_details())) {
    return false;
  }
  return std::any_of(details.details().begin(), details.details().end(),
                     [](const auto& any) {
                       return any.template Is<google::rpc::RetryInfo>();
                     });
}

// Thread-safe.
class Recorder {
 public:
  void Record(const Question& question, steady_clock::time_point intended,
              const RawAnswer& answer) {
    const auto name = kQuestionNames[static_cast<size_t>(question.kind)];
    const bool refused = IsRefusal(answer.status);
    std::string fault;
    if (answer.status.ok()) {
      fault = question.check(answer.messages);
    } else if (!refused) {
      fault = absl::StrCat("error ", answer.status.error_code(), ": ",
                           answer.status.error_message());
    }
    std::lock_guard lock(mutex_);
    if (!fault.empty()) {
      ++figures_.faults;
      if (figures_.fault_examples.size() < kMostExamples) {
        figures_.fault_examples.push_back(absl::StrCat(name, ": ", fault));
      }
    } else if (refused) {
      figures_.refused.Add(answer.end - intended);
    } else {
      figures_.answered[static_cast<size_t>(question.kind)].Add(answer.end -
                                                                intended);
    }
  }

  // REQUIRES: nobody records any more.
  LoadFigures& figures() { return figures_; }

 private:
  std::mutex mutex_;
  LoadFigures figures_;  // guarded by mutex_
};

}  // namespace

void LoadFigures::Add(const LoadFigures& other) {
  for (size_t i = 0; i < kQuestionKinds; ++i)
    answered[i].Add(other.answered[i]);
  refused.Add(other.refused);
  sent += other.sent;
  seconds += other.seconds;
  latest = std::max(latest, other.latest);
  faults += other.faults;
  fault_examples.insert(fault_examples.end(), other.fault_examples.begin(),
                        other.fault_examples.end());
}

uint64_t LoadFigures::answers() const {
  uint64_t count = 0;
  for (const LatencyHistogram& histogram : answered) {
    count += histogram.count();
  }
  return count;
}

std::vector<std::string> LoadFigures::Faults() const {
  if (faults == 0) return {};
  std::vector<std::string> lines = {absl::StrCat(faults, " wrong or failed")};
  lines.insert(lines.end(), fault_examples.begin(), fault_examples.end());
  return lines;
}

nlohmann::ordered_json LoadFigures::Summary() const {
  nlohmann::ordered_json kinds;
  for (size_t i = 0; i < kQuestionKinds; ++i) {
    if (answered[i].count() > 0) {
      kinds[kQuestionNames[i]] = answered[i].Summary();
    }
  }
  return {{"seconds", seconds},
          {"sent", sent},
          {"sent_per_second", static_cast<double>(sent) / seconds},
          {"sent_late_max_ms", 1e-6 * static_cast<double>(latest.count())},
          {"answers_right", answers()},
          {"answers_wrong_or_failed", faults},
          {"answered", kinds},
          {"refused", refused.Summary()}};
}

std::vector<std::unique_ptr<RawConnection>> Connect(const std::string& address,
                                                    size_t count) {
  std::vector<std::unique_ptr<RawConnection>> connections;
  for (size_t i = 0; i < count; ++i) {
    connections.push_back(std::make_unique<RawConnection>(address));
  }
  return connections;
}

LoadFigures RunOpenLoop(
    const std::vector<std::unique_ptr<RawConnection>>& connections,
    Workload& workload, const Mix& mix, double rate, double seconds,
    std::mt19937_64& random) {
  // The kernel may wake this thread 50 microseconds late otherwise, which would
  // count as the server's.
  prctl(PR_SET_TIMERSLACK, 1);
  Recorder recorder;
  std::exponential_distribution<double> gap(rate);
  std::discrete_distribution<size_t> any_kind(mix.begin(), mix.end());
  const auto start = steady_clock::now();
  std::chrono::nanoseconds latest{0};
  uint64_t sent = 0;
  for (double at = gap(random); at < seconds; at += gap(random)) {
    const auto intended =
        start + std::chrono::duration_cast<steady_clock::duration>(
                    std::chrono::duration<double>(at));
    Question question =
        workload.Next(static_cast<QuestionKind>(any_kind(random)));
    std::this_thread::sleep_until(intended);
    latest = std::max<std::chrono::nanoseconds>(latest,
                                                steady_clock::now() - intended);
    RawRequest request = std::exchange(question.request, {});
    connections[sent++ % connections.size()]->Send(
        std::move(request),
        [&recorder, intended,
         question = std::move(question)](const RawAnswer& answer) {
          recorder.Record(question, intended, answer);
        });
  }
  for (const auto& connection : connections) connection->WaitIdle();
  LoadFigures figures = std::move(recorder.figures());
  figures.sent = sent;
  figures.seconds = seconds;
  figures.latest = latest;
  return figures;
}

}  // namespace geodesic::client
