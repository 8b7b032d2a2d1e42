#include "server/engine/source_numbers.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "absl/strings/match.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "server/engine/status_details.h"

namespace geodesic::server {
namespace {

uint32_t NumberOf(const std::vector<uint32_t>& numbers, size_t i,
                  size_t first) {
  return numbers.empty() ? static_cast<uint32_t>(first + i) : numbers[i];
}

// "curves[1].points[2].t 3 ..." -> "sources[4].curve.points[2].t 3 ...", if
// `message` begins with an element of `list`.
bool Renumber(std::string& message, std::string_view list,
              std::string_view ending, const std::vector<uint32_t>& numbers,
              size_t first, bool is_single) {
  if (!message.starts_with(list) || message[list.size()] != '[') return false;
  const size_t begin = list.size() + 1;
  const size_t end = message.find(']');
  uint64_t index = 0;
  if (end == std::string::npos ||
      !absl::SimpleAtoi(absl::string_view(message).substr(begin, end - begin),
                        &index)) {
    return false;
  }
  const std::string name =
      is_single
          ? "source"
          : absl::StrCat("sources[", NumberOf(numbers, index, first), "]");
  message = absl::StrCat(name, absl::string_view(ending.data(), ending.size()),
                         absl::string_view(message).substr(end + 1));
  return true;
}

}  // namespace

std::vector<uint32_t> NumberCanonical(const Query& query,
                                      const SourceNumbers& numbers,
                                      const Query& canonical,
                                      const Mesh& mesh) {
  std::vector<uint32_t> result(SourceCount(canonical));
  // Backwards, so that of equal sources the first stays.
  for (size_t i = query.sources.size(); i-- > 0;) {
    const Source source{Canonicalize(query.sources[i].point, mesh),
                        query.sources[i].offset + 0.0};
    // Of equal points the canonical form has the least offset only.
    const auto at = std::ranges::lower_bound(canonical.sources, source.point,
                                             {}, &Source::point);
    if (at->offset != source.offset) continue;
    result[at - canonical.sources.begin()] = NumberOf(numbers.points, i, 0);
  }
  for (size_t j = 0; j < query.curves.size(); ++j) {
    result[canonical.sources.size() + j] =
        NumberOf(numbers.curves, j, query.sources.size());
  }
  return result;
}

absl::Status ValidateAsNumbered(const Query& query,
                                const SourceNumbers& numbers,
                                const Mesh& mesh) {
  absl::Status status = Validate(query, mesh);
  if (status.ok()) return status;
  std::string message(status.message());
  if (!Renumber(message, "curves", ".curve", numbers.curves,
                query.sources.size(), numbers.is_single)) {
    Renumber(message, "sources", "", numbers.points, 0, numbers.is_single);
  }
  // The message begins with the path of what is wrong.
  const std::string field = message.substr(0, message.find_first_of(" :"));
  return WithField(absl::Status(status.code(), message), field);
}

}  // namespace geodesic::server
