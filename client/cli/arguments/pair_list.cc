#include "client/cli/arguments/pair_list.h"

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <istream>

#include "absl/strings/str_cat.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

void SkipBlanks(std::string_view* text) {
  while (!text->empty() && IsBlank(text->front())) text->remove_prefix(1);
}

// Takes the text of a place off the front. Commas end it, but for the two
// between the weights of a place in a face.
std::string_view TakePlace(std::string_view* text) {
  int commas = text->starts_with("face:") ? 2 : 0;
  size_t size = 0;
  for (; size < text->size() && !IsBlank((*text)[size]); ++size) {
    if ((*text)[size] == ',' && commas-- == 0) break;
  }
  const std::string_view place = text->substr(0, size);
  text->remove_prefix(size);
  return place;
}

}  // namespace

absl::StatusOr<PointPair> ParsePair(std::string_view line) {
  std::string_view rest = line;
  SkipBlanks(&rest);
  absl::StatusOr<SurfacePoint> source = ParsePoint(TakePlace(&rest));
  if (!source.ok()) return source.status();
  SkipBlanks(&rest);
  if (rest.starts_with(',')) rest.remove_prefix(1);
  SkipBlanks(&rest);
  if (rest.empty()) {
    return absl::InvalidArgumentError(
        absl::StrCat("'", std::string(line), "' is one place; write two"));
  }
  absl::StatusOr<SurfacePoint> target = ParsePoint(TakePlace(&rest));
  if (!target.ok()) return target.status();
  SkipBlanks(&rest);
  if (!rest.empty()) {
    return absl::InvalidArgumentError(
        absl::StrCat("'", std::string(rest), "' follows the two places of '",
                     std::string(line), "'"));
  }
  return PointPair{*source, *target};
}

absl::StatusOr<PairList> PairList::Open(const std::string& path) {
  if (path == kStandardInput) return PairList(path, nullptr);
  auto file = std::make_unique<std::ifstream>(path);
  if (!*file) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot read ", path));
  }
  return PairList(path, std::move(file));
}

absl::StatusOr<PairList::Piece> PairList::Read(size_t most) {
  std::istream& from = file_ == nullptr ? std::cin : *file_;
  Piece piece;
  std::string line;
  while (piece.pairs.size() < most && std::getline(from, line)) {
    ++lines_;
    if (line.starts_with('#') || std::ranges::all_of(line, IsBlank)) continue;
    absl::StatusOr<PointPair> pair = ParsePair(line);
    if (!pair.ok()) {
      return absl::InvalidArgumentError(absl::StrCat(
          path_, " line ", lines_, ": ", std::string(pair.status().message())));
    }
    piece.pairs.push_back(*std::move(pair));
    piece.lines.push_back(lines_);
  }
  if (from.bad()) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot read ", path_));
  }
  return piece;
}

}  // namespace geodesic::client
