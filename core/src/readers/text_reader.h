// What the readers of text formats share.

#ifndef GEODESIC_READERS_TEXT_READER_H_
#define GEODESIC_READERS_TEXT_READER_H_

#include <cstdint>
#include <optional>
#include <string_view>

#include "geodesic/read_mesh.h"
#include "readers/reader_errors.h"
#include "readers/soup_builder.h"
#include "readers/text_scanner.h"

namespace geodesic {

// The methods of its readers return whether to go on, as SoupBuilder's do.
class TextReader {
 public:
  TextReader(std::string_view bytes, const ReadLimits& limits)
      : scanner_(bytes), builder_(limits) {}

 protected:
  // Moves to the next line; false at the end of the file.
  bool NextLine() {
    const bool is_there = scanner_.Next();
    line_ = scanner_.line_number();
    rest_ = scanner_.line();
    return is_there;
  }

  // Refuses the file for what is wrong with the line at hand.
  template <typename... Parts>
  bool Refuse(const Parts&... parts) {
    return builder_.Refuse(AtLine(line_, parts...));
  }

  // Reads a finite coordinate of `element`.
  template <typename... Parts>
  bool ReadCoordinate(std::string_view token, double& coordinate,
                      const Parts&... element) {
    const std::optional<double> value = ParseFinite(token);
    if (!value.has_value()) {
      return Refuse(element..., ": '", Printable(token),
                    "' is not a finite number");
    }
    coordinate = *value;
    return true;
  }

  // Adds the vertex that the line at hand begins with.
  bool ReadVertex() {
    Point point;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view token = TakeToken(rest_);
      if (token.empty()) {
        return Refuse("vertex ", builder_.vertices(), " has ", axis,
                      " coordinates; 3 are needed");
      }
      if (!ReadCoordinate(token, point[axis], "vertex ", builder_.vertices())) {
        return false;
      }
    }
    return builder_.AddVertex(point);
  }

  LineScanner scanner_;
  SoupBuilder builder_;
  uint64_t line_ = 0;      // that messages name
  std::string_view rest_;  // of the line, still to be read
};

}  // namespace geodesic

#endif  // GEODESIC_READERS_TEXT_READER_H_
