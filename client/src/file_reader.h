// Reads a file from front to back in pieces.

#ifndef GEODESIC_CLIENT_FILE_READER_H_
#define GEODESIC_CLIENT_FILE_READER_H_

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "absl/status/statusor.h"

namespace geodesic::client {

// Not thread-safe.
class FileReader {
 public:
  // Errors: NOT_FOUND, PERMISSION_DENIED or FAILED_PRECONDITION if it cannot be
  // opened, INVALID_ARGUMENT if it is no regular file; all name the path.
  static absl::StatusOr<FileReader> Open(const std::string& path);

  uint64_t size() const { return size_; }

  // Fills `buffer` with the next bytes, up to its size; shrinks it at the end
  // of the file, to nothing once that is reached.
  // Errors: DATA_LOSS naming the path.
  absl::Status Read(std::string* buffer);

  // Starts over.
  void Rewind() { std::rewind(file_.get()); }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  FileReader(std::string path, std::FILE* file, uint64_t size)
      : path_(std::move(path)), file_(file), size_(size) {}

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  uint64_t size_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_FILE_READER_H_
