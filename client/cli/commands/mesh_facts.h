// What is said about meshes.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_MESH_FACTS_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_MESH_FACTS_H_

#include <string>
#include <vector>

#include "client/cli/terminal/text.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

// "3", or "none".
std::string Genus(const MeshInfo& mesh);

// All that is known, a line each.
std::vector<Fact> FactsOf(const MeshInfo& mesh);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_MESH_FACTS_H_
