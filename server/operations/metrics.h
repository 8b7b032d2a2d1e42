// The server's metrics, in the form Prometheus reads.
//
// docs/operations.md lists and explains them.

#ifndef GEODESIC_SERVER_OPERATIONS_METRICS_H_
#define GEODESIC_SERVER_OPERATIONS_METRICS_H_

#include <prometheus/counter.h>
#include <prometheus/family.h>
#include <prometheus/histogram.h>
#include <prometheus/metric_family.h>
#include <prometheus/registry.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/query_engine.h"
#include "server/tier/redis_blobs.h"

namespace geodesic::server {

// A request that has ended.
struct RequestReport {
  std::string_view method;
  absl::Status status;
  double seconds = 0;
  // The part of `seconds` spent waiting for the client to read.
  double write_seconds = 0;
  uint64_t bytes = 0;
};

// The values of every label come from a fixed list, so no client can make the
// page grow. Thread-safe.
class Metrics {
 public:
  Metrics();

  void RequestEnded(const RequestReport& report);
  void JobEnded(const JobTimes& times);
  void TokensReloaded(bool is_ok);

  // Adds a function that gives more metrics at each scrape.
  // REQUIRES: nobody scrapes yet.
  using Collector = std::function<std::vector<prometheus::MetricFamily>()>;
  void Add(Collector collector);

  // Adds a gauge whose value is read at each scrape. REQUIRES: as Add.
  void AddGauge(const std::string& name, const std::string& help,
                std::function<double()> value);

  // The text of the page.
  std::string Text() const;

 private:
  prometheus::Registry registry_;
  std::vector<Collector> collectors_;
  prometheus::Family<prometheus::Counter>& requests_;
  prometheus::Family<prometheus::Counter>& errors_;
  prometheus::Family<prometheus::Histogram>& request_seconds_;
  prometheus::Family<prometheus::Histogram>& write_seconds_;
  prometheus::Family<prometheus::Counter>& bytes_;
  prometheus::Family<prometheus::Histogram>& queue_seconds_;
  prometheus::Family<prometheus::Histogram>& run_seconds_;
  prometheus::Counter& cancelled_seconds_;
  prometheus::Family<prometheus::Counter>& reloads_;
};

// The engine's own figures, read at each scrape; `requests` is the memory of
// requests. Thread-safe.
std::vector<prometheus::MetricFamily> CollectEngine(const QueryEngine& engine,
                                                    const ByteBudget& requests);

// The figures of the tier that servers share. Thread-safe.
std::vector<prometheus::MetricFamily> CollectSharedTier(const RedisBlobs& tier);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPERATIONS_METRICS_H_
