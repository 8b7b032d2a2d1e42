// What an output file's ending asks for.

#ifndef GEODESIC_CLIENT_OUTPUT_OUTPUT_FORMAT_H_
#define GEODESIC_CLIENT_OUTPUT_OUTPUT_FORMAT_H_

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/picture/picture.h"
#include "geodesic_client/field.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

enum class OutputFormat { kNpy, kCsv, kRaw, kPly, kVtk, kPng };

// "npy", "csv", "f64", "ply", "vtk" or "png".
std::string_view OutputFormatName(OutputFormat format);

// ".npy, .csv, .f64, .ply, .vtk and .png".
std::string OutputEndings();

// Errors: INVALID_ARGUMENT naming the path and the endings that are known.
absl::StatusOr<OutputFormat> OutputFormatFromPath(std::string_view path);

// Whether a file in this format takes more than the distances.
bool NeedsMesh(OutputFormat format);

// An error now rather than after a long computation, if the path's folder does
// not exist or cannot be written to.
absl::Status CheckWritable(const std::string& path);

// What goes into a file. `mesh` may be null unless the format needs it.
struct OutputContent {
  const MeshArrays* mesh = nullptr;
  const std::vector<double>* distances = nullptr;
  std::vector<uint64_t> sources;
  PictureOptions picture;
};

// Writes the whole file or nothing; returns its size in bytes.
// Errors: those of writing files, naming the path.
absl::StatusOr<uint64_t> WriteOutput(const std::string& path,
                                     OutputFormat format,
                                     const OutputContent& content);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_OUTPUT_FORMAT_H_
