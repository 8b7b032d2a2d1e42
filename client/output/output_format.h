// The formats of output files, which their endings name.

#ifndef GEODESIC_CLIENT_OUTPUT_OUTPUT_FORMAT_H_
#define GEODESIC_CLIENT_OUTPUT_OUTPUT_FORMAT_H_

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace geodesic::client {

enum class OutputFormat {
  kNpy,
  kNpz,
  kCsv,
  kF64,
  kF32,
  kPly,
  kVtk,
  kObj,
  kJson,
  kPng,
  kHtml
};

// The formats in which each kind of answer can be written.
inline constexpr std::array kFieldFormats = {
    OutputFormat::kNpy, OutputFormat::kNpz, OutputFormat::kCsv,
    OutputFormat::kF64, OutputFormat::kF32, OutputFormat::kPly,
    OutputFormat::kVtk, OutputFormat::kPng, OutputFormat::kHtml};
inline constexpr std::array kLineFormats = {
    OutputFormat::kObj, OutputFormat::kPly,  OutputFormat::kVtk,
    OutputFormat::kCsv, OutputFormat::kJson, OutputFormat::kPng};
inline constexpr std::array kMatrixFormats = {
    OutputFormat::kNpy, OutputFormat::kNpz, OutputFormat::kCsv};
inline constexpr std::array kPairFormats = {
    OutputFormat::kNpy, OutputFormat::kCsv, OutputFormat::kObj,
    OutputFormat::kPly, OutputFormat::kVtk, OutputFormat::kJson};
inline constexpr std::array kTableFormats = {OutputFormat::kCsv,
                                             OutputFormat::kJson};
inline constexpr std::array kSampleFormats = {
    OutputFormat::kCsv, OutputFormat::kJson, OutputFormat::kPly};
inline constexpr std::array kLogMapFormats = {
    OutputFormat::kNpy, OutputFormat::kCsv, OutputFormat::kPly};

// The ending without its dot: "npy".
std::string_view OutputFormatName(OutputFormat format);

// ".npy, .npz, .csv and .png".
std::string OutputEndings(std::span<const OutputFormat> formats);

// The path of an output that goes to standard output.
inline constexpr char kStandardOutput[] = "-";

// Whether there is something at the path that is neither a file nor a folder.
bool IsPipeOrDevice(const std::string& path);

// Whether the path ends in ".gz", in any case.
bool IsCompressed(std::string_view path);

// The one of `formats` that the path's ending names, in any case and with ".gz"
// behind it or not; that of standard output is .csv.
// Errors: INVALID_ARGUMENT naming the path and the allowed endings; for ".gz"
// behind what is compressed already.
absl::StatusOr<OutputFormat> OutputFormatFromPath(
    std::string_view path, std::span<const OutputFormat> formats);

// Errors: the path's folder does not exist or cannot be written to; the file
// itself, by whatever name or link, is one of `inputs` ("-" is standard input),
// which the answer would replace: then the message ends with `way_out`.
// Standard output is taken for writable. To be called before a long
// computation.
absl::Status CheckWritable(const std::string& path,
                           std::span<const std::string> inputs,
                           std::string_view way_out = "write to another file");

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_OUTPUT_FORMAT_H_
