#include "geodesic/read_mesh.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "geodesic/checkpoint.h"
#include "geodesic/gzip.h"
#include "mesh/split_touching.h"
#include "readers/reader_errors.h"
#include "readers/readers.h"
#include "readers/text_scanner.h"

namespace geodesic {
namespace {

using Reader = absl::StatusOr<TriangleSoup> (*)(std::string_view bytes,
                                                const ReadLimits& limits);

// By the number of the format.
constexpr auto kReaders = std::to_array<Reader>(
    {ReadObj, ReadPly, ReadOff, ReadStl, ReadVtk, ReadGltf, ReadVtp});
static_assert(kReaders.size() == kMeshFormats.size());

struct Signature {
  std::string_view prefix;
  absl::string_view name;
  absl::string_view advice;
};

constexpr absl::string_view kDecompress = "decompress first";
constexpr absl::string_view kUtf8 = "save it as UTF-8 first";
constexpr absl::string_view kConvert =
    "convert it to PLY, OFF, OBJ, STL, glTF or VTP";
constexpr absl::string_view kDownload =
    "the download was perhaps an error page";

constexpr std::array<Signature, 13> kSignatures = {{
    {"\x1f\x8b", "gzip", kDecompress},
    {"PK\x03\x04", "zip", kDecompress},
    {"BZh", "bzip2", kDecompress},
    {"\xfd\x37zXZ", "xz", kDecompress},
    {"\x28\xb5\x2f\xfd", "zstd", kDecompress},
    {"7z\xbc\xaf", "7-Zip", kDecompress},
    {"\xfe\xff", "UTF-16 text", kUtf8},
    {"\xff\xfe", "UTF-16 text", kUtf8},
    {"\x89PNG", "a PNG picture", "name a mesh file"},
    {"<!DOCTYPE", "HTML", kDownload},
    {"<html", "HTML", kDownload},
    {"<?xml", "XML", kConvert},
    {"version https://git-lfs", "a Git LFS pointer",
     "fetch the file that it stands for"},
}};

// How far into a file its first element may stand.
constexpr size_t kXmlProlog = 4096;

// The mesh format that the first word of a text gives away.
std::optional<MeshFormat> GuessFormat(std::string_view bytes) {
  if (bytes.starts_with("# vtk DataFile")) return MeshFormat::kVtk;
  if (bytes.starts_with("glTF")) return MeshFormat::kGltf;
  if ((bytes.starts_with("<") || bytes.starts_with("\xef\xbb\xbf<")) &&
      bytes.substr(0, kXmlProlog).find("<VTKFile") != std::string_view::npos) {
    return MeshFormat::kVtp;
  }
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
  std::string name(MeshFormatName(format));
  absl::AsciiStrToUpper(&name);
  return name;
}

// OK unless the bytes are plainly something other than `format`.
// Errors: INVALID_ARGUMENT that says what they look like and what to do.
absl::Status CheckContent(std::string_view bytes, MeshFormat format) {
  if (bytes.empty()) return absl::InvalidArgumentError("the file is empty");
  const std::optional<MeshFormat> guess = GuessFormat(bytes);
  for (const Signature& signature : kSignatures) {
    if (!guess.has_value() && bytes.starts_with(signature.prefix)) {
      return absl::InvalidArgumentError(
          absl::StrCat("the bytes look like ", signature.name, ", not ",
                       Upper(format), ": ", signature.advice));
    }
  }
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

}  // namespace

absl::StatusOr<TriangleSoup> ReadMesh(std::string_view bytes, MeshFormat format,
                                      const ReadLimits& limits) {
  const auto number = static_cast<size_t>(format);
  if (number >= kReaders.size()) {
    return absl::InvalidArgumentError("unknown mesh format");
  }
  if (limits.max_gzip_bytes > 0 && IsGzip(bytes)) {
    const absl::StatusOr<std::vector<char>> inflated =
        Gunzip(bytes, limits.max_gzip_bytes, limits.checkpoint);
    if (!inflated.ok()) return inflated.status();
    ReadLimits once = limits;
    once.max_gzip_bytes = 0;
    return ReadMesh({inflated->data(), inflated->size()}, format, once);
  }
  // The header of a binary STL may begin with any bytes.
  if (format != MeshFormat::kStl || !HasSizeOfBinaryStl(bytes)) {
    if (absl::Status status = CheckContent(bytes, format); !status.ok()) {
      return status;
    }
  }
  absl::StatusOr<TriangleSoup> soup = kReaders[number](bytes, limits);
  if (!soup.ok()) return soup;
  if (format == MeshFormat::kStl &&
      limits.welding.kind != Welding::Kind::kNone) {
    SplitTouching(*soup);
  }
  NoCheckpoint goes_on;
  const absl::Status status =
      JoinSeams(limits.welding, *soup,
                limits.checkpoint != nullptr ? *limits.checkpoint : goes_on);
  if (!status.ok()) return status;
  return soup;
}

}  // namespace geodesic
