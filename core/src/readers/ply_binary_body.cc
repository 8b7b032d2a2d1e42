// Each element is compiled into a plan of few steps, which is then run row by
// row; runs of ignored scalars are one step.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/string_view.h"
#include "geodesic/triangle_soup.h"
#include "readers/messages.h"
#include "readers/ply_body.h"
#include "readers/ply_scalar.h"

namespace geodesic {
namespace {

enum class StepKind { kSkip, kCoordinate, kSkipList, kCorners };

struct Step {
  StepKind kind = StepKind::kSkip;
  // Bytes of the scalars; of a list, of its length field.
  size_t bytes = 0;
  size_t item_bytes = 0;                 // lists
  int axis = 0;                          // kCoordinate
  LoadDouble load_coordinate = nullptr;  // kCoordinate
  LoadInteger load_count = nullptr;      // lists
  LoadInteger load_item = nullptr;       // kCorners
};

struct Plan {
  std::vector<Step> steps;
  // The least bytes a row can take.
  uint64_t row_bytes = 0;
};

Plan MakePlan(const PlyElement& element, bool big_endian) {
  Plan plan;
  for (const PlyProperty& property : element.properties) {
    Step step;
    if (property.count_type.has_value()) {
      step.kind = StepKind::kSkipList;
      step.bytes = SizeOf(*property.count_type);
      step.item_bytes = SizeOf(property.type);
      step.load_count = IntegerLoader(*property.count_type, big_endian);
      if (property.role == PlyRole::kCorners) {
        step.kind = StepKind::kCorners;
        step.load_item = IntegerLoader(property.type, big_endian);
        plan.row_bytes += 3 * step.item_bytes;
      }
    } else {
      step.bytes = SizeOf(property.type);
      if (property.role != PlyRole::kIgnored) {
        step.kind = StepKind::kCoordinate;
        step.axis =
            static_cast<int>(property.role) - static_cast<int>(PlyRole::kX);
        step.load_coordinate = DoubleLoader(property.type, big_endian);
      }
    }
    plan.row_bytes += step.bytes;
    if (step.kind == StepKind::kSkip && !plan.steps.empty() &&
        plan.steps.back().kind == StepKind::kSkip) {
      plan.steps.back().bytes += step.bytes;
    } else {
      plan.steps.push_back(step);
    }
  }
  return plan;
}

class BinaryBodyReader {
 public:
  BinaryBodyReader(const PlyHeader& header, std::string_view bytes,
                   SoupBuilder& builder)
      : header_(header),
        bytes_(bytes),
        builder_(builder),
        offset_(header.body_offset) {}

  absl::Status Read() {
    const bool big_endian = header_.encoding == PlyEncoding::kBinaryBigEndian;
    for (const PlyElement& element : header_.elements) {
      const Plan plan = MakePlan(element, big_endian);
      // Rows without properties take no bytes, however many there are.
      if (plan.steps.empty()) continue;
      if (absl::Status status = Prepare(element, plan); !status.ok()) {
        return status;
      }
      for (uint64_t row = 0; row < element.count; ++row) {
        if (absl::Status status = ReadRow(element, plan, row); !status.ok()) {
          return status;
        }
      }
    }
    // Padding is harmless; anything else means that header and body disagree.
    if (bytes_.find_first_not_of(std::string_view("\0\r\n\t ", 5), offset_) !=
        std::string_view::npos) {
      return AtByte(offset_, remaining(),
                    " bytes more than the header declares");
    }
    return absl::OkStatus();
  }

 private:
  size_t remaining() const { return bytes_.size() - offset_; }

  // Holds the header's count against the bytes that are left.
  absl::Status Prepare(const PlyElement& element, const Plan& plan) {
    if (element.count > remaining() / plan.row_bytes) {
      return AtByte(offset_, element.count, " rows of element ",
                    Printable(element.name), " take at least ", plan.row_bytes,
                    " bytes each, but only ", remaining(), " bytes are left");
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

  absl::Status ReadRow(const PlyElement& element, const Plan& plan,
                       uint64_t row) {
    Point point = {};
    for (const Step& step : plan.steps) {
      if (remaining() < step.bytes) return Truncated(element, row);
      const char* const address = bytes_.data() + offset_;
      switch (step.kind) {
        case StepKind::kSkip:
          break;
        case StepKind::kCoordinate:
          point[step.axis] = step.load_coordinate(address);
          if (!std::isfinite(point[step.axis])) {
            return AtByte(offset_, element.Row(row), ": coordinate ",
                          absl::string_view("xyz").substr(step.axis, 1),
                          " is not a finite number");
          }
          break;
        case StepKind::kSkipList:
        case StepKind::kCorners:
          if (absl::Status status = ReadList(element, step, row);
              !status.ok()) {
            return status;
          }
          continue;
      }
      offset_ += step.bytes;
    }
    if (element.kind == PlyElementKind::kVertex) {
      return builder_.AddVertex(point);
    }
    return absl::OkStatus();
  }

  // Moves past a list. REQUIRES: the bytes of its length are there.
  absl::Status ReadList(const PlyElement& element, const Step& step,
                        uint64_t row) {
    const int64_t count = step.load_count(bytes_.data() + offset_);
    const bool corners = step.kind == StepKind::kCorners;
    if (corners && count < 3) {
      return AtByte(offset_, element.Row(row), " has ", count,
                    " corners; at least 3 are needed");
    }
    if (count < 0) {
      return AtByte(offset_, element.Row(row), " has a list of length ", count);
    }
    const size_t items_left = (remaining() - step.bytes) / step.item_bytes;
    if (static_cast<uint64_t>(count) > items_left) {
      return AtByte(offset_, element.Row(row), " has a list of ", count,
                    " items of ", step.item_bytes, " bytes, but only ",
                    remaining() - step.bytes, " bytes are left");
    }
    offset_ += step.bytes;
    if (!corners) {
      offset_ += count * step.item_bytes;
      return absl::OkStatus();
    }
    builder_.BeginFace();
    for (int64_t corner = 0; corner < count; ++corner) {
      const int64_t vertex = step.load_item(bytes_.data() + offset_);
      if (vertex < 0 || static_cast<uint64_t>(vertex) >= header_.vertices) {
        return AtByte(offset_, element.Row(row), " names vertex ", vertex,
                      ", but there are ", header_.vertices,
                      " vertices, counted from 0");
      }
      if (absl::Status status =
              builder_.AddCorner(static_cast<uint32_t>(vertex));
          !status.ok()) {
        return status;
      }
      offset_ += step.item_bytes;
    }
    return absl::OkStatus();
  }

  absl::Status Truncated(const PlyElement& element, uint64_t row) const {
    return AtByte(offset_, "the file ends within ", element.Row(row), " of ",
                  element.count);
  }

  const PlyHeader& header_;
  std::string_view bytes_;
  SoupBuilder& builder_;
  size_t offset_;
};

}  // namespace

absl::Status ReadPlyBinaryBody(const PlyHeader& header, std::string_view bytes,
                               SoupBuilder& builder) {
  return BinaryBodyReader(header, bytes, builder).Read();
}

}  // namespace geodesic
