// What the client's writers put into a file.

#ifndef GEODESIC_TESTS_CLIENT_WRITTEN_H_
#define GEODESIC_TESTS_CLIENT_WRITTEN_H_

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "client/output/atomic_file.h"
#include "tests/client/temporary_folder.h"

namespace geodesic::client {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename Write>
std::string Written(const Write& write) {
  const TemporaryFolder folder;
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(folder / "out");
  EXPECT_TRUE(file.ok());
  write(&*file);
  EXPECT_TRUE(file->Commit().ok());
  return FileBytes(folder / "out");
}

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_CLIENT_WRITTEN_H_
