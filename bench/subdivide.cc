// subdivide: writes a mesh file with Loop's subdivision as a binary PLY, for
// measurements on larger meshes than there are files of.

#include <CLI/CLI.hpp>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <fstream>
#include <iostream>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/mesh.h"
#include "geodesic/mesh_file.h"
#include "geodesic/open_mesh.h"

namespace geodesic {
namespace {

struct Options {
  std::string input, output;
  int times = 1;
};

// Little endian, as the machine is.
template <typename Number>
void Put(std::ostream& file, Number number) {
  file.write(reinterpret_cast<const char*>(&number), sizeof(number));
}

absl::Status Write(const TriangleSoup& soup, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex "
       << soup.positions.size()
       << "\nproperty double x\nproperty double y\nproperty double z\n"
          "element face "
       << soup.triangles.size()
       << "\nproperty list uchar uint vertex_indices\nend_header\n";
  for (const Point& position : soup.positions) {
    for (const double coordinate : position) Put(file, coordinate);
  }
  for (const Triangle& triangle : soup.triangles) {
    Put(file, uint8_t{3});
    for (const uint32_t corner : triangle) Put(file, corner);
  }
  if (!file.flush()) return absl::UnavailableError("cannot write " + path);
  return absl::OkStatus();
}

absl::Status Run(const Options& options) {
  absl::StatusOr<std::shared_ptr<const Mesh>> mesh =
      ReadMeshFile(options.input);
  if (!mesh.ok()) return mesh.status();
  OpenMesh::TriMesh open_mesh = ToOpenMesh(**mesh);
  OpenMesh::Subdivider::Uniform::LoopT<OpenMesh::TriMesh> subdivider;
  if (!subdivider(open_mesh, static_cast<size_t>(options.times))) {
    return absl::InternalError("cannot subdivide " + options.input);
  }
  return Write(FromOpenMesh(open_mesh), options.output);
}

}  // namespace
}  // namespace geodesic

int main(int argc, char** argv) {
  CLI::App app{"Writes a mesh file with Loop's subdivision as a binary PLY."};
  geodesic::Options options;
  app.add_option("INPUT", options.input, "OBJ, PLY, OFF or STL file")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("OUTPUT", options.output, "PLY file")->required();
  app.add_option("--times", options.times, "each makes four faces of one")
      ->check(CLI::Range(1, 6))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  if (absl::Status status = geodesic::Run(options); !status.ok()) {
    std::cerr << "subdivide: " << std::string(status.message()) << "\n";
    return 1;
  }
  return 0;
}
