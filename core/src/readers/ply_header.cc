#include "readers/ply_header.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "readers/messages.h"

namespace geodesic {
namespace {

class HeaderReader {
 public:
  explicit HeaderReader(LineScanner& scanner) : scanner_(scanner) {}

  absl::StatusOr<PlyHeader> Read() {
    if (!scanner_.Next() || Trimmed(scanner_.line()) != "ply") {
      return AtLine(1, "the file does not begin with 'ply'");
    }
    const LineEnd line_end = scanner_.line_end();
    bool ended = false;
    while (!ended) {
      if (!scanner_.Next()) {
        return AtLine(scanner_.line_number(),
                      "the file ends before end_header");
      }
      std::string_view rest = scanner_.line();
      const std::string_view keyword = TakeToken(rest);
      ended = keyword == "end_header";
      if (absl::Status status = ReadLine(keyword, rest); !status.ok()) {
        return status;
      }
    }
    // After CR alone, a line feed is the first byte of a binary body.
    const bool cr_only = line_end == LineEnd::kCr;
    const bool took_line_feed = scanner_.line_end() == LineEnd::kCrLf;
    header_.body_offset = scanner_.offset() - (cr_only && took_line_feed);
    if (!has_format_) {
      return AtLine(scanner_.line_number(), "the header names no format");
    }
    if (absl::Status status = AssignRoles(); !status.ok()) return status;
    return std::move(header_);
  }

 private:
  static std::string_view Trimmed(std::string_view line) {
    return TakeToken(line);
  }

  absl::Status ReadLine(std::string_view keyword, std::string_view rest) {
    if (keyword == "format") return ReadFormat(rest);
    if (keyword == "element") return ReadElement(rest);
    if (keyword == "property") return ReadProperty(rest);
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info" ||
        keyword == "end_header") {
      return absl::OkStatus();
    }
    // Blender 2.4 forgot the word comment: "Created by Blender3D 247 - ...".
    if (keyword == "Created") return absl::OkStatus();
    return AtLine(scanner_.line_number(), "'", Printable(keyword),
                  "' is not a word of a PLY header");
  }

  absl::Status ReadFormat(std::string_view rest) {
    const std::string_view name = TakeToken(rest);
    if (name == "ascii") {
      header_.encoding = PlyEncoding::kAscii;
    } else if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::kBinaryLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::kBinaryBigEndian;
    } else {
      return AtLine(scanner_.line_number(), "unknown format '", Printable(name),
                    "'");
    }
    if (has_format_) {
      return AtLine(scanner_.line_number(), "a second format");
    }
    has_format_ = true;
    return absl::OkStatus();
  }

  absl::Status ReadElement(std::string_view rest) {
    PlyElement element;
    element.name = TakeToken(rest);
    element.line = scanner_.line_number();
    const std::string_view count_token = TakeToken(rest);
    const std::optional<int64_t> count = ParseInteger(count_token);
    if (!count.has_value() || *count < 0) {
      return AtLine(element.line, "'", Printable(count_token),
                    "' is not a count of elements");
    }
    element.count = *count;
    header_.elements.push_back(std::move(element));
    return absl::OkStatus();
  }

  absl::Status ReadProperty(std::string_view rest) {
    if (header_.elements.empty()) {
      return AtLine(scanner_.line_number(), "a property before any element");
    }
    PlyProperty property;
    std::string_view type_name = TakeToken(rest);
    if (type_name == "list") {
      const std::string_view count_name = TakeToken(rest);
      property.count_type = PlyScalarFromName(count_name);
      if (!property.count_type.has_value() ||
          !IsInteger(*property.count_type)) {
        return AtLine(scanner_.line_number(), "'", Printable(count_name),
                      "' is not a type that can count a list");
      }
      type_name = TakeToken(rest);
    }
    const std::optional<PlyScalar> type = PlyScalarFromName(type_name);
    if (!type.has_value()) {
      return AtLine(scanner_.line_number(), "unknown type '",
                    Printable(type_name), "'");
    }
    property.type = *type;
    property.name = TakeToken(rest);
    if (property.name.empty()) {
      return AtLine(scanner_.line_number(), "a property without a name");
    }
    header_.elements.back().properties.push_back(property);
    return absl::OkStatus();
  }

  absl::Status AssignRoles() {
    bool has_vertices = false;
    bool has_faces = false;
    for (PlyElement& element : header_.elements) {
      absl::Status status = absl::OkStatus();
      if (element.name == "vertex") {
        if (std::exchange(has_vertices, true)) {
          return AtLine(element.line, "a second element vertex");
        }
        header_.vertices = element.count;
        status = AssignVertexRoles(element);
      } else if (element.name == "face") {
        if (std::exchange(has_faces, true)) {
          return AtLine(element.line, "a second element face");
        }
        status = AssignFaceRoles(element);
      } else if (element.name == "tristrips" && element.count > 0) {
        status = AtLine(element.line,
                        "triangle strips are not supported: save the mesh "
                        "with an element face");
      }
      if (!status.ok()) return status;
    }
    if (!has_vertices) {
      return AtLine(scanner_.line_number(),
                    "the header declares no element vertex");
    }
    return absl::OkStatus();
  }

  static absl::Status AssignVertexRoles(PlyElement& element) {
    element.kind = PlyElementKind::kVertex;
    for (const auto& [name, role] : {std::pair{"x", PlyRole::kX},
                                     {"y", PlyRole::kY},
                                     {"z", PlyRole::kZ}}) {
      PlyProperty* found = nullptr;
      for (PlyProperty& property : element.properties) {
        if (property.name != name) continue;
        if (found != nullptr || property.count_type.has_value()) {
          return AtLine(element.line, "vertex property ", name,
                        " is not one single number");
        }
        found = &property;
      }
      if (found == nullptr) {
        return AtLine(element.line, "element vertex has no property ", name);
      }
      found->role = role;
    }
    return absl::OkStatus();
  }

  static absl::Status AssignFaceRoles(PlyElement& element) {
    element.kind = PlyElementKind::kFace;
    PlyProperty* found = nullptr;
    for (PlyProperty& property : element.properties) {
      if (property.name != "vertex_indices" &&
          property.name != "vertex_index") {
        continue;
      }
      if (found != nullptr || !property.count_type.has_value() ||
          !IsInteger(property.type)) {
        return AtLine(element.line, "face property ", Printable(property.name),
                      " is not one list of whole numbers");
      }
      found = &property;
    }
    if (found != nullptr) {
      found->role = PlyRole::kCorners;
    } else if (element.count > 0) {
      return AtLine(element.line,
                    "element face has no list vertex_indices or "
                    "vertex_index");
    }
    return absl::OkStatus();
  }

  LineScanner& scanner_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

std::string PlyElement::Row(uint64_t row) const {
  return absl::StrCat(Printable(name), " ", row);
}

absl::StatusOr<PlyHeader> ReadPlyHeader(LineScanner& scanner) {
  return HeaderReader(scanner).Read();
}

}  // namespace geodesic
