// What a command says beside an answer that is right, and surely not what was
// wanted.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_NOTES_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_NOTES_H_

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "client/cli/commands/command.h"
#include "geodesic_types/places.h"

namespace geodesic::client {

// Says which sources are vertices of no face. Reads the mesh only if it has
// such vertices and sources are vertices. Errors: those of Client::GetMesh and
// Client::ReadMesh.
absl::StatusOr<std::vector<std::string>> NotesOnSources(
    const Session& session, const std::string& mesh_digest,
    std::span<const Source> sources);

// Why no path leads to each of `targets` whose distance is infinite, by
// Reach::WhyUnreached; empty for the others. Reads the mesh if there are such
// targets; if it cannot, `otherwise` is what it says of all. REQUIRES: as many
// targets as distances.
std::vector<std::string> WhyUnreached(const Session& session,
                                      const std::string& mesh_digest,
                                      std::span<const Source> sources,
                                      std::span<const SurfacePoint> targets,
                                      std::span<const double> distances,
                                      const std::string& otherwise);

// The last argument of WhyUnreached where a search has this limit, or none.
std::string BeyondRadius(std::optional<double> radius);

// Prints notes to standard error, where no summary holds them.
void PrintNotes(const Session& session, std::span<const std::string> notes);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_NOTES_H_
