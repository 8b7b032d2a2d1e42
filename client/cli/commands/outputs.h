// The files and pictures that an answer is written to.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_OUTPUTS_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_OUTPUTS_H_

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "client/cli/arguments/options.h"
#include "client/cli/commands/command.h"
#include "client/output/atomic_file.h"
#include "client/output/field_writers.h"
#include "geodesic_client/answer.h"

namespace geodesic::client {

// The mesh that was asked about, for outputs that hold or show it.
// Errors: those of Client::ReadMesh; DATA_LOSS if its vertex count is not the
// answer's.
absl::StatusOr<MeshArrays> FetchMesh(const Session& session,
                                     const AnswerInfo& info);

// Where a point lies in space. One that the mesh does not have lies anywhere.
Point PositionOf(const SurfacePoint& point, const MeshArrays& mesh);

struct WrittenFile {
  OutputArgument output;
  uint64_t bytes = 0;
};

// Writes the whole file or nothing. Returns its size in bytes.
absl::StatusOr<uint64_t> WriteFile(
    const std::string& path, const std::function<void(AtomicFile*)>& write);

// Writes values at the vertices of the mesh that was asked about to `path` as
// .ply, and returns the size in bytes. Where MESH is itself such a file, all
// that it holds stays (extended_ply.h). If it cannot, for the file has changed
// meanwhile perhaps, `mesh` is written, and standard error says so; to write it
// over that file is an error.
absl::StatusOr<uint64_t> WriteAnswerAsPly(const Session& session,
                                          const MeshArgument& argument,
                                          const AnswerInfo& info,
                                          const MeshArrays& mesh,
                                          std::span<const Column> columns,
                                          const std::string& mark,
                                          const std::string& path);

// Draws the picture and writes it. Returns its size in bytes.
absl::StatusOr<uint64_t> WritePicture(const std::string& path,
                                      const MeshArrays& mesh,
                                      const PictureContent& content,
                                      const PictureOptions& options);

// Shows the sources in a picture: points as dots, curves as bold lines. Places
// that the mesh does not have may appear anywhere.
void ShowSources(const std::vector<Source>& sources, const MeshArrays& mesh,
                 PictureContent* content);

// Shows the targets in a picture as dots.
void ShowTargets(const std::vector<SurfacePoint>& targets,
                 const MeshArrays& mesh, PictureContent* content);

// Calls `write` for every output, with the mesh of the answer if the format is
// among `with_mesh`, otherwise with an empty mesh.
absl::StatusOr<std::vector<WrittenFile>> WriteOutputs(
    const Session& session, const std::vector<OutputArgument>& outputs,
    const AnswerInfo& info, std::initializer_list<OutputFormat> with_mesh,
    const std::function<absl::StatusOr<uint64_t>(
        const OutputArgument&, const MeshArrays& mesh)>& write);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_OUTPUTS_H_
