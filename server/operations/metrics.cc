#include "server/operations/metrics.h"

#include <prometheus/text_serializer.h>

#include <chrono>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

using prometheus::Counter;
using prometheus::Family;
using prometheus::Histogram;
using prometheus::MetricFamily;
using prometheus::MetricType;

// In seconds: from a cached field on loopback to the longest solve.
Histogram::BucketBoundaries Buckets() {
  return {0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30, 100, 300};
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

// Indexed by JobPriority.
constexpr const char* kJobKinds[kJobPriorities] = {"build", "solve", "row",
                                                   "batch", "store", "prepare"};

double Seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

struct Sample {
  std::string label;
  uint64_t value;
};

// A family whose members differ in the label `name`; if that is "", it has one.
MetricFamily Make(MetricType type, const std::string& family,
                  const std::string& help, const std::string& name,
                  const std::vector<Sample>& samples) {
  MetricFamily result{family, help, type, {}};
  for (const Sample& sample : samples) {
    prometheus::ClientMetric metric;
    if (!name.empty()) metric.label.push_back({name, sample.label});
    const auto value = static_cast<double>(sample.value);
    metric.counter.value = value;
    metric.gauge.value = value;
    result.metric.push_back(std::move(metric));
  }
  return result;
}

// Appends the figures of the data folder.
void AppendDisk(const DurableStore& durable,
                std::vector<MetricFamily>& families) {
  const BlobStore& meshes = durable.meshes->blobs();
  const BlobStore& fields = *durable.fields;
  const BlobCounters of_meshes = meshes.counters();
  const BlobCounters of_fields = fields.counters();
  const Quarantine::Contents aside = durable.folder.quarantine().Count();
  const auto add = [&](MetricType type, const std::string& name,
                       const std::string& help,
                       const std::vector<Sample>& samples) {
    families.push_back(Make(type, name, help, "store", samples));
  };
  const auto add_counter = [&](const std::string& name, const std::string& help,
                               uint64_t BlobCounters::*counter) {
    add(MetricType::Counter, name, help,
        {{"meshes", of_meshes.*counter}, {"fields", of_fields.*counter}});
  };
  add(MetricType::Gauge, "geodesic_disk_used_bytes",
      "Disk that files take, or will when they are written",
      {{"meshes", meshes.used_bytes()},
       {"fields", fields.used_bytes()},
       {"quarantine", aside.bytes}});
  add(MetricType::Gauge, "geodesic_disk_capacity_bytes", "What they may take",
      {{"meshes", meshes.capacity()}, {"fields", fields.capacity()}});
  add(MetricType::Gauge, "geodesic_disk_files", "Files on disk",
      {{"meshes", meshes.size()},
       {"fields", fields.size()},
       {"quarantine", aside.files}});
  add_counter("geodesic_disk_evictions_total", "Files that went to make room",
              &BlobCounters::evictions);
  add_counter("geodesic_disk_writes_total", "Files to be written, failures too",
              &BlobCounters::writes);
  add_counter("geodesic_disk_write_failures_total",
              "Files that could not be written", &BlobCounters::write_failures);
  add_counter("geodesic_disk_too_large_total",
              "Files refused because they are larger than the capacity",
              &BlobCounters::too_large);
  add_counter("geodesic_disk_reads_total", "Files to be read, failures too",
              &BlobCounters::reads);
  add_counter("geodesic_disk_read_failures_total",
              "Files that could not be read, the damaged too",
              &BlobCounters::read_failures);
  add_counter("geodesic_disk_damaged_total",
              "Files that were found damaged, at the start or later",
              &BlobCounters::damaged);
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
                          "Times the tokens were read again, by result")) {
  // Alarms see the first of these only if there was a 0 before.
  errors_.Add({{"reason", "INTERNAL"}});
  reloads_.Add({{"result", "failed"}});
}

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
  const prometheus::Labels kind = {
      {"kind", kJobKinds[static_cast<size_t>(times.priority)]}};
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

std::vector<MetricFamily> CollectEngine(const QueryEngine& engine,
                                        const ByteBudget& requests) {
  const EngineCounters counters = engine.counters();
  const Limits& limits = engine.limits();
  const MeshStore& meshes = engine.meshes().store();
  const LandmarkStore& landmarks = engine.meshes().landmarks();
  const MethodStore& methods = engine.meshes().methods();
  const FieldEngine& fields = engine.fields();
  const Scheduler& scheduler = engine.scheduler();
  std::vector<MetricFamily> families = {
      Make(MetricType::Counter, "geodesic_field_answers_total",
           "Questions about a field, by how it came about: computed, joined "
           "(coalesced with one under way), cached",
           "origin",
           {{"computed", counters.solves_started},
            {"joined", counters.queries_joined},
            {"cached", counters.queries_cached}}),
      Make(MetricType::Counter, "geodesic_solves_ended_total",
           "Computations of fields that have ended, by result", "result",
           {{"finished", counters.solves_finished},
            {"stopped", counters.solves_stopped}}),
      Make(MetricType::Counter, "geodesic_pairs_total",
           "Pairs whose distance was found: by a search of their own, by a "
           "field for several, by a field in the cache",
           "by",
           {{"search", counters.pairs.searched},
            {"field", counters.pairs.from_fields},
            {"cache", counters.pairs.from_cache}}),
      Make(MetricType::Counter, "geodesic_meshes_built_total",
           "Meshes that uploads made resident", "",
           {{"", counters.meshes_built}}),
      Make(MetricType::Counter, "geodesic_meshes_loaded_total",
           "Meshes that came from disk into memory", "",
           {{"", counters.meshes_loaded}}),
      Make(MetricType::Counter, "geodesic_meshes_fetched_total",
           "Meshes that came from the shared tier", "",
           {{"", counters.meshes_fetched}}),
      Make(MetricType::Counter, "geodesic_fields_loaded_total",
           "Fields that came from disk or from the shared tier", "",
           {{"", counters.fields_loaded}}),
      Make(MetricType::Counter, "geodesic_landmarks_total",
           "Landmarks of meshes, by how they came about: computed, or loaded "
           "from disk or from the shared tier",
           "origin",
           {{"computed", engine.searches().landmarks().made()},
            {"loaded", engine.searches().landmarks().loaded()}}),
      Make(
          MetricType::Counter, "geodesic_methods_prepared_total",
          "What approximate algorithms needed of meshes, by how it came about: "
          "computed, or loaded from disk or from the shared tier",
          "origin",
          {{"computed", engine.methods().made()},
           {"loaded", engine.methods().loaded()}}),
      Make(MetricType::Counter, "geodesic_evictions_total",
           "Entries that went to make room", "store",
           {{"meshes", meshes.evictions()},
            {"fields", fields.cache().evictions()},
            {"landmarks", landmarks.evictions()},
            {"methods", methods.evictions()}}),
      Make(MetricType::Gauge, "geodesic_used_bytes",
           "Memory in use or reserved, by budget", "budget",
           {{"meshes", meshes.used_bytes()},
            {"fields", fields.cache().used_bytes()},
            {"uploads", engine.upload_memory().used()},
            {"solvers", engine.solver_memory().used()},
            {"landmarks", landmarks.used_bytes()},
            {"methods", methods.used_bytes()},
            {"requests", requests.used()}}),
      Make(MetricType::Gauge, "geodesic_capacity_bytes",
           "What each budget may hold", "budget",
           {{"meshes", limits.mesh_store_bytes},
            {"fields", limits.field_cache_bytes},
            {"uploads", limits.upload_memory_bytes},
            {"solvers", limits.solver_memory_bytes},
            {"landmarks", limits.landmark_memory_bytes},
            {"methods", limits.prepared_memory_bytes},
            {"requests", requests.capacity()}}),
      Make(MetricType::Gauge, "geodesic_jobs",
           "Jobs that run, and that wait for a thread", "state",
           {{"running", scheduler.running()}, {"queued", scheduler.queued()}}),
      Make(MetricType::Gauge, "geodesic_waiters",
           "Requests that wait for a field under way", "",
           {{"", fields.jobs().waiters()}}),
  };
  if (engine.durable() != nullptr) AppendDisk(*engine.durable(), families);
  return families;
}

std::vector<MetricFamily> CollectSharedTier(const RedisBlobs& tier) {
  const RedisCounters counters = tier.counters();
  return {
      Make(MetricType::Counter, "geodesic_shared_tier_reads_total",
           "Values that the shared tier was to give: found (hit), not there "
           "(miss), not given in time (failure), found to be wrong and deleted "
           "(wrong), or not asked for, since it is left alone (skipped)",
           "result",
           {{"hit", counters.hits},
            {"miss", counters.misses},
            {"failure", counters.failures},
            {"wrong", counters.wrong},
            {"skipped", counters.skipped}}),
      Make(MetricType::Counter, "geodesic_shared_tier_writes_total",
           "Values that it was to take: written, refused or not taken in time "
           "(failure), or not sent, since they are too large or too many or it "
           "is left alone (dropped)",
           "result",
           {{"written", counters.writes - counters.write_failures},
            {"failure", counters.write_failures},
            {"dropped", counters.dropped}}),
      Make(
          MetricType::Counter, "geodesic_shared_tier_bytes_total",
          "Bytes of values that came from it and went to it", "direction",
          {{"read", counters.bytes_read}, {"written", counters.bytes_written}}),
      Make(MetricType::Gauge, "geodesic_shared_tier_waiting_bytes",
           "Bytes that wait to be written to it", "",
           {{"", tier.waiting_bytes()}}),
      Make(MetricType::Gauge, "geodesic_shared_tier_left_alone",
           "1 while it is not asked, since it did not answer", "",
           {{"", tier.is_left_alone() ? uint64_t{1} : uint64_t{0}}}),
  };
}

}  // namespace geodesic::server
