#include "readers/messages.h"

#include <string>
#include <string_view>

#include "absl/strings/escaping.h"
#include "absl/strings/string_view.h"

namespace geodesic {

std::string Printable(std::string_view text, size_t max_bytes) {
  const std::string_view head = text.substr(0, max_bytes);
  std::string shown =
      absl::CHexEscape(absl::string_view(head.data(), head.size()));
  if (head.size() < text.size()) shown += "...";
  return shown;
}

}  // namespace geodesic
