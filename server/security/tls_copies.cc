#include "server/security/tls_copies.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <string_view>

#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

absl::StatusOr<FileDescriptor> InMemory(std::string_view text,
                                        const std::string& path) {
  const std::string name = absl::StrCat("the copy of ", path);
  FileDescriptor file(memfd_create("tls", MFD_CLOEXEC));
  if (file.get() < 0) return DiskError(errno, "make", name);
  absl::Status status = WriteAt(file.get(), 0, text, name);
  if (!status.ok()) return status;
  return file;
}

// Who opens `old` from now on gets `made`; who has it open keeps what it was.
void Replace(FileDescriptor& old, FileDescriptor made) {
  if (old.get() < 0) {
    old = std::move(made);
  } else {
    dup3(made.get(), old.get(), O_CLOEXEC);
  }
}

std::string PathOf(const FileDescriptor& file) {
  return absl::StrCat("/proc/self/fd/", file.get());
}

}  // namespace

absl::StatusOr<TlsCopies> TlsCopies::Make(TlsFiles files) {
  TlsCopies copies(std::move(files));
  const absl::StatusOr<bool> made = copies.Refresh();
  if (!made.ok()) return made.status();
  return copies;
}

TlsFiles TlsCopies::paths() const {
  return {.certificate = PathOf(certificate_),
          .key = PathOf(key_),
          .client_authorities = files_.client_authorities.empty()
                                    ? ""
                                    : PathOf(client_authorities_)};
}

absl::StatusOr<bool> TlsCopies::Refresh() {
  absl::StatusOr<TlsTexts> texts = ReadTlsFiles(files_);
  if (!texts.ok()) return texts.status();
  if (*texts == texts_) return false;
  auto certificate = InMemory(texts->certificate, files_.certificate);
  if (!certificate.ok()) return certificate.status();
  auto key = InMemory(texts->key, files_.key);
  if (!key.ok()) return key.status();
  auto authorities =
      InMemory(texts->client_authorities, files_.client_authorities);
  if (!authorities.ok()) return authorities.status();
  Replace(key_, *std::move(key));
  Replace(certificate_, *std::move(certificate));
  Replace(client_authorities_, *std::move(authorities));
  texts_ = *std::move(texts);
  return true;
}

}  // namespace geodesic::server
