#include "readers/content_sniffer.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "readers/text_scanner.h"

namespace geodesic {
namespace {

struct Signature {
  std::string_view prefix;
  absl::string_view name;
  absl::string_view advice;
};

constexpr absl::string_view kDecompress = "decompress first";
constexpr absl::string_view kUtf8 = "save it as UTF-8 first";
constexpr absl::string_view kConvert = "convert it to PLY, OFF, OBJ or STL";
constexpr absl::string_view kDownload =
    "the download was perhaps an error page";

constexpr std::array<Signature, 15> kSignatures = {{
    {"\x1f\x8b", "gzip", kDecompress},
    {"PK\x03\x04", "zip", kDecompress},
    {"BZh", "bzip2", kDecompress},
    {"\xfd\x37zXZ", "xz", kDecompress},
    {"\x28\xb5\x2f\xfd", "zstd", kDecompress},
    {"7z\xbc\xaf", "7-Zip", kDecompress},
    {"\xfe\xff", "UTF-16 text", kUtf8},
    {"\xff\xfe", "UTF-16 text", kUtf8},
    {"glTF", "glTF", kConvert},
    {"# vtk DataFile", "VTK", kConvert},
    {"\x89PNG", "a PNG picture", "name a mesh file"},
    {"<!DOCTYPE", "HTML", kDownload},
    {"<html", "HTML", kDownload},
    {"<?xml", "XML", kConvert},
    {"version https://git-lfs", "a Git LFS pointer",
     "fetch the file that it stands for"},
}};

// The mesh format that the first word of a text gives away.
std::optional<MeshFormat> GuessFormat(std::string_view bytes) {
  LineScanner scanner(bytes);
  std::string_view word;
  while (word.empty() || word.starts_with('#')) {
    if (!scanner.NextNonBlank()) return std::nullopt;
    std::string_view line = scanner.line();
    word = TakeToken(line);
  }
  if (word == "ply" && scanner.line_number() == 1) return MeshFormat::kPly;
  for (const std::string_view keyword :
       {"OFF", "COFF", "NOFF", "CNOFF", "STOFF"}) {
    if (word == keyword) return MeshFormat::kOff;
  }
  for (const std::string_view keyword :
       {"v", "vn", "vt", "mtllib", "usemtl", "o", "g"}) {
    if (word == keyword) return MeshFormat::kObj;
  }
  if (word == "solid") return MeshFormat::kStl;
  return std::nullopt;
}

std::string Upper(MeshFormat format) {
  const std::string_view name = MeshFormatName(format);
  return absl::AsciiStrToUpper(absl::string_view(name.data(), name.size()));
}

}  // namespace

absl::Status CheckContent(std::string_view bytes, MeshFormat format) {
  if (bytes.empty()) return absl::InvalidArgumentError("the file is empty");
  for (const Signature& signature : kSignatures) {
    if (bytes.starts_with(signature.prefix)) {
      return absl::InvalidArgumentError(
          absl::StrCat("the bytes look like ", signature.name, ", not ",
                       Upper(format), ": ", signature.advice));
    }
  }
  const std::optional<MeshFormat> guess = GuessFormat(bytes);
  if (guess.has_value() && *guess != format) {
    return absl::InvalidArgumentError(absl::StrCat(
        "the bytes look like ", Upper(*guess), ", not ", Upper(format)));
  }
  // An OBJ reader skips what it does not know, so it would take any bytes.
  if (format == MeshFormat::kObj &&
      bytes.find('\0') != std::string_view::npos) {
    return absl::InvalidArgumentError(
        absl::StrCat("byte ", bytes.find('\0'),
                     " is zero: the bytes look like binary data, not OBJ"));
  }
  return absl::OkStatus();
}

}  // namespace geodesic
