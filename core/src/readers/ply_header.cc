#include "readers/ply_header.h"

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "readers/byte_order.h"
#include "readers/reader_errors.h"

namespace geodesic {
namespace {

template <typename Result, typename Stored, std::endian kOrder>
Result LoadAs(const char* address) {
  return static_cast<Result>(Load<Stored, kOrder>(address));
}

template <typename Stored>
constexpr PlyType TypeOf(std::string_view name, std::string_view sized_name) {
  constexpr auto kLittle = std::endian::little, kBig = std::endian::big;
  return {
      name,
      sized_name,
      sizeof(Stored),
      std::is_integral_v<Stored>,
      {LoadAs<double, Stored, kLittle>, LoadAs<double, Stored, kBig>},
      {LoadAs<int64_t, Stored, kLittle>, LoadAs<int64_t, Stored, kBig>},
  };
}

constexpr std::array<PlyType, 8> kTypes = {
    TypeOf<int8_t>("char", "int8"),    TypeOf<uint8_t>("uchar", "uint8"),
    TypeOf<int16_t>("short", "int16"), TypeOf<uint16_t>("ushort", "uint16"),
    TypeOf<int32_t>("int", "int32"),   TypeOf<uint32_t>("uint", "uint32"),
    TypeOf<float>("float", "float32"), TypeOf<double>("double", "float64"),
};

// Null for an unknown name.
const PlyType* TypeNamed(std::string_view name) {
  for (const PlyType& type : kTypes) {
    if (name == type.name || name == type.sized_name) return &type;
  }
  return nullptr;
}

// Its methods return whether to go on; error_ says why not.
class HeaderReader {
 public:
  explicit HeaderReader(LineScanner& scanner) : scanner_(scanner) {}

  absl::StatusOr<PlyHeader> Read() {
    if (!ReadLines() || !AssignRoles()) return std::move(error_);
    return std::move(header_);
  }

 private:
  template <typename... Parts>
  bool RefuseAt(uint64_t line, const Parts&... parts) {
    error_ = AtLine(line, parts...);
    return false;
  }
  template <typename... Parts>
  bool Refuse(const Parts&... parts) {
    return RefuseAt(scanner_.line_number(), parts...);
  }

  bool ReadLines() {
    std::string_view rest;
    if (scanner_.Next()) rest = scanner_.line();
    if (TakeToken(rest) != "ply") {
      return RefuseAt(1, "the file does not begin with 'ply'");
    }
    const LineEnd line_end = scanner_.line_end();
    std::string_view keyword;
    while (keyword != "end_header") {
      if (!scanner_.Next()) return Refuse("the file ends before end_header");
      rest = scanner_.line();
      keyword = TakeToken(rest);
      if (!ReadLine(keyword, rest)) return false;
    }
    // After CR alone, a line feed is the first byte of a binary body.
    const bool cr_only = line_end == LineEnd::kCr;
    const bool took_line_feed = scanner_.line_end() == LineEnd::kCrLf;
    header_.body_offset = scanner_.offset() - (cr_only && took_line_feed);
    return has_format_ || Refuse("the header names no format");
  }

  bool ReadLine(std::string_view keyword, std::string_view rest) {
    if (keyword == "format") return ReadFormat(rest);
    if (keyword == "element") return ReadElement(rest);
    if (keyword == "property") return ReadProperty(rest);
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info" ||
        keyword == "end_header") {
      return true;
    }
    // Blender 2.4 forgot the word comment: "Created by Blender3D 247 - ...".
    if (keyword == "Created") return true;
    return Refuse("'", Printable(keyword), "' is not a word of a PLY header");
  }

  bool ReadFormat(std::string_view rest) {
    const std::string_view name = TakeToken(rest);
    if (name == "ascii") {
      header_.encoding = PlyEncoding::kAscii;
    } else if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::kBinaryLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::kBinaryBigEndian;
    } else {
      return Refuse("unknown format '", Printable(name), "'");
    }
    return !std::exchange(has_format_, true) || Refuse("a second format");
  }

  bool ReadElement(std::string_view rest) {
    PlyElement element;
    element.name = TakeToken(rest);
    element.line = scanner_.line_number();
    const std::string_view count_token = TakeToken(rest);
    const std::optional<int64_t> count = ParseInteger(count_token);
    if (!count.has_value() || *count < 0) {
      return Refuse("'", Printable(count_token),
                    "' is not a count of elements");
    }
    element.count = *count;
    header_.elements.push_back(std::move(element));
    return true;
  }

  bool ReadProperty(std::string_view rest) {
    if (header_.elements.empty()) {
      return Refuse("a property before any element");
    }
    PlyProperty property;
    std::string_view type_name = TakeToken(rest);
    if (type_name == "list") {
      const std::string_view count_name = TakeToken(rest);
      property.count_type = TypeNamed(count_name);
      if (property.count_type == nullptr || !property.count_type->is_integer) {
        return Refuse("'", Printable(count_name),
                      "' is not a type that can count a list");
      }
      type_name = TakeToken(rest);
    }
    property.type = TypeNamed(type_name);
    if (property.type == nullptr) {
      return Refuse("unknown type '", Printable(type_name), "'");
    }
    property.name = TakeToken(rest);
    if (property.name.empty()) return Refuse("a property without a name");
    header_.elements.back().properties.push_back(property);
    return true;
  }

  bool AssignRoles() {
    bool has_vertices = false;
    bool has_faces = false;
    for (PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        if (std::exchange(has_vertices, true)) {
          return RefuseAt(element.line, "a second element vertex");
        }
        header_.vertices = element.count;
        if (!AssignVertexRoles(element)) return false;
      } else if (element.name == "face") {
        if (std::exchange(has_faces, true)) {
          return RefuseAt(element.line, "a second element face");
        }
        if (!AssignFaceRoles(element)) return false;
      } else if (element.name == "tristrips" && element.count > 0) {
        return RefuseAt(element.line,
                        "triangle strips are not supported: save the mesh "
                        "with an element face");
      }
    }
    return has_vertices || Refuse("the header declares no element vertex");
  }

  bool AssignVertexRoles(PlyElement& element) {
    element.kind = PlyElementKind::kVertex;
    for (const auto& [name, role] : {std::pair{"x", PlyRole::kX},
                                     {"y", PlyRole::kY},
                                     {"z", PlyRole::kZ}}) {
      PlyProperty* found = nullptr;
      for (PlyProperty& property : element.properties) {
        if (property.name != name) continue;
        if (found != nullptr || property.count_type != nullptr) {
          return RefuseAt(element.line, "vertex property ", name,
                          " is not one single number");
        }
        found = &property;
      }
      if (found == nullptr) {
        return RefuseAt(element.line, "element vertex has no property ", name);
      }
      found->role = role;
    }
    return true;
  }

  bool AssignFaceRoles(PlyElement& element) {
    element.kind = PlyElementKind::kFace;
    PlyProperty* found = nullptr;
    for (PlyProperty& property : element.properties) {
      if (property.name != "vertex_indices" &&
          property.name != "vertex_index") {
        continue;
      }
      if (found != nullptr || property.count_type == nullptr ||
          !property.type->is_integer) {
        return RefuseAt(element.line, "face property ",
                        Printable(property.name),
                        " is not one list of whole numbers");
      }
      found = &property;
    }
    if (found != nullptr) found->role = PlyRole::kCorners;
    return found != nullptr || element.count == 0 ||
           RefuseAt(element.line,
                    "element face has no list vertex_indices or "
                    "vertex_index");
  }

  LineScanner& scanner_;
  PlyHeader header_;
  bool has_format_ = false;
  absl::Status error_;
};

}  // namespace

std::string PlyElement::Row(uint64_t row) const {
  return absl::StrCat(Printable(name), " ", row);
}

absl::StatusOr<PlyHeader> ReadPlyHeader(LineScanner& scanner) {
  return HeaderReader(scanner).Read();
}

}  // namespace geodesic
