// Writes .vtp files as VTK does, in every way that it knows.

#ifndef GEODESIC_TESTS_CORE_READERS_VTP_WRITER_H_
#define GEODESIC_TESTS_CORE_READERS_VTP_WRITER_H_

#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "geodesic/triangle_soup.h"
#include "tests/core/readers/byte_writer.h"

namespace geodesic::test {

enum class VtpFormat { kAscii, kBinary, kAppendedRaw, kAppendedBase64 };

struct VtpOptions {
  VtpFormat format = VtpFormat::kAscii;
  std::endian order = std::endian::little;
  bool has_long_headers = false;
  bool is_compressed = false;
  size_t block_bytes = 32;
};

// Every way that the header of a file can name.
inline std::vector<VtpOptions> AllVtpOptions() {
  std::vector<VtpOptions> all;
  for (const VtpFormat format :
       {VtpFormat::kAscii, VtpFormat::kBinary, VtpFormat::kAppendedRaw,
        VtpFormat::kAppendedBase64}) {
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      for (const bool has_long_headers : {false, true}) {
        for (const bool is_compressed : {false, true}) {
          all.push_back({format, order, has_long_headers, is_compressed});
        }
      }
    }
  }
  return all;
}

inline std::string NameOf(const VtpOptions& options) {
  constexpr std::array kFormats = {"Ascii", "Binary", "Raw", "Base64"};
  return absl::StrCat(kFormats.at(static_cast<size_t>(options.format)),
                      options.order == std::endian::big ? "Big" : "Little",
                      options.has_long_headers ? "Long" : "Short",
                      options.is_compressed ? "Zlib" : "Plain");
}

struct VtpPiece {
  std::vector<Point> points;
  std::vector<std::vector<int64_t>> polygons;
};

class VtpWriter {
 public:
  explicit VtpWriter(const VtpOptions& options) : options_(options) {}

  std::string Write(const std::vector<VtpPiece>& pieces) {
    std::string xml = absl::StrCat(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
        "byte_order=\"",
        options_.order == std::endian::little ? "LittleEndian" : "BigEndian",
        "\" header_type=\"", options_.has_long_headers ? "UInt64" : "UInt32",
        "\"",
        options_.is_compressed ? " compressor=\"vtkZLibDataCompressor\"" : "",
        ">\n<PolyData>\n");
    for (const VtpPiece& piece : pieces) absl::StrAppend(&xml, Piece(piece));
    absl::StrAppend(&xml, "</PolyData>\n");
    if (options_.format == VtpFormat::kAppendedRaw ||
        options_.format == VtpFormat::kAppendedBase64) {
      absl::StrAppend(
          &xml, "<AppendedData encoding=\"",
          options_.format == VtpFormat::kAppendedRaw ? "raw" : "base64",
          "\">\n_", appended_, "\n</AppendedData>\n");
    }
    return xml + "</VTKFile>\n";
  }

  // What stands in the file for these numbers of type T.
  template <typename T>
  std::string Encoded(const std::vector<T>& numbers) const {
    ByteWriter data(options_.order);
    for (const T number : numbers) data.Put<T>(number);
    if (!options_.is_compressed) {
      return Text(Header({data.bytes().size()}) + data.bytes());
    }
    const std::string& bytes = data.bytes();
    std::vector<uint64_t> header = {
        (bytes.size() + options_.block_bytes - 1) / options_.block_bytes,
        options_.block_bytes, bytes.size() % options_.block_bytes};
    std::string blocks;
    for (size_t at = 0; at < bytes.size(); at += options_.block_bytes) {
      const std::string block =
          Compressed(bytes.substr(at, options_.block_bytes));
      header.push_back(block.size());
      blocks += block;
    }
    // Each is written as base64 by itself.
    return Text(Header(header)) + Text(blocks);
  }

 private:
  static std::string Compressed(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string out(size, '\0');
    EXPECT_EQ(
        compress(reinterpret_cast<Bytef*>(out.data()), &size,
                 reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
        Z_OK);
    out.resize(size);
    return out;
  }

  std::string Header(const std::vector<uint64_t>& numbers) const {
    ByteWriter header(options_.order);
    for (const uint64_t number : numbers) {
      if (options_.has_long_headers) {
        header.Put<uint64_t>(number);
      } else {
        header.Put<uint32_t>(number);
      }
    }
    return header.bytes();
  }

  std::string Text(const std::string& bytes) const {
    return options_.format == VtpFormat::kAppendedRaw
               ? bytes
               : absl::Base64Escape(bytes);
  }

  template <typename T>
  std::string Array(std::string_view attributes,
                    const std::vector<T>& numbers) {
    std::string xml = absl::StrCat("<DataArray ", std::string(attributes));
    switch (options_.format) {
      case VtpFormat::kAscii:
        absl::StrAppend(&xml, " format=\"ascii\">\n");
        for (const T number : numbers) absl::StrAppend(&xml, number, " ");
        break;
      case VtpFormat::kBinary:
        absl::StrAppend(&xml, " format=\"binary\">\n  ", Encoded(numbers));
        break;
      default:
        absl::StrAppend(&xml, " format=\"appended\" offset=\"",
                        appended_.size(), "\"/>\n");
        appended_ += Encoded(numbers);
        return xml;
    }
    return xml + "\n</DataArray>\n";
  }

  std::string Piece(const VtpPiece& piece) {
    std::vector<double> coordinates;
    for (const Point& point : piece.points) {
      coordinates.insert(coordinates.end(), point.begin(), point.end());
    }
    std::vector<int64_t> corners;
    std::vector<int32_t> ends;
    for (const std::vector<int64_t>& polygon : piece.polygons) {
      corners.insert(corners.end(), polygon.begin(), polygon.end());
      ends.push_back(static_cast<int32_t>(corners.size()));
    }
    std::string xml = absl::StrCat(
        "<Piece NumberOfPoints=\"", piece.points.size(),
        "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"",
        piece.polygons.size(), "\">\n<Points>\n");
    xml += Array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"",
                 coordinates);
    xml += "</Points>\n<Polys>\n";
    xml += Array("type=\"Int64\" Name=\"connectivity\"", corners);
    xml += Array("type=\"Int32\" Name=\"offsets\"", ends);
    return xml + "</Polys>\n</Piece>\n";
  }

  const VtpOptions options_;
  std::string appended_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_CORE_READERS_VTP_WRITER_H_
