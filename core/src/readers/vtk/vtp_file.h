// A file of VTK's XML format: its markup, and the arrays that it names.

#ifndef GEODESIC_READERS_VTK_VTP_FILE_H_
#define GEODESIC_READERS_VTK_VTP_FILE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "readers/vtk/vtp_numbers.h"

namespace geodesic {

class Checkpoint;

// The bytes may be hostile: the markup is limited, and numbers are no part of
// it, so memory does not grow with them. Refers to the bytes that it was opened
// with.
class VtpFile {
 public:
  // `checkpoint` is polled now and then, unless it is null.
  // Errors: INVALID_ARGUMENT naming what is wrong, or what is not read here and
  // what to do instead; what `checkpoint` returns.
  static absl::StatusOr<VtpFile> Open(std::string_view bytes,
                                      Checkpoint* checkpoint);

  // The element PolyData.
  pugi::xml_node surface() const {
    return document_.document_element().child("PolyData");
  }

  // The numbers of an element DataArray. Errors: INVALID_ARGUMENT.
  absl::StatusOr<VtpNumbers> Numbers(pugi::xml_node array) const;

 private:
  // What stands between two tags.
  struct Text {
    size_t markup_begin;
    size_t markup_end;
    size_t begin;
    size_t end;
  };

  // Copies the markup of `text`, and 0 for long runs of numbers.
  absl::Status CollectMarkup(std::string_view text, Checkpoint* checkpoint);
  // Adds to the markup; false if it becomes too much.
  bool Keep(std::string_view text);
  absl::Status Parse();
  absl::Status ReadRoot();
  absl::Status FindAppended(std::string_view rest);
  // What stands in an element.
  std::string_view TextOf(pugi::xml_node element) const;

  std::string_view bytes_;
  std::string markup_;
  std::vector<Text> texts_;
  pugi::xml_document document_;
  VtpStyle style_;
  // What arrays elsewhere in the file refer to.
  std::optional<std::string_view> appended_;
  bool is_appended_base64_ = false;
};

}  // namespace geodesic

#endif  // GEODESIC_READERS_VTK_VTP_FILE_H_
