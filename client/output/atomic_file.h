// A file that appears under its name only when it is complete.

#ifndef GEODESIC_CLIENT_OUTPUT_ATOMIC_FILE_H_
#define GEODESIC_CLIENT_OUTPUT_ATOMIC_FILE_H_

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace geodesic::client {

// Writes to "<path>.part-<process>" and renames that at the end, compressed
// with gzip if the path ends in ".gz"; a link stays, and what it leads to is
// replaced. What goes to standard output (kStandardOutput), a pipe or a device
// is kept in a temporary file without a name, and copied at the end. Not
// thread-safe.
class AtomicFile {
 public:
  // Errors: those of opening a file for writing, naming the path;
  // INVALID_ARGUMENT for a pipe or device that ends in ".gz".
  static absl::StatusOr<AtomicFile> Create(const std::string& path);

  AtomicFile(AtomicFile&&) = default;
  AtomicFile& operator=(AtomicFile&&) = delete;
  // Removes the file under its temporary name unless Commit succeeded.
  ~AtomicFile();

  // Once a write has failed, later ones do nothing, and Commit returns the
  // error.
  void Append(std::string_view bytes);
  void Append(const void* bytes, size_t size) {
    Append({static_cast<const char*>(bytes), size});
  }

  // Writes over the first bytes of the file. REQUIRES: as many were appended.
  void Replace(std::string_view first_bytes);

  // The first error so far.
  absl::Status status() const;

  // Bytes appended so far; after Commit, those of the file.
  uint64_t size() const { return size_; }

  // Puts the file in its place, over an older one; or copies it to standard
  // output, past the buffers of streams, or to the pipe, which must have a
  // reader.
  // Errors: the first one, naming the path.
  absl::Status Commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  AtomicFile(std::string path, std::string place, std::string partial_path,
             std::FILE* file)
      : path_(std::move(path)),
        place_(std::move(place)),
        partial_path_(std::move(partial_path)),
        file_(file) {}

  // Errors of these are in error_.
  void CopyToPlace();
  void CopyTo(int descriptor);
  // Puts what was appended, compressed, into another file of this name, which
  // takes the place of the partial one.
  void Compress();

  std::string path_;
  std::string place_;         // where it goes in the end
  std::string partial_path_;  // empty if it is copied there
  std::unique_ptr<std::FILE, Close> file_;
  uint64_t size_ = 0;
  // errno of the first write that failed.
  int error_ = 0;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_ATOMIC_FILE_H_
