#include "client/cli/arguments/pair_list.h"

#include <unistd.h>

#include <cerrno>
#include <ext/stdio_filebuf.h>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

// Two places take far less.
constexpr size_t kLongestLine = 4096;

// The next line without its end; false when there is none. Errors:
// INVALID_ARGUMENT for a line that is longer than kLongestLine.
absl::StatusOr<bool> ReadLine(std::istream& from, std::string* line) {
  line->clear();
  char c = 0;
  while (from.get(c)) {
    if (c == '\n') return true;
    if (line->size() == kLongestLine) {
      return absl::InvalidArgumentError(
          absl::StrCat("the line has more than ", kLongestLine,
                       " characters; write two places a line"));
    }
    line->push_back(c);
  }
  return !line->empty();
}

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

void SkipBlanks(std::string_view* text) {
  while (!text->empty() && IsBlank(text->front())) text->remove_prefix(1);
}

// Takes the text of a place off the front. A comma or a blank ends it, but for
// the two commas between the numbers of a place in a face or near a point in
// space, and for blanks before the latter's numbers.
std::string_view TakePlace(std::string_view* text) {
  const bool is_nearest = text->starts_with("nearest:");
  int commas = is_nearest || text->starts_with("face:") ? 2 : 0;
  size_t size = 0;
  bool has_number = !is_nearest;
  for (; size < text->size(); ++size) {
    const char c = (*text)[size];
    if (c == ',' ? commas-- == 0 : IsBlank(c) && has_number) break;
    if (is_nearest && !IsBlank(c)) has_number = c != ':' && c != ',';
  }
  const std::string_view place = text->substr(0, size);
  text->remove_prefix(size);
  return place;
}

// Takes a field off the front, and what divides it from the next.
std::string_view TakeField(std::string_view* text) {
  const std::string_view field = TakePlace(text);
  SkipBlanks(text);
  if (text->starts_with(',')) text->remove_prefix(1);
  SkipBlanks(text);
  return field;
}

// Whether it names the two columns, as the first line of a table may.
bool IsHeader(std::string_view line) {
  const std::string first(TakeField(&line));
  const std::string second(TakeField(&line));
  return absl::EqualsIgnoreCase(first, "source") &&
         absl::EqualsIgnoreCase(second, "target") && line.empty();
}

}  // namespace

absl::StatusOr<WrittenPair> ParsePair(std::string_view line) {
  std::string_view rest = line;
  SkipBlanks(&rest);
  absl::StatusOr<WrittenPoint> source = ParsePoint(TakeField(&rest));
  if (!source.ok()) return source.status();
  if (rest.empty()) {
    return absl::InvalidArgumentError(
        absl::StrCat("'", std::string(line), "' is one place; write two"));
  }
  absl::StatusOr<WrittenPoint> target = ParsePoint(TakePlace(&rest));
  if (!target.ok()) return target.status();
  SkipBlanks(&rest);
  if (!rest.empty()) {
    return absl::InvalidArgumentError(
        absl::StrCat("'", std::string(rest), "' follows the two places of '",
                     std::string(line), "'"));
  }
  return WrittenPair{*source, *target};
}

absl::StatusOr<PairList> PairList::Open(const std::string& path) {
  std::unique_ptr<std::filebuf> file;
  if (path == kStandardInput) {
    // std::cin could not tell whether more has come.
    file = std::make_unique<__gnu_cxx::stdio_filebuf<char>>(dup(STDIN_FILENO),
                                                            std::ios::in);
  } else {
    file = std::make_unique<std::filebuf>();
    file->open(path, std::ios::in);
  }
  if (!file->is_open()) {
    return absl::ErrnoToStatus(errno,
                               absl::StrCat("cannot read ", ListName(path)));
  }
  return PairList(path, std::move(file));
}

absl::StatusOr<PairList::Piece> PairList::Read(size_t most) {
  std::istream& from = *stream_;
  Piece piece;
  std::string read;
  while (piece.pairs.size() < most) {
    // What has come is answered before more is waited for.
    if (!piece.pairs.empty() && file_->in_avail() == 0) break;
    ++lines_;
    const absl::StatusOr<bool> is_there = ReadLine(from, &read);
    if (!is_there.ok()) return AtLine(is_there.status());
    if (!*is_there) break;
    std::string_view line = WithoutMark(read, lines_);
    SkipBlanks(&line);
    if (line.empty() || line.starts_with('#')) continue;
    if (!std::exchange(has_content_, true) && IsHeader(line)) continue;
    absl::StatusOr<WrittenPair> pair = ParsePair(line);
    if (!pair.ok()) {
      return AtLine(pair.status());
    }
    piece.pairs.push_back(*std::move(pair));
    piece.lines.push_back(lines_);
  }
  if (from.bad()) {
    return absl::ErrnoToStatus(errno,
                               absl::StrCat("cannot read ", ListName(path_)));
  }
  return piece;
}

absl::Status PairList::AtLine(const absl::Status& status) const {
  return absl::InvalidArgumentError(absl::StrCat(
      ListName(path_), " line ", lines_, ": ", std::string(status.message())));
}

}  // namespace geodesic::client
