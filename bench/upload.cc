// How long an upload takes, from the client's file to a mesh that a running
// server answers for, beside a plain loop that reads the same file.
//
//   upload [FILE] [--server HOST:PORT] [--faces F] [--repeat R]
//
// FILE is a binary PLY of floats and triangles; without one a terrain of F
// faces (default 200,000) is written and used. The mesh is deleted between two
// rounds. Prints one JSON line of medians in milliseconds: the plain loop,
// writing once the memory that the mesh will take, and the upload in three
// parts (hashing the file, asking for it and sending the first megabyte;
// sending the rest; the wait for the answer) with its ratio to the plain loop.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/plain_ply.h"
#include "geodesic_client/client.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/temporary_folder.h"

namespace geodesic {
namespace {

using Clock = std::chrono::steady_clock;

double Milliseconds(Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

void WriteTerrain(const std::string& path, uint32_t faces) {
  const auto side = static_cast<uint32_t>(std::ceil(std::sqrt(faces / 2)));
  const TriangleSoup soup = test::Terrain(side, side, 1, 1);
  std::ofstream file(path, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex "
       << soup.positions.size()
       << "\nproperty float x\nproperty float y\nproperty float z\n"
          "element face "
       << soup.triangles.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point& point : soup.positions) {
    for (const double coordinate : point) {
      const auto stored = static_cast<float>(coordinate);
      file.write(reinterpret_cast<const char*>(&stored), sizeof(stored));
    }
  }
  for (const Triangle& corners : soup.triangles) {
    file.put(3).write(reinterpret_cast<const char*>(corners.data()),
                      sizeof(corners));
  }
}

struct Round {
  double plain, fresh_memory, ask, send, answer;

  double upload() const { return ask + send + answer; }
};

double WriteFreshMemory(size_t bytes) {
  const Clock::time_point start = Clock::now();
  const auto memory = std::make_unique_for_overwrite<char[]>(bytes);
  std::memset(memory.get(), 1, bytes);
  // Or the compiler would leave it out.
  const volatile char last = memory[bytes - 1];
  static_cast<void>(last);
  return Milliseconds(Clock::now() - start);
}

absl::Status Fail(const std::string& message) {
  return absl::FailedPreconditionError(message);
}

absl::StatusOr<Round> MeasureOnce(client::Client& client,
                                  const std::string& path,
                                  client::MeshInfo& mesh) {
  Round round = {};
  Clock::time_point start = Clock::now();
  if (!ReadPlainPly(path)) return Fail(path + " is no plain PLY");
  round.plain = Milliseconds(Clock::now() - start);

  start = Clock::now();
  Clock::time_point first = start, last = start;
  absl::StatusOr<client::UploadOutcome> upload =
      client.UploadFile(path, {}, [&](uint64_t, uint64_t) {
        last = Clock::now();
        if (first == start) first = last;
      });
  const Clock::time_point end = Clock::now();
  if (!upload.ok()) return upload.status();
  if (upload->already_resident) return Fail("the mesh was there already");
  round.ask = Milliseconds(first - start);
  round.send = Milliseconds(last - first);
  round.answer = Milliseconds(end - last);
  mesh = upload->mesh;
  round.fresh_memory = WriteFreshMemory(mesh.resident_bytes);
  absl::Status status = client.DeleteMesh(mesh.digest);
  if (!status.ok()) return status;
  return round;
}

template <typename Value>
double Median(std::vector<Round>& rounds, Value value) {
  std::ranges::sort(rounds, {}, value);
  return std::invoke(value, rounds[rounds.size() / 2]);
}

absl::Status Measure(const std::string& server, const std::string& path,
                     int repeat) {
  client::Client client(server);
  client::MeshInfo mesh;
  std::vector<Round> rounds;
  for (int i = 0; i < repeat; ++i) {
    absl::StatusOr<Round> round = MeasureOnce(client, path, mesh);
    if (!round.ok()) return round.status();
    rounds.push_back(*round);
  }
  const double plain = Median(rounds, &Round::plain);
  const double upload = Median(rounds, &Round::upload);
  const nlohmann::ordered_json line = {
      {"faces", mesh.face_count},
      {"repeat", repeat},
      {"plain_ms", plain},
      {"fresh_memory_ms", Median(rounds, &Round::fresh_memory)},
      {"ask_ms", Median(rounds, &Round::ask)},
      {"send_ms", Median(rounds, &Round::send)},
      {"answer_ms", Median(rounds, &Round::answer)},
      {"upload_ms", upload},
      {"upload_best_ms", std::ranges::min(rounds, {}, &Round::upload).upload()},
      {"upload/plain", upload / plain}};
  std::cout << line.dump() << std::endl;
  return absl::OkStatus();
}

}  // namespace
}  // namespace geodesic

int main(int argc, char** argv) {
  CLI::App app("How long an upload takes beside a plain loop over the file",
               "upload");
  std::string server = "127.0.0.1:50051", path;
  uint32_t faces = 200'000;
  int repeat = 15;
  app.add_option("FILE", path, "A binary PLY; a terrain without one")
      ->check(CLI::ExistingFile);
  app.add_option("--server", server, "Where it listens")->capture_default_str();
  app.add_option("--faces", faces, "Faces of the terrain")
      ->check(CLI::Range(2, 30'000'000))
      ->capture_default_str();
  app.add_option("--repeat", repeat, "Uploads that are timed")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const geodesic::test::TemporaryFolder folder;
  if (path.empty()) {
    path = folder / "terrain.ply";
    geodesic::WriteTerrain(path, faces);
  }
  const absl::Status status = geodesic::Measure(server, path, repeat);
  if (status.ok()) return 0;
  std::cerr << "upload: " << status << std::endl;
  return 1;
}
