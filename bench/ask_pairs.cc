// How fast a running server answers pairs of vertices to the C++ client.
//
//   ask_pairs MESH_FILE [HOST:PORT] [--landmarks] [--single N] [--list N]
//
// Uploads the mesh, has its landmarks made with --landmarks, and asks for
// random pairs: some by a call each, one after the other, then a list of others
// in one call. Prints one JSON line: seconds of a single call (median, 99th
// percentile), and pairs a second of the list.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "geodesic_client/client.h"

namespace geodesic::client {
namespace {

struct Wishes {
  std::string mesh_file;
  std::string server = "127.0.0.1:50051";
  bool landmarks = false;
  uint32_t single = 1000, list = 2000;
  uint32_t seed = 1;
};

// What the server makes of a mesh that has as many vertices.
constexpr uint64_t kLandmarks = 64;

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

int Fail(const absl::Status& status) {
  std::cerr << "ask_pairs: " << status << std::endl;
  return 1;
}

// The server makes them between questions about pairs.
absl::Status AwaitLandmarks(Client& client, const std::string& digest) {
  const absl::StatusOr<PairAnswer> asked = client.ComputePairs(
      {.mesh_digest = digest, .pairs = {{VertexPoint{0}, VertexPoint{1}}}});
  if (!asked.ok()) return asked.status();
  for (;;) {
    const absl::StatusOr<MeshInfo> mesh = client.GetMesh(digest);
    if (!mesh.ok()) return mesh.status();
    if (mesh->landmark_count >= kLandmarks) return absl::OkStatus();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

int Measure(const Wishes& wishes) {
  Client client(wishes.server);
  const absl::StatusOr<UploadOutcome> upload =
      client.UploadFile(wishes.mesh_file);
  if (!upload.ok()) return Fail(upload.status());
  const std::string& digest = upload->mesh.digest;
  nlohmann::ordered_json line = {{"faces", upload->mesh.faces},
                                 {"landmarks", wishes.landmarks}};
  if (wishes.landmarks) {
    const auto start = std::chrono::steady_clock::now();
    const absl::Status status = AwaitLandmarks(client, digest);
    if (!status.ok()) return Fail(status);
    line["prepare_s"] = SecondsSince(start);
  }

  std::mt19937 random(wishes.seed);
  std::uniform_int_distribution<uint32_t> any(
      0, static_cast<uint32_t>(upload->mesh.vertices - 1));
  PairQuery query{.mesh_digest = digest};
  std::vector<double> seconds;
  for (uint32_t i = 0; i < wishes.single; ++i) {
    query.pairs = {{VertexPoint{any(random)}, VertexPoint{any(random)}}};
    const auto start = std::chrono::steady_clock::now();
    const auto answer = client.ComputePairs(query);
    if (!answer.ok()) return Fail(answer.status());
    seconds.push_back(SecondsSince(start));
  }
  std::ranges::sort(seconds);
  line["single"] = wishes.single;
  line["median_s"] = seconds[seconds.size() / 2];
  line["p99_s"] = seconds[seconds.size() * 99 / 100];

  query.pairs.clear();
  for (uint32_t i = 0; i < wishes.list; ++i) {
    query.pairs.push_back({VertexPoint{any(random)}, VertexPoint{any(random)}});
  }
  const auto start = std::chrono::steady_clock::now();
  const auto answer = client.ComputePairs(query);
  if (!answer.ok()) return Fail(answer.status());
  line["list"] = wishes.list;
  line["pairs_per_s"] = wishes.list / SecondsSince(start);
  line["searched"] = answer->summary.searched;
  std::cout << line.dump() << std::endl;
  return 0;
}

}  // namespace
}  // namespace geodesic::client

int main(int argc, char** argv) {
  CLI::App app("How fast a geodesicd server answers pairs of vertices",
               "ask_pairs");
  geodesic::client::Wishes wishes;
  app.add_option("MESH_FILE", wishes.mesh_file,
                 "A mesh that has no vertex "
                 "without faces")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("SERVER", wishes.server, "Where the server listens")
      ->capture_default_str();
  app.add_flag("--landmarks", wishes.landmarks, "Have landmarks made first");
  app.add_option("--single", wishes.single, "Pairs that are asked one by one")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--list", wishes.list, "Pairs of the list")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seed", wishes.seed, "Of the random pairs")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return geodesic::client::Measure(wishes);
}
