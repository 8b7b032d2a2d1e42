// A distance field into the files the command line names.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_FIELD_OUTPUTS_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_FIELD_OUTPUTS_H_

#include <vector>

#include "absl/status/statusor.h"
#include "client/cli/commands/question.h"
#include "client/picture/picture.h"
#include "geodesic_client/field.h"

namespace geodesic::client {

// What a field's files hold.
struct FieldOutputArguments {
  bool nearest_sources = false;
  bool gradients = false;
  bool float32 = false;
  PictureOptions picture;
};

absl::StatusOr<std::vector<WrittenFile>> WriteFieldOutputs(
    const Session& session, const FieldOutputArguments& arguments,
    const std::vector<OutputArgument>& outputs, const Question& question,
    const Field& field);

// Where a point lies in space. A point that the mesh does not have is anywhere.
Point PositionOf(const SurfacePoint& point, const MeshArrays& mesh);

// Shows the sources in a picture: points as dots, curves as bold lines.
void ShowSources(const std::vector<Source>& sources, const MeshArrays& mesh,
                 PictureContent* content);

// Draws the picture and writes it; its size in bytes.
absl::StatusOr<uint64_t> WritePicture(const std::string& path,
                                      const MeshArrays& mesh,
                                      const PictureContent& content,
                                      const PictureOptions& options);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_FIELD_OUTPUTS_H_
