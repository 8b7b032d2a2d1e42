#include "client/cli/own_server/page_files.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <string_view>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/string_view.h"
#include "client/cli/own_server/descriptor.h"
#include "digest/sha256.h"

namespace geodesic::client {
namespace {

constexpr size_t kTokenBytes = 32;

// Makes a file that only this user can read.
absl::Status WritePrivate(const std::string& path, std::string_view text) {
  unlink(path.c_str());
  const Descriptor file(open(path.c_str(),
                             O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                             S_IRUSR | S_IWUSR));
  if (file.is_open() && write(file.get(), text.data(), text.size()) ==
                            static_cast<ssize_t>(text.size())) {
    return absl::OkStatus();
  }
  return absl::ErrnoToStatus(errno, absl::StrCat("cannot write ", path));
}

// The first word in the file; empty if there is none.
std::string FirstWord(const std::string& path) {
  std::ifstream file(path);
  std::string word;
  file >> word;
  return word;
}

}  // namespace

void PageFiles::Remove() const { unlink(port_path().c_str()); }

absl::Status PageFiles::Prepare() const {
  std::array<char, kTokenBytes> random = {};
  if (getrandom(random.data(), random.size(), 0) != kTokenBytes) {
    return absl::ErrnoToStatus(errno, "cannot draw a token");
  }
  const std::string token =
      absl::BytesToHexString(absl::string_view(random.data(), random.size()));
  absl::Status status = WritePrivate(token_path(), token);
  status.Update(WritePrivate(
      hash_path(),
      absl::StrCat(R"({"tokens": [{"name": "page", "scopes": ["admin"], )",
                   R"("sha256": ")", Sha256Hex(token), "\"}]}\n")));
  return status;
}

std::optional<std::string> PageFiles::Url() const {
  const std::string port = FirstWord(port_path());
  const std::string token = FirstWord(token_path());
  if (port.empty() || token.empty()) return std::nullopt;
  return absl::StrCat("http://127.0.0.1:", port, "/#token=", token);
}

absl::StatusOr<std::string> PageFiles::WriteLink(const std::string& url) const {
  std::string path = stem_ + ".view.html";
  const std::string escaped =
      absl::StrReplaceAll(url, {{"&", "&amp;"}, {"\"", "&quot;"}});
  absl::Status status = WritePrivate(
      path, absl::StrCat("<!doctype html>\n<meta charset=\"utf-8\">\n"
                         "<title>geodesic</title>\n"
                         "<meta http-equiv=\"refresh\" content=\"0; url=",
                         escaped, "\">\n<p><a href=\"", escaped,
                         "\">The page</a></p>\n"));
  if (!status.ok()) return status;
  return path;
}

}  // namespace geodesic::client
