// What a server must have, may have and must not have, by what it has
// acknowledged.

#ifndef GEODESIC_TESTS_RELIABILITY_MESH_LEDGER_H_
#define GEODESIC_TESTS_RELIABILITY_MESH_LEDGER_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "geodesic_client/client.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

// A mesh of the load. Only one client uploads and deletes it, so what happened
// to it has an order.
struct LedgerMesh {
  enum class State {
    kPresent,  // an upload was acknowledged, no deletion begun since
    kAbsent,   // a deletion was acknowledged, or there never was an upload
    kEither,   // an upload or a deletion had no answer
  };

  MeshArrays arrays;
  std::string digest;
  State state = State::kAbsent;
};

// `count` planar grids of different sizes and shapes, whose distances are
// Euclid's.
std::vector<LedgerMesh> MakeLedger(size_t count);

// Empty if the field from this vertex is the right one, else what is wrong.
std::string CheckField(const LedgerMesh& mesh, uint64_t source,
                       const Field& field);

// Compares everything that the server has with the ledger: what must be there
// is listed and comes back bit by bit, what must not be is unknown to every
// RPC, and what may be is whole if it is there. Then the ledger knows the
// states. Returns what is wrong, a line each.
std::vector<std::string> CheckLedger(Client& client,
                                     std::vector<LedgerMesh>& ledger);

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_MESH_LEDGER_H_
