// What VTK's formats have in common about cells.

#ifndef GEODESIC_READERS_VTK_VTK_CELLS_H_
#define GEODESIC_READERS_VTK_VTK_CELLS_H_

#include <cstdint>
#include <optional>

#include "readers/reader_errors.h"
#include "readers/soup_builder.h"

namespace geodesic {

inline constexpr char kVtkStripsAreNotRead[] =
    "triangle strips are not supported: save plain triangles";

// How many corners a cell has that ends with corner `end` of `all`, where the
// cells before it have `begin`; none if `end` is missing or out of range.
inline std::optional<int64_t> VtkCornersUpTo(std::optional<int64_t> end,
                                             uint64_t begin, uint64_t all) {
  if (!end.has_value() || *end < static_cast<int64_t>(begin) ||
      static_cast<uint64_t>(*end) > all) {
    return std::nullopt;
  }
  return *end - static_cast<int64_t>(begin);
}

struct VtkCell {
  uint64_t number = 0;
  int64_t corners = 0;
  // Whether it is a polygon; others are read, and left out.
  bool is_face = true;
  // What it may name: that many vertices, of which the builder calls the first
  // `first_vertex`.
  uint64_t vertices = 0;
  uint64_t first_vertex = 0;
};

// Takes the corners of a cell, each a std::optional<int64_t> of `next_corner`.
// Whether to go on: `refuse` is given the parts of a message, and returns
// false.
template <typename NextCorner, typename Refuse>
bool AddVtkCell(SoupBuilder& builder, const VtkCell& cell,
                NextCorner next_corner, Refuse refuse) {
  if (cell.is_face && cell.corners < 3) {
    return refuse("cell ", cell.number, TooFewCorners(cell.corners));
  }
  builder.BeginFace();
  for (int64_t corner = 0; corner < cell.corners; ++corner) {
    const std::optional<int64_t> vertex = next_corner();
    if (!vertex.has_value()) {
      return refuse("cell ", cell.number, ": corner ", corner, " is no number");
    }
    if (*vertex < 0 || static_cast<uint64_t>(*vertex) >= cell.vertices) {
      return refuse("cell ", cell.number,
                    NamesNoVertex(*vertex, cell.vertices));
    }
    if (cell.is_face && !builder.AddCorner(static_cast<uint32_t>(
                            cell.first_vertex + *vertex))) {
      return false;
    }
  }
  return true;
}

}  // namespace geodesic

#endif  // GEODESIC_READERS_VTK_VTK_CELLS_H_
