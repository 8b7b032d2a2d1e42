// Questions about a file's mesh, whether or not the server still has it.

#ifndef GEODESIC_CLIENT_ASK_ABOUT_FILE_H_
#define GEODESIC_CLIENT_ASK_ABOUT_FILE_H_

#include <string>
#include <type_traits>

#include "geodesic_client/client.h"
#include "geodesic_client/errors.h"

namespace geodesic::client {

// Uploads the file unless the server has it, and calls `ask` with the mesh's
// digest. A server short of memory may evict a mesh in between: it is then
// uploaded again and asked about once more.
//
//   absl::StatusOr<Field> field =
//       AskAboutFile(client, "horse.ply", [&](const std::string& digest) {
//         return client.ComputeField({.mesh_digest = digest,
//                                     .sources = {{VertexPoint{0}}}});
//       });
//
// `ask` returns an absl::StatusOr; this returns the last one, or why the upload
// failed. Errors: as Client::UploadFile and `ask`.
template <typename Ask>
std::invoke_result_t<Ask, const std::string&> AskAboutFile(
    Client& client, const std::string& path, Ask ask,
    const CallOptions& options = {}) {
  for (bool is_again = false;; is_again = true) {
    absl::StatusOr<UploadOutcome> upload = client.UploadFile(path, options);
    if (!upload.ok()) return upload.status();
    auto answer = ask(upload->mesh.digest);
    if (is_again || ErrorReason(answer.status()) != "MESH_NOT_RESIDENT") {
      return answer;
    }
  }
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ASK_ABOUT_FILE_H_
