#include "server/engine/base/argument_checks.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/string_view.h"
#include "digest/sha256.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

absl::string_view View(std::string_view text) {
  return {text.data(), text.size()};
}

}  // namespace

absl::Status CheckDigest(std::string_view field, const std::string& digest) {
  if (IsSha256Hex(digest)) return absl::OkStatus();
  return InvalidField(
      field,
      absl::StrCat(View(field), " must be 64 lower-case hexadecimal digits, ",
                   "not \"", digest.substr(0, 80), "\""));
}

absl::Status CheckCount(std::string_view things, uint64_t count,
                        std::string_view limit_name, uint64_t limit,
                        std::string_view who) {
  if (count <= limit) return absl::OkStatus();
  return absl::ResourceExhaustedError(
      absl::StrCat(View(who), " ", count, " ", View(things), "; ",
                   View(limit_name), " is ", limit, " (limit ",
                   absl::StrReplaceAll(View(limit_name), {{"_", "-"}}), ")"));
}

absl::Status AnswerNotKept() {
  return WithReason(
      absl::NotFoundError("the answer is no longer kept: ask for it again, "
                          "without a resumption"),
      reason::kAnswerNotKept);
}

absl::Status NotResident(const std::string& digest) {
  return WithMesh(absl::NotFoundError(absl::StrCat(
                      "mesh ", digest, " is not resident; upload it again")),
                  digest);
}

}  // namespace geodesic::server
