// A plain loop that reads a mesh file: what the upload is measured against.

#ifndef GEODESIC_BENCH_PLAIN_PLY_H_
#define GEODESIC_BENCH_PLAIN_PLY_H_

#include <optional>
#include <string>

#include "geodesic/triangle_soup.h"

namespace geodesic {

// Reads a binary little-endian PLY whose vertices are floats, x, y and z first,
// and whose faces are one list of three ints, as one would without thinking of
// speed or of bad files. Nothing for any other file.
std::optional<TriangleSoup> ReadPlainPly(const std::string& path);

}  // namespace geodesic

#endif  // GEODESIC_BENCH_PLAIN_PLY_H_
