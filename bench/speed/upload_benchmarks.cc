#include <benchmark/benchmark.h>

#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "bench/plain_ply.h"
#include "bench/speed/benchmarks.h"
#include "digest/sha256.h"
#include "geodesic/mesh_summary.h"
#include "geodesic/read_mesh.h"
#include "server/engine/jobs/thread_pool.h"
#include "server/engine/meshes/mesh_digest.h"
#include "server/engine/query_engine.h"

namespace geodesic::speed {
namespace {

// As a client's messages.
constexpr size_t kChunk = size_t{1} << 20;

std::string BytesOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// From the first byte received to the mesh that queries find.
bool Upload(server::QueryEngine& engine, std::string_view bytes,
            MeshFormat format) {
  auto upload = engine.meshes().StartUpload(
      {.format = format, .size_bytes = bytes.size()});
  if (!upload.ok()) return false;
  for (size_t at = 0; at < bytes.size(); at += kChunk) {
    if (!(*upload)->Append(at, bytes.substr(at, kChunk)).ok()) return false;
  }
  std::promise<bool> resident;
  const auto job = engine.meshes().FinishUpload(
      *std::move(upload),
      [&resident](const absl::StatusOr<server::UploadResult>& result) {
        resident.set_value(result.ok());
      });
  return job.ok() && resident.get_future().get();
}

void MeasureWhole(benchmark::State& state, const std::string& bytes,
                  MeshFormat format) {
  const server::SteadyClock clock;
  for (auto _ : state) {
    state.PauseTiming();
    server::ThreadPool pool(1);
    std::optional<server::QueryEngine> engine(std::in_place, server::Limits(),
                                              clock, pool);
    state.ResumeTiming();
    if (!Upload(*engine, bytes, format)) state.SkipWithError("refused");
    state.PauseTiming();
    engine.reset();
    state.ResumeTiming();
  }
}

void MeasureReceive(benchmark::State& state, std::string_view bytes) {
  for (auto _ : state) {
    Sha256 hash;
    std::vector<char> received;
    for (size_t at = 0; at < bytes.size(); at += kChunk) {
      const std::string_view chunk = bytes.substr(at, kChunk);
      received.insert(received.end(), chunk.begin(), chunk.end());
      hash.Update(chunk);
    }
    benchmark::DoNotOptimize(hash.FinishHex());
  }
}

void MeasureBuild(benchmark::State& state, const TriangleSoup& soup) {
  for (auto _ : state) {
    state.PauseTiming();
    TriangleSoup copy = soup;
    state.ResumeTiming();
    std::shared_ptr<const Mesh> mesh = Mesh::Build(std::move(copy)).value();
    state.PauseTiming();
    mesh.reset();
    state.ResumeTiming();
  }
}

}  // namespace

void RegisterUpload(const std::string& file, int rounds) {
  const absl::StatusOr<MeshFormat> named = MeshFormatFromPath(file);
  if (!named.ok()) return;
  const MeshFormat format = *named;
  const auto add = [&](const char* step, auto measure) {
    benchmark::RegisterBenchmark(
        absl::StrCat("upload/", step, "/",
                     std::filesystem::path(file).stem().string())
            .c_str(),
        measure)
        ->Repetitions(rounds)
        ->MeasureProcessCPUTime()
        ->Unit(benchmark::kMillisecond);
  };
  using State = benchmark::State;
  if (ReadPlainPly(file).has_value()) {
    add("plain", [file](State& state) {
      for (auto _ : state) benchmark::DoNotOptimize(ReadPlainPly(file));
    });
  }
  add("receive",
      [file](State& state) { MeasureReceive(state, BytesOf(file)); });
  add("parse", [file, format](State& state) {
    const std::string bytes = BytesOf(file);
    for (auto _ : state) {
      benchmark::DoNotOptimize(ReadMesh(bytes, format).value());
    }
  });
  add("digest", [file, format](State& state) {
    const TriangleSoup soup = ReadMesh(BytesOf(file), format).value();
    for (auto _ : state) {
      benchmark::DoNotOptimize(server::MeshDigest(soup));
    }
  });
  add("build", [file, format](State& state) {
    MeasureBuild(state, ReadMesh(BytesOf(file), format).value());
  });
  add("summarize", [file, format](State& state) {
    const auto mesh =
        Mesh::Build(ReadMesh(BytesOf(file), format).value()).value();
    for (auto _ : state) benchmark::DoNotOptimize(Summarize(*mesh));
  });
  add("whole", [file, format](State& state) {
    MeasureWhole(state, BytesOf(file), format);
  });
}

}  // namespace geodesic::speed
