// Clients that ask much of a server and behave badly: readers that stall,
// uploads one after another, and hard questions whose deadlines are short.
// Their tokens are "reader", "uploader" and "asker".

#ifndef GEODESIC_TESTS_RELIABILITY_DISTURBERS_H_
#define GEODESIC_TESTS_RELIABILITY_DISTURBERS_H_

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "tests/reliability/hard_questions.h"
#include "tests/reliability/raw_call.h"
#include "tests/support/random.h"

namespace geodesic::client {

inline constexpr size_t kReaders = 10;
inline constexpr size_t kUploaders = 2;

class Disturbers {
 public:
  // Has the fields computed that readers ask for. `send_seconds` is the
  // server's limit. Errors: throws std::runtime_error.
  Disturbers(const std::string& address, int send_seconds, uint64_t seed);

  // Uploads the hard meshes; then, until Stop,
  //   readers ask for a field of 700 KB, take its first message, and look on
  //     only after the limit, when the server has ended it; then they ask
  //     again;
  //   uploaders upload a new mesh of 5,000 faces as soon as the last one is
  //     there;
  //   one client asks every kind of question about the hard meshes, one after
  //     another, each with a deadline of 20 ms to 1.5 s.
  // Errors: throws std::runtime_error.
  void Start();
  // Returns once all of them have gone, and the hard meshes, for which the
  // server would make landmarks for minutes. Errors: as Start.
  void Stop();

  // How many calls of which kind ended how, those that Stop ended in a line of
  // their own. Call while they are stopped, as Faults.
  nlohmann::ordered_json Summary() const { return ended_; }
  // Of calls that ended otherwise than by an answer, a deadline, a cancellation
  // or a refusal: the first, in words.
  const std::vector<std::string>& Faults() const { return faults_; }

 private:
  void Read(const std::stop_token& stop, const RawRequest& request);
  void Upload(const std::stop_token& stop);
  void Ask(const std::stop_token& stop);
  void Note(const std::stop_token& stop, const std::string& what,
            const absl::Status& status);

  const std::string address_;
  const int send_seconds_;
  test::Random random_;  // of who asks
  std::vector<Subject> subjects_;
  std::vector<RawRequest> reads_;
  std::atomic<uint64_t> uploads_ = 0;

  std::mutex mutex_;
  // Guarded by mutex_: by what was asked, then by code.
  std::map<std::string, std::map<std::string, uint64_t>> ended_;
  std::vector<std::string> faults_;

  std::vector<std::jthread> threads_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_DISTURBERS_H_
