// A connection to Redis on which nothing takes longer than the caller allows.
//
// hiredis connects and reads replies. What is sent is framed here: hiredis
// would copy a value twice more, and a broken connection would raise SIGPIPE.

#ifndef GEODESIC_SERVER_TIER_REDIS_CONNECTION_H_
#define GEODESIC_SERVER_TIER_REDIS_CONNECTION_H_

#include <chrono>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

struct redisContext;
struct redisReply;

namespace geodesic::server {

struct FreeRedisReply {
  void operator()(redisReply* reply) const;
};
using RedisReply = std::unique_ptr<redisReply, FreeRedisReply>;

// How long a call may take, and what cuts it short.
struct RedisPatience {
  std::chrono::steady_clock::time_point until;
  std::stop_token stop = {};
};

// The bytes of a command with these words.
std::string RedisCommand(std::initializer_list<std::string_view> words);

// The same, all but the last of its words, which has `last_bytes` bytes and is
// sent after it, followed by kRedisEnd.
std::string RedisCommandBefore(std::initializer_list<std::string_view> words,
                               size_t last_bytes);
inline constexpr std::string_view kRedisEnd = "\r\n";

// Not thread-safe. After an error the connection is of no use.
class RedisConnection {
 public:
  // `address` is HOST:PORT or unix:PATH. Looks the host up, which may take
  // longer than `patience`, connects, and gives the password unless it is
  // empty.
  // Errors: UNAVAILABLE, which does not name the password.
  static absl::StatusOr<std::unique_ptr<RedisConnection>> Open(
      const std::string& address, const std::string& password,
      const RedisPatience& patience);

  ~RedisConnection();
  RedisConnection(const RedisConnection&) = delete;
  RedisConnection& operator=(const RedisConnection&) = delete;

  // Sends `parts`, one after the other, which are commands, and returns the
  // `count` replies to them. A reply may be an error of Redis's.
  // Errors: UNAVAILABLE: not in time; broken; more than kMostReplyBytes came.
  absl::StatusOr<std::vector<RedisReply>> Ask(
      std::span<const std::string_view> parts, size_t count,
      const RedisPatience& patience);

  // The same for one command. Errors of Redis's are UNAVAILABLE, too, and leave
  // the connection as it was.
  absl::StatusOr<RedisReply> Ask(std::string_view command,
                                 const RedisPatience& patience);

  // Nothing larger is ever asked for.
  static constexpr size_t kMostReplyBytes = size_t{1} << 20;

 private:
  struct Disconnect {
    void operator()(redisContext* context) const;
  };

  explicit RedisConnection(redisContext* context) : context_(context) {}

  // Waits until the socket is ready for one of these events of poll.
  absl::Status Await(int events, const RedisPatience& patience) const;
  // Sends as much as the socket takes, and drops it from `parts`.
  absl::Status Send(std::vector<std::string_view>& parts) const;

  std::unique_ptr<redisContext, Disconnect> context_;
};

// The words of an error that Redis answered with.
std::string RedisError(const redisReply& reply);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_TIER_REDIS_CONNECTION_H_
