#include "tests/reliability/workload.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "geodesic/v1/field_service.pb.h"
#include "geodesic/v1/matrix_service.pb.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "geodesic/v1/path_service.pb.h"
#include "geodesic_client/client.h"
#include "tests/integration/meshes.h"

namespace geodesic::client {
namespace {

constexpr size_t kCachedFields = 8;
constexpr uint32_t kUploadCells = 25;
constexpr size_t kUploadChunkBytes = size_t{64} << 10;
constexpr size_t kRows = 4;
constexpr size_t kColumns = 16;

double Distance(const std::array<double, 2>& a,
                const std::array<double, 2>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

bool IsNear(double value, double expected) {
  return std::abs(value - expected) <= 1e-9 * (1 + expected);
}

void AppendDoubles(const std::string& bytes, std::vector<double>& values) {
  const size_t old_size = values.size();
  values.resize(old_size + bytes.size() / sizeof(double));
  std::memcpy(values.data() + old_size, bytes.data(), bytes.size());
}

std::string Compare(const std::vector<double>& values,
                    const std::vector<double>& expected) {
  if (values.size() != expected.size()) {
    return absl::StrCat(values.size(), " values instead of ", expected.size());
  }
  for (size_t i = 0; i < values.size(); ++i) {
    if (IsNear(values[i], expected[i])) continue;
    return absl::StrCat("value ", i, " is ", values[i], " instead of ",
                        expected[i]);
  }
  return "";
}

// `take` gets each message; false if one cannot be parsed.
template <typename Response, typename Take>
bool ForEach(const std::vector<std::string>& messages, const Take& take) {
  Response response;
  for (const std::string& message : messages) {
    if (!response.ParseFromString(message)) return false;
    take(response);
  }
  return true;
}

constexpr char kUnreadable[] = "a message that cannot be parsed";

// `offset` is of a chunk's first value in `expected`, `bytes` are its values.
template <typename Response, typename Offset, typename Bytes>
std::string CheckChunks(const std::vector<std::string>& messages,
                        const std::vector<double>& expected,
                        const Offset& offset, const Bytes& bytes) {
  std::vector<double> values;
  bool in_order = true;
  bool has_trailer = false;
  const auto take = [&](const Response& response) {
    has_trailer = response.has_trailer();
    if (!response.has_chunk()) return;
    in_order &= offset(response.chunk()) == values.size();
    AppendDoubles(bytes(response.chunk()), values);
  };
  if (!ForEach<Response>(messages, take)) return kUnreadable;
  if (!in_order || !has_trailer) return "messages out of order";
  return Compare(values, expected);
}

std::string CheckField(const std::vector<std::string>& messages,
                       const std::vector<double>& expected) {
  return CheckChunks<v1::ComputeFieldResponse>(
      messages, expected, [](const auto& chunk) { return chunk.offset(); },
      [](const auto& chunk) { return chunk.distances(); });
}

std::string CheckMatrix(const std::vector<std::string>& messages,
                        const std::vector<double>& expected) {
  return CheckChunks<v1::ComputeMatrixResponse>(
      messages, expected,
      [](const auto& chunk) { return chunk.row() * kColumns + chunk.offset(); },
      [](const auto& chunk) { return chunk.values(); });
}

// Two lengths, and the first and the last point of the line.
std::string CheckPath(const std::vector<std::string>& messages,
                      const std::array<double, 2>& from,
                      const std::array<double, 2>& to) {
  const double distance = Distance(from, to);
  std::vector<double> values;
  std::vector<double> positions;
  const auto take = [&](const v1::ComputePathsResponse& response) {
    if (!response.has_path()) return;
    if (values.empty()) {
      values = {response.path().distance(), response.path().length()};
    }
    AppendDoubles(response.path().piece().positions(), positions);
  };
  if (!ForEach<v1::ComputePathsResponse>(messages, take)) return kUnreadable;
  if (positions.size() < 3) return "no path";
  values.insert(values.end(), positions.begin(), positions.begin() + 2);
  values.insert(values.end(), positions.end() - 3, positions.end() - 1);
  return Compare(values, {distance, distance, from[0], from[1], to[0], to[1]});
}

std::string CheckUpload(const std::vector<std::string>& messages,
                        const std::string& digest, uint64_t cells) {
  v1::CreateMeshResponse response;
  if (messages.size() != 1 || !response.ParseFromString(messages[0])) {
    return kUnreadable;
  }
  const v1::Mesh& mesh = response.mesh();
  const bool is_right = mesh.digest() == digest &&
                        mesh.vertex_count() == (cells + 1) * (cells + 1) &&
                        mesh.face_count() == 2 * cells * cells &&
                        mesh.edge_count() == 3 * cells * cells + 2 * cells &&
                        mesh.boundary_edge_count() == 4 * cells &&
                        !response.already_resident();
  return is_right ? "" : absl::StrCat("wrong mesh: ", mesh.ShortDebugString());
}

RawRequest OneMessage(const std::string& method,
                      const google::protobuf::MessageLite& message) {
  return {.method = method, .messages = {message.SerializeAsString()}};
}

}  // namespace

absl::StatusOr<Mix> ParseMix(const std::string& text) {
  Mix mix = {};
  for (const std::string& part :
       std::vector<std::string>(absl::StrSplit(text, ','))) {
    const std::vector<std::string> words = absl::StrSplit(part, '=');
    const auto kind =
        std::find(kQuestionNames.begin(), kQuestionNames.end(), words[0]);
    if (words.size() != 2 || kind == kQuestionNames.end() ||
        !absl::SimpleAtoi(words[1], &mix[kind - kQuestionNames.begin()])) {
      return absl::InvalidArgumentError(
          absl::StrCat("\"", part, "\" is not KIND=NUMBER"));
    }
  }
  if (std::all_of(mix.begin(), mix.end(), [](unsigned n) { return n == 0; })) {
    return absl::InvalidArgumentError("a mix of nothing");
  }
  return mix;
}

Workload::Workload(uint32_t vertices, uint64_t seed, std::string token)
    : cells_(static_cast<uint32_t>(std::lround(std::sqrt(vertices))) - 1),
      grid_(PlanarGrid(cells_)),
      digest_(MeshDigest(grid_)),
      seed_(seed),
      token_(std::move(token)),
      random_(seed) {
  for (size_t i = 0; i < kCachedFields; ++i) {
    cached_.push_back(DistancesFrom(At(i)));
  }
}

void Workload::Prepare(const std::string& address) const {
  Client client(address, {.token = token_});
  absl::Status status = client.UploadArrays(grid_).status();
  for (uint32_t vertex = 0; status.ok() && vertex < kCachedFields; ++vertex) {
    status = client
                 .ComputeField({.mesh_digest = digest_,
                                .sources = {{VertexPoint{vertex}}}})
                 .status();
  }
  if (!status.ok()) throw std::runtime_error(status.ToString());
}

Question Workload::Next(QuestionKind kind) {
  Question question = Make(kind);
  question.request.token = token_;
  return question;
}

Question Workload::Make(QuestionKind kind) {
  switch (kind) {
    case QuestionKind::kUpload:
      return Upload(kUploadCells, kUploadChunkBytes);
    case QuestionKind::kCold:
      return ColdField();
    case QuestionKind::kCached:
      return CachedField();
    case QuestionKind::kPath:
      return Path();
    case QuestionKind::kMatrix:
      return Matrix();
  }
  return {};
}

Question Workload::Upload(uint32_t cells, size_t chunk_bytes) {
  MeshArrays mesh = PlanarGrid(cells);
  // The seed too, for a server may outlive a load.
  const double scale =
      1 + 1e-3 * static_cast<double>(++uploads_) + static_cast<double>(seed_);
  for (Point& p : mesh.positions) p[0] *= scale;
  const std::string digest = MeshDigest(mesh);
  std::string bytes(reinterpret_cast<const char*>(mesh.positions.data()),
                    mesh.positions.size() * sizeof(Point));
  bytes.append(reinterpret_cast<const char*>(mesh.triangles.data()),
               mesh.triangles.size() * sizeof(Triangle));

  RawRequest request = {.method = "/geodesic.v1.MeshService/CreateMesh"};
  v1::CreateMeshRequest message;
  v1::UploadHeader& header = *message.mutable_header();
  header.set_format(v1::MESH_FORMAT_ARRAYS);
  header.set_size_bytes(bytes.size());
  header.set_vertex_count(mesh.positions.size());
  header.set_face_count(mesh.triangles.size());
  header.set_expected_digest(digest);
  request.messages.push_back(message.SerializeAsString());
  for (size_t offset = 0; offset < bytes.size(); offset += chunk_bytes) {
    message.mutable_chunk()->set_offset(offset);
    message.mutable_chunk()->set_data(bytes.substr(offset, chunk_bytes));
    request.messages.push_back(message.SerializeAsString());
  }
  return {QuestionKind::kUpload, std::move(request),
          [digest, cells](const std::vector<std::string>& messages) {
            return CheckUpload(messages, digest, cells);
          }};
}

Question Workload::ColdField() {
  // Inside the lower face of a cell: corner, the one to its right, and the one
  // above that.
  std::uniform_real_distribution<double> part(0.05, 0.45);
  const double right = part(random_);
  const double above = part(random_);
  const uint64_t column = random_() % cells_;
  const uint64_t row = random_() % cells_;
  const double size = 1.0 / cells_;
  const Place place = {(static_cast<double>(column) + right + above) * size,
                       (static_cast<double>(row) + above) * size};
  v1::ComputeFieldRequest message;
  message.set_mesh_digest(digest_);
  v1::FacePoint& point = *message.add_sources()->mutable_face();
  point.set_face(2 * (column + row * cells_));
  point.add_weights(1 - right - above);
  point.add_weights(right);
  point.add_weights(above);
  return {QuestionKind::kCold,
          OneMessage("/geodesic.v1.FieldService/ComputeField", message),
          [this, place](const std::vector<std::string>& messages) {
            return CheckField(messages, DistancesFrom(place));
          }};
}

Question Workload::CachedField() {
  const uint64_t vertex = random_() % cached_.size();
  v1::ComputeFieldRequest message;
  message.set_mesh_digest(digest_);
  message.add_sources()->set_vertex(vertex);
  return {QuestionKind::kCached,
          OneMessage("/geodesic.v1.FieldService/ComputeField", message),
          [this, vertex](const std::vector<std::string>& messages) {
            return CheckField(messages, cached_[vertex]);
          }};
}

Question Workload::Path() {
  const uint64_t from = AnyVertex();
  const uint64_t to = AnyVertex();
  v1::ComputePathsRequest message;
  message.set_mesh_digest(digest_);
  message.add_sources()->set_vertex(from);
  message.add_targets()->set_vertex(to);
  return {
      QuestionKind::kPath,
      OneMessage("/geodesic.v1.PathService/ComputePaths", message),
      [from = At(from), to = At(to)](const std::vector<std::string>& messages) {
        return CheckPath(messages, from, to);
      }};
}

Question Workload::Matrix() {
  v1::ComputeMatrixRequest message;
  message.set_mesh_digest(digest_);
  std::vector<uint64_t> sources(kRows);
  std::vector<uint64_t> targets(kColumns);
  for (uint64_t& vertex : sources) {
    message.add_sources()->set_vertex(vertex = AnyVertex());
  }
  for (uint64_t& vertex : targets) {
    message.add_targets()->set_vertex(vertex = AnyVertex());
  }
  std::vector<double> expected;
  for (const uint64_t source : sources) {
    for (const uint64_t target : targets) {
      expected.push_back(Distance(At(source), At(target)));
    }
  }
  return {QuestionKind::kMatrix,
          OneMessage("/geodesic.v1.MatrixService/ComputeMatrix", message),
          [expected](const std::vector<std::string>& messages) {
            return CheckMatrix(messages, expected);
          }};
}

uint64_t Workload::AnyVertex() { return random_() % grid_.positions.size(); }

Workload::Place Workload::At(uint64_t vertex) const {
  return {grid_.positions[vertex][0], grid_.positions[vertex][1]};
}

std::vector<double> Workload::DistancesFrom(const Place& place) const {
  std::vector<double> distances;
  distances.reserve(grid_.positions.size());
  for (const Point& p : grid_.positions) {
    distances.push_back(Distance({p[0], p[1]}, place));
  }
  return distances;
}

}  // namespace geodesic::client
