#include "server/engine/meshes/mesh_upload.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <new>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic/gzip.h"
#include "geodesic/read_mesh.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/engine/meshes/mesh_digest.h"

namespace geodesic::server {
namespace {

// Canonical arrays are copied as they lie in memory.
static_assert(std::endian::native == std::endian::little);

// The buffer starts with the size of a usual chunk and then doubles.
constexpr uint64_t kFirstCapacity = uint64_t{1} << 20;

// Bounds on the triangles' memory, as multiples of the file's size. Most files
// keep to the first: "f 1001 1002 1003\n" is 17 bytes and makes 12. A file that
// does not is read again with a larger bound. Every file keeps to the last: a
// byte may be a corner, and add a triangle; in a .vtp it may be compressed.
constexpr uint64_t kUsualFactor = 3;
constexpr uint64_t kNextFactor = 4;
constexpr uint64_t kLastFactor = 48;
constexpr uint64_t kMostInflation = 1032;

// Gunzip's memory, as a multiple of what comes out.
constexpr uint64_t kGunzipFactor = 2;

// The subject of CheckCount's messages.
constexpr char kUpload[] = "the upload announces";

uint64_t FirstFactor(const UploadHeader& header) {
  return header.format == kArrays ? 1 : kUsualFactor;
}

uint64_t LastFactor(const UploadHeader& header) {
  return header.format == MeshFormat::kVtp ? kLastFactor * kMostInflation
                                           : kLastFactor;
}

// An array that grows takes twice its content while it is moved, so half of the
// bytes is for vertices, and a little less than half for triangles: with each
// goes a bit that says of which polygon it is. Polygons are cut when nothing
// grows any more: a polygon of all triangles then has half of the bytes
// and more: cutting takes 26 bytes for each of its corners.
ReadLimits LimitsWithin(uint64_t bytes) {
  return {.max_vertices = bytes / (4 * sizeof(Point)),
          .max_triangles = bytes / (4 * sizeof(Triangle) + 4)};
}

absl::Status CheckArraysHeader(const UploadHeader& header,
                               const Limits& limits) {
  // The counts are checked first, so that the sizes below cannot overflow.
  for (const absl::Status& status :
       {CheckCount("vertices", header.vertex_count, "max_vertices",
                   limits.max_vertices, kUpload),
        CheckCount("faces", header.face_count, "max_faces", limits.max_faces,
                   kUpload)}) {
    if (!status.ok()) return status;
  }
  const uint64_t size = header.vertex_count * sizeof(Point) +
                        header.face_count * sizeof(Triangle);
  if (size == header.size_bytes) return absl::OkStatus();
  return InvalidField(
      "header.size_bytes",
      absl::StrCat("header.size_bytes is ", header.size_bytes, ", but ",
                   header.vertex_count, " vertices and ", header.face_count,
                   " faces take ", size, " bytes"));
}

absl::Status CheckHeader(const UploadHeader& header, const Limits& limits) {
  if (!header.expected_digest.empty() && !IsSha256Hex(header.expected_digest)) {
    return InvalidField("header.expected_digest",
                        "header.expected_digest must be empty or 64 lower-case "
                        "hexadecimal digits");
  }
  if (header.size_bytes == 0) {
    return InvalidField("header.size_bytes",
                        "the file is empty: it holds no mesh");
  }
  absl::Status status =
      CheckCount("bytes", header.size_bytes, "max_upload_bytes",
                 limits.max_upload_bytes, kUpload);
  if (!status.ok()) return status;
  if (header.format == kArrays) {
    return CheckArraysHeader(header, limits);
  }
  if (header.vertex_count != 0 || header.face_count != 0) {
    return InvalidField(
        header.vertex_count != 0 ? "header.vertex_count" : "header.face_count",
        "header.vertex_count and header.face_count belong to uploads of "
        "arrays; a file says itself what it holds");
  }
  return absl::OkStatus();
}

uint64_t SoupBytes(const TriangleSoup& soup) {
  return soup.positions.capacity() * sizeof(Point) +
         soup.triangles.capacity() * sizeof(Triangle) +
         soup.reading.joined.capacity() * sizeof(JoinedVertex);
}

// Takes the memory that joining edges needs beside the soup.
class JoiningCheckpoint final : public Checkpoint {
 public:
  // `file`: the bytes that are read.
  JoiningCheckpoint(Checkpoint& next, uint64_t file, ByteReservation& memory)
      : next_(next), file_(file), memory_(memory) {}

  absl::Status Poll(const Progress& progress) override {
    if (progress.solver_bytes > 0) {
      absl::Status status = memory_.GrowTo(
          std::max(memory_.bytes(), file_ + progress.solver_bytes));
      if (!status.ok()) return status;
    }
    return next_.Poll({});
  }

 private:
  Checkpoint& next_;
  const uint64_t file_;
  ByteReservation& memory_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<MeshUpload>> MeshUpload::Start(
    UploadHeader header, const Limits& limits,
    std::shared_ptr<ByteBudget> budget) {
  if (absl::Status status = CheckHeader(header, limits); !status.ok()) {
    return status;
  }
  absl::StatusOr<ByteReservation> nothing = ByteReservation::Make(budget, 0);
  if (!nothing.ok()) return nothing.status();
  auto upload = std::unique_ptr<MeshUpload>(
      new MeshUpload(std::move(header), limits, std::move(budget)));
  upload->reservation_ = *std::move(nothing);
  return upload;
}

MeshUpload::MeshUpload(UploadHeader header, const Limits& limits,
                       std::shared_ptr<ByteBudget> budget)
    : header_(std::move(header)),
      limits_(limits),
      budget_(std::move(budget)),
      soup_factor_(FirstFactor(header_)) {}

absl::Status MeshUpload::Append(uint64_t offset, std::string_view data) {
  if (offset != bytes_.size()) {
    return InvalidField("chunk.offset",
                        absl::StrCat("chunk.offset is ", offset, ", but ",
                                     bytes_.size(), " bytes came before it"));
  }
  if (data.size() > header_.size_bytes - bytes_.size()) {
    return InvalidField(
        "chunk.data",
        absl::StrCat("the chunk at offset ", offset, " brings ", data.size(),
                     " bytes, beyond the ", header_.size_bytes,
                     " that header.size_bytes announced"));
  }
  if (const uint64_t needed = bytes_.size() + data.size();
      needed > bytes_.capacity()) {
    // Old and new buffer live side by side while the bytes move over.
    const uint64_t held = bytes_.capacity();
    const uint64_t capacity = std::min(
        header_.size_bytes, std::max({needed, 2 * held, kFirstCapacity}));
    absl::Status status = reservation_.GrowTo(held + capacity);
    if (!status.ok()) return status;
    try {
      bytes_.reserve(capacity);
    } catch (const std::bad_alloc&) {
      return absl::ResourceExhaustedError(absl::StrCat(
          "the server has no memory for an upload of ", capacity, " bytes"));
    }
    reservation_.ShrinkTo(capacity);
  }
  bytes_.insert(bytes_.end(), data.begin(), data.end());
  if (header_.format != kArrays) hash_.Update(data);
  return absl::OkStatus();
}

absl::Status MeshUpload::Finish() {
  if (bytes_.size() != header_.size_bytes) {
    return InvalidField(
        "header.size_bytes",
        absl::StrCat("the upload ended after ", bytes_.size(), " of the ",
                     header_.size_bytes,
                     " bytes that header.size_bytes announced"));
  }
  if (header_.format != kArrays) {
    file_ = {header_.format, hash_.FinishHex(), header_.welding};
    if (const std::string_view file = Bytes(); IsGzip(file)) {
      inflated_bound_ =
          std::min(PromisedGzipBytes(file), limits_.max_upload_bytes);
    }
  }
  return absl::OkStatus();
}

uint64_t MeshUpload::BytesToParse(const UploadHeader& header) {
  return (1 + FirstFactor(header)) * header.size_bytes;
}

absl::Status MeshUpload::ReserveForParse() {
  return reservation_.GrowTo(
      bytes_.capacity() +
      (inflated_bound_ > 0 ? kGunzipFactor * inflated_bound_ : SoupBound()));
}

absl::Status MeshUpload::Inflate(Checkpoint& checkpoint) {
  absl::StatusOr<std::vector<char>> inflated =
      Gunzip(Bytes(), inflated_bound_, &checkpoint);
  if (inflated.ok()) {
    bytes_ = *std::move(inflated);
    inflated_bound_ = 0;
    reservation_.ShrinkTo(bytes_.capacity());
    return absl::OkStatus();
  }
  if (absl::IsResourceExhausted(inflated.status()) &&
      inflated_bound_ < limits_.max_upload_bytes) {
    inflated_bound_ =
        std::min(kNextFactor * inflated_bound_, limits_.max_upload_bytes);
    return absl::OkStatus();
  }
  return FreeAndExplain(inflated.status());
}

absl::Status MeshUpload::FreeAndExplain(const absl::Status& status) {
  std::vector<char>().swap(bytes_);
  reservation_.ShrinkTo(0);
  return absl::IsInvalidArgument(status) ? WithFieldPath(status, "chunk.data")
                                         : status;
}

absl::StatusOr<bool> MeshUpload::Parse(Checkpoint& checkpoint) {
  if (inflated_bound_ > 0) {
    const absl::Status status = Inflate(checkpoint);
    if (!status.ok()) return status;
    return false;
  }
  const ReadLimits core_limits;
  const ReadLimits own = {
      .max_vertices = std::min(limits_.max_vertices, core_limits.max_vertices),
      .max_triangles = std::min(limits_.max_faces, core_limits.max_triangles)};
  const ReadLimits within = LimitsWithin(SoupBound());
  JoiningCheckpoint joining(checkpoint, bytes_.capacity(), reservation_);
  absl::StatusOr<TriangleSoup> soup =
      header_.format == kArrays
          ? ParseArrays(joining)
          : ParseFile({.max_vertices =
                           std::min(own.max_vertices, within.max_vertices),
                       .max_triangles =
                           std::min(own.max_triangles, within.max_triangles),
                       .checkpoint = &joining,
                       .welding = header_.welding});
  if (absl::IsResourceExhausted(soup.status()) &&
      soup_factor_ < LastFactor(header_) &&
      (within.max_vertices < own.max_vertices ||
       within.max_triangles < own.max_triangles)) {
    soup_factor_ *= kNextFactor;
    return false;
  }
  if (!soup.ok()) return FreeAndExplain(soup.status());
  std::vector<char>().swap(bytes_);
  reservation_.ShrinkTo(SoupBytes(*soup));
  if (absl::Status s = checkpoint.Poll({}); !s.ok()) return s;
  digest_ = MeshDigest(*soup);
  const std::string& expected = header_.expected_digest;
  if (!expected.empty() && expected != digest_) {
    return InvalidField("header.expected_digest",
                        absl::StrCat("the mesh has digest ", digest_,
                                     ", not the expected ", expected));
  }
  soup_ = *std::move(soup);
  return true;
}

absl::StatusOr<TriangleSoup> MeshUpload::ParseArrays(
    Checkpoint& checkpoint) const {
  TriangleSoup soup;
  soup.positions.resize(header_.vertex_count);
  soup.triangles.resize(header_.face_count);
  const size_t position_bytes = soup.positions.size() * sizeof(Point);
  if (position_bytes != 0) {
    std::memcpy(soup.positions.data(), bytes_.data(), position_bytes);
  }
  if (!soup.triangles.empty()) {
    std::memcpy(soup.triangles.data(), bytes_.data() + position_bytes,
                soup.triangles.size() * sizeof(Triangle));
  }
  // Whoever sends arrays may have joined them already.
  if (header_.welding.kind == Welding::Kind::kWithin) {
    absl::Status status = JoinSeams(header_.welding, soup, checkpoint);
    if (!status.ok()) return status;
  }
  return soup;
}

absl::StatusOr<TriangleSoup> MeshUpload::ParseFile(
    const ReadLimits& limits) const {
  return ReadMesh(Bytes(), *header_.format, limits);
}

}  // namespace geodesic::server
