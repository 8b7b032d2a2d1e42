// Questions whose answers are known without asking: the meshes are plane, so
// distances are Euclid's.

#ifndef GEODESIC_TESTS_RELIABILITY_WORKLOAD_H_
#define GEODESIC_TESTS_RELIABILITY_WORKLOAD_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic_client/mesh.h"
#include "tests/reliability/raw_call.h"

namespace geodesic::client {

enum class QuestionKind : uint8_t { kUpload, kCold, kCached, kPath, kMatrix };

inline constexpr std::array kQuestionNames = {"upload", "cold", "cached",
                                              "path", "matrix"};
inline constexpr size_t kQuestionKinds = kQuestionNames.size();

// How many of each kind among their sum, by kind.
using Mix = std::array<unsigned, kQuestionKinds>;

// From "cached=5,cold=2"; what is not named does not come.
// Errors: INVALID_ARGUMENT naming what is wrong.
absl::StatusOr<Mix> ParseMix(const std::string& text);

struct Question {
  QuestionKind kind = QuestionKind::kCached;
  RawRequest request;
  // Empty if these messages are the right answer, else what is wrong with them.
  // Thread-safe; the workload outlives it.
  std::function<std::string(const std::vector<std::string>&)> check;
};

// Makes questions of each kind:
//   upload   a mesh of 1,250 faces that was never there before
//   cold     a field from a point that was never a source
//   cached   one of a few fields that Prepare has had computed
//   path     between two vertices
//   matrix   4 x 16 distances between vertices
// all but the first on a grid of some `vertices` vertices. Not thread-safe.
class Workload {
 public:
  // What Next makes shows the token, if there is one.
  Workload(uint32_t vertices, uint64_t seed, std::string token = {});

  // Uploads the grid and has the fields computed that are to be cached.
  // Errors: throws std::runtime_error.
  void Prepare(const std::string& address) const;

  Question Next(QuestionKind kind);

  // The upload of a new mesh of 8 faces, a byte a message.
  Question UploadByteByByte() { return Upload(2, 1); }

 private:
  using Place = std::array<double, 2>;

  Question Make(QuestionKind kind);
  // Of a grid of so many cells a side, in chunks of so many bytes.
  Question Upload(uint32_t cells, size_t chunk_bytes);
  Question ColdField();
  Question CachedField();
  Question Path();
  Question Matrix();
  uint64_t AnyVertex();
  Place At(uint64_t vertex) const;
  std::vector<double> DistancesFrom(const Place& place) const;

  const uint32_t cells_;
  const MeshArrays grid_;
  const std::string digest_;
  const uint64_t seed_;
  const std::string token_;
  std::mt19937_64 random_;
  uint64_t uploads_ = 0;
  // Of the fields that are cached; by vertex, the source's.
  std::vector<std::vector<double>> cached_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_WORKLOAD_H_
