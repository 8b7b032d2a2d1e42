// Names a mesh and asks a server that is not there, with the installed library.

#include <chrono>
#include <cstdio>
#include <string>

#include "geodesic_client/client.h"

int main() {
  using namespace geodesic::client;
  const MeshArrays triangle = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::string digest = MeshDigest(triangle);
  std::printf("%s\n", digest.c_str());
  if (!IsMeshDigest(digest)) return 1;

  // Nothing listens on port 1.
  Client client("127.0.0.1:1");
  const FieldQuery query = {.mesh_digest = digest,
                            .sources = {{VertexPoint{0}}}};
  const absl::Status status =
      client.ComputeField(query, {.timeout = std::chrono::seconds(60)})
          .status();
  std::printf("%s\n", status.ToString().c_str());
  return absl::IsUnavailable(status) ? 0 : 1;
}
