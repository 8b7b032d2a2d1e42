#include "client/cli/commands/field_outputs.h"

#include <string>
#include <utility>

#include "client/output/columns.h"
#include "client/output/field_writers.h"
#include "client/output/npy.h"
#include "client/output/place_text.h"
#include "client/output/zip_archive.h"

namespace geodesic::client {
namespace {

// The field's columns: distances first, then what else was asked for.
std::vector<Column> ColumnsOf(const FieldOutputArguments& arguments,
                              const Field& field) {
  const NumberType real = NumberTypeOf(arguments.float32);
  std::vector<Column> columns = {
      {.name = kDistanceColumn, .values = field.distances, .type = real}};
  if (arguments.nearest_sources) {
    Column nearest = {.name = kNearestSourceColumn, .type = NumberType::kInt32};
    for (const uint32_t source : field.nearest_sources) {
      nearest.values.push_back(source == kNoSource ? -1.0 : source);
    }
    columns.push_back(std::move(nearest));
  }
  if (arguments.gradients) {
    Column gradients = {.name = kGradientColumn, .components = 3, .type = real};
    for (const auto& gradient : field.gradients) {
      gradients.values.insert(gradients.values.end(), gradient.begin(),
                              gradient.end());
    }
    columns.push_back(std::move(gradients));
  }
  return columns;
}

// Members: distances, and nearest_sources, gradients and target_distances where
// there are any.
absl::StatusOr<uint64_t> WriteNpz(const std::string& path,
                                  const std::vector<Column>& columns,
                                  const std::vector<double>& target_distances) {
  absl::StatusOr<ZipArchive> archive = ZipArchive::Create(path);
  if (!archive.ok()) return FileError(archive.status());
  for (const Column& column : columns) {
    const char* name = column.name == kNearestSourceColumn
                           ? "nearest_sources.npy"
                       : column.name == kGradientColumn ? "gradients.npy"
                                                        : "distances.npy";
    std::vector<uint64_t> shape = {column.count()};
    if (column.components > 1) shape.push_back(column.components);
    archive->Add(name, NpyArray(column.values, column.type, shape));
  }
  if (!target_distances.empty()) {
    archive->Add(
        "target_distances.npy",
        NpyArray(target_distances, columns[0].type, {target_distances.size()}));
  }
  absl::StatusOr<uint64_t> size = archive->Commit();
  if (!size.ok()) return FileError(size.status());
  return size;
}

bool NeedsMesh(OutputFormat format) {
  return format == OutputFormat::kPly || format == OutputFormat::kVtk ||
         format == OutputFormat::kPng;
}

PictureContent ContentOf(const Question& question, const Field& field,
                         const MeshArrays& mesh) {
  PictureContent content = {.distances = field.distances,
                            .nearest_sources = field.nearest_sources,
                            .isolines = true};
  for (const Source& source : question.sources) {
    content.source_names.push_back(SourceText(source));
  }
  ShowSources(question.sources, mesh, &content);
  for (const SurfacePoint& target : question.targets) {
    content.targets.push_back(PositionOf(target, mesh));
  }
  return content;
}

// Reads of a mesh's arrays with numbers that may be out of range.
class Locator {
 public:
  explicit Locator(const MeshArrays& mesh) : mesh_(mesh) {}

  Point operator()(const VertexPoint& point) const {
    return Vertex(point.vertex);
  }
  Point operator()(const EdgePoint& point) const {
    return Combine(
        {{1 - point.t, Vertex(point.from)}, {point.t, Vertex(point.to)}});
  }
  Point operator()(const FacePoint& point) const {
    if (point.face >= mesh_.triangles.size()) return {};
    const Triangle& corners = mesh_.triangles[point.face];
    return Combine({{point.weights[0], Vertex(corners[0])},
                    {point.weights[1], Vertex(corners[1])},
                    {point.weights[2], Vertex(corners[2])}});
  }

 private:
  Point Vertex(uint64_t vertex) const {
    return vertex < mesh_.positions.size() ? mesh_.positions[vertex] : Point{};
  }

  static Point Combine(const std::vector<std::pair<double, Point>>& weighted) {
    Point sum = {};
    for (const auto& [weight, point] : weighted) {
      for (size_t axis = 0; axis < sum.size(); ++axis) {
        sum[axis] += weight * point[axis];
      }
    }
    return sum;
  }

  const MeshArrays& mesh_;
};

}  // namespace

Point PositionOf(const SurfacePoint& point, const MeshArrays& mesh) {
  return std::visit(Locator(mesh), point);
}

void ShowSources(const std::vector<Source>& sources, const MeshArrays& mesh,
                 PictureContent* content) {
  for (const Source& source : sources) {
    if (const Curve* curve = std::get_if<Curve>(&source.place)) {
      PictureLine line;
      for (const SurfacePoint& point : curve->points) {
        line.points.push_back(PositionOf(point, mesh));
      }
      content->bold_lines.push_back(std::move(line));
      continue;
    }
    std::visit(
        [&](const auto& place) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(place)>, Curve>) {
            content->sources.push_back(PositionOf(place, mesh));
          }
        },
        source.place);
  }
}

absl::StatusOr<uint64_t> WritePicture(const std::string& path,
                                      const MeshArrays& mesh,
                                      const PictureContent& content,
                                      const PictureOptions& options) {
  absl::StatusOr<std::string> png = Render(mesh, content, options).EncodePng();
  if (!png.ok()) return png.status();
  return WriteFile(path, [&png](AtomicFile* file) {
    file->Append(*png);
    return absl::OkStatus();
  });
}

absl::StatusOr<std::vector<WrittenFile>> WriteFieldOutputs(
    const Session& session, const FieldOutputArguments& arguments,
    const std::vector<OutputArgument>& outputs, const Question& question,
    const Field& field) {
  const std::vector<Column> columns = ColumnsOf(arguments, field);
  MeshOnDemand mesh(session, field.mesh_digest);
  return WriteOutputs(
      session, outputs,
      [&](const OutputArgument& output) -> absl::StatusOr<uint64_t> {
        const MeshArrays* arrays = nullptr;
        if (NeedsMesh(output.format)) {
          absl::StatusOr<const MeshArrays*> got = mesh.Get(field.vertex_count);
          if (!got.ok()) return got.status();
          arrays = *got;
        }
        if (output.format == OutputFormat::kNpz) {
          return WriteNpz(output.path, columns, field.target_distances);
        }
        if (output.format == OutputFormat::kPng) {
          return WritePicture(output.path, *arrays,
                              ContentOf(question, field, *arrays),
                              arguments.picture);
        }
        return WriteFile(output.path, [&](AtomicFile* file) {
          switch (output.format) {
            case OutputFormat::kNpy:
              WriteNpy(columns[0], file);
              break;
            case OutputFormat::kCsv:
              WriteCsv(columns, file);
              break;
            case OutputFormat::kF64:
              WriteRaw(columns[0], NumberType::kFloat64, file);
              break;
            case OutputFormat::kF32:
              WriteRaw(columns[0], NumberType::kFloat32, file);
              break;
            case OutputFormat::kPly:
              WritePly(*arrays, columns, file);
              break;
            case OutputFormat::kVtk:
              WriteVtk(*arrays, columns, file);
              break;
            default:
              return absl::InternalError("no field format");
          }
          return absl::OkStatus();
        });
      });
}

}  // namespace geodesic::client
