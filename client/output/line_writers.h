// Polylines on the surface in the formats other programs read: shortest paths
// and isolines.
//
// A writer appends to the file; errors surface at its Commit.

#ifndef GEODESIC_CLIENT_OUTPUT_LINE_WRITERS_H_
#define GEODESIC_CLIENT_OUTPUT_LINE_WRITERS_H_

#include <string>
#include <vector>

#include "client/output/atomic_file.h"
#include "client/output/number_type.h"
#include "geodesic_client/polyline.h"

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

// Wavefront OBJ: a group, its points and an l statement for each line. Lines
// without points are left out, here and in .ply and .vtk.
void WriteLinesObj(const Lines& lines, AtomicFile* file);

// Binary PLY: vertices x, y, z and edges vertex1, vertex2, line (the line's
// number), and the attributes at each edge.
void WriteLinesPly(const Lines& lines, AtomicFile* file);

// Legacy VTK polydata, binary: LINES, with the attributes as cell scalars.
void WriteLinesVtk(const Lines& lines, AtomicFile* file);

// "line,point,x,y,z,place,...": a row for each point, the attributes in the
// last columns. A closed line repeats its first point at its end.
void WriteLinesCsv(const Lines& lines, AtomicFile* file);

// A FeatureCollection as in GeoJSON, in the mesh's own coordinates: one
// LineString for each line (a null geometry if it has fewer than two points),
// whose properties are the attributes, null where infinite, `closed` and
// `points`, the surface points.
void WriteLinesJson(const Lines& lines, AtomicFile* file);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_LINE_WRITERS_H_
