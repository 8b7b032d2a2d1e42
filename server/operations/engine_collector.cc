#include "server/operations/engine_collector.h"

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>

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
                  std::initializer_list<Sample> samples) {
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

}  // namespace

std::vector<MetricFamily> EngineCollector::Collect() const {
  const EngineCounters counters = engine_.counters();
  const Limits& limits = engine_.limits();
  const MeshStore& meshes = engine_.meshes();
  const FieldEngine& fields = engine_.fields();
  const Scheduler& scheduler = engine_.scheduler();
  return {
      Make(
          MetricType::Counter, "geodesic_field_answers_total",
          "Questions about a field, by how it came about: computed, continued, "
          "joined (coalesced with one under way), cached",
          "origin",
          {{"computed", counters.solves_started - counters.solves_continued},
           {"continued", counters.solves_continued},
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
            {"fields", fields.fields().evictions()}}),
      Make(MetricType::Gauge, "geodesic_used_bytes",
           "Memory in use or reserved, by budget", "budget",
           {{"meshes", meshes.used_bytes()},
            {"fields", fields.fields().used_bytes()},
            {"computations", fields.computations().used_bytes()},
            {"uploads", engine_.upload_memory().used()},
            {"solvers", engine_.solver_memory().used()}}),
      Make(MetricType::Gauge, "geodesic_capacity_bytes",
           "What each budget may hold", "budget",
           {{"meshes", limits.mesh_store_bytes},
            {"fields", limits.field_cache_bytes},
            {"computations", limits.computation_store_bytes},
            {"uploads", limits.upload_memory_bytes},
            {"solvers", limits.solver_memory_bytes}}),
      Make(MetricType::Gauge, "geodesic_jobs",
           "Jobs that run, and that wait for a thread", "state",
           {{"running", scheduler.running()}, {"queued", scheduler.queued()}}),
      Make(MetricType::Gauge, "geodesic_waiters",
           "Requests that wait for a field under way", "",
           {{"", fields.flights().waiters()}}),
  };
}

}  // namespace geodesic::server
