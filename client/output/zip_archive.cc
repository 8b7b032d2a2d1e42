#include "client/output/zip_archive.h"

#include <zip.h>

#include <filesystem>

#include "absl/strings/str_cat.h"
#include "client/output/output_format.h"

namespace geodesic::client {
namespace {

// The first day that a zip file can hold. A fixed time makes equal content
// equal files.
constexpr time_t kFirstDay = 315532800 + 12 * 3600;  // 1980-01-01, noon UTC

}  // namespace

void ZipArchive::Discard::operator()(zip* archive) const {
  zip_discard(archive);
}

absl::StatusOr<ZipArchive> ZipArchive::Create(const std::string& path) {
  if (IsPipeOrDevice(path)) {
    return absl::InvalidArgumentError(absl::StrCat(
        "cannot write ", path, ": .npz goes into files, and this is none"));
  }
  int code = 0;
  zip* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  if (archive == nullptr) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    absl::Status status = absl::UnknownError(
        absl::StrCat("cannot write ", path, ": ", zip_error_strerror(&error)));
    zip_error_fini(&error);
    return status;
  }
  return ZipArchive(path, archive);
}

void ZipArchive::Add(const std::string& name, std::string bytes) {
  buffers_.push_back(std::make_unique<std::string>(std::move(bytes)));
  const std::string& kept = *buffers_.back();
  AddSource(name, zip_source_buffer(archive_.get(), kept.data(), kept.size(),
                                    /*freep=*/0));
}

void ZipArchive::Add(const std::string& name, std::FILE* file) {
  zip_source_t* source = zip_source_filep(archive_.get(), file, 0, -1);
  if (source == nullptr) std::fclose(file);
  AddSource(name, source);
}

void ZipArchive::AddSource(const std::string& name, zip_source_t* source) {
  if (failed_ || source == nullptr) {
    failed_ = true;
    zip_source_free(source);
    return;
  }
  const int64_t index =
      zip_file_add(archive_.get(), name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) zip_source_free(source);
  const auto member = static_cast<zip_uint64_t>(index);
  failed_ =
      index < 0 ||
      zip_set_file_compression(archive_.get(), member, ZIP_CM_STORE, 0) != 0 ||
      zip_file_set_mtime(archive_.get(), member, kFirstDay, 0) != 0;
}

absl::StatusOr<uint64_t> ZipArchive::Commit() {
  if (failed_ || zip_close(archive_.get()) != 0) {
    return absl::UnknownError(absl::StrCat("cannot write ", path_, ": ",
                                           zip_strerror(archive_.get())));
  }
  // zip_close has freed it.
  static_cast<void>(archive_.release());
  std::error_code error;
  const uint64_t size = std::filesystem::file_size(path_, error);
  if (error) {
    return absl::UnknownError(
        absl::StrCat("cannot read ", path_, ": ", error.message()));
  }
  return size;
}

}  // namespace geodesic::client
