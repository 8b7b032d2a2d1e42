// Client::UploadFile, UploadArrays and FindFile. They ask whether the server
// has a mesh before they send it.

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "codec/mesh_format.h"
#include "connection.h"
#include "digest/sha256.h"
#include "rpc_status.h"
#include "translate.h"

namespace geodesic::client {
namespace {

constexpr size_t kChunkBytes = size_t{1} << 20;

// Reads a regular file from front to back in pieces.
class FileReader {
 public:
  // Errors: NOT_FOUND, PERMISSION_DENIED or FAILED_PRECONDITION if it cannot be
  // opened, INVALID_ARGUMENT if it is no regular file; all name the path.
  static absl::StatusOr<FileReader> Open(const std::string& path) {
    // Opening a pipe would block, so the file's kind is checked first.
    struct stat info = {};
    if (stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode)) {
      return absl::InvalidArgumentError(
          absl::StrCat(path, " is not a regular file"));
    }
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) {
      return absl::ErrnoToStatus(errno, absl::StrCat("cannot open ", path));
    }
    return FileReader(path, file, static_cast<uint64_t>(info.st_size));
  }

  uint64_t size() const { return size_; }

  // Fills `buffer` with the next bytes, up to its size. At the end of the file
  // it shrinks `buffer`, and empties it if no bytes are left.
  // Errors: DATA_LOSS naming the path.
  absl::Status Read(std::string* buffer) {
    buffer->resize(std::fread(buffer->data(), 1, buffer->size(), file_.get()));
    return std::ferror(file_.get()) == 0
               ? absl::OkStatus()
               : absl::DataLossError(absl::StrCat("cannot read ", path_));
  }

  void Rewind() { std::rewind(file_.get()); }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  FileReader(std::string path, std::FILE* file, uint64_t size)
      : path_(std::move(path)), file_(file), size_(size) {}

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  uint64_t size_;
};

// Fills `chunk` with the next bytes of an upload, which follow the last chunk
// unless `restart` is set. An empty chunk ends the upload.
using ChunkSource =
    std::function<absl::Status(bool restart, std::string* chunk)>;

// Sends an upload, and sends it again if the connection breaks or the server is
// full. That is safe: the server drops an upload that does not end, and finds a
// mesh resident whose upload did. `path` is the file's, or empty. `route`: as
// `mesh` for Call.
absl::StatusOr<UploadOutcome> Send(
    v1::MeshService::Stub* stub, const std::string& path,
    const v1::UploadHeader& header, const std::string& route,
    const ChunkSource& next_chunk, const CallOptions& options,
    const CountProgressCallback& progress, bool retry) {
  const auto send_once = [&]() -> absl::StatusOr<UploadOutcome> {
    v1::CreateMeshResponse response;
    Call call(options, route);
    auto writer = stub->CreateMesh(call.context(), &response);
    v1::CreateMeshRequest request;
    *request.mutable_header() = header;
    bool open = writer->Write(request);
    uint64_t sent = 0;
    absl::Status local;
    for (bool restart = true; open; restart = false) {
      v1::UploadChunk* chunk = request.mutable_chunk();
      chunk->mutable_data()->resize(kChunkBytes);
      local = next_chunk(restart, chunk->mutable_data());
      if (!local.ok()) call.context()->TryCancel();
      if (!local.ok() || chunk->data().empty()) break;
      chunk->set_offset(sent);
      open = writer->Write(request);
      sent += chunk->data().size();
      if (progress != nullptr) progress(sent, header.size_bytes());
    }
    writer->WritesDone();
    // This status tells why a write failed.
    const absl::Status status = FromRpcStatus(writer->Finish(), path);
    if (!local.ok()) return local;
    if (!status.ok()) return status;
    return UploadOutcome{.mesh = FromProto(response.mesh()),
                         .already_resident = response.already_resident(),
                         .bytes_sent = sent};
  };
  for (int attempts = 1;; ++attempts) {
    absl::StatusOr<UploadOutcome> outcome = send_once();
    if (outcome.ok() || !retry ||
        !WaitToRetry(outcome.status(), attempts, options.stop)) {
      return outcome;
    }
  }
}

absl::StatusOr<std::string> HashFile(FileReader* file,
                                     const CallOptions& options) {
  Sha256 hash;
  std::string buffer;
  do {
    if (options.stop.stop_requested()) {
      return absl::CancelledError("stopped while hashing the file");
    }
    buffer.resize(kChunkBytes);
    if (absl::Status status = file->Read(&buffer); !status.ok()) return status;
    hash.Update(buffer);
  } while (!buffer.empty());
  return hash.FinishHex();
}

// Of an UploadHeader or a FileDigest.
template <typename Message>
void SetWelding(const Welding& welding, Message* message) {
  if (welding.distance.has_value()) {
    message->set_weld_distance(*welding.distance);
  }
  message->set_keep_seams(welding.keep_seams);
}

// The mesh that was uploaded as this file, if the server has it.
absl::StatusOr<std::optional<std::string>> FindMeshOf(
    v1::MeshService::Stub* stub, const std::string& sha256, MeshFormat format,
    const Welding& welding, const CallOptions& options) {
  v1::FindMissingMeshesRequest request;
  v1::FileDigest* asked = request.add_files();
  asked->set_format(codec::ToProto(format));
  asked->set_sha256(sha256);
  SetWelding(welding, asked);
  v1::FindMissingMeshesResponse response;
  Call call(options, sha256);
  absl::Status status = FromRpcStatus(
      stub->FindMissingMeshes(call.context(), request, &response));
  if (!status.ok()) return status;
  if (response.known_files().empty()) return std::nullopt;
  return response.known_files(0).mesh_digest();
}

}  // namespace

absl::StatusOr<std::optional<std::string>> Client::FindFile(
    const std::string& path, MeshFormat format, const Welding& welding,
    const CallOptions& options) {
  absl::StatusOr<FileReader> file = FileReader::Open(path);
  if (!file.ok()) return file.status();
  absl::StatusOr<std::string> sha256 = HashFile(&*file, options);
  if (!sha256.ok()) return sha256.status();
  return FindMeshOf(connection_->meshes.get(), *sha256, format, welding,
                    options);
}

absl::StatusOr<UploadOutcome> Client::UploadFile(
    const std::string& path, MeshFormat format, const Welding& welding,
    const CallOptions& options, const CountProgressCallback& progress) {
  absl::StatusOr<FileReader> file = FileReader::Open(path);
  if (!file.ok()) return file.status();
  absl::StatusOr<std::string> sha256 = HashFile(&*file, options);
  if (!sha256.ok()) return sha256.status();
  absl::StatusOr<std::optional<std::string>> known =
      FindMeshOf(connection_->meshes.get(), *sha256, format, welding, options);
  if (!known.ok()) return known.status();
  if (known->has_value()) {
    absl::StatusOr<MeshInfo> mesh = GetMesh(**known, options);
    if (mesh.ok()) {
      return UploadOutcome{.mesh = *std::move(mesh), .already_resident = true};
    }
    // The mesh may have been evicted since it was asked for, or a balancer may
    // send questions about it to another server than this file: to that one
    // the file goes.
    if (!absl::IsNotFound(mesh.status())) return mesh.status();
  }

  v1::UploadHeader header;
  header.set_format(codec::ToProto(format));
  header.set_size_bytes(file->size());
  SetWelding(welding, &header);
  uint64_t left = 0;
  auto next_chunk = [&](bool restart, std::string* chunk) {
    if (restart) {
      file->Rewind();
      left = file->size();
    }
    chunk->resize(std::min<uint64_t>(chunk->size(), left));
    const size_t wanted = chunk->size();
    absl::Status status = file->Read(chunk);
    if (status.ok() && chunk->size() != wanted) {
      return absl::DataLossError(
          absl::StrCat(path, " became shorter while it was read"));
    }
    left -= chunk->size();
    return status;
  };
  return Send(connection_->meshes.get(), path, header, known->value_or(*sha256),
              next_chunk, options, progress, connection_->retry);
}

absl::StatusOr<UploadOutcome> Client::UploadFile(
    const std::string& path, const CallOptions& options,
    const CountProgressCallback& progress) {
  absl::StatusOr<MeshFormat> format = MeshFormatFromPath(path);
  if (!format.ok()) return format.status();
  return UploadFile(path, *format, {}, options, progress);
}

absl::StatusOr<UploadOutcome> Client::UploadArrays(
    const MeshArrays& mesh, const CallOptions& options,
    const CountProgressCallback& progress) {
  const std::string digest = MeshDigest(mesh);
  absl::StatusOr<MeshInfo> resident = GetMesh(digest, options);
  if (resident.ok()) {
    return UploadOutcome{.mesh = *std::move(resident),
                         .already_resident = true};
  }
  if (!absl::IsNotFound(resident.status())) return resident.status();

  const uint64_t position_bytes = mesh.positions.size() * sizeof(Point);
  const uint64_t triangle_bytes = mesh.triangles.size() * sizeof(Triangle);
  v1::UploadHeader header;
  header.set_format(v1::MESH_FORMAT_ARRAYS);
  header.set_size_bytes(position_bytes + triangle_bytes);
  header.set_vertex_count(mesh.positions.size());
  header.set_face_count(mesh.triangles.size());
  header.set_expected_digest(digest);
  uint64_t offset = 0;
  auto next_chunk = [&](bool restart, std::string* chunk) {
    if (restart) offset = 0;
    // A chunk holds bytes of one array only.
    const bool in_positions = offset < position_bytes;
    const uint64_t begin = in_positions ? offset : offset - position_bytes;
    const uint64_t end = in_positions ? position_bytes : triangle_bytes;
    const void* array = in_positions
                            ? static_cast<const void*>(mesh.positions.data())
                            : mesh.triangles.data();
    chunk->resize(std::min<uint64_t>(chunk->size(), end - begin));
    if (!chunk->empty()) {
      std::memcpy(chunk->data(), static_cast<const char*>(array) + begin,
                  chunk->size());
    }
    offset += chunk->size();
    return absl::OkStatus();
  };
  return Send(connection_->meshes.get(), /*path=*/"", header, digest,
              next_chunk, options, progress, connection_->retry);
}

}  // namespace geodesic::client
