#include "server/tier/redis_connection.h"

#include <hiredis/hiredis.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "absl/strings/strip.h"

namespace geodesic::server {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

// How often it is checked whether the server ends.
constexpr milliseconds kStopPeriod{50};

// Of Redis's words in an error.
constexpr size_t kMostWords = 100;

absl::Status Lost(std::string_view why) {
  return absl::UnavailableError(
      absl::StrCat("the connection is lost: ", std::string(why)));
}

// Begins to connect; null if there is no memory for that.
redisContext* Connect(const std::string& address) {
  absl::string_view place = address;
  if (absl::ConsumePrefix(&place, "unix:")) {
    return redisConnectUnixNonBlock(std::string(place).c_str());
  }
  const size_t colon = place.rfind(':');
  absl::string_view host = place.substr(0, colon);
  if (absl::ConsumePrefix(&host, "[")) absl::ConsumeSuffix(&host, "]");
  int port = 0;
  (void)absl::SimpleAtoi(place.substr(colon + 1), &port);
  return redisConnectNonBlock(std::string(host).c_str(), port);
}

constexpr const char* kCrLf = "\r\n";

// The beginning of a command of `count` words, as far as these.
std::string Framed(size_t count,
                   std::initializer_list<std::string_view> words) {
  std::string bytes = absl::StrCat("*", count, kCrLf);
  for (const std::string_view word : words) {
    absl::StrAppend(&bytes, "$", word.size(), kCrLf);
    bytes += word;
    bytes += kCrLf;
  }
  return bytes;
}

}  // namespace

void FreeRedisReply::operator()(redisReply* reply) const {
  freeReplyObject(reply);
}

void RedisConnection::Disconnect::operator()(redisContext* context) const {
  redisFree(context);
}

RedisConnection::~RedisConnection() = default;

std::string RedisCommandBefore(std::initializer_list<std::string_view> words,
                               size_t last_bytes) {
  std::string bytes = Framed(words.size() + 1, words);
  absl::StrAppend(&bytes, "$", last_bytes, kCrLf);
  return bytes;
}

std::string RedisCommand(std::initializer_list<std::string_view> words) {
  return Framed(words.size(), words);
}

std::string RedisError(const redisReply& reply) {
  return std::string(reply.str, std::min(reply.len, kMostWords));
}

absl::StatusOr<std::unique_ptr<RedisConnection>> RedisConnection::Open(
    const std::string& address, const std::string& password,
    const RedisPatience& patience) {
  redisContext* const context = Connect(address);
  if (context == nullptr) return absl::UnavailableError("there is no memory");
  std::unique_ptr<RedisConnection> connection(new RedisConnection(context));
  if (context->err != 0) return Lost(context->errstr);
  absl::Status status = connection->Await(POLLOUT, patience);
  if (!status.ok()) return status;
  int error = 0;
  socklen_t size = sizeof(error);
  if (getsockopt(context->fd, SOL_SOCKET, SO_ERROR, &error, &size) != 0 ||
      error != 0) {
    return Lost(std::strerror(error));
  }
  // Connections may be idle for long.
  const int keep_alive = 1;
  setsockopt(context->fd, SOL_SOCKET, SO_KEEPALIVE, &keep_alive,
             sizeof(keep_alive));
  if (!password.empty()) {
    status =
        connection->Ask(RedisCommand({"AUTH", password}), patience).status();
    if (!status.ok()) return status;
  }
  // Redis may be there and yet refuse to work, e.g. without a password.
  status = connection->Ask(RedisCommand({"PING"}), patience).status();
  if (!status.ok()) return status;
  return connection;
}

absl::Status RedisConnection::Await(int events,
                                    const RedisPatience& patience) const {
  for (;;) {
    if (patience.stop.stop_requested()) return Lost("the server ends");
    const auto now = steady_clock::now();
    if (now >= patience.until) return Lost("no answer in time");
    auto wait = std::chrono::ceil<milliseconds>(patience.until - now);
    if (patience.stop.stop_possible()) wait = std::min(wait, kStopPeriod);
    pollfd ready{.fd = context_->fd,
                 .events = static_cast<int16_t>(events),
                 .revents = 0};
    const int count = poll(&ready, 1, static_cast<int>(wait.count()));
    if (count > 0) return absl::OkStatus();
    if (count < 0 && errno != EINTR) return Lost(std::strerror(errno));
  }
}

absl::Status RedisConnection::Send(std::vector<std::string_view>& parts) const {
  while (!parts.empty()) {
    std::string_view& part = parts.front();
    const ssize_t sent = send(context_->fd, part.data(), part.size(),
                              MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0) {
      if (errno == EAGAIN || errno == EINTR) return absl::OkStatus();
      return Lost(std::strerror(errno));
    }
    part.remove_prefix(static_cast<size_t>(sent));
    if (part.empty()) parts.erase(parts.begin());
  }
  return absl::OkStatus();
}

absl::StatusOr<std::vector<RedisReply>> RedisConnection::Ask(
    std::span<const std::string_view> parts, size_t count,
    const RedisPatience& patience) {
  std::vector<std::string_view> to_send(parts.begin(), parts.end());
  std::vector<RedisReply> replies;
  while (replies.size() < count) {
    if (absl::Status status = Send(to_send); !status.ok()) return status;
    void* reply = nullptr;
    if (redisGetReplyFromReader(context_.get(), &reply) != REDIS_OK) {
      return Lost(context_->errstr);
    }
    if (reply != nullptr) {
      replies.emplace_back(static_cast<redisReply*>(reply));
      continue;
    }
    if (context_->reader->len - context_->reader->pos > kMostReplyBytes) {
      return Lost("the answer is too long");
    }
    absl::Status status =
        Await(to_send.empty() ? POLLIN : POLLIN | POLLOUT, patience);
    if (!status.ok()) return status;
    // Without anything to read this does nothing.
    if (redisBufferRead(context_.get()) != REDIS_OK) {
      return Lost(context_->errstr);
    }
  }
  return replies;
}

absl::StatusOr<RedisReply> RedisConnection::Ask(std::string_view command,
                                                const RedisPatience& patience) {
  absl::StatusOr<std::vector<RedisReply>> replies =
      Ask(std::array{command}, 1, patience);
  if (!replies.ok()) return replies.status();
  RedisReply reply = std::move(replies->front());
  if (reply->type == REDIS_REPLY_ERROR) {
    return absl::UnavailableError(
        absl::StrCat("Redis refuses: ", RedisError(*reply)));
  }
  return reply;
}

}  // namespace geodesic::server
