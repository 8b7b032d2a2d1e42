#include "client/output/output_format.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "client/output/place_text.h"

namespace geodesic::client {

std::string_view OutputFormatName(OutputFormat format) {
  // Indexed by OutputFormat.
  constexpr std::array kNames = {"npy", "npz", "csv",  "f64", "f32", "ply",
                                 "vtk", "obj", "json", "png", "html"};
  return kNames.at(static_cast<size_t>(format));
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

bool IsCompressed(std::string_view path) {
  return absl::EndsWithIgnoreCase({path.data(), path.size()}, ".gz");
}

absl::StatusOr<OutputFormat> OutputFormatFromPath(
    std::string_view path, std::span<const OutputFormat> formats) {
  if (IsCompressed(path)) {
    absl::StatusOr<OutputFormat> format =
        OutputFormatFromPath(path.substr(0, path.size() - 3), formats);
    if (format.ok() &&
        (*format == OutputFormat::kNpz || *format == OutputFormat::kPng)) {
      return absl::InvalidArgumentError(absl::StrCat(
          std::string(path), ": .", std::string(OutputFormatName(*format)),
          " is compressed already; leave .gz away"));
    }
    return format;
  }
  const std::string ending =
      path == kStandardOutput
          ? ".csv"
          : absl::AsciiStrToLower(
                std::filesystem::path(path).extension().string());
  for (const OutputFormat format : formats) {
    if (ending.size() > 1 && ending.substr(1) == OutputFormatName(format)) {
      return format;
    }
  }
  return absl::InvalidArgumentError(absl::StrCat(
      "cannot tell what to write to ", std::string(path),
      ": the endings this command knows are ", OutputEndings(formats)));
}

bool IsPipeOrDevice(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status =
      std::filesystem::status(path, error);
  return std::filesystem::exists(status) &&
         !std::filesystem::is_regular_file(status) &&
         !std::filesystem::is_directory(status);
}

absl::Status CheckWritable(const std::string& path,
                           std::span<const std::string> inputs,
                           std::string_view way_out) {
  if (path == kStandardOutput) return absl::OkStatus();
  std::error_code error;
  // A terminal is read and written.
  const bool is_file = std::filesystem::is_regular_file(path, error);
  for (const std::string& input : inputs) {
    const std::string_view read =
        input == kStandardInput ? "/dev/stdin" : std::string_view(input);
    if (!is_file || !std::filesystem::equivalent(path, read, error)) continue;
    return absl::InvalidArgumentError(
        absl::StrCat("cannot write ", path,
                     ": it is read by this command, and the answer would "
                     "replace it; ",
                     std::string(way_out)));
  }
  if (IsPipeOrDevice(path)) {
    return access(path.c_str(), W_OK) == 0
               ? absl::OkStatus()
               : absl::ErrnoToStatus(errno,
                                     absl::StrCat("cannot write ", path));
  }
  std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) folder = ".";
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    return absl::ErrnoToStatus(
        errno,
        absl::StrCat("cannot write ", path, " into the folder ",
                     folder.string(), ", which must exist and allow it"));
  }
  if (std::filesystem::is_directory(path, error)) {
    return absl::InvalidArgumentError(
        absl::StrCat("cannot write ", path, ": it is a folder"));
  }
  return absl::OkStatus();
}

}  // namespace geodesic::client
