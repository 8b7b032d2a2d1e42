#include "client/output/extended_ply.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "client/output/approximation_mark.h"
#include "client/output/number_text.h"

namespace geodesic::client {
namespace {

enum class Encoding { kAscii, kLittleEndian, kBigEndian };

struct Property {
  size_t bytes = 0;        // of a list: of each item
  size_t count_bytes = 0;  // lists only: of their length
  bool stays = true;
};

struct Element {
  bool is_vertex = false;
  uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::kAscii;
  std::vector<Element> elements;  // up to the vertices
  std::string extended;           // with the lines for the columns

  const Element& vertices() const { return elements.back(); }
};

struct Type {
  std::string_view name, sized_name;
  size_t bytes;
};
constexpr std::array<Type, 8> kTypes = {{{"char", "int8", 1},
                                         {"uchar", "uint8", 1},
                                         {"short", "int16", 2},
                                         {"ushort", "uint16", 2},
                                         {"int", "int32", 4},
                                         {"uint", "uint32", 4},
                                         {"float", "float32", 4},
                                         {"double", "float64", 8}}};

// 0 for an unknown type.
size_t BytesOf(std::string_view name) {
  for (const Type& type : kTypes) {
    if (name == type.name || name == type.sized_name) return type.bytes;
  }
  return 0;
}

// Takes a line, with what ends it, off the front.
std::string_view TakeLine(std::string_view& text) {
  const size_t size = std::min(text.find('\n'), text.size() - 1) + 1;
  const std::string_view line = text.substr(0, size);
  text.remove_prefix(size);
  return line;
}

std::vector<std::string_view> WordsOf(std::string_view line) {
  constexpr char kBlanks[] = " \t\r\n";
  std::vector<std::string_view> words;
  for (size_t first = 0;
       (first = line.find_first_not_of(kBlanks, first)) != line.npos;) {
    const size_t end =
        std::min(line.find_first_of(kBlanks, first), line.size());
    words.push_back(line.substr(first, end - first));
    first = end;
  }
  return words;
}

// Reads a header and writes the one of the extended file, a line at a time.
class HeaderReader {
 public:
  HeaderReader(std::span<const Column> columns, const std::string& mark)
      : columns_(columns), mark_(mark) {}

  // Takes the header off the front of `ply`.
  std::optional<Header> Read(std::string_view& ply) {
    bool is_first = true, has_ended = false;
    while (!ply.empty() && !has_ended) {
      const std::string_view line = TakeLine(ply);
      const std::vector<std::string_view> words = WordsOf(line);
      if (is_first && (words.size() != 1 || words[0] != "ply")) return {};
      is_first = false;
      has_ended = words.size() == 1 && words[0] == "end_header";
      end_of_line_ = line.ends_with("\r\n") ? "\r\n" : "\n";
      if (!Take(words, has_ended)) return {};
      lines_.emplace_back(line);
      if (is_replaced_) lines_.pop_back();
      if (words.size() == 3 && words[0] == "format") mark_at_ = lines_.size();
    }
    if (!has_ended || !has_passed_vertices_ || mark_at_ == 0) return {};
    WriteLines();
    return std::move(header_);
  }

 private:
  // Whether the reader is among the vertices' properties.
  bool IsAtVertices() const {
    return !has_passed_vertices_ && !header_.elements.empty() &&
           header_.vertices().is_vertex;
  }

  bool Take(const std::vector<std::string_view>& words, bool is_end) {
    const std::string_view first = words.empty() ? "" : words[0];
    is_replaced_ = false;
    if (first == "format") return TakeFormat(words);
    if (IsAtVertices() && (first == "element" || is_end)) {
      AddColumns();
      has_passed_vertices_ = true;
    }
    if (has_passed_vertices_) return true;
    if (first == "element") return TakeElement(words);
    return first != "property" || TakeProperty(words);
  }

  bool TakeFormat(const std::vector<std::string_view>& words) {
    const std::string_view name = words.size() == 3 ? words[1] : "";
    header_.encoding = name == "ascii" ? Encoding::kAscii
                       : name == "binary_little_endian"
                           ? Encoding::kLittleEndian
                           : Encoding::kBigEndian;
    return header_.encoding != Encoding::kBigEndian ||
           name == "binary_big_endian";
  }

  bool TakeElement(const std::vector<std::string_view>& words) {
    Element element;
    if (words.size() != 3 || !ParseNumber(words[2], &element.count)) {
      return false;
    }
    element.is_vertex = words[1] == "vertex";
    header_.elements.push_back(std::move(element));
    return true;
  }

  bool TakeProperty(const std::vector<std::string_view>& words) {
    if (header_.elements.empty() || words.size() < 3) return false;
    const bool is_list = words[1] == "list";
    if (words.size() != (is_list ? 5 : 3)) return false;
    const Property property = {
        .bytes = BytesOf(words[is_list ? 3 : 1]),
        .count_bytes = is_list ? BytesOf(words[2]) : 0,
        .stays = !IsAtVertices() || !IsNameOfColumn(words.back())};
    if (property.bytes == 0 || (is_list && property.count_bytes == 0)) {
      return false;
    }
    is_replaced_ = !property.stays;
    has_replaced_ |= is_replaced_;
    header_.elements.back().properties.push_back(property);
    return true;
  }

  bool IsNameOfColumn(std::string_view name) const {
    return std::ranges::any_of(columns_, [name](const Column& column) {
      return std::ranges::count(column.names(), name) > 0;
    });
  }

  void AddColumns() {
    for (const Column& column : columns_) {
      for (const std::string& name : column.names()) {
        lines_.push_back("property " + std::string(column.stored_name()) + " " +
                         name + std::string(end_of_line_));
      }
    }
  }

  // Whether it says what the values of an earlier result are, which gave way.
  bool IsOfEarlierResult(std::string_view line) const {
    while (line.ends_with('\n') || line.ends_with('\r')) line.remove_suffix(1);
    if (line == kUnitComment) return true;
    constexpr std::string_view kComment = "comment ";
    if (!line.starts_with(kComment)) return false;
    line.remove_prefix(kComment.size());
    return line == mark_ || (has_replaced_ && IsMark(std::string(line)));
  }

  void WriteLines() {
    for (size_t i = 0; i < lines_.size(); ++i) {
      if (i == mark_at_) {
        AddLine(kUnitComment);
        if (!mark_.empty()) AddLine("comment " + mark_);
      }
      if (!IsOfEarlierResult(lines_[i])) header_.extended += lines_[i];
    }
  }

  void AddLine(std::string_view line) {
    header_.extended.append(line).append(end_of_line_);
  }

  std::span<const Column> columns_;
  const std::string& mark_;
  Header header_;
  std::vector<std::string> lines_;  // of the extended file
  size_t mark_at_ = 0;              // the line behind the format
  std::string_view end_of_line_;
  bool has_passed_vertices_ = false;
  bool is_replaced_ = false;   // the line that is read
  bool has_replaced_ = false;  // any
};

std::span<const double> ValuesOf(const Column& column, size_t vertex) {
  return {&column.values[vertex * column.components], column.components};
}

// Takes an element's rows off the front of `body` and appends them, those of
// the vertices with the columns. Returns false if they are not all there.
class TextRows {
 public:
  TextRows(std::string_view& body, std::span<const Column> columns,
           std::string* extended)
      : body_(body), columns_(columns), extended_(extended) {}

  bool Extend(const Element& element) {
    for (uint64_t row = 0; row < element.count; ++row) {
      std::vector<std::string_view> words;
      std::string_view line;
      while (words.empty()) {
        if (body_.empty()) return false;
        line = TakeLine(body_);
        words = WordsOf(line);
      }
      if (!element.is_vertex) {
        extended_->append(line);
      } else if (!ExtendRow(element, words, line, row)) {
        return false;
      }
    }
    return true;
  }

 private:
  bool ExtendRow(const Element& element,
                 std::span<const std::string_view> words, std::string_view line,
                 uint64_t row) {
    std::string_view blank;
    const auto add = [&](std::string_view word) {
      extended_->append(blank).append(word);
      blank = " ";
    };
    for (const Property& property : element.properties) {
      if (words.empty()) return false;
      uint64_t count = 0;
      if (property.count_bytes != 0 && !ParseNumber(words[0], &count)) {
        return false;
      }
      const uint64_t taken = property.count_bytes == 0 ? 1 : 1 + count;
      if (taken > words.size() || taken == 0) return false;
      if (property.stays) std::ranges::for_each(words.first(taken), add);
      words = words.subspan(taken);
    }
    if (!words.empty()) return false;
    for (const Column& column : columns_) {
      for (const double value : ValuesOf(column, row)) {
        add(TextOf(value, column.type));
      }
    }
    extended_->append(line.ends_with("\r\n") ? "\r\n" : "\n");
    return true;
  }

  std::string_view& body_;
  std::span<const Column> columns_;
  std::string* extended_;
};

// The same for binary files.
class BinaryRows {
 public:
  BinaryRows(std::string_view& body, std::span<const Column> columns,
             std::endian order, std::string* extended)
      : body_(body), columns_(columns), order_(order), extended_(extended) {}

  bool Extend(const Element& element) {
    for (uint64_t row = 0; row < element.count; ++row) {
      for (const Property& property : element.properties) {
        if (!Copy(property)) return false;
      }
      // Without properties rows take no bytes, however many there are.
      if (element.properties.empty()) break;
      if (!element.is_vertex) continue;
      for (const Column& column : columns_) {
        AppendNumbers(ValuesOf(column, row), column.stored_type(), extended_,
                      order_);
      }
    }
    return true;
  }

 private:
  bool Copy(const Property& property) {
    uint64_t bytes = property.bytes;
    if (property.count_bytes != 0) {
      if (body_.size() < property.count_bytes) return false;
      bytes = property.count_bytes +
              property.bytes * NumberOf(body_.substr(0, property.count_bytes));
    }
    if (bytes > body_.size()) return false;
    if (property.stays) extended_->append(body_.substr(0, bytes));
    body_.remove_prefix(bytes);
    return true;
  }

  // Lengths are of integer types, and not negative: below 2^32.
  uint64_t NumberOf(std::string_view bytes) const {
    uint64_t number = 0;
    for (size_t i = 0; i < std::min<size_t>(bytes.size(), 4); ++i) {
      const size_t at = order_ == std::endian::big ? i : bytes.size() - 1 - i;
      number = number << 8 | static_cast<unsigned char>(bytes[at]);
    }
    return number;
  }

  std::string_view& body_;
  std::span<const Column> columns_;
  std::endian order_;
  std::string* extended_;
};

}  // namespace

std::optional<std::string> ExtendedPly(std::string_view ply,
                                       std::span<const Column> columns,
                                       const std::string& mark) {
  std::optional<Header> header = HeaderReader(columns, mark).Read(ply);
  if (!header.has_value() ||
      std::ranges::any_of(columns, [&header](const Column& column) {
        return column.count() != header->vertices().count;
      })) {
    return std::nullopt;
  }
  std::string extended = std::move(header->extended);
  const auto extend_all = [&](auto rows) {
    return std::ranges::all_of(
        header->elements,
        [&rows](const Element& element) { return rows.Extend(element); });
  };
  const std::endian order = header->encoding == Encoding::kBigEndian
                                ? std::endian::big
                                : std::endian::little;
  const bool is_extended =
      header->encoding == Encoding::kAscii
          ? extend_all(TextRows(ply, columns, &extended))
          : extend_all(BinaryRows(ply, columns, order, &extended));
  if (!is_extended) return std::nullopt;
  extended.append(ply);
  return extended;
}

std::optional<std::string> ExtendedPlyFile(const std::string& path,
                                           std::span<const Column> columns,
                                           const std::string& mark) {
  struct Close {
    void operator()(gzFile file) const { gzclose(file); }
  };
  // It reads what is not compressed as it is.
  const std::unique_ptr<gzFile_s, Close> file(gzopen(path.c_str(), "rb"));
  if (file == nullptr) return std::nullopt;
  std::string ply;
  std::vector<char> piece(size_t{1} << 20);
  int count = 0;
  while ((count = gzread(file.get(), piece.data(),
                         static_cast<unsigned>(piece.size()))) > 0) {
    ply.append(piece.data(), static_cast<size_t>(count));
  }
  if (count < 0) return std::nullopt;
  return ExtendedPly(ply, columns, mark);
}

}  // namespace geodesic::client
