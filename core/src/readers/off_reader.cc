// OFF and its variants with colours, normals and texture coordinates, ASCII.
//
// The format is free of line structure on paper, but colours of unknown width
// may end a vertex or a face, so what every program writes and reads is one
// vertex or face per line; this reader holds files to that.

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "readers/readers.h"
#include "readers/text_reader.h"

namespace geodesic {
namespace {

// The shortest lines there are, ends included: "0 0 0" and "3 0 0 0".
constexpr uint64_t kLeastVertexBytes = 6;
constexpr uint64_t kLeastFaceBytes = 8;

class OffReader : TextReader {
 public:
  using TextReader::TextReader;

  absl::StatusOr<TriangleSoup> Read() {
    if (ReadHeader() && ReadVertices() && ReadFaces() && NextRow()) {
      Refuse("more than the ", vertices_, " vertices and ", faces_,
             " faces that the header counts");
    }
    return std::move(builder_).Take();
  }

 private:
  // Moves to the next line that says something, without its comment.
  bool NextRow() {
    while (NextLine()) {
      rest_ = rest_.substr(0, rest_.find('#'));
      std::string_view probe = rest_;
      if (!TakeToken(probe).empty()) return true;
    }
    return false;
  }

  bool ReadHeader() {
    if (!NextRow()) {
      return builder_.Refuse(AtLine(1, "the file holds no OFF header"));
    }
    const std::string_view token = TakeToken(rest_);
    std::string_view keyword = token;
    bool three_space = true;
    for (const std::string_view prefix : {"ST", "C", "N", "4", "n"}) {
      if (!keyword.starts_with(prefix)) continue;
      keyword.remove_prefix(prefix.size());
      three_space = prefix != "4" && prefix != "n";
    }
    if (!keyword.starts_with("OFF")) {
      return Refuse("'", Printable(token), "' is no OFF header");
    }
    if (!three_space) {
      return Refuse("'", Printable(token),
                    "' holds points that are not in 3-space");
    }
    // A well-known data set writes the counts right behind: "OFF8 6 12".
    const std::string_view glued = keyword.substr(3);
    if (!glued.empty()) return ReadCounts(glued);
    std::string_view probe = rest_;
    const std::string_view next = TakeToken(probe);
    if (next == "BINARY") {
      return Refuse(
          "binary OFF is not supported: "
          "save the mesh as ASCII OFF or as PLY");
    }
    if (next.empty() && !NextRow()) {
      return Refuse("the file ends before its counts");
    }
    return ReadCounts(TakeToken(rest_));
  }

  bool ReadCounts(std::string_view vertices_token) {
    const std::string_view faces_token = TakeToken(rest_);
    const std::optional<int64_t> vertices = ParseInteger(vertices_token);
    const std::optional<int64_t> faces = ParseInteger(faces_token);
    if (!vertices.has_value() || !faces.has_value() || *vertices < 0 ||
        *faces < 0) {
      return Refuse("'", Printable(vertices_token), " ", Printable(faces_token),
                    "' is not a count of vertices and of faces");
    }
    vertices_ = *vertices;
    faces_ = *faces;
    // The last line may lack its end.
    const uint64_t remaining = scanner_.remaining() + 1;
    if (vertices_ > remaining / kLeastVertexBytes) {
      return Refuse(vertices_, " vertices cannot fit the ",
                    scanner_.remaining(), " bytes that follow");
    }
    if (faces_ >
        (remaining - vertices_ * kLeastVertexBytes) / kLeastFaceBytes) {
      return Refuse(vertices_, " vertices and ", faces_,
                    " faces cannot fit the ", scanner_.remaining(),
                    " bytes that follow");
    }
    return builder_.ReserveVertices(vertices_) &&
           builder_.ReserveTriangles(faces_);
  }

  bool ReadVertices() {
    for (uint64_t vertex = 0; vertex < vertices_; ++vertex) {
      if (!NextRow()) {
        return Refuse("the file ends before vertex ", vertex, " of ",
                      vertices_);
      }
      // Normals, colours and texture coordinates may follow.
      if (!ReadVertex()) return false;
    }
    return true;
  }

  bool ReadFaces() {
    for (uint64_t face = 0; face < faces_; ++face) {
      if (!NextRow()) {
        return Refuse("the file ends before face ", face, " of ", faces_);
      }
      if (!ReadFace(face)) return false;
    }
    return true;
  }

  // A colour may follow the corners.
  bool ReadFace(uint64_t face) {
    const std::string_view count_token = TakeToken(rest_);
    const std::optional<int64_t> corners = ParseInteger(count_token);
    if (!corners.has_value() || *corners < 0) {
      return Refuse("face ", face, ": '", Printable(count_token),
                    "' is not a count of corners");
    }
    if (*corners < 3) return Refuse("face ", face, TooFewCorners(*corners));
    builder_.BeginFace();
    for (int64_t corner = 0; corner < *corners; ++corner) {
      const std::string_view token = TakeToken(rest_);
      if (token.empty()) {
        return Refuse("face ", face, " names ", corner, " of its ", *corners,
                      " corners");
      }
      const std::optional<int64_t> vertex = ParseInteger(token);
      if (!vertex.has_value()) {
        return Refuse("face ", face, ": '", Printable(token),
                      "' is not a vertex number");
      }
      if (*vertex < 0 || static_cast<uint64_t>(*vertex) >= vertices_) {
        return Refuse("face ", face, NamesNoVertex(*vertex, vertices_));
      }
      if (!builder_.AddCorner(static_cast<uint32_t>(*vertex))) return false;
    }
    return true;
  }

  uint64_t vertices_ = 0;
  uint64_t faces_ = 0;
};

}  // namespace

absl::StatusOr<TriangleSoup> ReadOff(std::string_view bytes,
                                     const ReadLimits& limits) {
  return OffReader(bytes, limits).Read();
}

}  // namespace geodesic
