#include "client/output/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <utility>

#include "absl/strings/str_cat.h"

namespace geodesic::client {

absl::StatusOr<AtomicFile> AtomicFile::Create(const std::string& path) {
  std::string partial_path = absl::StrCat(path, ".part-", getpid());
  std::FILE* file = std::fopen(partial_path.c_str(), "wb");
  if (file == nullptr) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot write ", path));
  }
  return AtomicFile(path, std::move(partial_path), file);
}

AtomicFile::AtomicFile(std::string path, std::string partial_path,
                       std::FILE* file)
    : path_(std::move(path)),
      partial_path_(std::move(partial_path)),
      file_(file) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      partial_path_(std::move(other.partial_path_)),
      file_(std::exchange(other.file_, nullptr)),
      size_(other.size_),
      error_(other.error_) {}

AtomicFile::~AtomicFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::remove(partial_path_.c_str());
}

void AtomicFile::Append(std::string_view bytes) {
  if (error_ != 0 || bytes.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) {
    error_ = errno;
    return;
  }
  size_ += bytes.size();
}

absl::Status AtomicFile::status() const {
  return error_ == 0 ? absl::OkStatus()
                     : absl::ErrnoToStatus(
                           error_, absl::StrCat("cannot write ", path_));
}

absl::Status AtomicFile::Commit() {
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && error_ == 0) {
    error_ = errno;
  }
  if (error_ == 0 && std::rename(partial_path_.c_str(), path_.c_str()) != 0) {
    error_ = errno;
  }
  if (error_ != 0) std::remove(partial_path_.c_str());
  return status();
}

}  // namespace geodesic::client
