// Clients that upload, ask and delete, and write down what was acknowledged:
// what a server must have, may have and must not have.

#ifndef GEODESIC_TESTS_RELIABILITY_MIXED_LOAD_H_
#define GEODESIC_TESTS_RELIABILITY_MIXED_LOAD_H_

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
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

// Compares everything that the server has with the ledger: what must be there
// is listed and comes back bit by bit, what must not be is unknown to every
// RPC, and what may be is whole if it is there. Then the ledger knows the
// states. Returns what is wrong, a line each.
std::vector<std::string> CheckLedger(Client& client,
                                     std::vector<LedgerMesh>& ledger);

struct LoadCounts {
  std::atomic<uint64_t> uploads = 0;
  std::atomic<uint64_t> deletions = 0;
  std::atomic<uint64_t> fields = 0;
  std::atomic<uint64_t> reads = 0;
  // Uploads and deletions without an answer, for the server was gone.
  std::atomic<uint64_t> unanswered = 0;
};

// Starts the clients, each with a connection of its own and its share of the
// ledger to upload and delete; they ask about all of it.
class MixedLoad {
 public:
  // Adds to `counts`. REQUIRES: `ledger` and `counts` outlive the object;
  // `ledger` is left alone until Join.
  MixedLoad(const std::string& address, std::vector<LedgerMesh>& ledger,
            LoadCounts& counts, size_t clients, uint64_t seed);

  // Waits until the clients together have had so many answers, or all of them
  // have noticed that the server is gone.
  void AwaitAnswers(uint64_t answers);

  // To be called just before the server is killed: from now on calls may fail.
  void ExpectDeath() { is_dying_ = true; }

  // Waits until every client has noticed that the server is gone.
  void Join();

  // What the server answered wrongly. Call after Join.
  const std::vector<std::string>& wrong() const { return wrong_; }

 private:
  void Run(const std::string& address, size_t number, uint64_t seed);
  // Both return false when the server is gone.
  bool Change(Client& client, LedgerMesh& mesh);
  bool Ask(Client& client, const LedgerMesh& mesh, bool is_own,
           uint64_t random);
  // Whether the server is gone; anything else is wrong.
  bool IsGone(const absl::Status& status, const std::string& what);
  void Report(const std::string& fault);

  std::vector<LedgerMesh>& ledger_;
  LoadCounts& counts_;
  const size_t clients_;
  std::atomic<bool> is_dying_ = false;

  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_:
  uint64_t answers_ = 0;
  size_t running_;
  std::vector<std::string> wrong_;

  std::vector<std::thread> threads_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_MIXED_LOAD_H_
