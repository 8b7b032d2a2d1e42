// Stanford PLY.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "readers/ply_header.h"
#include "readers/reader_errors.h"
#include "readers/readers.h"
#include "readers/soup_builder.h"
#include "readers/text_scanner.h"

namespace geodesic {
namespace {

// The rows of all elements, behind the header. Its methods return whether to go
// on, as SoupBuilder's do.
class Body {
 public:
  Body(const PlyHeader& header, SoupBuilder& builder)
      : header_(header), builder_(builder) {}
  virtual ~Body() = default;

  void Read() {
    for (const PlyElement& element : header_.elements) {
      // A binary row without properties takes no bytes; an ASCII one is a blank
      // line, and those are skipped.
      if (element.properties.empty()) continue;
      if (!Begin(element) || !Reserve(element)) return;
      uint64_t plain = 0;
      if (!ReadPlainTriangles(element, plain)) return;
      for (uint64_t row = plain; row < element.count; ++row) {
        Point point = {};
        if (!ReadRow(element, row, point)) return;
        if (element.kind == PlyElementKind::kVertex &&
            !builder_.AddVertex(point)) {
          return;
        }
      }
    }
    End();
  }

 protected:
  // Holds the header's count of rows against the bytes that are left.
  virtual bool Begin(const PlyElement& element) = 0;
  // Reads the first rows as long as they are triangles, and says how many: for
  // an encoding in which that is faster.
  virtual bool ReadPlainTriangles(const PlyElement& /*element*/,
                                  uint64_t& /*rows*/) {
    return true;
  }
  // Reads one row; of a vertex its place into `point`.
  virtual bool ReadRow(const PlyElement& element, uint64_t row,
                       Point& point) = 0;
  // Refuses whatever follows the last row.
  virtual bool End() = 0;
  // An error that names the place in the file.
  virtual absl::Status Here(const std::string& message) const = 0;

  template <typename... Parts>
  bool Refuse(const Parts&... parts) {
    return builder_.Refuse(Here(absl::StrCat(parts...)));
  }
  bool AddCorner(const PlyElement& element, uint64_t row, int64_t vertex) {
    if (vertex < 0 || static_cast<uint64_t>(vertex) >= header_.vertices) {
      return Refuse(element.Row(row), NamesNoVertex(vertex, header_.vertices));
    }
    return builder_.AddCorner(static_cast<uint32_t>(vertex));
  }

  const PlyHeader& header_;
  SoupBuilder& builder_;

 private:
  bool Reserve(const PlyElement& element) {
    switch (element.kind) {
      case PlyElementKind::kVertex:
        return builder_.ReserveVertices(element.count);
      case PlyElementKind::kFace:
        return builder_.ReserveTriangles(element.count);
      case PlyElementKind::kOther:
        break;
    }
    return true;
  }
};

// One row a line.
class AsciiBody final : public Body {
 public:
  AsciiBody(const PlyHeader& header, LineScanner& scanner, SoupBuilder& builder)
      : Body(header, builder), scanner_(scanner) {}

 private:
  bool Begin(const PlyElement& element) override {
    // A value takes a digit and a blank or line end; a face has three corners.
    uint64_t row_bytes = 0;
    bool has_corners = false;
    for (const PlyProperty& property : element.properties) {
      const bool is_face = property.role == PlyRole::kCorners;
      row_bytes += is_face ? 8 : 2;
      has_corners = has_corners || is_face;
    }
    // The last line may lack its end.
    if (element.count <= (scanner_.remaining() + 1) / row_bytes) return true;
    return builder_.Refuse(AtLine(
        element.line, element.count, " rows of element ",
        Printable(element.name),
        has_corners ? ", of three corners or more," : "", " cannot fit the ",
        scanner_.remaining(), " bytes that are left for them"));
  }

  bool ReadRow(const PlyElement& element, uint64_t row, Point& point) override {
    if (!scanner_.NextNonBlank()) {
      return Refuse("the file ends before ", element.Row(row), " of ",
                    element.count);
    }
    std::string_view rest = scanner_.line();
    for (const PlyProperty& property : element.properties) {
      const std::string_view token = TakeToken(rest);
      if (token.empty()) return RefuseMissing(element, row, property);
      if (property.count_type != nullptr) {
        if (!ReadList(element, row, property, token, rest)) return false;
      } else if (property.role != PlyRole::kIgnored) {
        const std::optional<double> value = ParseFinite(token);
        if (!value.has_value()) {
          return Refuse(element.Row(row), ": '", Printable(token),
                        "' is not a finite number");
        }
        point[static_cast<int>(property.role)] = *value;
      }
    }
    const std::string_view extra = TakeToken(rest);
    return extra.empty() || Refuse(element.Row(row), ": '", Printable(extra),
                                   "' is more than the header declares");
  }

  bool ReadList(const PlyElement& element, uint64_t row,
                const PlyProperty& property, std::string_view count_token,
                std::string_view& rest) {
    const std::optional<int64_t> count = ParseInteger(count_token);
    if (!count.has_value() || *count < 0) {
      return Refuse(element.Row(row), ": '", Printable(count_token),
                    "' is not the length of a list");
    }
    const bool corners = property.role == PlyRole::kCorners;
    if (corners && *count < 3) {
      return Refuse(element.Row(row), TooFewCorners(*count));
    }
    builder_.BeginFace();
    for (int64_t item = 0; item < *count; ++item) {
      const std::string_view token = TakeToken(rest);
      if (token.empty()) return RefuseMissing(element, row, property);
      if (!corners) continue;
      const std::optional<int64_t> vertex = ParseInteger(token);
      if (!vertex.has_value()) {
        return Refuse(element.Row(row), ": '", Printable(token),
                      "' is not a vertex number");
      }
      if (!AddCorner(element, row, *vertex)) return false;
    }
    return true;
  }

  bool End() override {
    return !scanner_.NextNonBlank() ||
           Refuse("more rows than the header declares");
  }

  bool RefuseMissing(const PlyElement& element, uint64_t row,
                     const PlyProperty& property) {
    return Refuse(element.Row(row), " ends within or before property ",
                  Printable(property.name));
  }
  absl::Status Here(const std::string& message) const override {
    return AtLine(scanner_.line_number(), message);
  }

  LineScanner& scanner_;
};

// Each element is compiled into a plan of few steps, which is then run row by
// row; runs of ignored scalars are one step.
class BinaryBody final : public Body {
 public:
  BinaryBody(const PlyHeader& header, std::string_view bytes,
             SoupBuilder& builder)
      : Body(header, builder), bytes_(bytes), offset_(header.body_offset) {}

 private:
  enum class StepKind { kSkip, kCoordinate, kSkipList, kCorners };

  struct Step {
    StepKind kind = StepKind::kSkip;
    // Bytes of the scalars; of a list, of its length field.
    size_t bytes = 0;
    size_t item_bytes = 0;                             // lists
    int axis = 0;                                      // kCoordinate
    double (*load_coordinate)(const char*) = nullptr;  // kCoordinate
    int64_t (*load_count)(const char*) = nullptr;      // lists
    int64_t (*load_item)(const char*) = nullptr;       // kCorners
    // Whether items are bit for bit what a Triangle holds, but for a sign.
    bool are_native = false;  // kCorners
  };

  bool Begin(const PlyElement& element) override {
    steps_.clear();
    uint64_t row_bytes = 0;  // the least that a row can take
    for (const PlyProperty& property : element.properties) {
      const Step step = StepOf(property);
      row_bytes += step.bytes;
      if (step.kind == StepKind::kCorners) row_bytes += 3 * step.item_bytes;
      if (step.kind == StepKind::kSkip && !steps_.empty() &&
          steps_.back().kind == StepKind::kSkip) {
        steps_.back().bytes += step.bytes;
      } else {
        steps_.push_back(step);
      }
    }
    if (element.count <= remaining() / row_bytes) return true;
    return Refuse(element.count, " rows of element ", Printable(element.name),
                  " take at least ", row_bytes, " bytes each, but only ",
                  remaining(), " bytes are left");
  }

  Step StepOf(const PlyProperty& property) const {
    const bool order = header_.encoding == PlyEncoding::kBinaryBigEndian;
    const PlyType& type = *property.type;
    if (property.count_type != nullptr) {
      return {.kind = property.role == PlyRole::kCorners ? StepKind::kCorners
                                                         : StepKind::kSkipList,
              .bytes = property.count_type->bytes,
              .item_bytes = type.bytes,
              .load_count = property.count_type->load_integer[order],
              .load_item = type.load_integer[order],
              .are_native = property.role == PlyRole::kCorners &&
                            type.bytes == sizeof(uint32_t) &&
                            order == (std::endian::native == std::endian::big)};
    }
    if (property.role == PlyRole::kIgnored) return {.bytes = type.bytes};
    return {.kind = StepKind::kCoordinate,
            .bytes = type.bytes,
            .axis = static_cast<int>(property.role),
            .load_coordinate = type.load_double[order]};
  }

  bool ReadPlainTriangles(const PlyElement& element, uint64_t& rows) override {
    const bool is_plain =
        steps_[0].are_native && steps_[0].bytes == 1 &&
        (steps_.size() == 1 ||
         (steps_.size() == 2 && steps_[1].kind == StepKind::kSkip));
    if (!is_plain) return true;
    Triangle corners;
    const size_t row_bytes =
        1 + sizeof(corners) + (steps_.size() == 2 ? steps_[1].bytes : 0);
    for (; rows < element.count && remaining() >= row_bytes &&
           bytes_[offset_] == 3;
         ++rows) {
      std::memcpy(&corners, bytes_.data() + offset_ + 1, sizeof(corners));
      // ReadRow says what is wrong.
      if (std::ranges::max(corners) >= header_.vertices) break;
      if (!builder_.AddTriangle(corners)) return false;
      offset_ += row_bytes;
    }
    return true;
  }

  bool ReadRow(const PlyElement& element, uint64_t row, Point& point) override {
    for (const Step& step : steps_) {
      if (remaining() < step.bytes) {
        return Refuse("the file ends within ", element.Row(row), " of ",
                      element.count);
      }
      switch (step.kind) {
        case StepKind::kSkip:
          break;
        case StepKind::kCoordinate:
          point[step.axis] = step.load_coordinate(bytes_.data() + offset_);
          if (!std::isfinite(point[step.axis])) {
            return Refuse(element.Row(row), ": coordinate ",
                          absl::string_view("xyz").substr(step.axis, 1),
                          " is not a finite number");
          }
          break;
        case StepKind::kSkipList:
        case StepKind::kCorners:
          if (!ReadList(element, step, row)) return false;
          continue;
      }
      offset_ += step.bytes;
    }
    return true;
  }

  // Moves past a list. REQUIRES: the bytes of its length are there.
  bool ReadList(const PlyElement& element, const Step& step, uint64_t row) {
    const int64_t count = step.load_count(bytes_.data() + offset_);
    const bool is_face = step.kind == StepKind::kCorners;
    if (is_face && count < 3) {
      return Refuse(element.Row(row), TooFewCorners(count));
    }
    if (count < 0) {
      return Refuse(element.Row(row), " has a list of length ", count);
    }
    const size_t left = remaining() - step.bytes;
    if (static_cast<uint64_t>(count) > left / step.item_bytes) {
      return Refuse(element.Row(row), " has a list of ", count, " items of ",
                    step.item_bytes, " bytes, but only ", left,
                    " bytes are left");
    }
    offset_ += step.bytes;
    if (!is_face) {
      offset_ += count * step.item_bytes;
      return true;
    }
    builder_.BeginFace();
    for (int64_t corner = 0; corner < count; ++corner) {
      const int64_t vertex = step.load_item(bytes_.data() + offset_);
      if (!AddCorner(element, row, vertex)) return false;
      offset_ += step.item_bytes;
    }
    return true;
  }

  bool End() override {
    // Padding is harmless; anything else means that header and body disagree.
    return bytes_.find_first_not_of(std::string_view("\0\r\n\t ", 5),
                                    offset_) == std::string_view::npos ||
           Refuse(remaining(), " bytes more than the header declares");
  }

  size_t remaining() const { return bytes_.size() - offset_; }
  absl::Status Here(const std::string& message) const override {
    return AtByte(offset_, message);
  }

  std::string_view bytes_;
  size_t offset_;
  std::vector<Step> steps_;  // of a row of the element at hand
};

}  // namespace

absl::StatusOr<TriangleSoup> ReadPly(std::string_view bytes,
                                     const ReadLimits& limits) {
  LineScanner scanner(bytes);
  const absl::StatusOr<PlyHeader> header = ReadPlyHeader(scanner);
  if (!header.ok()) return header.status();
  SoupBuilder builder(limits);
  if (header->encoding == PlyEncoding::kAscii) {
    AsciiBody(*header, scanner, builder).Read();
  } else {
    BinaryBody(*header, bytes, builder).Read();
  }
  return std::move(builder).Take();
}

}  // namespace geodesic
