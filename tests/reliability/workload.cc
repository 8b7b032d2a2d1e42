#include "tests/reliability/workload.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "codec/answer_reader.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "geodesic/v1/question_service.pb.h"
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

constexpr char kUnreadable[] = "a message that cannot be parsed";

// Empty if they are a whole answer, which `reader` then has read.
std::string Read(const std::vector<std::string>& messages,
                 codec::AnswerReader& reader) {
  v1::Answer answer;
  for (const std::string& message : messages) {
    if (!answer.ParseFromString(message)) return kUnreadable;
    const absl::Status status = reader.Consume(answer);
    if (!status.ok()) return status.ToString();
  }
  return reader.has_trailer() ? "" : "no trailer";
}

std::string CheckDistances(const std::vector<std::string>& messages,
                           const codec::AnswerReader::Shape& shape,
                           const std::vector<double>& expected) {
  codec::AnswerReader reader;
  std::vector<double> distances;
  reader.Collect("distance", shape, &distances);
  const std::string wrong = Read(messages, reader);
  return wrong.empty() ? Compare(distances, expected) : wrong;
}

std::string CheckField(const std::vector<std::string>& messages,
                       const std::vector<double>& expected) {
  return CheckDistances(messages, {codec::AnswerReader::kVertices}, expected);
}

// Two lengths, and the first and the last point of the line.
std::string CheckPath(const std::vector<std::string>& messages,
                      const std::array<double, 2>& from,
                      const std::array<double, 2>& to) {
  codec::AnswerReader reader;
  std::vector<double> distances;
  std::vector<double> lengths;
  std::vector<Point> positions;
  reader.Collect("distance", {1}, &distances);
  reader.Collect("length", {1}, &lengths);
  reader.Collect("position", {codec::AnswerReader::kAny, 3}, &positions);
  const std::string wrong = Read(messages, reader);
  if (!wrong.empty()) return wrong;
  if (positions.empty()) return "no path";
  const Point& first = positions.front();
  const Point& last = positions.back();
  const double distance = Distance(from, to);
  return Compare(
      {distances[0], lengths[0], first[0], first[1], last[0], last[1]},
      {distance, distance, from[0], from[1], to[0], to[1]});
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
          OneMessage("/geodesic.v1.QuestionService/ComputeField", message),
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
          OneMessage("/geodesic.v1.QuestionService/ComputeField", message),
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
      OneMessage("/geodesic.v1.QuestionService/ComputePaths", message),
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
          OneMessage("/geodesic.v1.QuestionService/ComputeMatrix", message),
          [expected](const std::vector<std::string>& messages) {
            return CheckDistances(messages, {kRows, kColumns}, expected);
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
