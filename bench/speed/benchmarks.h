// What is measured on each mesh. Every function registers Google Benchmarks
// under names that begin with a word of its own and end with the mesh's name.

#ifndef GEODESIC_BENCH_SPEED_BENCHMARKS_H_
#define GEODESIC_BENCH_SPEED_BENCHMARKS_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bench/subject.h"
#include "geodesic_types/algorithms.h"

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

// pairs/MESH: the distances of `count` random pairs of vertices, by a search
// without landmarks, with 64, and by a field that stops at the target, which
// take turns. Counters, for WAY of search, landmarks and field: WAY, the median
// in milliseconds, WAY_p99, WAY_windows and WAY_windows_p99. Beside them made,
// the milliseconds that the landmarks took, and off, the largest relative
// difference between the ways.
void RegisterPairs(const Subject& subject, uint32_t count);
inline constexpr uint32_t kSeedOfPairs = 1;

// cgal_pairs/MESH: the first few of these pairs by CGAL. Counters: median, in
// milliseconds, and off, as above.
void RegisterCgalPairs(const Subject& subject);

// upload/STEP/FILE: what happens to the bytes of a mesh file until the mesh is
// resident, and upload/whole/FILE; upload/plain/FILE: a plain loop that reads
// the same file, if it is a binary little-endian PLY of triangles.
void RegisterUpload(const std::string& file, int rounds);

}  // namespace geodesic::speed

#endif  // GEODESIC_BENCH_SPEED_BENCHMARKS_H_
