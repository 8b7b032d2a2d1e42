// libFuzzer target of the OBJ reader.

#include <cstddef>
#include <cstdint>

#include "geodesic/read_mesh.h"
#include "tests/fuzz/check_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  geodesic::test::CheckReader(data, size, geodesic::MeshFormat::kObj);
  return 0;
}
