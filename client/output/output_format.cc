#include "client/output/output_format.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <filesystem>

#include "absl/strings/str_cat.h"
#include "client/output/atomic_file.h"
#include "client/output/field_writers.h"
#include "client/picture/png_writer.h"

namespace geodesic::client {
namespace {

constexpr std::array kFormats = {OutputFormat::kNpy, OutputFormat::kCsv,
                                 OutputFormat::kRaw, OutputFormat::kPly,
                                 OutputFormat::kVtk, OutputFormat::kPng};

}  // namespace

std::string_view OutputFormatName(OutputFormat format) {
  switch (format) {
    case OutputFormat::kNpy:
      return "npy";
    case OutputFormat::kCsv:
      return "csv";
    case OutputFormat::kRaw:
      return "f64";
    case OutputFormat::kPly:
      return "ply";
    case OutputFormat::kVtk:
      return "vtk";
    case OutputFormat::kPng:
      return "png";
  }
  return "unknown";
}

std::string OutputEndings() {
  std::string list;
  for (const OutputFormat format : kFormats) {
    const bool last = format == kFormats.back();
    absl::StrAppend(&list,
                    list.empty() ? "."
                    : last       ? " and ."
                                 : ", .",
                    std::string(OutputFormatName(format)));
  }
  return list;
}

absl::StatusOr<OutputFormat> OutputFormatFromPath(std::string_view path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  for (const OutputFormat format : kFormats) {
    if (ending.size() > 1 && ending.substr(1) == OutputFormatName(format)) {
      return format;
    }
  }
  return absl::InvalidArgumentError(
      absl::StrCat("cannot tell what to write to ", std::string(path),
                   ": name a file that ends in ", OutputEndings()));
}

bool NeedsMesh(OutputFormat format) {
  return format == OutputFormat::kPly || format == OutputFormat::kVtk ||
         format == OutputFormat::kPng;
}

absl::Status CheckWritable(const std::string& path) {
  std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) folder = ".";
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot write ", path));
  }
  if (std::error_code error; std::filesystem::is_directory(path, error)) {
    return absl::InvalidArgumentError(
        absl::StrCat("cannot write ", path, ": it is a folder"));
  }
  return absl::OkStatus();
}

absl::StatusOr<uint64_t> WriteOutput(const std::string& path,
                                     OutputFormat format,
                                     const OutputContent& content) {
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
  if (!file.ok()) return file.status();
  switch (format) {
    case OutputFormat::kNpy:
      WriteNpy(*content.distances, &*file);
      break;
    case OutputFormat::kCsv:
      WriteCsv(*content.distances, &*file);
      break;
    case OutputFormat::kRaw:
      WriteRaw(*content.distances, &*file);
      break;
    case OutputFormat::kPly:
      WritePly(*content.mesh, *content.distances, &*file);
      break;
    case OutputFormat::kVtk:
      WriteVtk(*content.mesh, *content.distances, &*file);
      break;
    case OutputFormat::kPng: {
      absl::StatusOr<std::string> png = EncodePng(RenderField(
          *content.mesh, *content.distances, content.sources, content.picture));
      if (!png.ok()) return png.status();
      file->Append(*png);
      break;
    }
  }
  if (absl::Status status = file->Commit(); !status.ok()) return status;
  return file->size();
}

}  // namespace geodesic::client
