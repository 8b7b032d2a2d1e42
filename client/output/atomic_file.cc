#include "client/output/atomic_file.h"

#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/output/output_format.h"

namespace geodesic::client {

absl::StatusOr<AtomicFile> AtomicFile::Create(const std::string& path) {
  const bool is_standard = path == kStandardOutput;
  std::string partial_path =
      is_standard ? "" : absl::StrCat(path, ".part-", getpid());
  std::FILE* file =
      is_standard ? std::tmpfile() : std::fopen(partial_path.c_str(), "wb+");
  if (file == nullptr) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot write ", path));
  }
  return AtomicFile(path, std::move(partial_path), file);
}

AtomicFile::~AtomicFile() {
  if (file_ == nullptr) return;
  file_.reset();
  if (!partial_path_.empty()) std::remove(partial_path_.c_str());
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
  return error_ == 0
             ? absl::OkStatus()
             : absl::ErrnoToStatus(error_, absl::StrCat("cannot write ",
                                                        path_ == kStandardOutput
                                                            ? "standard output"
                                                            : path_));
}

void AtomicFile::CopyToStandardOutput() {
  std::array<char, 1 << 16> buffer;
  std::rewind(file_.get());
  size_t count = 0;
  while (error_ == 0 && (count = std::fread(buffer.data(), 1, buffer.size(),
                                            file_.get())) > 0) {
    for (const char* next = buffer.data(); error_ == 0 && count > 0;) {
      const ssize_t written = write(STDOUT_FILENO, next, count);
      if (written >= 0) {
        next += written;
        count -= static_cast<size_t>(written);
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
  }
  if (error_ == 0 && std::ferror(file_.get()) != 0) error_ = EIO;
}

void AtomicFile::Compress() {
  const std::string packed_path = partial_path_ + ".gz";
  const gzFile packed = gzopen(packed_path.c_str(), "wb");
  if (packed == nullptr) {
    error_ = errno;
    return;
  }
  std::array<char, 1 << 16> buffer;
  std::rewind(file_.get());
  size_t count = 0;
  while (error_ == 0 && (count = std::fread(buffer.data(), 1, buffer.size(),
                                            file_.get())) > 0) {
    if (gzwrite(packed, buffer.data(), static_cast<unsigned>(count)) == 0) {
      error_ = errno != 0 ? errno : EIO;
    }
  }
  if (error_ == 0 && std::ferror(file_.get()) != 0) error_ = EIO;
  if (gzclose(packed) != Z_OK && error_ == 0) error_ = errno != 0 ? errno : EIO;
  std::remove(partial_path_.c_str());
  partial_path_ = packed_path;
  std::error_code unknown;
  size_ = std::filesystem::file_size(packed_path, unknown);
}

absl::Status AtomicFile::Commit() {
  if (path_ == kStandardOutput) {
    if (std::fflush(file_.get()) != 0 && error_ == 0) error_ = errno;
    CopyToStandardOutput();
    file_.reset();
    return status();
  }
  if (error_ == 0 && IsCompressed(path_)) Compress();
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
