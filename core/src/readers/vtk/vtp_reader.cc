// VTK's XML format of surfaces (".vtp"): the polygons of all pieces, one behind
// another.
//
// Vertices, lines and data go unread.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "readers/reader_errors.h"
#include "readers/readers.h"
#include "readers/soup_builder.h"
#include "readers/text_scanner.h"
#include "readers/vtk/vtk_cells.h"
#include "readers/vtk/vtp_file.h"

namespace geodesic {
namespace {

// Its methods return whether to go on, as SoupBuilder's do.
class VtpReader {
 public:
  VtpReader(const VtpFile& file, uint64_t file_bytes, const ReadLimits& limits)
      : file_(file), file_bytes_(file_bytes), builder_(limits) {}

  absl::StatusOr<TriangleSoup> Read() {
    bool goes_on = true;
    for (const pugi::xml_node piece : file_.surface().children("Piece")) {
      goes_on = ReadPiece(piece);
      if (!goes_on) break;
      ++piece_;
    }
    if (goes_on && piece_ == 0) {
      builder_.Refuse(
          absl::InvalidArgumentError("the file holds no element Piece"));
    }
    if (goes_on && has_lines_ && !has_polygons_) {
      builder_.Refuse(absl::InvalidArgumentError(
          "the file holds lines and no polygons: save a surface"));
    }
    return std::move(builder_).Take();
  }

 private:
  template <typename... Parts>
  bool Refuse(const Parts&... parts) {
    return builder_.Refuse(absl::InvalidArgumentError(
        absl::StrCat("piece ", piece_, ": ", parts...)));
  }

  bool ReadPiece(pugi::xml_node piece) {
    uint64_t points = 0;
    uint64_t polygons = 0;
    uint64_t lines = 0;
    uint64_t strips = 0;
    if (!TakeCount(piece, "NumberOfPoints", &points) ||
        !TakeCount(piece, "NumberOfPolys", &polygons) ||
        !TakeCount(piece, "NumberOfLines", &lines) ||
        !TakeCount(piece, "NumberOfStrips", &strips)) {
      return false;
    }
    if (strips > 0) return Refuse(kVtkStripsAreNotRead);
    has_polygons_ |= polygons > 0;
    has_lines_ |= lines > 0;
    const uint64_t first_vertex = builder_.vertices();
    return (points == 0 || ReadPoints(piece, points)) &&
           (polygons == 0 || ReadPolygons(piece, polygons, first_vertex));
  }

  // What is not named is not there.
  bool TakeCount(pugi::xml_node piece, const char* name, uint64_t* count) {
    const pugi::xml_attribute attribute = piece.attribute(name);
    if (!attribute) return true;
    const std::optional<int64_t> number = ParseInteger(attribute.value());
    if (!number.has_value() || *number < 0) {
      return Refuse(name, " '", Printable(attribute.value()), "' is no count");
    }
    *count = static_cast<uint64_t>(*number);
    return true;
  }

  // The numbers of an array, which messages call `name`.
  std::optional<VtpNumbers> Find(pugi::xml_node array, const char* name) {
    if (!array) {
      Refuse("the array ", name, " is missing");
      return std::nullopt;
    }
    absl::StatusOr<VtpNumbers> numbers = file_.Numbers(array);
    if (numbers.ok()) return *std::move(numbers);
    builder_.Refuse(
        absl::Status(numbers.status().code(),
                     absl::StrCat("piece ", piece_, ": ", name, ": ",
                                  numbers.status().message())));
    return std::nullopt;
  }

  std::optional<VtpNumbers> FindPart(pugi::xml_node piece, const char* name) {
    const pugi::xml_node array =
        piece.child("Polys").find_child_by_attribute("DataArray", "Name", name);
    std::optional<VtpNumbers> numbers = Find(array, name);
    if (!numbers.has_value() || numbers->is_whole()) return numbers;
    Refuse(name, ": '", Printable(array.attribute("type").value()),
           "' is no type of whole numbers");
    return std::nullopt;
  }

  bool ReadPoints(pugi::xml_node piece, uint64_t count) {
    const pugi::xml_node array = piece.child("Points").child("DataArray");
    std::optional<VtpNumbers> numbers = Find(array, "Points");
    if (!numbers.has_value()) return false;
    const std::string_view components =
        array.attribute("NumberOfComponents").value();
    if (components != "3") {
      return Refuse("Points have '", Printable(components),
                    "' components; 3 are needed");
    }
    if (count > numbers->MostNumbers() / 3) {
      return Refuse(count, " points do not fit the array Points");
    }
    if (piece_ == 0 && !numbers->is_compressed() &&
        !builder_.ReserveVertices(count)) {
      return false;
    }
    for (uint64_t vertex = 0; vertex < count; ++vertex) {
      Point point;
      for (double& coordinate : point) {
        const std::optional<double> value = numbers->Real();
        if (!value.has_value()) {
          return Refuse("point ", vertex, ": a coordinate is missing, damaged ",
                        "or not a finite number");
        }
        coordinate = *value;
      }
      if (!builder_.AddVertex(point)) return false;
    }
    return Account(*numbers);
  }

  bool ReadPolygons(pugi::xml_node piece, uint64_t count,
                    uint64_t first_vertex) {
    std::optional<VtpNumbers> ends = FindPart(piece, "offsets");
    if (!ends.has_value()) return false;
    std::optional<VtpNumbers> corners = FindPart(piece, "connectivity");
    if (!corners.has_value()) return false;
    if (count > ends->MostNumbers()) {
      return Refuse(count, " polygons do not fit the array offsets");
    }
    const uint64_t all_corners = corners->MostNumbers();
    const uint64_t vertices = builder_.vertices() - first_vertex;
    uint64_t begin = 0;
    for (uint64_t cell = 0; cell < count; ++cell) {
      const std::optional<int64_t> own =
          VtkCornersUpTo(ends->Integer(), begin, all_corners);
      if (!own.has_value()) {
        return Refuse("cell ", cell, ": its end in offsets is out of range");
      }
      begin += *own;
      if (!AddVtkCell(
              builder_,
              {.number = cell,
               .corners = *own,
               .vertices = vertices,
               .first_vertex = first_vertex},
              [&] { return corners->Integer(); },
              [&](const auto&... parts) { return Refuse(parts...); })) {
        return false;
      }
    }
    return Account(*ends) && Account(*corners);
  }

  // Keeps a file from growing by arrays that several pieces name.
  bool Account(const VtpNumbers& numbers) {
    taken_ += numbers.taken();
    return taken_ <= file_bytes_ ||
           Refuse("its arrays are also those of other pieces");
  }

  const VtpFile& file_;
  const uint64_t file_bytes_;
  SoupBuilder builder_;
  uint64_t piece_ = 0;
  uint64_t taken_ = 0;  // bytes of the file, so far
  bool has_polygons_ = false;
  bool has_lines_ = false;
};

}  // namespace

absl::StatusOr<TriangleSoup> ReadVtp(std::string_view bytes,
                                     const ReadLimits& limits) {
  const absl::StatusOr<VtpFile> file = VtpFile::Open(bytes, limits.checkpoint);
  if (!file.ok()) return file.status();
  return VtpReader(*file, bytes.size(), limits).Read();
}

}  // namespace geodesic
