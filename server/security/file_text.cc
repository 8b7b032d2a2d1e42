#include "server/security/file_text.h"

#include <cerrno>
#include <fstream>
#include <sstream>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace geodesic::server {

absl::StatusOr<std::string> ReadFileText(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  // To insert nothing, as of an empty file, would count as a failure.
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad() || !text) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot read ", path));
  }
  return std::move(text).str();
}

}  // namespace geodesic::server
