// How fast a cached field streams from a running server to the C++ client.
//
//   stream_field [HOST:PORT] [--vertices V] [--repeat R]
//
// Uploads a flat triangulated square of V vertices (default 200,000), has its
// field computed once, and fetches it R more times (default 200). Fails unless
// the distances are Euclid's, and the same each time. Prints one JSON line:
// bytes of a field, median and best seconds of a call, and the median's rate in
// GB/s.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geodesic_client/client.h"

namespace geodesic::client {
namespace {

// A flat square of about this many vertices.
MeshArrays Square(uint32_t vertex_count) {
  const auto side = static_cast<uint32_t>(std::ceil(std::sqrt(vertex_count)));
  MeshArrays mesh;
  for (uint32_t j = 0; j < side; ++j) {
    for (uint32_t i = 0; i < side; ++i) {
      mesh.positions.push_back(
          {static_cast<double>(i), static_cast<double>(j), 0});
      if (i == 0 || j == 0) continue;
      const uint32_t d = i + j * side;
      mesh.triangles.push_back({d - side - 1, d - side, d});
      mesh.triangles.push_back({d - side - 1, d, d - 1});
    }
  }
  return mesh;
}

// Whether these are the distances from the square's first corner.
bool AreEuclids(const std::vector<double>& distances,
                const MeshArrays& square) {
  return std::ranges::equal(
      distances, square.positions, [](double distance, const Point& p) {
        return std::abs(distance - std::hypot(p[0], p[1])) <= 1e-10 * distance;
      });
}

int Fail(const absl::Status& status) {
  std::cerr << "stream_field: " << status << std::endl;
  return 1;
}

int Measure(const std::string& server, uint32_t vertex_count, int repeat) {
  Client client(server);
  const MeshArrays square = Square(vertex_count);
  absl::StatusOr<UploadOutcome> upload = client.UploadArrays(square);
  if (!upload.ok()) return Fail(upload.status());
  const FieldQuery query = {.mesh_digest = upload->mesh.digest,
                            .sources = {{VertexPoint{0}}}};
  absl::StatusOr<Field> field = client.ComputeField(query);
  if (!field.ok()) return Fail(field.status());
  const std::vector<double> distances = field->distances;
  if (!AreEuclids(distances, square)) {
    return Fail(absl::DataLossError("the distances are wrong"));
  }
  const size_t bytes = distances.size() * sizeof(double);

  std::vector<double> seconds;
  for (int i = 0; i < repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    field = client.ComputeField(query);
    const std::chrono::duration<double> elapsed =
        std::chrono::steady_clock::now() - start;
    if (!field.ok()) return Fail(field.status());
    if (field->origin != FieldOrigin::kCached) {
      return Fail(absl::FailedPreconditionError("the field was not cached"));
    }
    if (field->distances != distances) {
      return Fail(absl::DataLossError("the distances have changed"));
    }
    seconds.push_back(elapsed.count());
  }
  std::ranges::sort(seconds);
  const double median = seconds[seconds.size() / 2];
  const nlohmann::ordered_json line = {
      {"vertices", distances.size()},
      {"bytes", bytes},
      {"repeat", repeat},
      {"median_s", median},
      {"best_s", seconds.front()},
      {"median_gb_per_s", 1e-9 * static_cast<double>(bytes) / median}};
  std::cout << line.dump() << std::endl;
  return 0;
}

}  // namespace
}  // namespace geodesic::client

int main(int argc, char** argv) {
  CLI::App app("How fast a cached field streams from a geodesicd server",
               "stream_field");
  std::string server = "127.0.0.1:50051";
  uint32_t vertices = 200'000;
  int repeat = 200;
  app.add_option("SERVER", server, "Where the server listens")
      ->capture_default_str();
  app.add_option("--vertices", vertices, "Vertices of the mesh")
      ->check(CLI::Range(4, 100'000'000))
      ->capture_default_str();
  app.add_option("--repeat", repeat, "Calls that are timed")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return geodesic::client::Measure(server, vertices, repeat);
}
