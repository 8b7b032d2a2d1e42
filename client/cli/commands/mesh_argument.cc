#include "client/cli/commands/mesh_argument.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <string_view>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "client/cli/terminal/exit_code.h"
#include "client/cli/terminal/text.h"
#include "geodesic_client/errors.h"

namespace geodesic::client {
namespace {

constexpr size_t kShortestPrefix = 8;

bool IsDigestOrPrefix(std::string_view text) {
  return text.size() >= kShortestPrefix && text.size() <= 64 &&
         std::ranges::all_of(text, [](char c) {
           return absl::ascii_isxdigit(static_cast<unsigned char>(c));
         });
}

bool IsFile(const std::string& text) {
  std::error_code error;
  return std::filesystem::exists(text, error);
}

// The file's format.
// Errors: FileError if it cannot be read or its format is unknown.
absl::StatusOr<MeshFormat> InspectFile(const MeshArgument& mesh) {
  const std::string& path = mesh.text;
  if (access(path.c_str(), R_OK) != 0) {
    return FileError(
        absl::ErrnoToStatus(errno, absl::StrCat("cannot read ", path)));
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    return FileError(absl::InvalidArgumentError(
        absl::StrCat(path, " is not a regular file")));
  }
  if (mesh.format.has_value()) return *mesh.format;
  absl::StatusOr<MeshFormat> format = MeshFormatFromPath(path);
  if (!format.ok()) {
    return FileError(absl::InvalidArgumentError(absl::StrCat(
        std::string(format.status().message()), "; or say it with --format")));
  }
  return format;
}

absl::Status Neither(const std::string& text) {
  return FileError(absl::NotFoundError(absl::StrCat(
      text,
      " is neither a file nor a digest (64 hexadecimal digits, or at least the "
      "first 8)")));
}

// Returns `text` if it is a digest, otherwise the resident digest that begins
// with it.
absl::StatusOr<std::string> CompleteDigest(const Session& session,
                                           std::string text) {
  if (!IsDigestOrPrefix(text)) return Neither(text);
  absl::AsciiStrToLower(&text);
  if (IsMeshDigest(text)) return text;
  absl::StatusOr<std::vector<MeshInfo>> meshes =
      session.client.ListMeshes(session.call);
  if (!meshes.ok()) return meshes.status();
  std::erase_if(*meshes, [&text](const MeshInfo& mesh) {
    return !mesh.digest.starts_with(text);
  });
  if (meshes->empty()) {
    return absl::NotFoundError(
        absl::StrCat("no resident mesh has a digest that begins with ", text));
  }
  if (meshes->size() > 1) {
    return absl::InvalidArgumentError(
        absl::StrCat(meshes->size(), " resident meshes begin with ", text,
                     ", among them ", meshes->at(0).digest, " and ",
                     meshes->at(1).digest, ": give more digits"));
  }
  return meshes->front().digest;
}

}  // namespace

absl::StatusOr<UploadOutcome> UploadMesh(const Session& session,
                                         const MeshArgument& mesh) {
  absl::StatusOr<MeshFormat> format = InspectFile(mesh);
  if (!format.ok()) return format.status();
  using Clock = std::chrono::steady_clock;
  ProgressDisplay display(session.progress_style, session.terminal_width,
                          Clock::now(), &session.err);
  return session.client.UploadFile(
      mesh.text, *format, mesh.welding, session.call,
      [&display](uint64_t sent, uint64_t total) {
        display.Update(Clock::now(), "uploading",
                       static_cast<double>(sent) / static_cast<double>(total),
                       absl::StrCat(ByteCount(sent), " of ", ByteCount(total)));
      });
}

absl::Status AskAboutMesh(
    const Session& session, const MeshArgument& mesh,
    const std::function<absl::Status(const std::string& digest)>& ask) {
  if (!IsFile(mesh.text)) {
    if (mesh.welding.keep_seams || mesh.welding.distance.has_value()) {
      return FileError(absl::InvalidArgumentError(absl::StrCat(
          "--weld and --no-weld say how a file is read, and ", mesh.text,
          " is no file: its edges are joined already or not")));
    }
    absl::StatusOr<std::string> digest = CompleteDigest(session, mesh.text);
    return digest.ok() ? ask(*digest) : digest.status();
  }
  for (bool is_again = false;; is_again = true) {
    absl::StatusOr<UploadOutcome> upload = UploadMesh(session, mesh);
    if (!upload.ok()) return upload.status();
    absl::Status status = ask(upload->mesh.digest);
    if (is_again || ErrorReason(status) != "MESH_NOT_RESIDENT") return status;
  }
}

absl::StatusOr<std::string> FindMesh(const Session& session,
                                     const MeshArgument& mesh) {
  const std::string& text = mesh.text;
  if (!IsFile(text)) return CompleteDigest(session, text);
  absl::StatusOr<MeshFormat> format = InspectFile(mesh);
  if (!format.ok()) return format.status();
  absl::StatusOr<std::optional<std::string>> digest =
      session.client.FindFile(text, *format, mesh.welding, session.call);
  if (!digest.ok()) return digest.status();
  if (!digest->has_value()) {
    return absl::NotFoundError(
        absl::StrCat("the server has no mesh that came from ", text));
  }
  return **std::move(digest);
}

bool IsPlyFile(const MeshArgument& mesh) {
  if (!IsFile(mesh.text) && IsDigestOrPrefix(mesh.text)) return false;
  if (mesh.format.has_value()) return *mesh.format == MeshFormat::kPly;
  const absl::StatusOr<MeshFormat> format = MeshFormatFromPath(mesh.text);
  return format.ok() && *format == MeshFormat::kPly;
}

bool IsPlyFileOf(const Session& session, const MeshArgument& mesh,
                 const std::string& digest) {
  if (!IsPlyFile(mesh) || !IsFile(mesh.text)) return false;
  const absl::StatusOr<std::string> found = FindMesh(session, mesh);
  return found.ok() && *found == digest;
}

}  // namespace geodesic::client
