// What the fuzz targets of the mesh readers share.

#ifndef GEODESIC_TESTS_FUZZ_CHECK_READER_H_
#define GEODESIC_TESTS_FUZZ_CHECK_READER_H_

#include <cstddef>
#include <cstdint>

#include "geodesic/read_mesh.h"

namespace geodesic::test {

// Reads the bytes; aborts if the reader breaks a promise of read_mesh.h. What
// was read is then built into a Mesh, which must not crash either.
void CheckReader(const uint8_t* data, size_t size, MeshFormat format);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_FUZZ_CHECK_READER_H_
