// OFF and its variants with colours, normals and texture coordinates, ASCII.
//
// The format is free of line structure on paper, but colours of unknown width
// may end a vertex or a face, so what every program writes and reads is one
// vertex or face per line; this reader holds files to that.

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/read_mesh.h"
#include "readers/messages.h"
#include "readers/readers.h"
#include "readers/soup_builder.h"
#include "readers/text_scanner.h"

namespace geodesic {
namespace {

// The shortest lines there are, ends included: "0 0 0" and "3 0 0 0".
constexpr uint64_t kLeastVertexBytes = 6;
constexpr uint64_t kLeastFaceBytes = 8;

class OffReader {
 public:
  OffReader(std::string_view bytes, const ReadLimits& limits)
      : scanner_(bytes), builder_(limits) {}

  absl::StatusOr<TriangleSoup> Read() {
    if (absl::Status status = ReadHeader(); !status.ok()) return status;
    for (uint64_t vertex = 0; vertex < vertices_; ++vertex) {
      if (absl::Status status = ReadVertex(vertex); !status.ok()) return status;
    }
    for (uint64_t face = 0; face < faces_; ++face) {
      if (absl::Status status = ReadFace(face); !status.ok()) return status;
    }
    if (NextLine()) {
      return AtLine(scanner_.line_number(), "more than the ", vertices_,
                    " vertices and ", faces_, " faces that the header counts");
    }
    return std::move(builder_).Take();
  }

 private:
  // Moves to the next line that says something; rest_ is that line without
  // its comment.
  bool NextLine() {
    while (scanner_.NextNonBlank()) {
      rest_ = scanner_.line();
      rest_ = rest_.substr(0, rest_.find('#'));
      std::string_view probe = rest_;
      if (!TakeToken(probe).empty()) return true;
    }
    return false;
  }

  absl::Status ReadHeader() {
    if (!NextLine()) return AtLine(1, "the file holds no OFF header");
    const std::string_view token = TakeToken(rest_);
    std::string_view keyword = token;
    bool three_space = true;
    for (const std::string_view prefix : {"ST", "C", "N", "4", "n"}) {
      if (!keyword.starts_with(prefix)) continue;
      keyword.remove_prefix(prefix.size());
      three_space = prefix != "4" && prefix != "n";
    }
    if (!keyword.starts_with("OFF")) {
      return AtLine(scanner_.line_number(), "'", Printable(token),
                    "' is no OFF header");
    }
    if (!three_space) {
      return AtLine(scanner_.line_number(), "'", Printable(token),
                    "' holds points that are not in 3-space");
    }
    // A well-known data set writes the counts right behind: "OFF8 6 12".
    const std::string_view glued = keyword.substr(3);
    if (!glued.empty()) return ReadCounts(glued);
    std::string_view probe = rest_;
    std::string_view next = TakeToken(probe);
    if (next == "BINARY") {
      return AtLine(scanner_.line_number(),
                    "binary OFF is not supported: "
                    "save the mesh as ASCII OFF or as PLY");
    }
    if (next.empty() && !NextLine()) {
      return AtLine(scanner_.line_number(), "the file ends before its counts");
    }
    return ReadCounts(TakeToken(rest_));
  }

  absl::Status ReadCounts(std::string_view vertices_token) {
    const std::string_view faces_token = TakeToken(rest_);
    const std::optional<int64_t> vertices = ParseInteger(vertices_token);
    const std::optional<int64_t> faces = ParseInteger(faces_token);
    if (!vertices.has_value() || !faces.has_value() || *vertices < 0 ||
        *faces < 0) {
      return AtLine(scanner_.line_number(), "'", Printable(vertices_token), " ",
                    Printable(faces_token),
                    "' is not a count of vertices and of faces");
    }
    vertices_ = *vertices;
    faces_ = *faces;
    // The last line may lack its end.
    const uint64_t remaining = scanner_.remaining() + 1;
    if (vertices_ > remaining / kLeastVertexBytes) {
      return AtLine(scanner_.line_number(), vertices_,
                    " vertices cannot fit the ", scanner_.remaining(),
                    " bytes that follow");
    }
    if (faces_ >
        (remaining - vertices_ * kLeastVertexBytes) / kLeastFaceBytes) {
      return AtLine(scanner_.line_number(), vertices_, " vertices and ", faces_,
                    " faces cannot fit the ", scanner_.remaining(),
                    " bytes that follow");
    }
    if (absl::Status status = builder_.ReserveVertices(vertices_);
        !status.ok()) {
      return status;
    }
    return builder_.ReserveTriangles(faces_);
  }

  absl::Status ReadVertex(uint64_t vertex) {
    if (!NextLine()) {
      return AtLine(scanner_.line_number(), "the file ends before vertex ",
                    vertex, " of ", vertices_);
    }
    Point point;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view token = TakeToken(rest_);
      if (token.empty()) {
        return AtLine(scanner_.line_number(), "vertex ", vertex, " has ", axis,
                      " coordinates; 3 are needed");
      }
      const std::optional<double> value = ParseFinite(token);
      if (!value.has_value()) {
        return AtLine(scanner_.line_number(), "vertex ", vertex, ": '",
                      Printable(token), "' is not a finite number");
      }
      point[axis] = *value;
    }
    // Normals, colours and texture coordinates may follow.
    return builder_.AddVertex(point);
  }

  absl::Status ReadFace(uint64_t face) {
    if (!NextLine()) {
      return AtLine(scanner_.line_number(), "the file ends before face ", face,
                    " of ", faces_);
    }
    const std::string_view count_token = TakeToken(rest_);
    const std::optional<int64_t> corners = ParseInteger(count_token);
    if (!corners.has_value() || *corners < 0) {
      return AtLine(scanner_.line_number(), "face ", face, ": '",
                    Printable(count_token), "' is not a count of corners");
    }
    if (*corners < 3) {
      return AtLine(scanner_.line_number(), "face ", face, " has ", *corners,
                    " corners; at least 3 are needed");
    }
    builder_.BeginFace();
    for (int64_t corner = 0; corner < *corners; ++corner) {
      if (absl::Status status = ReadCorner(face, corner, *corners);
          !status.ok()) {
        return status;
      }
    }
    // A colour may follow.
    return absl::OkStatus();
  }

  absl::Status ReadCorner(uint64_t face, int64_t corner, int64_t corners) {
    const std::string_view token = TakeToken(rest_);
    if (token.empty()) {
      return AtLine(scanner_.line_number(), "face ", face, " names ", corner,
                    " of its ", corners, " corners");
    }
    const std::optional<int64_t> vertex = ParseInteger(token);
    if (!vertex.has_value()) {
      return AtLine(scanner_.line_number(), "face ", face, ": '",
                    Printable(token), "' is not a vertex number");
    }
    if (*vertex < 0 || static_cast<uint64_t>(*vertex) >= vertices_) {
      return AtLine(scanner_.line_number(), "face ", face, " names vertex ",
                    *vertex, ", but there are ", vertices_,
                    " vertices, counted from 0");
    }
    return builder_.AddCorner(static_cast<uint32_t>(*vertex));
  }

  LineScanner scanner_;
  SoupBuilder builder_;
  std::string_view rest_;
  uint64_t vertices_ = 0;
  uint64_t faces_ = 0;
};

}  // namespace

absl::StatusOr<TriangleSoup> ReadOff(std::string_view bytes,
                                     const ReadLimits& limits) {
  return OffReader(bytes, limits).Read();
}

}  // namespace geodesic
