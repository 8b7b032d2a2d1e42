// What approximate methods cost, and how far off they are.

#include <cmath>
#include <cstdint>
#include <ctime>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/measured.h"
#include "bench/paper/experiments.h"
#include "bench/paper/table.h"
#include "geodesic/approximate/prepare.h"
#include "geodesic/mesh_summary.h"
#include "geodesic/parallel_chen_han.h"
#include "geodesic/solve.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::paper {
namespace {

double ProcessorSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// A method on a mesh: processor seconds of one thread, and relative errors.
struct MethodCost {
  double prepare_seconds = 0;
  double prepared_mib = 0;
  double solve_seconds = 0;  // of the fastest run
  RelativeErrors errors;
};

// One mesh, with its exact distances.
class Comparison {
 public:
  Comparison(const Subject& subject, uint32_t source, int most_runs)
      : subject_(subject),
        most_runs_(most_runs),
        query_(*ValidQuery::Make({.sources = {{VertexPoint{source}}}},
                                 *subject.mesh)),
        exact_(Solve(*subject.mesh, query_, {}, checkpoint_)->distances) {}

  MethodCost Measure(ApproximateMethod method, const MethodOptions& options) {
    MethodCost cost;
    const double start = ProcessorSeconds();
    const auto prepared =
        PrepareMethod(*subject_.mesh, method, options, checkpoint_).value();
    cost.prepare_seconds = ProcessorSeconds() - start;
    cost.prepared_mib = static_cast<double>(prepared->bytes()) / (1 << 20);
    TakeFastest([&] { return prepared->Distances(query_, checkpoint_); }, cost);
    return cost;
  }

  // Of an exact algorithm, or of fwp-list within a tolerance.
  MethodCost Measure(Algorithm algorithm, double tolerance) {
    const ValidQuery query = *ValidQuery::Make({.sources = query_->sources,
                                                .algorithm = algorithm,
                                                .tolerance = tolerance},
                                               *subject_.mesh);
    MethodCost cost;
    TakeFastest([&] { return Solve(*subject_.mesh, query, {}, checkpoint_); },
                cost);
    return cost;
  }

  // Of parallel Chen-Han in one thread; the fastest run.
  double SecondsByLevels() {
    MethodCost cost;
    TakeFastest(
        [&] { return SolveByLevels(*subject_.mesh, query_, {}, checkpoint_); },
        cost);
    return cost.solve_seconds;
  }

 private:
  // What the fastest run of solve() takes, which gives a field, and its errors.
  template <typename SolveField>
  void TakeFastest(SolveField solve, MethodCost& cost) const {
    for (int run = 0; run < most_runs_; ++run) {
      const double before = ProcessorSeconds();
      const auto field = solve().value();
      const double seconds = ProcessorSeconds() - before;
      if (run == 0 || seconds < cost.solve_seconds) {
        cost.solve_seconds = seconds;
        cost.errors = CompareDistances(field.distances, exact_);
      }
    }
  }

  const Subject& subject_;
  const int most_runs_;
  NoCheckpoint checkpoint_;
  const ValidQuery query_;
  const std::vector<double> exact_;
};

// The models that the user gave, or a mesh that is made.
std::vector<Subject> Models(const Setting& setting) {
  if (!setting.models.empty()) {
    return {setting.models.begin(), setting.models.end()};
  }
  return {Generated("noisy-torus",
                    test::Torus({.around = 100, .across = 40, .noise = 0.02}))};
}

}  // namespace

void RunMethods(const Setting& setting) {
  Table table{"mesh",         "faces",   "g",      "method", "prepare s",
              "prepared MiB", "field s", "mean %", "max %"};
  for (const Subject& subject : Models(setting)) {
    const uint64_t faces = subject.mesh->face_count();
    const double g = Summarize(*subject.mesh).anisotropy;
    Comparison comparison(subject, subject.source(), setting.most_runs());
    const auto add = [&](const char* name, ApproximateMethod method,
                         const MethodOptions& options) {
      const MethodCost cost = comparison.Measure(method, options);
      table.Add(subject.name, faces, g, name, cost.prepare_seconds,
                cost.prepared_mib, cost.solve_seconds, 100 * cost.errors.mean,
                100 * cost.errors.largest);
    };
    add("heat", ApproximateMethod::kHeat, {});
    add("svg by fwp", ApproximateMethod::kSvg,
        {.svg = {.builder = SaddleGraphBuilder::kFwp}});
    add("svg by ich", ApproximateMethod::kSvg,
        {.svg = {.builder = SaddleGraphBuilder::kIch}});
    add("fmm", ApproximateMethod::kFmm, {});
    add("fmm-untidy", ApproximateMethod::kFmmUntidy, {});
    const auto add_exact = [&](std::string_view name, double seconds) {
      table.Add(subject.name, faces, g, name, 0, 0, seconds, 0, 0);
    };
    add_exact("pch", comparison.SecondsByLevels());
    for (const AlgorithmInfo& info : kAlgorithms) {
      if (!IsFeasible(info.algorithm, faces)) continue;
      const SolveStatistics cost =
          Measure(subject, info.algorithm, kPaperOptions, setting.most_runs());
      add_exact(info.name, cost.solve_seconds);
    }
  }
}

void RunNeighbours(const Setting& setting) {
  Table table{"mesh",        "faces", "K",       "by",     "prepare s",
              "ms a vertex", "MiB",   "field s", "mean %", "max %"};
  for (const Subject& subject : Models(setting)) {
    Comparison comparison(subject, subject.source(), setting.most_runs());
    for (const uint32_t neighbours : {10, 25, 50, 100, 200}) {
      if (setting.quick && neighbours > 50) break;
      for (const auto& [name, builder] :
           {std::pair("fwp", SaddleGraphBuilder::kFwp),
            std::pair("ich", SaddleGraphBuilder::kIch)}) {
        const MethodCost cost = comparison.Measure(
            ApproximateMethod::kSvg,
            {.svg = {.neighbours = neighbours, .builder = builder}});
        table.Add(subject.name, subject.mesh->face_count(), neighbours, name,
                  cost.prepare_seconds,
                  1e3 * cost.prepare_seconds / subject.mesh->vertex_count(),
                  cost.prepared_mib, cost.solve_seconds, 100 * cost.errors.mean,
                  100 * cost.errors.largest);
      }
    }
  }
}

void RunMarching(const Setting& setting) {
  Table table{"mesh", "faces", "g", "method", "field s", "mean %", "max %"};
  const auto add = [&](const Subject& subject) {
    Comparison comparison(subject, subject.source(), setting.most_runs());
    const double g = Summarize(*subject.mesh).anisotropy;
    for (const ApproximateMethod method :
         {ApproximateMethod::kFmm, ApproximateMethod::kFmmUntidy}) {
      const MethodCost cost = comparison.Measure(method, {});
      table.Add(subject.name, subject.mesh->face_count(), g,
                ApproximateMethodName(method), cost.solve_seconds,
                100 * cost.errors.mean, 100 * cost.errors.largest);
    }
  };
  // As in Fig. 7.
  const uint32_t vertices = setting.quick ? 1200 : 10000;
  for (const double aspect : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0}) {
    const auto across =
        static_cast<uint32_t>(std::lround(std::sqrt(vertices / 2.5 * aspect)));
    add(Generated(
        "torus", test::Torus({.around = vertices / across, .across = across})));
  }
  for (const Subject& model : setting.models) add(model);
}

void RunHeatTime(const Setting& setting) {
  Table table{"mesh", "faces", "g", "lambda", "mean %", "max %"};
  const auto add = [&](const Subject& subject, uint32_t source) {
    Comparison comparison(subject, source, 1);
    for (const double lambda :
         {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 40.0, 80.0, 160.0, 320.0, 640.0}) {
      const MethodCost cost = comparison.Measure(ApproximateMethod::kHeat,
                                                 {.heat = {.lambda = lambda}});
      table.Add(subject.name, subject.mesh->face_count(),
                Summarize(*subject.mesh).anisotropy, lambda,
                100 * cost.errors.mean, 100 * cost.errors.largest);
    }
  };
  const uint32_t meridians = setting.quick ? 40 : 200;
  const uint32_t bands = setting.quick ? 100 : 500;
  // From the equator: around the pole heat spreads the same way everywhere.
  add(Generated("sphere", test::UvSphere(meridians, bands)),
      1 + (bands / 2 - 1) * meridians);
  for (const Subject& model : setting.models) add(model, model.source());
}

void RunTradeOff(const Setting& setting) {
  Table table{"mesh",      "faces",   "program", "method", "setting",
              "prepare s", "field s", "mean",    "max"};
  for (const Subject& subject : Models(setting)) {
    const uint64_t faces = subject.mesh->face_count();
    Comparison comparison(subject, subject.source(), setting.most_runs());
    const auto add = [&](std::string_view method, std::string_view with,
                         const MethodCost& cost) {
      table.Add(subject.name, faces, "geodesic", method, with,
                cost.prepare_seconds, cost.solve_seconds, cost.errors.mean,
                cost.errors.largest);
    };
    for (const AlgorithmInfo& info : kAlgorithms) {
      if (!IsFeasible(info.algorithm, faces)) continue;
      add("exact", info.name, comparison.Measure(info.algorithm, 0));
    }
    for (const char* tolerance :
         {"1e-7", "1e-6", "1e-5", "1e-4", "1e-3", "1e-2", "1e-1"}) {
      add("tolerance", tolerance,
          comparison.Measure(Algorithm::kFwpList, std::stod(tolerance)));
    }
    for (const char* lambda : {"1", "10", "80"}) {
      add("heat", lambda,
          comparison.Measure(ApproximateMethod::kHeat,
                             {.heat = {.lambda = std::stod(lambda)}}));
    }
    add("fmm", "", comparison.Measure(ApproximateMethod::kFmm, {}));
    add("fmm-untidy", "",
        comparison.Measure(ApproximateMethod::kFmmUntidy, {}));
    for (const char* neighbours : {"10", "25", "50", "100", "200"}) {
      const auto k = static_cast<uint32_t>(std::stoul(neighbours));
      if (setting.quick && k > 50) break;
      add("svg", neighbours,
          comparison.Measure(ApproximateMethod::kSvg,
                             {.svg = {.neighbours = k}}));
    }
    for (const char* samples : {"100", "200", "400"}) {
      const auto m = static_cast<uint32_t>(std::stoul(samples));
      if (setting.quick && m > 100) break;
      add("gtu", samples,
          comparison.Measure(ApproximateMethod::kGtu, {.gtu = {.samples = m}}));
    }
  }
}

}  // namespace geodesic::paper
