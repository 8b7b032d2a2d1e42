// Clients that upload, ask and delete, and write down what was acknowledged.

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

#include "tests/reliability/mesh_ledger.h"

namespace geodesic::client {

struct LoadCounts {
  uint64_t uploads = 0;
  uint64_t deletions = 0;
  uint64_t fields = 0;
  uint64_t reads = 0;
  // Uploads and deletions without an answer, for the server was gone.
  uint64_t unanswered = 0;

  LoadCounts& operator+=(const LoadCounts& other);
};

// Starts the clients, each with a connection of its own and its share of the
// ledger to upload and delete; they ask about all of it.
class MixedLoad {
 public:
  // REQUIRES: `ledger` outlives the object and is left alone until Join.
  MixedLoad(const std::string& address, std::vector<LedgerMesh>& ledger,
            size_t clients, uint64_t seed);

  // Waits until the clients together have had so many answers, or all of them
  // have noticed that the server is gone.
  void AwaitAnswers(uint64_t answers);

  // To be called just before the server is killed: from now on calls may fail.
  void ExpectDeath() { is_dying_ = true; }

  // Waits until every client has noticed that the server is gone.
  LoadCounts Join();

  // What the server answered wrongly. Call after Join.
  const std::vector<std::string>& wrong() const { return wrong_; }

 private:
  void Run(const std::string& address, size_t number, uint64_t seed);
  // Both return false when the server is gone.
  bool Change(Client& client, LedgerMesh& mesh, LoadCounts& counts);
  bool Ask(Client& client, const LedgerMesh& mesh, bool is_own, uint64_t random,
           LoadCounts& counts);
  // Whether the server is gone; anything else is wrong.
  bool IsGone(const absl::Status& status, const std::string& what);
  void Report(const std::string& fault);

  std::vector<LedgerMesh>& ledger_;
  const size_t clients_;
  std::atomic<bool> is_dying_ = false;

  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_:
  uint64_t answers_ = 0;
  size_t running_;
  LoadCounts counts_;
  std::vector<std::string> wrong_;

  std::vector<std::thread> threads_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_MIXED_LOAD_H_
