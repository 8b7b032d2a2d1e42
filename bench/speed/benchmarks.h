// What is measured on each mesh. Every function registers Google Benchmarks
// under names that begin with a word of its own and end with the mesh's name.

#ifndef GEODESIC_BENCH_SPEED_BENCHMARKS_H_
#define GEODESIC_BENCH_SPEED_BENCHMARKS_H_

#include <memory>
#include <string>
#include <vector>

#include "bench/subject.h"
#include "geodesic/algorithm.h"

namespace geodesic::speed {

// Whether the algorithm is one that users would choose, or the same rule on a
// heap, which it is to be compared with.
constexpr bool IsMeasured(Algorithm algorithm) {
  return algorithm != Algorithm::kCh && algorithm != Algorithm::kLcCh &&
         algorithm != Algorithm::kLcMmp;
}

// solve/ALGORITHM/MESH: one source, one thread. Counters: created, propagated,
// bytes.
void RegisterSolve(const Subject& subject, int rounds);

// envelope/MESH. Counter: windows (lower_envelope.h).
void RegisterLowerEnvelope(const Subject& subject);

// sources/THREADS/MESH: `sources` fields, taken in turn by THREADS threads.
void RegisterSources(const Subject& subject, int sources, int most_threads,
                     int rounds);

// cgal/MESH: CGAL's Surface_mesh_shortest_path, one source, once. Its mesh is
// built beforehand. Counter: off, the largest relative difference from the
// default algorithm's field.
void RegisterCgal(const Subject& subject);

// upload/STEP/FILE: what happens to the bytes of a mesh file until the mesh is
// resident, and upload/whole/FILE; upload/plain/FILE: a plain loop that reads
// the same file, if it is a binary little-endian PLY of triangles.
void RegisterUpload(const std::string& file, int rounds);

}  // namespace geodesic::speed

#endif  // GEODESIC_BENCH_SPEED_BENCHMARKS_H_
