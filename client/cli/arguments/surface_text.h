// Places on the surface as they are written on the command line:
//
//   17                     vertex 17
//   edge:3-8@0.25          on the edge from vertex 3 to 8, a quarter of the way
//   face:5@0.2,0.3,0.5     in face 5, barycentric weights of its corners
//   17:0.5                 a source with an offset; likewise for the others
//   3;edge:3-8@0.5;9:0.5   a curve through these points, with an offset

#ifndef GEODESIC_CLIENT_CLI_ARGUMENTS_SURFACE_TEXT_H_
#define GEODESIC_CLIENT_CLI_ARGUMENTS_SURFACE_TEXT_H_

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic_client/surface_point.h"

namespace geodesic::client {

// As the path of a list.
inline constexpr char kStandardInput[] = "-";

// Errors: INVALID_ARGUMENT naming the text and what it should be, likewise for
// the others. Whether the mesh has such a place is for the server to say.
absl::StatusOr<SurfacePoint> ParsePoint(std::string_view text);

// "POINT" or "POINT:OFFSET".
absl::StatusOr<Source> ParseSource(std::string_view text);

// "POINT;POINT;..." or "POINT;POINT;...:OFFSET".
absl::StatusOr<Source> ParseCurve(std::string_view text);

// The sources of a file, one a line: a curve where the line has a ';'. Empty
// lines and those that begin with '#' are skipped. "-" is standard input.
// Errors: of opening and reading the file; INVALID_ARGUMENT naming the line.
absl::StatusOr<std::vector<Source>> ReadSources(const std::string& path);

// The same for points.
absl::StatusOr<std::vector<SurfacePoint>> ReadPoints(const std::string& path);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_ARGUMENTS_SURFACE_TEXT_H_
