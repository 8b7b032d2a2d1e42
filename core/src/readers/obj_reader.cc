// Wavefront OBJ. Only v and f statements matter here; everything else is
// skipped unread, so that no name, path or extension can confuse the reader.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "readers/readers.h"
#include "readers/text_reader.h"

namespace geodesic {
namespace {

class ObjReader : TextReader {
 public:
  using TextReader::TextReader;

  absl::StatusOr<TriangleSoup> Read() {
    while (NextLine()) {
      if (!ReadStatement()) return std::move(builder_).Take();
    }
    CheckReferences();
    return std::move(builder_).Take();
  }

 private:
  bool ReadStatement() {
    const bool continued = CutComment(rest_);
    const std::string_view keyword = TakeToken(rest_);
    if (keyword != "v" && keyword != "f") return true;
    if (continued) JoinLines();
    // A weight or a colour may follow a vertex; neither moves it.
    return keyword == "v" ? ReadVertex() : ReadFace();
  }

  // Cuts off the comment, then the backslash that continues the line, if there
  // is one: at the end of a comment it continues nothing.
  static bool CutComment(std::string_view& line) {
    line = line.substr(0, line.find('#'));
    const bool continued = line.ends_with('\\');
    if (continued) line.remove_suffix(1);
    return continued;
  }

  // Appends the lines that continue a statement.
  void JoinLines() {
    joined_ = rest_;
    bool continued = true;
    while (continued && scanner_.Next()) {
      std::string_view next = scanner_.line();
      continued = CutComment(next);
      joined_ += ' ';
      joined_ += next;
    }
    rest_ = joined_;
  }

  bool ReadFace() {
    builder_.BeginFace();
    int64_t corners = 0;
    for (std::string_view token = TakeToken(rest_); !token.empty();
         token = TakeToken(rest_), ++corners) {
      const std::optional<int64_t> reference = ParseCorner(token);
      if (!reference.has_value()) {
        return Refuse("face ", faces_, ": '", Printable(token),
                      "' is not a corner (v, v/vt, v//vn or v/vt/vn)");
      }
      if (!AddCorner(*reference)) return false;
    }
    if (corners < 3) return Refuse("face ", faces_, TooFewCorners(corners));
    ++faces_;
    return true;
  }

  // The vertex reference of a corner; texture and normal numbers stay unused,
  // so it is enough that they could be numbers.
  static std::optional<int64_t> ParseCorner(std::string_view token) {
    const size_t slash = token.find('/');
    if (slash != std::string_view::npos) {
      if (token.find_first_not_of("0123456789+-/", slash) !=
          std::string_view::npos) {
        return std::nullopt;
      }
      token = token.substr(0, slash);
    }
    return ParseInteger(token);
  }

  // From OBJ's count (from 1, or back from the last vertex read) to ours. A
  // reference may run ahead of the vertices: see CheckReferences.
  bool AddCorner(int64_t reference) {
    const uint64_t vertices = builder_.vertices();
    if (reference == 0) {
      return Refuse("face ", faces_, " names vertex 0, but OBJ counts from 1");
    }
    if (reference > 0) {
      const uint64_t vertex = static_cast<uint64_t>(reference) - 1;
      if (vertex >= vertices &&
          (highest_.line == 0 || vertex > highest_.vertex)) {
        highest_ = {.vertex = vertex, .line = line_, .face = faces_};
      }
      return builder_.AddCorner(static_cast<uint32_t>(vertex));
    }
    const uint64_t back = uint64_t{0} - static_cast<uint64_t>(reference);
    if (back > vertices) {
      return Refuse("face ", faces_, " names vertex ", reference, ", but only ",
                    vertices, " vertices precede it");
    }
    return builder_.AddCorner(static_cast<uint32_t>(vertices - back));
  }

  // Positive references count through the whole file, so only at its end is it
  // known whether they hold. The highest decides for all.
  void CheckReferences() {
    if (highest_.line == 0 || highest_.vertex < builder_.vertices()) return;
    line_ = highest_.line;
    Refuse("face ", highest_.face, " names vertex ", highest_.vertex + 1,
           ", but the file has only ", builder_.vertices(), " vertices");
  }

  struct ForwardReference {
    uint64_t vertex = 0;
    uint64_t line = 0;  // 0: none yet
    uint64_t face = 0;
  };

  std::string joined_;
  uint64_t faces_ = 0;
  ForwardReference highest_;
};

}  // namespace

absl::StatusOr<TriangleSoup> ReadObj(std::string_view bytes,
                                     const ReadLimits& limits) {
  return ObjReader(bytes, limits).Read();
}

}  // namespace geodesic
