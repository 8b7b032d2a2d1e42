#include "client/output/output_format.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>

#include "absl/strings/str_cat.h"

namespace geodesic::client {

std::string_view OutputFormatName(OutputFormat format) {
  switch (format) {
    case OutputFormat::kNpy:
      return "npy";
    case OutputFormat::kNpz:
      return "npz";
    case OutputFormat::kCsv:
      return "csv";
    case OutputFormat::kF64:
      return "f64";
    case OutputFormat::kF32:
      return "f32";
    case OutputFormat::kPly:
      return "ply";
    case OutputFormat::kVtk:
      return "vtk";
    case OutputFormat::kObj:
      return "obj";
    case OutputFormat::kJson:
      return "json";
    case OutputFormat::kPng:
      return "png";
  }
  return "unknown";
}

std::string OutputEndings(std::span<const OutputFormat> formats) {
  std::string list;
  for (const OutputFormat format : formats) {
    const bool last = format == formats.back();
    absl::StrAppend(&list,
                    list.empty() ? "."
                    : last       ? " and ."
                                 : ", .",
                    std::string(OutputFormatName(format)));
  }
  return list;
}

absl::StatusOr<OutputFormat> OutputFormatFromPath(
    std::string_view path, std::span<const OutputFormat> formats) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  for (const OutputFormat format : formats) {
    if (ending.size() > 1 && ending.substr(1) == OutputFormatName(format)) {
      return format;
    }
  }
  return absl::InvalidArgumentError(absl::StrCat(
      "cannot tell what to write to ", std::string(path),
      ": the endings this command knows are ", OutputEndings(formats)));
}

absl::Status CheckWritable(const std::string& path) {
  std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) folder = ".";
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    return absl::ErrnoToStatus(
        errno,
        absl::StrCat("cannot write ", path, " into the folder ",
                     folder.string(), ", which must exist and allow it"));
  }
  if (std::error_code error; std::filesystem::is_directory(path, error)) {
    return absl::InvalidArgumentError(
        absl::StrCat("cannot write ", path, ": it is a folder"));
  }
  return absl::OkStatus();
}

}  // namespace geodesic::client
