#include "bench/subject.h"

#include <filesystem>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "bench/load_mesh.h"

namespace geodesic {

Subject Generated(std::string name, TriangleSoup soup) {
  return {std::move(name), Mesh::Build(std::move(soup)).value()};
}

absl::StatusOr<std::vector<Subject>> LoadSubjects(
    std::span<const std::string> files) {
  std::vector<Subject> subjects;
  for (const std::string& file : files) {
    absl::StatusOr<std::shared_ptr<const Mesh>> mesh = LoadMesh(file);
    if (!mesh.ok()) {
      return absl::Status(mesh.status().code(),
                          absl::StrCat(file, ": ", mesh.status().message()));
    }
    subjects.push_back(
        {std::filesystem::path(file).stem().string(), *std::move(mesh)});
  }
  return subjects;
}

}  // namespace geodesic
