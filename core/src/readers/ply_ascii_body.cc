#include <cstdint>
#include <optional>
#include <string_view>

#include "absl/status/status.h"
#include "geodesic/triangle_soup.h"
#include "readers/messages.h"
#include "readers/ply_body.h"

namespace geodesic {
namespace {

class AsciiBodyReader {
 public:
  AsciiBodyReader(const PlyHeader& header, LineScanner& scanner,
                  SoupBuilder& builder)
      : header_(header), scanner_(scanner), builder_(builder) {}

  absl::Status Read() {
    for (const PlyElement& element : header_.elements) {
      const uint64_t row_bytes = LeastRowBytes(element);
      // A row without properties is a blank line, and those are skipped.
      if (row_bytes == 0) continue;
      if (absl::Status status = Prepare(element, row_bytes); !status.ok()) {
        return status;
      }
      for (uint64_t row = 0; row < element.count; ++row) {
        if (absl::Status status = ReadRow(element, row); !status.ok()) {
          return status;
        }
      }
    }
    if (scanner_.NextNonBlank()) {
      return AtLine(scanner_.line_number(),
                    "more rows than the header declares");
    }
    return absl::OkStatus();
  }

 private:
  // A value takes a digit and a blank or line end; a face has three corners.
  static uint64_t LeastRowBytes(const PlyElement& element) {
    uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
      bytes += property.role == PlyRole::kCorners ? 8 : 2;
    }
    return bytes;
  }

  // Holds the header's count against the bytes that are left.
  absl::Status Prepare(const PlyElement& element, uint64_t row_bytes) {
    // The last line may lack its end.
    if (element.count > (scanner_.remaining() + 1) / row_bytes) {
      return AtLine(element.line, element.count, " rows of element ",
                    Printable(element.name), " cannot fit the ",
                    scanner_.remaining(), " bytes that are left for them");
    }
    switch (element.kind) {
      case PlyElementKind::kVertex:
        return builder_.ReserveVertices(element.count);
      case PlyElementKind::kFace:
        return builder_.ReserveTriangles(element.count);
      case PlyElementKind::kOther:
        break;
    }
    return absl::OkStatus();
  }

  absl::Status ReadRow(const PlyElement& element, uint64_t row) {
    if (!scanner_.NextNonBlank()) {
      return AtLine(scanner_.line_number(), "the file ends before ",
                    element.Row(row), " of ", element.count);
    }
    std::string_view rest = scanner_.line();
    Point point = {};
    for (const PlyProperty& property : element.properties) {
      absl::Status status =
          property.count_type.has_value()
              ? ReadList(element, row, property, rest)
              : ReadScalar(element, row, property, rest, point);
      if (!status.ok()) return status;
    }
    if (const std::string_view extra = TakeToken(rest); !extra.empty()) {
      return AtLine(scanner_.line_number(), element.Row(row), ": '",
                    Printable(extra), "' is more than the header declares");
    }
    if (element.kind == PlyElementKind::kVertex) {
      return builder_.AddVertex(point);
    }
    return absl::OkStatus();
  }

  absl::Status ReadScalar(const PlyElement& element, uint64_t row,
                          const PlyProperty& property, std::string_view& rest,
                          Point& point) {
    const std::string_view token = TakeToken(rest);
    if (token.empty()) return Missing(element, row, property);
    if (property.role == PlyRole::kIgnored) return absl::OkStatus();
    const std::optional<double> value = ParseFinite(token);
    if (!value.has_value()) {
      return AtLine(scanner_.line_number(), element.Row(row), ": '",
                    Printable(token), "' is not a finite number");
    }
    point[static_cast<int>(property.role) - static_cast<int>(PlyRole::kX)] =
        *value;
    return absl::OkStatus();
  }

  absl::Status ReadList(const PlyElement& element, uint64_t row,
                        const PlyProperty& property, std::string_view& rest) {
    const std::string_view count_token = TakeToken(rest);
    if (count_token.empty()) return Missing(element, row, property);
    const std::optional<int64_t> count = ParseInteger(count_token);
    if (!count.has_value() || *count < 0) {
      return AtLine(scanner_.line_number(), element.Row(row), ": '",
                    Printable(count_token), "' is not the length of a list");
    }
    const bool corners = property.role == PlyRole::kCorners;
    if (corners && *count < 3) {
      return AtLine(scanner_.line_number(), element.Row(row), " has ", *count,
                    " corners; at least 3 are needed");
    }
    builder_.BeginFace();
    for (int64_t item = 0; item < *count; ++item) {
      const std::string_view token = TakeToken(rest);
      if (token.empty()) return Missing(element, row, property);
      if (!corners) continue;
      if (absl::Status status = ReadCorner(element, row, token); !status.ok()) {
        return status;
      }
    }
    return absl::OkStatus();
  }

  absl::Status ReadCorner(const PlyElement& element, uint64_t row,
                          std::string_view token) {
    const std::optional<int64_t> vertex = ParseInteger(token);
    if (!vertex.has_value()) {
      return AtLine(scanner_.line_number(), element.Row(row), ": '",
                    Printable(token), "' is not a vertex number");
    }
    if (*vertex < 0 || static_cast<uint64_t>(*vertex) >= header_.vertices) {
      return AtLine(scanner_.line_number(), element.Row(row), " names vertex ",
                    *vertex, ", but there are ", header_.vertices,
                    " vertices, counted from 0");
    }
    return builder_.AddCorner(static_cast<uint32_t>(*vertex));
  }

  absl::Status Missing(const PlyElement& element, uint64_t row,
                       const PlyProperty& property) const {
    return AtLine(scanner_.line_number(), element.Row(row),
                  " ends within or before property ", Printable(property.name));
  }

  const PlyHeader& header_;
  LineScanner& scanner_;
  SoupBuilder& builder_;
};

}  // namespace

absl::Status ReadPlyAsciiBody(const PlyHeader& header, LineScanner& scanner,
                              SoupBuilder& builder) {
  return AsciiBodyReader(header, scanner, builder).Read();
}

}  // namespace geodesic
