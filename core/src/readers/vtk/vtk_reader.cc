// VTK's legacy format (".vtk"): surfaces as POLYDATA or UNSTRUCTURED_GRID,
// ASCII or binary, with cells as files before version 5 have them (each with
// its count of corners) and since (offsets into one list of corners).
//
// Data behind the cells, such as scalars, go unread.

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "readers/reader_errors.h"
#include "readers/readers.h"
#include "readers/soup_builder.h"
#include "readers/text_scanner.h"
#include "readers/vtk/vtk_cells.h"
#include "readers/vtk/vtk_numbers.h"

namespace geodesic {
namespace {

// The cells of an UNSTRUCTURED_GRID that are faces, or no part of a surface.
constexpr int64_t kVertexCell = 1;
constexpr int64_t kPolyLineCell = 4;
constexpr int64_t kTriangleCell = 5;
constexpr int64_t kPolygonCell = 7;
constexpr int64_t kQuadCell = 9;

// The words of a line that begins a section.
struct Section {
  std::string_view name;
  std::array<std::string_view, 3> rest;
};

Section Words(std::string_view line) {
  Section section;
  section.name = TakeToken(line);
  for (std::string_view& word : section.rest) word = TakeToken(line);
  return section;
}

// Its methods return whether to go on, as SoupBuilder's do.
class VtkReader {
 public:
  VtkReader(std::string_view bytes, const ReadLimits& limits)
      : cursor_(bytes), builder_(limits) {}

  absl::StatusOr<TriangleSoup> Read() {
    bool goes_on = ReadHeader();
    while (goes_on && !is_complete_ && NextSection()) goes_on = ReadSection();
    if (goes_on && !has_cells_) {
      Refuse("the file holds no POLYGONS and no CELLS");
    }
    return std::move(builder_).Take();
  }

 private:
  template <typename... Parts>
  bool Refuse(const Parts&... parts) {
    return builder_.Refuse(AtByte(cursor_.offset(), parts...));
  }

  bool ReadHeader() {
    std::string_view first = cursor_.Line().value_or("");
    constexpr std::string_view kMagic = "# vtk DataFile Version ";
    if (!first.starts_with(kMagic)) {
      return Refuse("the file does not begin with '", std::string(kMagic), "'");
    }
    first.remove_prefix(kMagic.size());
    const std::optional<int64_t> version =
        ParseInteger(first.substr(0, first.find('.')));
    if (!version.has_value()) {
      return Refuse("'", Printable(first), "' is no version");
    }
    has_offsets_ = *version >= 5;
    cursor_.Line();  // the title
    const Section encoding = Words(cursor_.Line().value_or(""));
    if (encoding.name == "BINARY") {
      cursor_.set_binary(std::endian::big);
    } else if (encoding.name != "ASCII") {
      return Refuse("'", Printable(encoding.name),
                    "' is neither ASCII nor BINARY");
    }
    return true;
  }

  // Moves to the next line that says something.
  bool NextSection() {
    while (const std::optional<std::string_view> line = cursor_.Line()) {
      section_ = Words(*line);
      if (!section_.name.empty()) return true;
    }
    return false;
  }

  bool ReadSection() {
    if (section_.name == "DATASET") {
      is_grid_ = section_.rest[0] == "UNSTRUCTURED_GRID";
      return is_grid_ || section_.rest[0] == "POLYDATA" ||
             Refuse("the file holds a ", Printable(section_.rest[0]),
                    ", which is no surface; POLYDATA and UNSTRUCTURED_GRID "
                    "are read");
    }
    if (section_.name == "POINTS") return ReadPoints();
    if (section_.name == "POLYGONS" || section_.name == "CELLS") {
      return ReadCells();
    }
    if (section_.name == "VERTICES" || section_.name == "LINES") {
      return FindCells().has_value();
    }
    if (section_.name == "METADATA") {
      // Up to a blank line.
      for (std::string_view line = "-"; !line.empty();) {
        line = cursor_.Line().value_or("");
      }
      return true;
    }
    if (section_.name == "FIELD") return SkipField();
    if (section_.name == "TRIANGLE_STRIPS") {
      return Refuse(kVtkStripsAreNotRead);
    }
    if (section_.name == "POINT_DATA" || section_.name == "CELL_DATA" ||
        section_.name == "CELL_TYPES") {
      is_complete_ = true;
      return true;
    }
    return Refuse("'", Printable(section_.name), "' begins no known section");
  }

  bool TakeCount(std::string_view word, uint64_t* count) {
    const std::optional<int64_t> number = ParseInteger(word);
    if (!number.has_value() || *number < 0) {
      return Refuse(std::string(section_.name), ": '", Printable(word),
                    "' is no count");
    }
    *count = static_cast<uint64_t>(*number);
    return true;
  }

  const VtkType* FindType(std::string_view name) {
    const VtkType* const type = VtkTypeNamed(kVtkTypes, name);
    if (type != nullptr) return type;
    Refuse(std::string(section_.name), ": '", Printable(name),
           "' is no known type");
    return nullptr;
  }

  // Moves past `count` numbers; a cursor at them, if they are there.
  std::optional<VtkCursor> Pass(uint64_t count, const VtkType& type) {
    const VtkCursor begin = cursor_;
    if (count <= cursor_.MostNumbers(type) && cursor_.Skip(count, type)) {
      return begin;
    }
    Refuse(std::string(section_.name), ": ", count, " numbers do not fit the ",
           begin.remaining(), " bytes that follow");
    return std::nullopt;
  }

  bool ReadPoints() {
    uint64_t count = 0;
    if (!TakeCount(section_.rest[0], &count)) return false;
    const VtkType* const type = FindType(section_.rest[1]);
    if (type == nullptr) return false;
    if (builder_.vertices() > 0) return Refuse("POINTS come twice");
    if (count > cursor_.MostNumbers(*type) / 3) {
      return Refuse(count, " points do not fit the ", cursor_.remaining(),
                    " bytes that follow");
    }
    if (!builder_.ReserveVertices(count)) return false;
    for (uint64_t vertex = 0; vertex < count; ++vertex) {
      Point point;
      for (double& coordinate : point) {
        const std::optional<double> value = cursor_.Real(*type);
        if (!value.has_value()) {
          return Refuse("point ", vertex,
                        ": a coordinate is missing or not a finite number");
        }
        coordinate = *value;
      }
      if (!builder_.AddVertex(point)) return false;
    }
    return true;
  }

  // Arrays about the mesh as a whole: "name components tuples type", numbers.
  bool SkipField() {
    uint64_t arrays = 0;
    if (!TakeCount(section_.rest[1], &arrays)) return false;
    for (uint64_t array = 0; array < arrays; ++array) {
      if (!NextSection()) return Refuse("the file ends within a FIELD");
      uint64_t components = 0;
      uint64_t tuples = 0;
      if (!TakeCount(section_.rest[0], &components) ||
          !TakeCount(section_.rest[1], &tuples)) {
        return false;
      }
      if (section_.rest[2] == "string") {
        for (uint64_t line = 0; line < tuples; ++line) {
          if (!cursor_.Line().has_value()) break;
        }
        continue;
      }
      const VtkType* const type = FindType(section_.rest[2]);
      if (type == nullptr) return false;
      if (components != 0 && tuples > cursor_.remaining() / components) {
        return Refuse("an array of ", components, " times ", tuples,
                      " numbers does not fit the file");
      }
      if (!Pass(components * tuples, *type).has_value()) return false;
    }
    return true;
  }

  // Where the numbers of a section of cells lie.
  struct Cells {
    uint64_t count = 0;
    // The first corners; before version 5, each cell's count before its own.
    VtkCursor corners;
    const VtkType* type = &kVtkInt;
    // Since version 5: where each cell's corners begin, and where the last end.
    std::optional<VtkCursor> offsets;
    const VtkType* offset_type = &kVtkInt;
    uint64_t corner_count = 0;
  };

  // Moves past the cells.
  std::optional<Cells> FindCells() {
    Cells cells{.corners = cursor_};
    uint64_t numbers = 0;
    if (!TakeCount(section_.rest[0], &cells.count) ||
        !TakeCount(section_.rest[1], &numbers)) {
      return std::nullopt;
    }
    if (!has_offsets_) {
      cells.corner_count = numbers;
      if (!Pass(numbers, kVtkInt).has_value()) return std::nullopt;
      return cells;
    }
    cells.corner_count = numbers;
    const uint64_t offsets = cells.count;
    cells.count = offsets == 0 ? 0 : offsets - 1;
    cells.offset_type = EnterPart("OFFSETS");
    if (cells.offset_type == nullptr) return std::nullopt;
    cells.offsets = Pass(offsets, *cells.offset_type);
    if (!cells.offsets.has_value()) return std::nullopt;
    cells.type = EnterPart("CONNECTIVITY");
    if (cells.type == nullptr) return std::nullopt;
    const std::optional<VtkCursor> corners = Pass(numbers, *cells.type);
    if (!corners.has_value()) return std::nullopt;
    cells.corners = *corners;
    return cells;
  }

  // The type of a part of the cells, whose numbers follow.
  const VtkType* EnterPart(std::string_view name) {
    if (!NextSection() || section_.name != name) {
      Refuse("'", std::string(name), "' was expected");
      return nullptr;
    }
    const VtkType* const type = FindType(section_.rest[0]);
    if (type == nullptr || type->is_whole) return type;
    Refuse(std::string(name), ": '", std::string(type->name),
           "' is no type of whole numbers");
    return nullptr;
  }

  bool ReadCells() {
    if (has_cells_) return Refuse("cells come twice");
    has_cells_ = true;
    std::optional<Cells> cells = FindCells();
    if (!cells.has_value()) return false;
    std::optional<VtkCursor> kinds;
    if (is_grid_) {
      if (!NextSection() || section_.name != "CELL_TYPES") {
        return Refuse("'CELL_TYPES' was expected");
      }
      kinds = Pass(cells->count, kVtkInt);
      if (!kinds.has_value()) return false;
    }
    uint64_t begin = 0;
    if (cells->offsets.has_value() && cells->count > 0 &&
        cells->offsets->Integer(*cells->offset_type) != 0) {
      return Refuse("the first of the OFFSETS is not 0");
    }
    for (uint64_t cell = 0; cell < cells->count; ++cell) {
      int64_t corners = 0;
      if (cells->offsets.has_value()) {
        const std::optional<int64_t> count =
            VtkCornersUpTo(cells->offsets->Integer(*cells->offset_type), begin,
                           cells->corner_count);
        if (!count.has_value()) {
          return Refuse("cell ", cell, ": its end in OFFSETS is out of range");
        }
        corners = *count;
      } else {
        const std::optional<int64_t> count =
            cells->corners.Integer(*cells->type);
        if (!count.has_value() || *count < 0 ||
            static_cast<uint64_t>(*count) > cells->corner_count - begin) {
          return Refuse("cell ", cell, ": its count of corners is missing or ",
                        "beyond the section");
        }
        corners = *count;
      }
      begin += corners;
      const std::optional<int64_t> kind =
          kinds.has_value() ? kinds->Integer(kVtkInt) : kPolygonCell;
      if (!kind.has_value()) return Refuse("cell ", cell, " has no type");
      if (!AddCell(*cells, cell, corners, *kind)) return false;
    }
    return true;
  }

  // Takes a cell's corners.
  bool AddCell(Cells& cells, uint64_t cell, int64_t corners, int64_t kind) {
    const bool is_face =
        kind == kTriangleCell || kind == kPolygonCell || kind == kQuadCell;
    if (!is_face && (kind < kVertexCell || kind > kPolyLineCell)) {
      return Refuse("cell ", cell, " has type ", kind,
                    "; triangles (5), polygons (7) and quads (9) are read");
    }
    return AddVtkCell(
        builder_,
        {.number = cell,
         .corners = corners,
         .is_face = is_face,
         .vertices = builder_.vertices()},
        [&] { return cells.corners.Integer(*cells.type); },
        [&](const auto&... parts) { return Refuse(parts...); });
  }

  VtkCursor cursor_;
  SoupBuilder builder_;
  Section section_;
  bool has_offsets_ = false;
  bool is_grid_ = false;
  bool has_cells_ = false;
  // Whether what follows is no part of the mesh.
  bool is_complete_ = false;
};

}  // namespace

absl::StatusOr<TriangleSoup> ReadVtk(std::string_view bytes,
                                     const ReadLimits& limits) {
  return VtkReader(bytes, limits).Read();
}

}  // namespace geodesic
