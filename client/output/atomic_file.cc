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

AtomicFile::~AtomicFile() {
  if (file_ == nullptr) return;
  file_.reset();
  std::remove(partial_path_.c_str());
}

void AtomicFile::Append(std::string_view bytes) {
  if (error_ != 0 || bytes.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) {
    error_ = errno;
    return;
  }
  size_ += bytes.size();
}

void AtomicFile::Replace(std::string_view first_bytes) {
  if (error_ != 0) return;
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0 ||
      std::fwrite(first_bytes.data(), 1, first_bytes.size(), file_.get()) !=
          first_bytes.size() ||
      std::fseek(file_.get(), 0, SEEK_END) != 0) {
    error_ = errno;
  }
}

absl::Status AtomicFile::status() const {
  return error_ == 0 ? absl::OkStatus()
                     : absl::ErrnoToStatus(
                           error_, absl::StrCat("cannot write ", path_));
}

absl::Status AtomicFile::Commit() {
  if (std::fclose(file_.release()) != 0 && error_ == 0) {
    error_ = errno;
  }
  if (error_ == 0 && std::rename(partial_path_.c_str(), path_.c_str()) != 0) {
    error_ = errno;
  }
  if (error_ != 0) std::remove(partial_path_.c_str());
  return status();
}

}  // namespace geodesic::client
