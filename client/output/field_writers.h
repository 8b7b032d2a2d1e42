// Distance fields in the formats other programs read.
//
// Bytes are little endian unless said otherwise. +infinity stays infinity in
// every format. A writer appends to the file; errors surface at its Commit.

#ifndef GEODESIC_CLIENT_OUTPUT_FIELD_WRITERS_H_
#define GEODESIC_CLIENT_OUTPUT_FIELD_WRITERS_H_

#include <span>

#include "client/output/atomic_file.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

// The name of the scalar in .csv, .ply and .vtk.
inline constexpr std::string_view kScalarName = "geodesic_distance";

// NumPy format 1.0: dtype <f8, shape (V,).
void WriteNpy(std::span<const double> distances, AtomicFile* file);

// A header line "vertex,geodesic_distance", then a line for each vertex, with
// the fewest digits that give the same double again; infinity is "inf".
void WriteCsv(std::span<const double> distances, AtomicFile* file);

// binary64 values and nothing else.
void WriteRaw(std::span<const double> distances, AtomicFile* file);

// Binary PLY: vertices x, y, z, geodesic_distance (all double) and faces.
// REQUIRES: one distance per vertex; fewer than 2^31 vertices, as in WriteVtk.
void WritePly(const MeshArrays& mesh, std::span<const double> distances,
              AtomicFile* file);

// Legacy VTK polydata, binary (hence big endian, as that format demands), with
// the point scalar geodesic_distance.
void WriteVtk(const MeshArrays& mesh, std::span<const double> distances,
              AtomicFile* file);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_FIELD_WRITERS_H_
