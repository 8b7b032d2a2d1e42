#include "readers/vtk/vtp_file.h"

#include <algorithm>
#include <array>

#include "absl/strings/str_cat.h"
#include "geodesic/checkpoint.h"
#include "readers/reader_errors.h"
#include "readers/text_scanner.h"
#include "readers/vtk/vtk_numbers.h"

namespace geodesic {
namespace {

constexpr std::array kTypes = {
    VtkTypeOf<float>("Float32"), VtkTypeOf<double>("Float64"),
    VtkTypeOf<int8_t>("Int8"),   VtkTypeOf<uint8_t>("UInt8"),
    VtkTypeOf<int16_t>("Int16"), VtkTypeOf<uint16_t>("UInt16"),
    VtkTypeOf<int32_t>("Int32"), VtkTypeOf<uint32_t>("UInt32"),
    VtkTypeOf<int64_t>("Int64"), VtkTypeOf<uint64_t>("UInt64"),
};

// Markup of this size takes some 50 MB of memory at the worst. A file of one
// piece has some kilobytes.
constexpr size_t kMaxMarkupBytes = size_t{1} << 20;
// Shorter runs of numbers stay in the markup.
constexpr size_t kLongRun = 32;
// Some milliseconds of text.
constexpr size_t kBetweenPolls = size_t{1} << 20;

constexpr std::string_view kAppendedTag = "<AppendedData";

// Whether numbers are written with it, as text or as base64. None of these
// characters ends anything in XML, so that runs of them can be left out.
bool IsOfNumber(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
         (c >= 'A' && c <= 'Z') || c == '+' || c == '-' || c == '.' ||
         c == '/' || c == '=' || IsVtkBlank(c);
}

template <typename... Parts>
absl::Status Invalid(const Parts&... parts) {
  return absl::InvalidArgumentError(absl::StrCat(parts...));
}

absl::Status TooMuchMarkup() {
  return Invalid("the file has more than ", kMaxMarkupBytes,
                 " bytes of XML beside its numbers; save it with fewer pieces "
                 "and arrays");
}

}  // namespace

absl::StatusOr<VtpFile> VtpFile::Open(std::string_view bytes,
                                      Checkpoint* checkpoint) {
  VtpFile file;
  file.bytes_ = bytes;
  // What follows this tag need not be XML.
  const size_t tag = bytes.find(kAppendedTag);
  const size_t tag_end = bytes.find('>', tag);
  const bool has_appended = tag_end != std::string_view::npos;
  const size_t end = has_appended ? tag_end + 1 : bytes.size();
  absl::Status status = file.CollectMarkup(bytes.substr(0, end), checkpoint);
  if (!status.ok()) return status;
  if (has_appended) file.markup_ += "</AppendedData></VTKFile>";
  if (status = file.Parse(); !status.ok()) return status;
  if (status = file.ReadRoot(); !status.ok()) return status;
  if (has_appended) status = file.FindAppended(bytes.substr(end));
  if (!status.ok()) return status;
  return file;
}

bool VtpFile::Keep(std::string_view text) {
  if (text.size() > kMaxMarkupBytes - markup_.size()) return false;
  markup_ += text;
  return true;
}

absl::Status VtpFile::CollectMarkup(std::string_view text,
                                    Checkpoint* checkpoint) {
  size_t at = 0;
  while (at < text.size()) {
    // A tag, and what stands behind it.
    const std::string_view rest = text.substr(at, kMaxMarkupBytes + 1);
    const size_t tag_bytes = std::min(rest.find('>'), rest.size() - 1) + 1;
    if (!Keep(rest.substr(0, tag_bytes))) return TooMuchMarkup();
    at += tag_bytes;
    const size_t begin = at;
    for (; at < text.size() && IsOfNumber(text[at]); ++at) {
      if ((at - begin) % kBetweenPolls != 0 || checkpoint == nullptr) continue;
      if (absl::Status s = checkpoint->Poll({}); !s.ok()) return s;
    }
    const bool is_numbers = at == text.size() || text[at] == '<';
    if (!is_numbers) {
      const std::string_view more = text.substr(at, kMaxMarkupBytes + 1);
      at += std::min(more.find('<'), more.size());
    }
    const size_t markup_begin = markup_.size();
    if (!Keep(is_numbers && at - begin >= kLongRun
                  ? "0"
                  : text.substr(begin, at - begin))) {
      return TooMuchMarkup();
    }
    texts_.push_back({markup_begin, markup_.size(), begin, at});
  }
  return absl::OkStatus();
}

absl::Status VtpFile::Parse() {
  const pugi::xml_parse_result result = document_.load_buffer(
      markup_.data(), markup_.size(), pugi::parse_minimal, pugi::encoding_utf8);
  if (result) return absl::OkStatus();
  // Where that is in the file.
  const size_t at = static_cast<size_t>(result.offset);
  const auto next = std::upper_bound(
      texts_.begin(), texts_.end(), at,
      [](size_t place, const Text& text) { return place < text.markup_end; });
  const size_t place = next == texts_.begin() ? at
                                              : std::prev(next)->end + at -
                                                    std::prev(next)->markup_end;
  return AtByte(std::min(place, bytes_.size()),
                "the XML is damaged or cut off: ", result.description());
}

absl::Status VtpFile::ReadRoot() {
  const pugi::xml_node root = document_.document_element();
  if (root.name() != std::string_view("VTKFile")) {
    return Invalid("the file's first element is not VTKFile");
  }
  const std::string_view type = root.attribute("type").value();
  if (type.starts_with("P") && type != "PolyData") {
    return Invalid("the file is a ", Printable(type),
                   ", which names other files: save the surface as one .vtp");
  }
  if (type != "PolyData") {
    return Invalid("the file holds a ", Printable(type),
                   ", which is no surface: extract its surface first (Extract "
                   "Surface in ParaView, extract_surface() in PyVista) and "
                   "save that as .vtp");
  }
  const std::string_view order = root.attribute("byte_order").value();
  if (order == "BigEndian") {
    style_.order = std::endian::big;
  } else if (!order.empty() && order != "LittleEndian") {
    return Invalid("byte_order '", Printable(order),
                   "' is neither LittleEndian nor BigEndian");
  }
  const std::string_view header = root.attribute("header_type").value();
  style_.has_long_headers = header == "UInt64";
  if (!style_.has_long_headers && !header.empty() && header != "UInt32") {
    return Invalid("header_type '", Printable(header),
                   "' is neither UInt32 nor UInt64");
  }
  const std::string_view compressor = root.attribute("compressor").value();
  style_.is_compressed = compressor == "vtkZLibDataCompressor";
  if (!style_.is_compressed && !compressor.empty()) {
    return Invalid("the arrays are compressed by ", Printable(compressor),
                   ", which is not read: save the file with zlib or without "
                   "compression");
  }
  if (!surface()) return Invalid("the file has no element PolyData");
  return absl::OkStatus();
}

absl::Status VtpFile::FindAppended(std::string_view rest) {
  const std::string_view encoding = document_.document_element()
                                        .child("AppendedData")
                                        .attribute("encoding")
                                        .value();
  is_appended_base64_ = encoding == "base64";
  if (!is_appended_base64_ && encoding != "raw") {
    return Invalid("AppendedData: encoding '", Printable(encoding),
                   "' is neither raw nor base64");
  }
  const size_t mark = std::min(rest.find_first_not_of(" \t\r\n"), rest.size());
  if (!rest.substr(mark).starts_with('_')) {
    return AtByte(bytes_.size() - rest.size() + mark,
                  "AppendedData does not begin with '_'");
  }
  rest.remove_prefix(mark + 1);
  appended_ = rest.substr(
      0, is_appended_base64_ ? rest.find('<') : rest.rfind("</AppendedData"));
  return absl::OkStatus();
}

std::string_view VtpFile::TextOf(pugi::xml_node element) const {
  const ptrdiff_t place = element.first_child().offset_debug();
  const auto text = std::lower_bound(
      texts_.begin(), texts_.end(), place,
      [](const Text& earlier, ptrdiff_t sought) {
        return static_cast<ptrdiff_t>(earlier.markup_begin) < sought;
      });
  if (text == texts_.end() ||
      static_cast<ptrdiff_t>(text->markup_begin) != place) {
    return {};
  }
  return bytes_.substr(text->begin, text->end - text->begin);
}

absl::StatusOr<VtpNumbers> VtpFile::Numbers(pugi::xml_node array) const {
  const std::string_view type_name = array.attribute("type").value();
  const VtkType* const type = VtkTypeNamed(kTypes, type_name);
  if (type == nullptr) {
    return Invalid("'", Printable(type_name), "' is no known type");
  }
  const std::string_view format = array.attribute("format").value();
  if (format == "ascii") return VtpNumbers::OfText(TextOf(array), *type);
  if (format == "binary") {
    return VtpNumbers::OfBytes(VtpBytes(TextOf(array), /*is_base64=*/true),
                               style_, *type);
  }
  if (format != "appended") {
    return Invalid("format '", Printable(format),
                   "' is neither ascii, binary nor appended");
  }
  if (!appended_.has_value()) {
    return Invalid("its numbers are appended, but there is no AppendedData");
  }
  const std::string_view offset_name = array.attribute("offset").value();
  const std::optional<int64_t> offset = ParseInteger(offset_name);
  if (!offset.has_value() || *offset < 0 ||
      static_cast<uint64_t>(*offset) > appended_->size()) {
    return Invalid("offset '", Printable(offset_name), "' is not within the ",
                   appended_->size(), " bytes of AppendedData");
  }
  return VtpNumbers::OfBytes(
      VtpBytes(appended_->substr(*offset), is_appended_base64_), style_, *type);
}

}  // namespace geodesic
