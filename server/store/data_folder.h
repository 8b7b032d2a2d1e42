// The folder in which one server, and no other, keeps what outlives it.

#ifndef GEODESIC_SERVER_STORE_DATA_FOLDER_H_
#define GEODESIC_SERVER_STORE_DATA_FOLDER_H_

#include <memory>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "server/store/posix_file.h"
#include "server/store/quarantine.h"

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
  Quarantine& quarantine() const { return *quarantine_; }

 private:
  DataFolder(FileDescriptor folder, FileDescriptor lock,
             std::unique_ptr<Quarantine> quarantine)
      : folder_(std::move(folder)),
        lock_(std::move(lock)),
        quarantine_(std::move(quarantine)) {}

  FileDescriptor folder_;
  FileDescriptor lock_;
  std::unique_ptr<Quarantine> quarantine_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_DATA_FOLDER_H_
