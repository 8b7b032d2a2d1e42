// ASCII STL: any number of solids, keywords in any case.

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/match.h"
#include "absl/strings/string_view.h"
#include "geodesic/read_mesh.h"
#include "readers/messages.h"
#include "readers/readers.h"
#include "readers/soup_builder.h"
#include "readers/text_scanner.h"
#include "readers/vertex_welder.h"

namespace geodesic {
namespace {

bool Is(std::string_view token, absl::string_view keyword) {
  return absl::EqualsIgnoreCase(absl::string_view(token.data(), token.size()),
                                keyword);
}

class AsciiStlReader {
 public:
  AsciiStlReader(std::string_view bytes, const ReadLimits& limits)
      : scanner_(bytes), builder_(limits), welder_(builder_) {}

  absl::StatusOr<TriangleSoup> Read() {
    for (std::string_view token = Take(); !token.empty(); token = Take()) {
      if (!Is(token, "solid")) return Unexpected(token, "solid");
      rest_ = {};  // a name, which may hold anything
      if (absl::Status status = ReadSolid(); !status.ok()) return status;
    }
    return std::move(builder_).Take();
  }

 private:
  // The next token, on whatever line; empty at the end of the file.
  std::string_view Take() {
    while (true) {
      const std::string_view token = TakeToken(rest_);
      if (!token.empty()) return token;
      if (!scanner_.Next()) return {};
      rest_ = scanner_.line();
    }
  }

  absl::Status Expect(absl::string_view keyword) {
    const std::string_view token = Take();
    return Is(token, keyword) ? absl::OkStatus() : Unexpected(token, keyword);
  }

  absl::Status Unexpected(std::string_view token,
                          absl::string_view expected) const {
    if (token.empty()) {
      return AtLine(scanner_.line_number(), "the file ends at face ", face_,
                    ", where '", expected, "' was expected");
    }
    return AtLine(scanner_.line_number(), "face ", face_, ": '", expected,
                  "' was expected, not '", Printable(token), "'");
  }

  // The rest of a solid behind its name.
  absl::Status ReadSolid() {
    std::string_view token = Take();
    for (; Is(token, "facet"); token = Take(), ++face_) {
      if (absl::Status status = ReadFacet(); !status.ok()) return status;
    }
    if (!Is(token, "endsolid")) return Unexpected(token, "endsolid");
    rest_ = {};  // the name again
    return absl::OkStatus();
  }

  // The rest of a facet behind its first word.
  absl::Status ReadFacet() {
    std::string_view token = Take();
    if (Is(token, "normal")) {
      // Normals follow from the corners, so theirs go unread.
      for (int axis = 0; axis < 3; ++axis) Take();
      token = Take();
    }
    if (!Is(token, "outer")) return Unexpected(token, "outer");
    if (absl::Status status = Expect("loop"); !status.ok()) return status;
    builder_.BeginFace();
    uint64_t corners = 0;
    for (token = Take(); Is(token, "vertex"); token = Take(), ++corners) {
      if (absl::Status status = ReadCorner(corners); !status.ok()) {
        return status;
      }
    }
    if (!Is(token, "endloop")) return Unexpected(token, "endloop");
    if (corners < 3) {
      return AtLine(scanner_.line_number(), "face ", face_, " has ", corners,
                    " corners; at least 3 are needed");
    }
    return Expect("endfacet");
  }

  absl::Status ReadCorner(uint64_t corner) {
    Point point;
    for (double& coordinate : point) {
      const std::string_view token = Take();
      const std::optional<double> value = ParseFinite(token);
      if (!value.has_value()) {
        return AtLine(scanner_.line_number(), "face ", face_, ", corner ",
                      corner, ": '", Printable(token),
                      "' is not a finite number");
      }
      coordinate = *value;
    }
    return welder_.AddCorner(point);
  }

  LineScanner scanner_;
  SoupBuilder builder_;
  VertexWelder welder_;
  std::string_view rest_;
  uint64_t face_ = 0;
};

}  // namespace

absl::StatusOr<TriangleSoup> ReadAsciiStl(std::string_view bytes,
                                          const ReadLimits& limits) {
  return AsciiStlReader(bytes, limits).Read();
}

}  // namespace geodesic
