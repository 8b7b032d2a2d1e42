// Wavefront OBJ. Only v and f statements matter here; everything else is
// skipped unread, so that no name, path or extension can confuse the reader.

#include <cstdint>
#include <optional>
#include <string>
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

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const ReadLimits& limits)
      : scanner_(bytes), builder_(limits) {}

  absl::StatusOr<TriangleSoup> Read() {
    while (scanner_.Next()) {
      if (absl::Status status = ReadStatement(); !status.ok()) return status;
    }
    if (absl::Status status = CheckReferences(); !status.ok()) return status;
    return std::move(builder_).Take();
  }

 private:
  absl::Status ReadStatement() {
    line_ = scanner_.line_number();
    std::string_view rest = scanner_.line();
    // A comment first: the backslash at the end of one continues nothing.
    rest = rest.substr(0, rest.find('#'));
    const bool continued = rest.ends_with('\\');
    if (continued) rest.remove_suffix(1);
    const std::string_view keyword = TakeToken(rest);
    if (keyword != "v" && keyword != "f") return absl::OkStatus();
    if (continued) rest = Join(rest);
    return keyword == "v" ? ReadVertex(rest) : ReadFace(rest);
  }

  // Appends the lines that continue a statement.
  std::string_view Join(std::string_view first) {
    joined_ = first;
    bool continued = true;
    while (continued && scanner_.Next()) {
      std::string_view next = scanner_.line();
      next = next.substr(0, next.find('#'));
      continued = next.ends_with('\\');
      if (continued) next.remove_suffix(1);
      joined_ += ' ';
      joined_ += next;
    }
    return joined_;
  }

  absl::Status ReadVertex(std::string_view rest) {
    Point point;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view token = TakeToken(rest);
      if (token.empty()) {
        return AtLine(line_, "vertex ", builder_.vertices(), " has ", axis,
                      " coordinates; 3 are needed");
      }
      const std::optional<double> value = ParseFinite(token);
      if (!value.has_value()) {
        return AtLine(line_, "vertex ", builder_.vertices(), ": '",
                      Printable(token), "' is not a finite number");
      }
      point[axis] = *value;
    }
    // A weight or a colour may follow; neither moves the vertex.
    return builder_.AddVertex(point);
  }

  absl::Status ReadFace(std::string_view rest) {
    builder_.BeginFace();
    uint64_t corners = 0;
    for (std::string_view token = TakeToken(rest); !token.empty();
         token = TakeToken(rest), ++corners) {
      const std::optional<int64_t> reference = ParseCorner(token);
      if (!reference.has_value()) {
        return AtLine(line_, "face ", faces_, ": '", Printable(token),
                      "' is not a corner (v, v/vt, v//vn or v/vt/vn)");
      }
      const absl::StatusOr<uint32_t> vertex = Resolve(*reference);
      if (!vertex.ok()) return vertex.status();
      if (absl::Status status = builder_.AddCorner(*vertex); !status.ok()) {
        return status;
      }
    }
    if (corners < 3) {
      return AtLine(line_, "face ", faces_, " has ", corners,
                    " corners; at least 3 are needed");
    }
    ++faces_;
    return absl::OkStatus();
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
  absl::StatusOr<uint32_t> Resolve(int64_t reference) {
    const uint64_t vertices = builder_.vertices();
    if (reference == 0) {
      return AtLine(line_, "face ", faces_,
                    " names vertex 0, but OBJ counts from 1");
    }
    if (reference > 0) {
      const uint64_t vertex = static_cast<uint64_t>(reference) - 1;
      if (vertex >= vertices &&
          (highest_.line == 0 || vertex > highest_.vertex)) {
        highest_ = {.vertex = vertex, .line = line_, .face = faces_};
      }
      return static_cast<uint32_t>(vertex);
    }
    const uint64_t back = uint64_t{0} - static_cast<uint64_t>(reference);
    if (back > vertices) {
      return AtLine(line_, "face ", faces_, " names vertex ", reference,
                    ", but only ", vertices, " vertices precede it");
    }
    return static_cast<uint32_t>(vertices - back);
  }

  // Positive references count through the whole file, so only at its end is it
  // known whether they hold. The highest decides for all.
  absl::Status CheckReferences() const {
    if (highest_.line == 0 || highest_.vertex < builder_.vertices()) {
      return absl::OkStatus();
    }
    return AtLine(highest_.line, "face ", highest_.face, " names vertex ",
                  highest_.vertex + 1, ", but the file has only ",
                  builder_.vertices(), " vertices");
  }

  struct ForwardReference {
    uint64_t vertex = 0;
    uint64_t line = 0;  // 0: none yet
    uint64_t face = 0;
  };

  LineScanner scanner_;
  SoupBuilder builder_;
  std::string joined_;
  uint64_t line_ = 0;
  uint64_t faces_ = 0;
  ForwardReference highest_;
};

}  // namespace

absl::StatusOr<TriangleSoup> ReadObj(std::string_view bytes,
                                     const ReadLimits& limits) {
  return ObjReader(bytes, limits).Read();
}

}  // namespace geodesic
