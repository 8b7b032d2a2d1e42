// The folder in which one server, and no other, keeps what outlives it.

#ifndef GEODESIC_SERVER_STORE_DATA_FOLDER_H_
#define GEODESIC_SERVER_STORE_DATA_FOLDER_H_

#include <string>

#include "absl/status/statusor.h"
#include "server/store/posix_file.h"

namespace geodesic::server {

// Holds the folder's lock while it lives; a process that dies lets go of it.
class DataFolder {
 public:
  // Makes the folder when there is none, readable by this user alone; its
  // parents must exist.
  // Errors: UNAVAILABLE naming the process that has the folder already, or what
  // keeps it from being made or opened.
  static absl::StatusOr<DataFolder> Open(const std::string& path);

  int descriptor() const { return folder_.get(); }

 private:
  DataFolder(FileDescriptor folder, FileDescriptor lock)
      : folder_(std::move(folder)), lock_(std::move(lock)) {}

  FileDescriptor folder_;
  FileDescriptor lock_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_DATA_FOLDER_H_
