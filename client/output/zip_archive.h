// Writes archives of arrays. An .npz file is a zip file of .npy files, here not
// compressed.

#ifndef GEODESIC_CLIENT_OUTPUT_ZIP_ARCHIVE_H_
#define GEODESIC_CLIENT_OUTPUT_ZIP_ARCHIVE_H_

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

struct zip;
struct zip_source;

namespace geodesic::client {

// Collects members. The file appears under its name only when it is complete.
// Equal members make equal files. Not thread-safe.
class ZipArchive {
 public:
  // Errors: those of opening a file for writing, naming the path.
  static absl::StatusOr<ZipArchive> Create(const std::string& path);

  void Add(const std::string& name, std::string bytes);

  // Adds all that `file` holds, which Commit reads. Takes over the file and
  // closes it.
  void Add(const std::string& name, std::FILE* file);

  // Puts the archive in its place, over an older file. Returns its size in
  // bytes.
  // Errors: the first one, naming the path.
  absl::StatusOr<uint64_t> Commit();

 private:
  struct Discard {
    void operator()(zip* archive) const;
  };

  ZipArchive(std::string path, zip* archive)
      : path_(std::move(path)), archive_(archive) {}

  // Takes over `source`.
  void AddSource(const std::string& name, zip_source* source);

  std::string path_;
  // Members point into these until Commit.
  std::vector<std::unique_ptr<std::string>> buffers_;
  std::unique_ptr<zip, Discard> archive_;
  bool failed_ = false;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_ZIP_ARCHIVE_H_
