// Blobs in Redis, a second tier of memory that several servers share.
//
// An outage is a miss. Whatever Redis does, a question loses at most `patience`
// for each kRedisPieceBytes of what it reads:
//   1. connections are made, and values are written, by a thread of the tier's
//      own; a question finds a connection that is open, or does not ask;
//   2. an answer that does not come in time closes its connection. After
//      kMostFailures in a row Redis is left alone for kSilence, then tried by
//      that thread, and asked again once it has answered;
//   3. what waits to be written is bounded in bytes; the oldest gives way.
//
// A value is believed only if every digest in it agrees. One that is wrong is
// deleted, and counts as not there. Digests show damage, not malice: whoever
// may write to Redis may say what distances are (docs/operations.md).
//
// The key is kRedisPrefix and the blob's name. The value:
//   header    as in blob_format.h, with the kind "shared"
//   metadata  comes first, so that one answer tells whether the rest is wanted
//   body

#ifndef GEODESIC_SERVER_TIER_REDIS_BLOBS_H_
#define GEODESIC_SERVER_TIER_REDIS_BLOBS_H_

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "server/locks/mutex.h"
#include "server/store/blobs.h"
#include "server/tier/redis_connection.h"

namespace geodesic::server {

// The number is that of the value's format.
inline constexpr std::string_view kRedisPrefix = "geodesic:1:";

// Large enough to read at the network's speed, small enough to come well within
// a few milliseconds.
inline constexpr size_t kRedisPieceBytes = size_t{256} << 10;

// How often things have happened since the start.
struct RedisCounters {
  // Of questions that may have been spared work:
  uint64_t hits = 0;
  uint64_t misses = 0;    // there is no such value, or it is of no use
  uint64_t failures = 0;  // no answer in time, or an error
  uint64_t wrong = 0;     // a value whose digests do not agree
  uint64_t skipped = 0;   // not asked, because no connection was free
  // Of values:
  uint64_t writes = 0;
  uint64_t write_failures = 0;  // Redis refused, or did not answer
  uint64_t dropped = 0;         // too large, too many, or nobody to write to

  uint64_t bytes_read = 0;
  uint64_t bytes_written = 0;
};

class RedisBlobs final : public Blobs {
 public:
  struct Options {
    // HOST:PORT or unix:PATH.
    std::string address;
    // Of each answer that a question waits for.
    std::chrono::milliseconds patience{5};
    // After so long Redis forgets a value.
    std::chrono::seconds expiry{86400};
    // Of one value, and of all that wait to be written, together.
    uint64_t max_bytes = uint64_t{32} << 20;
    // As many as may ask at once.
    size_t connections = 1;
    // The password of now; empty: none.
    std::function<std::string()> password = [] { return std::string(); };
    // Is called with a line for people when Redis is left alone, and when it is
    // back.
    std::function<void(const std::string& line)> tell = [](const std::string&) {
    };
  };

  static constexpr int kMostFailures = 3;
  static constexpr std::chrono::seconds kSilence{5};

  // Returns at once; Redis is asked when it has answered for the first time.
  explicit RedisBlobs(Options options);

  // Waits for what its thread is doing, a few milliseconds, or as long as the
  // system looks a host's name up.
  ~RedisBlobs() override;

  // If `take` fails with CANCELLED it has seen enough, which counts as nothing.
  absl::Status Read(const std::string& name, TakeBlob take) override;

  // Whether it may be written now.
  absl::Status Admit(uint64_t body_bytes, uint64_t metadata_bytes) override;

  // Returns when the value has been copied; writing it may fail.
  absl::Status Put(const std::string& name, std::string_view metadata,
                   std::span<const std::string_view> body) override;

  RedisCounters counters() const;
  bool is_left_alone() const;
  uint64_t waiting_bytes() const;

 private:
  using Connection = std::unique_ptr<RedisConnection>;
  using Time = std::chrono::steady_clock::time_point;

  // Something for the thread to do.
  struct Task {
    std::string name;
    // To be written; otherwise what is there under the name is deleted.
    bool has_value = false;
    std::string metadata;
    std::string body;

    uint64_t bytes() const {
      return has_value ? metadata.size() + body.size() : name.size();
    }
  };

  // A connection that nobody uses; null if Redis is not to be asked now.
  Connection TakeConnection();
  void GiveBack(Connection connection);
  // A connection in use has failed, and is gone.
  void Failed(const absl::Status& why);
  // Read on a connection. `is_lost` becomes true if that has failed.
  absl::Status ReadOn(RedisConnection& connection, const std::string& name,
                      TakeBlob take, bool& is_lost);
  void Enqueue(Task task);
  void Count(uint64_t RedisCounters::*event, uint64_t times = 1);

  // The thread.
  void Run(const std::stop_token& stop);
  // Waits for something to do. False when the server ends.
  bool Await(const std::stop_token& stop);
  void Connect(const std::stop_token& stop);
  // `writer` is null, or the thread's own connection.
  void Do(const Task& task, Connection& writer, const std::stop_token& stop);
  void LeaveAlone(const absl::Status& why);

  const Options options_;

  mutable Mutex mutex_;
  std::condition_variable_any work_;
  std::vector<Connection> idle_ ABSL_GUARDED_BY(mutex_);
  size_t open_ ABSL_GUARDED_BY(mutex_) = 0;   // idle_ and those in use
  int failures_ ABSL_GUARDED_BY(mutex_) = 0;  // in a row
  bool is_left_alone_ ABSL_GUARDED_BY(mutex_) = true;
  bool has_told_ ABSL_GUARDED_BY(mutex_) = false;  // that it is
  Time retry_at_ ABSL_GUARDED_BY(mutex_);          // while it is left alone
  // No values are written before.
  Time refuses_until_ ABSL_GUARDED_BY(mutex_);
  std::deque<Task> waiting_ ABSL_GUARDED_BY(mutex_);
  uint64_t waiting_bytes_ ABSL_GUARDED_BY(mutex_) = 0;
  RedisCounters counters_ ABSL_GUARDED_BY(mutex_);

  std::jthread thread_;  // last, since it uses the others
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_TIER_REDIS_BLOBS_H_
