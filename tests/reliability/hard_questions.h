// Meshes that are hard for some part of the server, and questions of every kind
// that the protocol has, for laws that hold for all of them.

#ifndef GEODESIC_TESTS_RELIABILITY_HARD_QUESTIONS_H_
#define GEODESIC_TESTS_RELIABILITY_HARD_QUESTIONS_H_

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/triangle_soup.h"
#include "geodesic_client/client.h"
#include "tests/support/random.h"

namespace geodesic::client {

struct HardMesh {
  std::string name;
  // Makes it; empty for a file.
  std::function<TriangleSoup()> make;
  std::string path;
};

// Those that tests make, large ones of up to `faces` faces, and the files of
// the test meshes' folders hostile and flat_saddles, if there are any.
std::vector<HardMesh> HardMeshes(uint32_t faces);

// What a question is about.
struct Subject {
  MeshArrays arrays;  // empty for a file
  std::string path;   // of a file of the mesh
  MeshInfo info;      // once it was uploaded

  // As it is: nothing of what was made is joined.
  absl::StatusOr<UploadOutcome> Upload(Client& client,
                                       const CallOptions& options) const;
};

struct HardQuestion {
  std::string name;
  // Asks it, with places drawn at random.
  std::function<absl::Status(Client&, const Subject&, test::Random&,
                             const CallOptions&)>
      ask;
  // Whether it uploads the mesh, which must not be there, and deletes it.
  bool is_upload = false;
  // Whether it searches for targets. Then the server may keep the search for a
  // while, and make landmarks when the question has ended.
  bool searches = false;
};

std::vector<HardQuestion> HardQuestions();

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_HARD_QUESTIONS_H_
