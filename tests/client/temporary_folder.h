// A folder for one test's files, under the name that the client's tests use.

#ifndef GEODESIC_TESTS_CLIENT_TEMPORARY_FOLDER_H_
#define GEODESIC_TESTS_CLIENT_TEMPORARY_FOLDER_H_

#include "tests/support/temporary_folder.h"

namespace geodesic::client {

using test::FileBytes;
using test::TemporaryFolder;
using test::WriteFile;

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_CLIENT_TEMPORARY_FOLDER_H_
