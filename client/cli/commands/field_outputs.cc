#include "client/cli/commands/field_outputs.h"

#include <cerrno>
#include <fstream>
#include <list>
#include <stop_token>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/drawings.h"
#include "client/output/binary_numbers.h"
#include "client/output/field_writers.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"
#include "client/output/zip_archive.h"

namespace geodesic::client {
namespace {

// The field's columns: distances first, then what else was asked for.
std::vector<Column> ColumnsOf(const FieldArguments& arguments,
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
    archive->Add(name, NpyArray(column.values, column.type, column.shape()));
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
  ShowTargets(question.targets, mesh, &content);
  return content;
}

// The files of the outputs, or the terminal.
class Rows {
 public:
  Rows(const Session& session, const std::vector<OutputArgument>& outputs)
      : outputs_(outputs) {
    for (const OutputArgument& output : outputs) {
      places_.push_back(&files_.emplace_back(output.path));
    }
    if (outputs.empty()) places_.push_back(&session.out);
  }

  void Write(const std::string& text) {
    for (std::ostream* place : places_) *place << text;
  }

  // Whether all is written so far.
  bool Flush() {
    bool good = true;
    for (std::ostream* place : places_) good &= !place->flush().fail();
    if (!good && error_ == 0) error_ = errno;
    return good;
  }

  absl::Status Close(std::vector<WrittenFile>* written) {
    if (!Flush()) {
      return outputs_.empty() ? OutputFailed()
                              : FileError(absl::ErrnoToStatus(
                                    error_, absl::StrCat("cannot write ",
                                                         outputs_[0].path)));
    }
    auto file = files_.begin();
    for (const OutputArgument& output : outputs_) {
      written->push_back({output, static_cast<uint64_t>((file++)->tellp())});
    }
    return absl::OkStatus();
  }

 private:
  const std::vector<OutputArgument>& outputs_;
  std::list<std::ofstream> files_;
  std::vector<std::ostream*> places_;
  int error_ = 0;
};

}  // namespace

absl::StatusOr<std::vector<WrittenFile>> WriteFieldOutputs(
    const Session& session, const FieldArguments& arguments,
    const Question& question, const Field& field) {
  const std::vector<Column> columns = ColumnsOf(arguments, field);
  MeshOnDemand mesh(session, field.mesh_digest);
  return WriteOutputs(
      session, arguments.outputs,
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
            default:
              WriteVtk(*arrays, columns, file);
          }
        });
      });
}

absl::StatusOr<Field> StreamRows(const Session& session,
                                 const FieldQuery& query,
                                 const std::vector<OutputArgument>& outputs,
                                 Stopwatch* watch, FieldExtremes* extremes,
                                 std::vector<WrittenFile>* written) {
  // A stop asked for by the user, or because nothing more can be written.
  std::stop_source stop;
  const std::stop_callback pass_on(session.call.stop,
                                   [&stop] { stop.request_stop(); });
  CallOptions call = session.call;
  call.stop = stop.get_token();

  Rows rows(session, outputs);
  rows.Write(absl::StrCat("vertex,", kDistanceColumn, "\n"));
  if (!rows.Flush()) stop.request_stop();
  CsvLine line;
  const auto on_settled = [&](std::span<const SettledVertex> settled) {
    for (const SettledVertex& vertex : settled) {
      extremes->Add(vertex.vertex, vertex.distance);
      line.Integer(vertex.vertex).Number(vertex.distance);
      rows.Write(line.End());
    }
    if (!rows.Flush()) stop.request_stop();
  };
  absl::StatusOr<Field> field =
      session.client.StreamField(query, on_settled, call, watch->OnSolve());
  if (absl::Status status = rows.Close(written); !status.ok()) return status;
  return field;
}

}  // namespace geodesic::client
