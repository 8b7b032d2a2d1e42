#include "geodesic/field_path.h"

#include "absl/strings/cord.h"
#include "absl/strings/string_view.h"

namespace geodesic {
namespace {

constexpr char kUrl[] = "geodesic/field-path";

// Abseil's own type where it was built for C++14.
absl::string_view View(std::string_view text) {
  return {text.data(), text.size()};
}

}  // namespace

absl::Status WithFieldPath(absl::Status status, std::string_view path) {
  status.SetPayload(kUrl, absl::Cord(View(path)));
  return status;
}

absl::Status InvalidField(std::string_view path, std::string_view message) {
  return WithFieldPath(absl::InvalidArgumentError(View(message)), path);
}

std::optional<std::string> FieldPathOf(const absl::Status& status) {
  const auto payload = status.GetPayload(kUrl);
  if (!payload) return std::nullopt;
  return std::string(*payload);
}

}  // namespace geodesic
