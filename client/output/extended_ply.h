// A PLY file with more values at its vertices.

#ifndef GEODESIC_CLIENT_OUTPUT_EXTENDED_PLY_H_
#define GEODESIC_CLIENT_OUTPUT_EXTENDED_PLY_H_

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "client/output/field_writers.h"

namespace geodesic::client {

// The bytes of the PLY file `ply` with the columns behind the other values of
// each vertex. Its encoding, coordinates, colours, polygons and whatever else
// it holds stay as they are; values that have a column's name give way. A
// `mark` (approximation_mark.h) is added as a comment. Time and memory go with
// the file. Returns nothing if the file cannot be extended so: it is cut off,
// its lines end in another way than \n or \r\n, or there is not one value of
// each column for every vertex.
std::optional<std::string> ExtendedPly(std::string_view ply,
                                       std::span<const Column> columns,
                                       const std::string& mark = "");

// The same for a file, which may be compressed with gzip. Returns nothing also
// if it cannot be read.
std::optional<std::string> ExtendedPlyFile(const std::string& path,
                                           std::span<const Column> columns,
                                           const std::string& mark = "");

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_EXTENDED_PLY_H_
