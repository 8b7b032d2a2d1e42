// Reads pairs of places from a text file, piece by piece.

#ifndef GEODESIC_CLIENT_CLI_ARGUMENTS_PAIR_LIST_H_
#define GEODESIC_CLIENT_CLI_ARGUMENTS_PAIR_LIST_H_

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "client/places/written_place.h"

namespace geodesic::client {

// Two places (place_text.h) with blanks, tabs or a comma between them. Blanks
// after a comma of nearest:X,Y,Z belong to it. What
// follows them is an error, INVALID_ARGUMENT naming the text.
absl::StatusOr<WrittenPair> ParsePair(std::string_view line);

// A pair of places a line. Empty lines and those that begin with '#' are
// skipped, and so is a first line "source,target".
class PairList {
 public:
  // "-" is standard input. Errors: those of opening the file, naming it.
  static absl::StatusOr<PairList> Open(const std::string& path);

  struct Piece {
    std::vector<WrittenPair> pairs;
    std::vector<uint64_t> lines;  // where each pair stands, from 1
  };

  // The next pairs: `most` of them, or fewer where the file ends or what has
  // come of a pipe does. Waits for one; none is the end.
  // Errors: those of reading; INVALID_ARGUMENT naming the file and the line.
  absl::StatusOr<Piece> Read(size_t most);

  const std::string& path() const { return path_; }

 private:
  PairList(std::string path, std::unique_ptr<std::filebuf> file)
      : path_(std::move(path)),
        file_(std::move(file)),
        stream_(std::make_unique<std::istream>(file_.get())) {}

  // An error in the line that was read last.
  absl::Status AtLine(const absl::Status& status) const;

  std::string path_;
  std::unique_ptr<std::filebuf> file_;
  std::unique_ptr<std::istream> stream_;  // of file_
  uint64_t lines_ = 0;                    // that were read
  bool has_content_ = false;              // whether one was not skipped
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_ARGUMENTS_PAIR_LIST_H_
