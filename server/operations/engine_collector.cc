#include "server/operations/engine_collector.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace geodesic::server {
namespace {

using prometheus::MetricFamily;
using prometheus::MetricType;

struct Sample {
  std::string label;
  uint64_t value;
};

// A family whose members differ in the label called `name`; without a name
// there is one member.
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

// What the data folder takes and does.
void AppendDisk(const DurableStore& durable,
                std::vector<MetricFamily>& families) {
  const BlobStore& meshes = durable.meshes->blobs();
  const BlobStore& fields = durable.fields->blobs();
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

std::vector<MetricFamily> CollectEngine(const QueryEngine& engine,
                                        const ByteBudget& requests) {
  const EngineCounters counters = engine.counters();
  const Limits& limits = engine.limits();
  const MeshStore& meshes = engine.meshes().store();
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
      Make(MetricType::Counter, "geodesic_meshes_built_total",
           "Meshes that uploads made resident", "",
           {{"", counters.meshes_built}}),
      Make(MetricType::Counter, "geodesic_evictions_total",
           "Entries that went to make room", "store",
           {{"meshes", meshes.evictions()},
            {"fields", fields.cache().evictions()}}),
      Make(MetricType::Gauge, "geodesic_used_bytes",
           "Memory in use or reserved, by budget", "budget",
           {{"meshes", meshes.used_bytes()},
            {"fields", fields.cache().used_bytes()},
            {"uploads", engine.upload_memory().used()},
            {"solvers", engine.solver_memory().used()},
            {"requests", requests.used()}}),
      Make(MetricType::Gauge, "geodesic_capacity_bytes",
           "What each budget may hold", "budget",
           {{"meshes", limits.mesh_store_bytes},
            {"fields", limits.field_cache_bytes},
            {"uploads", limits.upload_memory_bytes},
            {"solvers", limits.solver_memory_bytes},
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

}  // namespace geodesic::server
