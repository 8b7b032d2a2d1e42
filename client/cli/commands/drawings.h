// Pictures of answers.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_DRAWINGS_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_DRAWINGS_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "client/picture/picture.h"
#include "geodesic_client/surface_point.h"

namespace geodesic::client {

// Shows the sources in a picture: points as dots, curves as bold lines. What
// the mesh does not have is anywhere.
void ShowSources(const std::vector<Source>& sources, const MeshArrays& mesh,
                 PictureContent* content);

// Likewise for targets, which are points.
void ShowTargets(const std::vector<SurfacePoint>& targets,
                 const MeshArrays& mesh, PictureContent* content);

// Draws the picture and writes it; its size in bytes.
absl::StatusOr<uint64_t> WritePicture(const std::string& path,
                                      const MeshArrays& mesh,
                                      const PictureContent& content,
                                      const PictureOptions& options);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_DRAWINGS_H_
