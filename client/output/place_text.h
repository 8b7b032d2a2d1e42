// Converts places on the surface to JSON, and from and to the command line's
// text:
//
//   17                     vertex 17
//   edge:3-8@0.25          on the edge from vertex 3 to 8, a quarter of the way
//   face:5@0.2,0.3,0.5     in face 5, barycentric weights of its corners
//   nearest:1,-2,0.5       the point of the surface nearest to this one
//   min:x, max:z           the vertex with the least or greatest coordinate
//   name:tip@places.txt    what "tip" stands for in a file, whose lines are a
//                          name, blanks and a point
//   17:0.5                 a source with an offset; likewise for the others
//   3;edge:3-8@0.5;9:0.5   a curve through these points, with an offset

#ifndef GEODESIC_CLIENT_OUTPUT_PLACE_TEXT_H_
#define GEODESIC_CLIENT_OUTPUT_PLACE_TEXT_H_

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "client/places/written_place.h"
#include "geodesic_types/places.h"

namespace geodesic::client {

// "17", "edge:3-8@0.25" or "face:5@0.2,0.3,0.5", with the fewest digits that
// give the same doubles again.
std::string PointText(const SurfacePoint& point);

// The same, or the points of a curve with ';' between them; with ":OFFSET" at
// the end unless it is 0.
std::string SourceText(const Source& source);

// {"vertex": 17}, {"edge": [3, 8], "t": 0.25} or
// {"face": 5, "weights": [0.2, 0.3, 0.5]}.
nlohmann::ordered_json PointToJson(const SurfacePoint& point);

// The same, or {"curve": [point, ...]}; with "offset".
nlohmann::ordered_json SourceToJson(const Source& source);

// The path of a list that is read from standard input.
inline constexpr char kStandardInput[] = "-";
// What messages call a list: its path, or "standard input".
std::string ListName(const std::string& path);
// A line of a list without the byte order mark that the first one may begin
// with. `number`: from 1.
std::string_view WithoutMark(std::string_view line, uint64_t number);

// Reads the file of a name. Errors: INVALID_ARGUMENT naming the text and what
// it should be, or the file; ParseSource and ParseCurve have the same. The
// server checks whether the mesh has the place.
absl::StatusOr<WrittenPoint> ParsePoint(std::string_view text);

// "POINT" or "POINT:OFFSET".
absl::StatusOr<WrittenSource> ParseSource(std::string_view text);

// "POINT;POINT;..." or "POINT;POINT;...:OFFSET".
absl::StatusOr<WrittenSource> ParseCurve(std::string_view text);

// The files that names in "POINT", "POINT:OFFSET" or a curve are looked up in.
// Where the text does not tell whether a colon begins an offset, with it and
// without.
std::vector<std::string> FilesOfNames(std::string_view text);

// The sources of a file, one a line, around which there may be blanks. A line
// with a ';' is a curve. Empty lines and those that begin with '#' are skipped.
// "-" is standard input.
// Errors: those of opening and reading the file; INVALID_ARGUMENT naming the
// line.
absl::StatusOr<std::vector<WrittenSource>> ReadSources(const std::string& path);

// The same for points.
absl::StatusOr<std::vector<WrittenPoint>> ReadPoints(const std::string& path);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_PLACE_TEXT_H_
