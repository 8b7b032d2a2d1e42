// Polylines on the surface in the formats other programs read: shortest paths
// and isolines.
//
// A writer appends to the file; errors surface at its Commit.

#ifndef GEODESIC_CLIENT_OUTPUT_LINE_WRITERS_H_
#define GEODESIC_CLIENT_OUTPUT_LINE_WRITERS_H_

#include <string>
#include <vector>

#include "client/output/atomic_file.h"
#include "client/output/output_format.h"
#include "geodesic_client/questions.h"

namespace geodesic::client {

struct Line {
  Polyline polyline;
  // Whether the last point leads back to the first.
  bool is_closed = false;
  // One for each of Lines::attributes.
  std::vector<double> values;
};

// What is known about every line besides its points.
struct Attribute {
  std::string name;
  // Integers that are negative mean that there is none.
  bool is_integer = false;
};

struct Lines {
  std::vector<Attribute> attributes;
  std::vector<Line> lines;
};

// Writes lines in one of kLineFormats but .png. In all but .csv and .json,
// lines without points are left out. .obj: Wavefront OBJ, with a group, its
// points and an l statement a line. .ply: binary, with vertices x, y, z and
// edges vertex1, vertex2, line (the
//   line's number), and the attributes at each edge.
// .vtk: legacy polydata, binary: LINES, with the attributes as cell scalars.
// .csv: "line,point,x,y,z,place,...", a row for each point, the attributes in
//   the last columns. A closed line repeats its first point at its end.
// .json: a FeatureCollection as in GeoJSON, in the mesh's own coordinates: one
//   LineString for each line (a null geometry if it has fewer than two points),
//   whose properties are the attributes, null where infinite, `closed` and
//   `points`, the surface points.
void WriteLines(const Lines& lines, OutputFormat format, AtomicFile* file);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_LINE_WRITERS_H_
