// The formats of mesh files.

#ifndef GEODESIC_TYPES_MESH_FORMAT_H_
#define GEODESIC_TYPES_MESH_FORMAT_H_

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/ascii.h"
#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"

namespace geodesic {

// Their one list. The protocol has MESH_FORMAT_ and the name in capitals; what
// reads them is in core/src/readers.
enum class MeshFormat {
  kObj,   // Wavefront OBJ: v and f statements; negative indices, a/b/c corners.
  kPly,   // Stanford PLY: ASCII, binary little endian, binary big endian.
  kOff,   // OFF, COFF, NOFF, STOFF..., ASCII.
  kStl,   // STL, ASCII or binary, told apart by content.
  kVtk,   // VTK's legacy format: POLYDATA or UNSTRUCTURED_GRID of polygons.
  kGltf,  // glTF 2.0, binary or with its buffers inside; not compressed.
  kVtp,   // VTK's XML format of PolyData; arrays as they are or within zlib.
};

// What is known of a format.
struct MeshFormatInfo {
  MeshFormat format;
  std::string_view name;  // and the ending of its files
  std::string_view other_ending = {};
};

// In the order of their numbers.
inline constexpr auto kMeshFormats = std::to_array<MeshFormatInfo>({
    {MeshFormat::kObj, "obj"},
    {MeshFormat::kPly, "ply"},
    {MeshFormat::kOff, "off"},
    {MeshFormat::kStl, "stl"},
    {MeshFormat::kVtk, "vtk"},
    {MeshFormat::kGltf, "gltf", "glb"},
    {MeshFormat::kVtp, "vtp"},
});

// "obj" for kObj.
constexpr std::string_view MeshFormatName(MeshFormat format) {
  return kMeshFormats[static_cast<size_t>(format)].name;
}

// The format that a path's ending names, in any case ("a/b.PLY" is kPly),
// whether or not ".gz" follows; .glb and .gltf are one.
// Errors: INVALID_ARGUMENT naming the path and the endings that are known.
inline absl::StatusOr<MeshFormat> MeshFormatFromPath(std::string_view path) {
  std::string file =
      absl::AsciiStrToLower(std::string(path.substr(path.rfind('/') + 1)));
  if (file.ends_with(".gz")) file.resize(file.size() - 3);
  const std::string_view name = file;
  const size_t dot = name.rfind('.');
  const std::string_view ending =
      dot == name.npos ? std::string_view() : name.substr(dot + 1);
  std::string known;
  for (const MeshFormatInfo& info : kMeshFormats) {
    for (const std::string_view one : {info.name, info.other_ending}) {
      if (one.empty()) continue;
      if (ending == one) return info.format;
      absl::StrAppend(&known, known.empty() ? "." : ", .", std::string(one));
    }
  }
  return absl::InvalidArgumentError(absl::StrCat(
      "the ending of '", absl::CHexEscape(std::string(path.substr(0, 200))),
      "' names no mesh format; known are ", known,
      ", and the same with .gz behind"));
}

}  // namespace geodesic

#endif  // GEODESIC_TYPES_MESH_FORMAT_H_
