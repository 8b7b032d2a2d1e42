#include "bench/subject.h"

#include <filesystem>
#include <utility>

#include "geodesic/mesh_file.h"

namespace geodesic {

Subject Generated(std::string name, TriangleSoup soup) {
  return {std::move(name), Mesh::Build(std::move(soup)).value()};
}

absl::StatusOr<std::vector<Subject>> LoadSubjects(
    std::span<const std::string> files) {
  std::vector<Subject> subjects;
  for (const std::string& file : files) {
    absl::StatusOr<std::shared_ptr<const Mesh>> mesh = ReadMeshFile(file);
    if (!mesh.ok()) return mesh.status();
    subjects.push_back(
        {std::filesystem::path(file).stem().string(), *std::move(mesh)});
  }
  return subjects;
}

}  // namespace geodesic
