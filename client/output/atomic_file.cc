#include "client/output/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/output/output_format.h"

namespace geodesic::client {

namespace {

// Where a link leads in the end, though nothing may be there yet; or `path`.
absl::StatusOr<std::string> BehindLinks(const std::string& path) {
  constexpr int kMostLinks = 40;  // as the kernel follows
  std::filesystem::path place = path;
  std::error_code error;
  for (int i = 0; i < kMostLinks; ++i) {
    if (!std::filesystem::is_symlink(place, error)) return place.string();
    place = place.parent_path() / std::filesystem::read_symlink(place, error);
  }
  return absl::ErrnoToStatus(ELOOP, absl::StrCat("cannot write ", path));
}

// Those of the file that is replaced, if there is one.
void KeepPermissions(const std::string& of, const std::string& by) {
  std::error_code error;
  const std::filesystem::file_status status =
      std::filesystem::status(of, error);
  if (!std::filesystem::is_regular_file(status)) return;
  std::filesystem::permissions(by, status.permissions(), error);
}

}  // namespace

absl::StatusOr<AtomicFile> AtomicFile::Create(const std::string& path) {
  const bool is_copied = path == kStandardOutput || IsPipeOrDevice(path);
  if (is_copied && IsCompressed(path)) {
    return absl::InvalidArgumentError(
        absl::StrCat("cannot write ", path,
                     ": what goes into a pipe or a device is not compressed; "
                     "give it a name without .gz"));
  }
  absl::StatusOr<std::string> behind_links = BehindLinks(path);
  if (!behind_links.ok()) return behind_links.status();
  std::string place = is_copied ? path : *std::move(behind_links);
  std::string partial_path =
      is_copied ? "" : absl::StrCat(place, ".part-", getpid());
  std::FILE* file =
      is_copied ? std::tmpfile() : std::fopen(partial_path.c_str(), "wb+");
  if (file == nullptr) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot write ", path));
  }
  KeepPermissions(place, partial_path);
  return AtomicFile(path, std::move(place), std::move(partial_path), file);
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

void AtomicFile::CopyToPlace() {
  if (std::fflush(file_.get()) != 0 && error_ == 0) error_ = errno;
  if (place_ == kStandardOutput) return CopyTo(STDOUT_FILENO);
  // A pipe that nobody reads is not waited for.
  const int descriptor =
      open(place_.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    if (error_ == 0) error_ = errno;
    return;
  }
  fcntl(descriptor, F_SETFL, O_WRONLY);
  CopyTo(descriptor);
  if (close(descriptor) != 0 && error_ == 0) error_ = errno;
}

void AtomicFile::CopyTo(int descriptor) {
  std::array<char, 1 << 16> buffer;
  std::rewind(file_.get());
  size_t count = 0;
  while (error_ == 0 && (count = std::fread(buffer.data(), 1, buffer.size(),
                                            file_.get())) > 0) {
    for (const char* next = buffer.data(); error_ == 0 && count > 0;) {
      const ssize_t written = write(descriptor, next, count);
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
  KeepPermissions(place_, partial_path_);
  std::error_code unknown;
  size_ = std::filesystem::file_size(packed_path, unknown);
}

absl::Status AtomicFile::Commit() {
  if (partial_path_.empty()) {
    CopyToPlace();
    file_.reset();
    return status();
  }
  if (error_ == 0 && IsCompressed(path_)) Compress();
  if (std::fclose(file_.release()) != 0 && error_ == 0) {
    error_ = errno;
  }
  if (error_ == 0 && std::rename(partial_path_.c_str(), place_.c_str()) != 0) {
    error_ = errno;
  }
  if (error_ != 0) std::remove(partial_path_.c_str());
  return status();
}

}  // namespace geodesic::client
