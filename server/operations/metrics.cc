#include "server/operations/metrics.h"

#include <prometheus/text_serializer.h>

#include <chrono>
#include <iterator>
#include <utility>
#include <vector>

#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

using prometheus::Counter;
using prometheus::Family;
using prometheus::Histogram;

// From a cached field on loopback to the longest solve, about three to ten.
const Histogram::BucketBoundaries& Buckets() {
  static const Histogram::BucketBoundaries buckets = {
      0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30, 100, 300};
  return buckets;
}

Family<Counter>& AddCounter(prometheus::Registry& registry,
                            const std::string& name, const std::string& help) {
  return prometheus::BuildCounter().Name(name).Help(help).Register(registry);
}

Family<Histogram>& AddHistogram(prometheus::Registry& registry,
                                const std::string& name,
                                const std::string& help) {
  return prometheus::BuildHistogram().Name(name).Help(help).Register(registry);
}

std::string JobKind(JobPriority priority) {
  switch (priority) {
    case JobPriority::kBuild:
      return "build";
    case JobPriority::kSolve:
      return "solve";
    case JobPriority::kRow:
      return "row";
    case JobPriority::kBatch:
      return "batch";
    case JobPriority::kStore:
      return "store";
  }
  return "other";
}

double Seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

Metrics::Metrics()
    : requests_(AddCounter(registry_, "geodesic_requests_total",
                           "Requests that have ended, by method and code")),
      errors_(AddCounter(registry_, "geodesic_errors_total",
                         "Requests that failed, by the error's reason")),
      request_seconds_(
          AddHistogram(registry_, "geodesic_request_seconds",
                       "Time from a request's arrival to its end")),
      write_seconds_(AddHistogram(
          registry_, "geodesic_stream_seconds",
          "Time of a request in which its client was waited for to take what "
          "was written")),
      bytes_(AddCounter(registry_, "geodesic_payload_bytes_total",
                        "Bytes of meshes and values, in and out, by method")),
      queue_seconds_(AddHistogram(registry_, "geodesic_job_queue_seconds",
                                  "Time a job waited for a thread")),
      run_seconds_(AddHistogram(registry_, "geodesic_job_run_seconds",
                                "Time a job had a thread")),
      cancelled_seconds_(
          AddCounter(registry_, "geodesic_cancelled_compute_seconds_total",
                     "Time on threads of jobs that nobody waited for at their "
                     "end")
              .Add({})),
      reloads_(AddCounter(registry_, "geodesic_token_reloads_total",
                          "Times the tokens were read again, by result")) {}

void Metrics::RequestEnded(const RequestReport& report) {
  const std::string method(report.method);
  requests_
      .Add({{"method", method},
            {"code", absl::StatusCodeToString(report.status.code())}})
      .Increment();
  if (!report.status.ok()) {
    errors_.Add({{"reason", ReasonOf(report.status)}}).Increment();
  }
  request_seconds_.Add({{"method", method}}, Buckets()).Observe(report.seconds);
  if (report.write_seconds > 0) {
    write_seconds_.Add({{"method", method}}, Buckets())
        .Observe(report.write_seconds);
  }
  bytes_.Add({{"method", method}}).Increment(static_cast<double>(report.bytes));
}

void Metrics::JobEnded(const JobTimes& times) {
  const prometheus::Labels kind = {{"kind", JobKind(times.priority)}};
  queue_seconds_.Add(kind, Buckets()).Observe(Seconds(times.waited));
  run_seconds_.Add(kind, Buckets()).Observe(Seconds(times.ran));
  if (times.was_stopped) cancelled_seconds_.Increment(Seconds(times.ran));
}

void Metrics::TokensReloaded(bool is_ok) {
  reloads_.Add({{"result", is_ok ? "ok" : "failed"}}).Increment();
}

void Metrics::Add(Collector collector) {
  collectors_.push_back(std::move(collector));
}

void Metrics::AddGauge(const std::string& name, const std::string& help,
                       std::function<double()> value) {
  Add([name, help, value = std::move(value)] {
    prometheus::MetricFamily family{
        name, help, prometheus::MetricType::Gauge, {}};
    family.metric.emplace_back().gauge.value = value();
    return std::vector{std::move(family)};
  });
}

std::string Metrics::Text() const {
  std::vector<prometheus::MetricFamily> families = registry_.Collect();
  for (const Collector& collector : collectors_) {
    std::vector<prometheus::MetricFamily> more = collector();
    std::move(more.begin(), more.end(), std::back_inserter(families));
  }
  return prometheus::TextSerializer().Serialize(families);
}

}  // namespace geodesic::server
