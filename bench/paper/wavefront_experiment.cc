// The wavefront over time.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "bench/paper/experiments.h"
#include "bench/paper/recording_queue.h"
#include "bench/paper/table.h"
#include "solver/propagation.h"
#include "solver/queues/binary_heap.h"
#include "solver/queues/fwp_buckets.h"
#include "solver/queues/label_correcting.h"
#include "solver/rules/ch_rule.h"
#include "solver/rules/mmp_rule.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::paper {
namespace {

// Labels in mean edge lengths.
template <template <typename> typename Rule, WindowQueue Queue>
void Record(const Subject& subject, Algorithm algorithm, Table& table) {
  const Mesh& mesh = *subject.mesh;
  const ValidQuery query =
      ValidQuery::Make({.sources = {{VertexPoint{subject.source()}}},
                        .algorithm = algorithm},
                       mesh)
          .value();
  const double h = mesh.mean_edge_length();
  const Tuning tuning{
      .bucket_width = h / std::sqrt(static_cast<double>(mesh.face_count())),
      .max_batch = kPaperOptions.max_batch};
  Propagation<Rule, RecordingQueue<Queue>> propagation(mesh, query, tuning,
                                                       nullptr);
  NoCheckpoint checkpoint;
  const absl::Status status = propagation.Advance({}, checkpoint);
  if (!status.ok()) std::cerr << status << "\n", std::abort();
  const RecordingQueue<Queue>& queue = propagation.queue();
  for (const WavefrontSample& sample : queue.samples()) {
    table.Add(subject.name, mesh.face_count(), AlgorithmName(algorithm),
              static_cast<double>(sample.popped) /
                  static_cast<double>(queue.popped()),
              sample.windows, sample.k, sample.mean_label / h,
              sample.label_deviation / h);
  }
}

}  // namespace

void RunWavefront(const Setting& setting) {
  const uint32_t cells = setting.quick ? 25 : 100;
  std::vector<Subject> subjects = {
      Generated("sphere", test::Icosphere(setting.quick ? 3 : 5)),
      Generated("terrain", test::Terrain(cells, cells, 1, 1))};
  subjects.insert(subjects.end(), setting.models.begin(), setting.models.end());
  Table table({"mesh", "faces", "algorithm", "time", "wavefront", "K",
               "mean label/h", "label deviation/h"});
  for (const Subject& subject : subjects) {
    Record<MmpRule, BinaryHeap>(subject, Algorithm::kMmp, table);
    Record<MmpRule, FwpBuckets>(subject, Algorithm::kFwpMmp, table);
    Record<MmpRule, LabelCorrecting>(subject, Algorithm::kLcMmp, table);
    Record<IchRule, BinaryHeap>(subject, Algorithm::kIch, table);
    Record<IchRule, FwpBuckets>(subject, Algorithm::kFwpCh, table);
    Record<IchRule, LabelCorrecting>(subject, Algorithm::kLcCh, table);
  }
}

}  // namespace geodesic::paper
