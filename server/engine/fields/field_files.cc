#include "server/engine/fields/field_files.h"

#include <array>
#include <span>
#include <stop_token>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "geodesic_types/algorithms.h"
#include "server/engine/base/binary_codec.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

// At most this many fields wait to be written; more are dropped, because a slow
// disk must not hold up the solvers.
constexpr size_t kMaxWaiting = 64;

static_assert(sizeof(Arrival) == 24, "arrivals are kept as they lie in memory");

void Encode(const SurfacePoint& point, BinaryWriter& writer) {
  writer.Put(static_cast<uint32_t>(point.index()));
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    writer.Put(vertex->vertex);
  } else if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    writer.Put(edge->from);
    writer.Put(edge->to);
    writer.Put(edge->t);
  } else {
    const auto& face = std::get<FacePoint>(point);
    writer.Put(face.face);
    for (const double weight : face.weights) writer.Put(weight);
  }
}

void Encode(const std::vector<SurfacePoint>& points, BinaryWriter& writer) {
  writer.Put(uint64_t{points.size()});
  for (const SurfacePoint& point : points) Encode(point, writer);
}

void Encode(const Curve& curve, BinaryWriter& writer) {
  Encode(curve.points, writer);
}

// Calls `visit` for each number of the statistics, in the order of the file.
template <typename Statistics, typename Visit>
void VisitNumbers(Statistics& statistics, Visit visit) {
  visit(statistics.iterations);
  visit(statistics.windows_created);
  visit(statistics.windows_propagated);
  visit(statistics.peak_wavefront);
  visit(statistics.mean_wavefront);
  visit(statistics.peak_windows);
  visit(statistics.pseudo_source_events);
  visit(statistics.peak_solver_bytes);
  visit(statistics.solve_seconds);
}

// Everything in the file but the arrays.
struct Metadata {
  std::string mesh_digest;
  bool has_arrivals = false;
  uint64_t layout = 0;  // of the mesh, where arrivals depend on it
  uint64_t targets = 0;
  // Of a field within a tolerance; 0: all distances are exact.
  double certified_error = 0;
  double settled_radius = 0;
  std::string algorithm;
  SolveStatistics statistics;
};

// A hash of how half-edges, which arrivals name, are numbered and placed. O(F).
uint64_t LayoutOf(const Mesh& mesh) {
  constexpr uint64_t kPrime = 0x100000001b3;  // FNV-1a's
  uint64_t hash = 0xcbf29ce484222325;
  for (uint32_t face = 0; face < mesh.face_count(); ++face) {
    const HalfEdge first = mesh.FirstSide(face);
    hash = (hash ^ first) * kPrime;
    hash = (hash ^ mesh.From(first)) * kPrime;
  }
  return hash;
}

std::string Encode(const FieldKey& key, const Mesh& mesh,
                   const DistanceField& field) {
  BinaryWriter writer;
  writer.Put(kFieldRecord);
  writer.PutString(key.mesh_digest);
  writer.Put(!field.arrivals.empty());
  writer.Put(field.arrivals.empty() ? 0 : LayoutOf(mesh));
  writer.Put(uint64_t{field.target_distances.size()});
  writer.Put(field.certified_error);
  writer.Put(field.settled_radius);
  const std::string_view algorithm = AlgorithmName(field.algorithm);
  writer.PutString(algorithm);
  VisitNumbers(field.statistics, [&](auto number) { writer.Put(number); });
  return writer.bytes();
}

std::array<std::string_view, 6> Body(const DistanceField& field) {
  const bool is_exact = field.certified_error == 0;
  return {AsBytes(field.distances),
          AsBytes(field.target_distances),
          AsBytes(field.arrivals),
          AsBytes(field.target_arrivals),
          is_exact ? "" : AsBytes(field.certified_errors),
          is_exact ? "" : AsBytes(field.target_certified_errors)};
}

// Empty if the metadata is another record.
std::optional<Metadata> Decode(std::string_view bytes) {
  return DecodeRecord<Metadata>(
      bytes, kFieldRecord, [](BinaryReader& reader, Metadata& metadata) {
        reader.GetString(metadata.mesh_digest);
        reader.Get(metadata.has_arrivals);
        reader.Get(metadata.layout);
        reader.Get(metadata.targets);
        reader.Get(metadata.certified_error);
        reader.Get(metadata.settled_radius);
        reader.GetString(metadata.algorithm);
        VisitNumbers(metadata.statistics,
                     [&](auto& number) { reader.Get(number); });
      });
}

// Whether the field may hold what is asked for. Only the field itself tells
// whether its targets are certified.
bool MayCover(const Metadata& metadata, const FieldReach& reach) {
  return reach.LimitsTargets() || metadata.settled_radius >= reach.radius;
}

template <typename T>
absl::Status ReadArray(BlobBody& body, size_t count, std::vector<T>& values) {
  if (body.bytes_left() / sizeof(T) < count) {
    return absl::DataLossError("the arrays are shorter than the mesh");
  }
  values.resize(count);
  return body.Read(AsWritableBytes(values));
}

}  // namespace

std::string FieldFiles::NameOf(const FieldKey& key) const {
  // Whatever is added to these has to be named here, too: else one field would
  // be read for another.
  const auto& [mesh_digest, checked, bucket_width, max_batch, method] = key;
  const auto& [sources, targets, algorithm, trace, tolerance] = *checked;
  BinaryWriter writer;
  writer.PutString("geodesic.field.v2");
  writer.PutString(version_);
  writer.PutString(mesh_digest);
  writer.Put(uint64_t{sources.size()});
  for (const Source& source : sources) {
    const auto& [place, offset] = source;
    writer.Put(IsCurve(source));
    std::visit([&](const auto& one) { Encode(one, writer); }, place);
    writer.Put(offset);
  }
  Encode(targets, writer);
  writer.PutString(AlgorithmName(algorithm));
  writer.Put(trace);
  writer.Put(bucket_width);
  writer.Put(max_batch);
  if (tolerance > 0) {
    writer.PutString("tolerance");
    writer.Put(tolerance);
  }
  if (method.has_value()) {
    const auto& [kind, lambda, neighbours, samples] = *method;
    writer.PutString(ApproximateMethodName(kind));
    writer.Put(lambda);
    writer.Put(neighbours);
    writer.Put(samples);
  }
  return Sha256Hex(writer.bytes());
}

std::optional<FieldKey> FieldFiles::Find(const FieldKey& key,
                                         const FieldReach& reach) {
  std::optional<FieldKey> found;
  VisitAnsweringKeys(key, [&](const FieldKey& candidate) {
    const std::optional<BlobInfo> info = blobs_.Find(NameOf(candidate));
    const std::optional<Metadata> metadata =
        info ? Decode(info->metadata) : std::nullopt;
    if (metadata && MayCover(*metadata, reach)) found = candidate;
    return found.has_value();
  });
  return found;
}

absl::Status FieldFiles::Put(const FieldKey& key, const Mesh& mesh,
                             const DistanceField& field) {
  const std::string name = NameOf(key);
  if (const std::optional<BlobInfo> present = blobs_.Find(name)) {
    const std::optional<Metadata> metadata = Decode(present->metadata);
    if (metadata && metadata->settled_radius >= field.settled_radius) {
      return absl::OkStatus();
    }
  }
  return blobs_.Keep(name, Encode(key, mesh, field), Body(field));
}

void FieldFiles::Share(const FieldKey& key, const Mesh& mesh,
                       const DistanceField& field) {
  if (!has_shared()) return;
  blobs_.Share(NameOf(key), Encode(key, mesh, field), Body(field));
}

absl::StatusOr<FieldFiles::Stored> FieldFiles::Load(const FieldKey& key,
                                                    const FieldReach& reach,
                                                    const Mesh& mesh) {
  const uint64_t vertices = mesh.vertex_count();
  const uint64_t targets = key.query->targets.size();
  Stored stored;
  const auto take = [&](std::string_view bytes,
                        BlobBody& body) -> absl::Status {
    const std::optional<Metadata> metadata = Decode(bytes);
    if (!metadata || metadata->targets != targets ||
        !MayCover(*metadata, reach) ||
        (metadata->has_arrivals && metadata->layout != LayoutOf(mesh))) {
      return absl::NotFoundError("the field that is kept is of no use here");
    }
    const absl::StatusOr<Algorithm> algorithm =
        AlgorithmFromName(metadata->algorithm);
    if (!algorithm.ok()) return algorithm.status();
    stored.field = {.settled_radius = metadata->settled_radius,
                    .certified_error = metadata->certified_error,
                    .algorithm = *algorithm,
                    .statistics = metadata->statistics};
    DistanceField& field = stored.field;
    absl::Status read;
    const auto get = [&](uint64_t count, auto& values) {
      if (read.ok()) read = ReadArray(body, count, values);
    };
    get(vertices, field.distances);
    get(targets, field.target_distances);
    if (metadata->has_arrivals) {
      get(vertices, field.arrivals);
      get(targets, field.target_arrivals);
    }
    if (metadata->certified_error > 0) {
      get(vertices, field.certified_errors);
      get(targets, field.target_certified_errors);
    }
    return read;
  };
  const absl::StatusOr<BlobTier> from = blobs_.Read(NameOf(key), take);
  if (!from.ok()) return from.status();
  stored.from = *from;
  return stored;
}

void FieldFiles::EraseMesh(const std::string& digest) {
  blobs_.EraseIf([&](std::string_view metadata) {
    const std::optional<Metadata> decoded = Decode(metadata);
    return decoded && decoded->mesh_digest == digest;
  });
}

void FieldWriter::Enqueue(const FieldKey& key, const MeshHandle& mesh,
                          const FieldHandle& field) {
  MutexLock lock(mutex_);
  if (waiting_.size() >= kMaxWaiting) return;
  waiting_.push_back({key, mesh, field});
  if (!has_job_) SubmitJob();
}

void FieldWriter::SubmitJob() {
  has_job_ = scheduler_
                 .Submit({.priority = JobPriority::kStore,
                          .is_continuation = true,
                          .waits_for_disk = [] { return true; },
                          .run = [this](const std::stop_token&) { WriteOne(); },
                          .abandon = [](const absl::Status&) {}})
                 .ok();
  // The server is stopping, so nobody will ask for these.
  if (!has_job_) waiting_.clear();
}

void FieldWriter::WriteOne() {
  const Item item = [this] {
    MutexLock lock(mutex_);
    Item first = std::move(waiting_.front());
    waiting_.pop_front();
    return first;
  }();
  const MeshHandle mesh = item.mesh.lock();
  const FieldHandle field = item.field.lock();
  if (mesh != nullptr && field != nullptr) {
    // A full disk does not hurt queries; uploads report it.
    (void)Guarded("kept a field",
                  [&] { return files_.Put(item.key, *mesh->mesh, *field); });
    // See FieldEngine::Keep.
    if (!meshes_.Contains(mesh->digest)) files_.EraseMesh(mesh->digest);
  }
  MutexLock lock(mutex_);
  has_job_ = false;
  if (!waiting_.empty()) SubmitJob();
}

}  // namespace geodesic::server
