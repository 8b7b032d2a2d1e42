// Writes polylines on the surface, such as shortest paths and isolines, in the
// formats that other programs read.
//
// A writer appends to the file, whose Commit returns errors.

#ifndef GEODESIC_CLIENT_OUTPUT_LINE_WRITERS_H_
#define GEODESIC_CLIENT_OUTPUT_LINE_WRITERS_H_

#include <string>
#include <vector>

#include "client/output/atomic_file.h"
#include "client/output/binary_numbers.h"
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

// A quantity that every line has besides its points.
struct Attribute {
  std::string name;
  // A negative integer means that the line has no value.
  NumberType type = NumberType::kFloat64;
};

struct Lines {
  std::vector<Attribute> attributes;
  std::vector<Line> lines;
};

// Writes lines in one of kLineFormats except .png. Only .csv and .json contain
// lines without points.
// .obj: Wavefront OBJ. A line is a group, its points and an l statement for
//   each piece between two of them.
// .ply: binary. Vertices have x, y, z; edges have vertex1, vertex2, line (the
//   line's number) and the attributes.
// .vtk: legacy polydata, binary: LINES, with the attributes as cell scalars.
// .csv: "line,point,x,y,z,place,...", a row for each point, the attributes in
//   the last columns. A closed line repeats its first point at its end.
// .json: a FeatureCollection as in GeoJSON, in the mesh's own coordinates, with
//   one LineString for each line (a null geometry if it has fewer than two
//   points). Its properties are the attributes (null where infinite), `closed`
//   and `points`, the surface points.
void WriteLines(const Lines& lines, OutputFormat format, AtomicFile* file);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_LINE_WRITERS_H_
