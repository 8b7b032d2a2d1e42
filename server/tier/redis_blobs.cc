#include "server/tier/redis_blobs.h"

#include <hiredis/hiredis.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "digest/sha256.h"
#include "server/store/blob_format.h"

namespace geodesic::server {
namespace {

using std::chrono::steady_clock;

constexpr std::string_view kKind = "shared";

// Metadata comes with the first piece.
constexpr size_t kMostMetadataBytes = kRedisPieceBytes - kBlobHeaderBytes;

// Nobody waits for what the thread does.
constexpr std::chrono::milliseconds kConnectPatience{500};
constexpr std::chrono::seconds kWritePatience{2};

std::string KeyOf(const std::string& name) {
  return std::string(kRedisPrefix) + name;
}

std::string GetRange(const std::string& key, uint64_t first, uint64_t count) {
  return RedisCommand({"GETRANGE", key, std::to_string(first),
                       std::to_string(first + count - 1)});
}

absl::Status Wrong(absl::string_view why) {
  return absl::DataLossError(absl::StrCat("the shared value is wrong: ", why));
}

// The beginning of a value, once it is known to be one of ours.
struct Beginning {
  BlobHeader header;
  std::string_view metadata;
  std::string_view body;  // as far as it has come
};

// Errors: DATA_LOSS.
absl::StatusOr<Beginning> Examine(const std::string& name,
                                  std::string_view bytes, uint64_t length) {
  if (bytes.size() < kBlobHeaderBytes) return Wrong("it is too short");
  absl::StatusOr<BlobHeader> header =
      DecodeBlobHeader(bytes.substr(0, kBlobHeaderBytes));
  if (!header.ok()) return Wrong(header.status().message());
  if (header->kind != kKind || header->name != name) {
    return Wrong("it has another name");
  }
  bytes.remove_prefix(kBlobHeaderBytes);
  if (header->metadata_bytes > bytes.size() || header->body_bytes > length ||
      kBlobHeaderBytes + header->metadata_bytes + header->body_bytes !=
          length) {
    return Wrong("it has another length");
  }
  Beginning value{.metadata = bytes.substr(0, header->metadata_bytes),
                  .body = bytes.substr(header->metadata_bytes)};
  if (Sha256Hex(value.metadata) != header->metadata_sha256) {
    return Wrong("its metadata does not have the digest that it names");
  }
  value.header = *std::move(header);
  return value;
}

// What follows the beginning is fetched as it is read.
class RedisBody final : public BlobBody {
 public:
  // `is_lost` becomes true when the connection has failed.
  RedisBody(RedisConnection& connection, std::string key,
            const Beginning& value, std::chrono::milliseconds patience,
            bool& is_lost)
      : BlobBody(value.header.body_bytes),
        connection_(connection),
        key_(std::move(key)),
        ready_(value.body),
        offset_(kBlobHeaderBytes + value.metadata.size() + value.body.size()),
        patience_(patience),
        is_lost_(is_lost) {}

  uint64_t bytes_fetched() const { return fetched_; }

 private:
  absl::Status ReadNext(std::span<char> bytes) override {
    while (!bytes.empty()) {
      if (ready_.empty()) {
        absl::Status status =
            Fetch(std::min<uint64_t>(bytes.size(), kRedisPieceBytes));
        if (!status.ok()) return status;
      }
      const size_t count = std::min(bytes.size(), ready_.size());
      std::memcpy(bytes.data(), ready_.data(), count);
      ready_.remove_prefix(count);
      bytes = bytes.subspan(count);
    }
    return absl::OkStatus();
  }

  absl::Status Fetch(uint64_t count) {
    absl::StatusOr<RedisReply> reply =
        connection_.Ask(GetRange(key_, offset_, count),
                        {.until = steady_clock::now() + patience_});
    if (!reply.ok()) {
      is_lost_ = true;
      return reply.status();
    }
    if ((*reply)->type != REDIS_REPLY_STRING || (*reply)->len != count) {
      return Wrong("it ends early");
    }
    reply_ = *std::move(reply);
    ready_ = {reply_->str, reply_->len};
    offset_ += count;
    fetched_ += count;
    return absl::OkStatus();
  }

  RedisConnection& connection_;
  const std::string key_;
  RedisReply reply_;
  std::string_view ready_;  // of the beginning, then of reply_
  uint64_t offset_;         // in the value, of what is fetched next
  uint64_t fetched_ = 0;
  const std::chrono::milliseconds patience_;
  bool& is_lost_;
};

}  // namespace

RedisBlobs::RedisBlobs(Options options)
    : options_(std::move(options)),
      thread_([this](const std::stop_token& stop) { Run(stop); }) {}

RedisBlobs::~RedisBlobs() = default;

absl::Status RedisBlobs::Read(const std::string& name, TakeBlob take) {
  Connection connection = TakeConnection();
  if (connection == nullptr) {
    Count(&RedisCounters::skipped);
    return absl::UnavailableError("the shared tier is left alone");
  }
  bool is_lost = false;
  absl::Status status = ReadOn(*connection, name, take, is_lost);
  if (is_lost) {
    connection.reset();
    Failed(status);
  } else {
    GiveBack(std::move(connection));
  }
  return status;
}

absl::Status RedisBlobs::ReadOn(RedisConnection& connection,
                                const std::string& name, TakeBlob take,
                                bool& is_lost) {
  const std::string key = KeyOf(name);
  const std::string begin = GetRange(key, 0, kRedisPieceBytes);
  const std::string length = RedisCommand({"STRLEN", key});
  auto replies =
      connection.Ask(std::array<std::string_view, 2>{begin, length}, 2,
                     {.until = steady_clock::now() + options_.patience});
  if (!replies.ok()) {
    is_lost = true;
    return replies.status();
  }
  const redisReply& first = *replies->at(0);
  const redisReply& second = *replies->at(1);
  const auto wrong_or_other = [&]() -> absl::Status {
    for (const redisReply* reply : {&first, &second}) {
      if (reply->type == REDIS_REPLY_ERROR &&
          !RedisError(*reply).starts_with("WRONGTYPE")) {
        is_lost = true;
        return absl::UnavailableError(
            absl::StrCat("Redis refuses: ", RedisError(*reply)));
      }
    }
    return Wrong("it is no string");
  };
  const auto read = [&]() -> absl::Status {
    if (first.type != REDIS_REPLY_STRING ||
        second.type != REDIS_REPLY_INTEGER) {
      return wrong_or_other();
    }
    if (second.integer == 0) return absl::NotFoundError("nobody has shared it");
    const absl::StatusOr<Beginning> value =
        Examine(name, {first.str, first.len}, second.integer);
    if (!value.ok()) return value.status();
    RedisBody body(connection, key, *value, options_.patience, is_lost);
    absl::Status status = take(value->metadata, body);
    if (status.ok()) status = body.Finish(value->header.body_sha256);
    Count(&RedisCounters::bytes_read, first.len + body.bytes_fetched());
    return status;
  };
  absl::Status status = read();
  if (is_lost) return status;
  if (absl::IsDataLoss(status)) {
    Count(&RedisCounters::wrong);
    options_.tell(absl::StrCat(key, " is deleted: ", status.message()));
    Enqueue({.name = name});
  } else if (status.ok()) {
    Count(&RedisCounters::hits);
  } else if (!absl::IsCancelled(status)) {
    Count(&RedisCounters::misses);
  }
  return status;
}

absl::Status RedisBlobs::Admit(uint64_t body_bytes, uint64_t metadata_bytes) {
  MutexLock lock(mutex_);
  if (metadata_bytes <= kMostMetadataBytes &&
      metadata_bytes + body_bytes <= options_.max_bytes && !is_left_alone_ &&
      steady_clock::now() >= refuses_until_) {
    return absl::OkStatus();
  }
  ++counters_.dropped;
  return absl::ResourceExhaustedError(
      absl::StrCat("the shared tier does not take ", body_bytes, " bytes now"));
}

absl::Status RedisBlobs::Put(const std::string& name, std::string_view metadata,
                             std::span<const std::string_view> body) {
  uint64_t bytes = 0;
  for (const std::string_view part : body) bytes += part.size();
  absl::Status status = Admit(bytes, metadata.size());
  if (!status.ok()) return status;
  Task task{.name = name, .has_value = true, .metadata = std::string(metadata)};
  task.body.reserve(bytes);
  for (const std::string_view part : body) task.body += part;
  Enqueue(std::move(task));
  return absl::OkStatus();
}

void RedisBlobs::Enqueue(Task task) {
  MutexLock lock(mutex_);
  if (is_left_alone_) return;
  waiting_bytes_ += task.bytes();
  waiting_.push_back(std::move(task));
  while (waiting_bytes_ > options_.max_bytes) {
    waiting_bytes_ -= waiting_.front().bytes();
    counters_.dropped += waiting_.front().has_value;
    waiting_.pop_front();
  }
  work_.notify_one();
}

RedisBlobs::Connection RedisBlobs::TakeConnection() {
  MutexLock lock(mutex_);
  if (idle_.empty()) return nullptr;
  Connection connection = std::move(idle_.back());
  idle_.pop_back();
  return connection;
}

void RedisBlobs::GiveBack(Connection connection) {
  MutexLock lock(mutex_);
  failures_ = 0;
  if (is_left_alone_) {
    --open_;
  } else {
    idle_.push_back(std::move(connection));
  }
}

void RedisBlobs::Failed(const absl::Status& why) {
  bool is_enough = false;
  {
    MutexLock lock(mutex_);
    ++counters_.failures;
    --open_;
    is_enough = ++failures_ >= kMostFailures;
    work_.notify_one();
  }
  if (is_enough) LeaveAlone(why);
}

void RedisBlobs::LeaveAlone(const absl::Status& why) {
  std::vector<Connection> closed;
  std::deque<Task> dropped;
  {
    MutexLock lock(mutex_);
    is_left_alone_ = true;
    retry_at_ = steady_clock::now() + kSilence;
    closed.swap(idle_);
    open_ -= closed.size();
    dropped.swap(waiting_);
    waiting_bytes_ = 0;
    for (const Task& task : dropped) counters_.dropped += task.has_value;
    work_.notify_one();
    if (std::exchange(has_told_, true)) return;
  }
  options_.tell(absl::StrCat(options_.address, " is left alone until it ",
                             "answers: ", why.message()));
}

void RedisBlobs::Run(const std::stop_token& stop) {
  Connection writer;
  while (Await(stop)) {
    std::optional<Task> task;
    {
      MutexLock lock(mutex_);
      if (is_left_alone_) {
        writer.reset();
      } else if (open_ >= options_.connections && !waiting_.empty()) {
        task = std::move(waiting_.front());
        waiting_.pop_front();
        waiting_bytes_ -= task->bytes();
      }
    }
    if (task) {
      Do(*task, writer, stop);
    } else {
      Connect(stop);
    }
  }
}

bool RedisBlobs::Await(const std::stop_token& stop) {
  MutexLock lock(mutex_);
  while (!stop.stop_requested()) {
    if (is_left_alone_) {
      if (steady_clock::now() >= retry_at_) return true;
      work_.wait_until(lock, stop, retry_at_, [] { return false; });
    } else {
      if (open_ < options_.connections || !waiting_.empty()) return true;
      work_.wait(lock, stop, [this]() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
        return is_left_alone_ || open_ < options_.connections ||
               !waiting_.empty();
      });
    }
  }
  return false;
}

void RedisBlobs::Connect(const std::stop_token& stop) {
  absl::StatusOr<Connection> connection = RedisConnection::Open(
      options_.address, options_.password(),
      {.until = steady_clock::now() + kConnectPatience, .stop = stop});
  if (!connection.ok()) {
    LeaveAlone(connection.status());
    return;
  }
  bool was_left_alone = false;
  {
    MutexLock lock(mutex_);
    if (std::exchange(is_left_alone_, false)) failures_ = 0;
    was_left_alone = std::exchange(has_told_, false);
    idle_.push_back(*std::move(connection));
    ++open_;
  }
  if (was_left_alone) {
    options_.tell(absl::StrCat(options_.address, " answers again"));
  }
}

void RedisBlobs::Do(const Task& task, Connection& writer,
                    const std::stop_token& stop) {
  const RedisPatience patience{.until = steady_clock::now() + kWritePatience,
                               .stop = stop};
  absl::Status status;
  if (writer == nullptr) {
    absl::StatusOr<Connection> connection =
        RedisConnection::Open(options_.address, options_.password(), patience);
    status = connection.status();
    if (status.ok()) writer = *std::move(connection);
  }
  const std::string key = KeyOf(task.name);
  std::string command;
  std::string header;
  std::vector<std::string_view> parts;
  if (!task.has_value) {
    command = RedisCommand({"DEL", key});
    parts = {command};
  } else {
    header = EncodeBlobHeader({.kind = std::string(kKind),
                               .name = task.name,
                               .body_bytes = task.body.size(),
                               .metadata_bytes = task.metadata.size(),
                               .body_sha256 = Sha256Hex(task.body),
                               .metadata_sha256 = Sha256Hex(task.metadata)});
    command = RedisCommandBefore(
        {"SETEX", key, std::to_string(options_.expiry.count())},
        header.size() + task.bytes());
    parts = {command, header, task.metadata, task.body, kRedisEnd};
  }
  bool is_refused = false;
  if (status.ok()) {
    auto replies = writer->Ask(parts, 1, patience);
    status = replies.status();
    if (status.ok() && replies->front()->type == REDIS_REPLY_ERROR) {
      is_refused = true;
      status = absl::ResourceExhaustedError(RedisError(*replies->front()));
    }
  }
  if (task.has_value) {
    Count(&RedisCounters::writes);
    if (status.ok()) {
      Count(&RedisCounters::bytes_written, header.size() + task.bytes());
    } else {
      Count(&RedisCounters::write_failures);
    }
  }
  if (is_refused) {
    // It is full, perhaps: what else waits would be sent for nothing.
    MutexLock lock(mutex_);
    refuses_until_ = steady_clock::now() + kSilence;
    for (const Task& other : waiting_) counters_.dropped += other.has_value;
    waiting_.clear();
    waiting_bytes_ = 0;
  } else if (!status.ok()) {
    writer.reset();
    LeaveAlone(status);
  }
}

void RedisBlobs::Count(uint64_t RedisCounters::*event, uint64_t times) {
  MutexLock lock(mutex_);
  counters_.*event += times;
}

RedisCounters RedisBlobs::counters() const {
  MutexLock lock(mutex_);
  return counters_;
}

bool RedisBlobs::is_left_alone() const {
  MutexLock lock(mutex_);
  return is_left_alone_;
}

uint64_t RedisBlobs::waiting_bytes() const {
  MutexLock lock(mutex_);
  return waiting_bytes_;
}

}  // namespace geodesic::server
