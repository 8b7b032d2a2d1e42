// Blobs in a real Redis. tests/integration/python/shared_tier_test.py has what
// servers make of them, and what a Redis that fails does to servers.

#include "server/tier/redis_blobs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "server/store/blob_tiers.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/until.h"

namespace geodesic::server {
namespace {

using ::geodesic::test::Until;
using ::testing::HasSubstr;

std::string Name(char digit) { return std::string(64, digit); }

// Bytes in which every piece differs from the others.
std::string Bytes(size_t count) {
  std::string bytes(count, '\0');
  uint32_t state = 1;
  for (char& byte : bytes) {
    state = state * 1664525 + 1013904223;
    byte = static_cast<char>(state >> 24);
  }
  return bytes;
}

class RedisBlobsTest : public ::testing::Test {
 protected:
  void SetUp() override { StartRedis(); }
  void TearDown() override {
    blobs_.reset();
    KillRedis();
  }

  void StartRedis() {
    const std::string path = folder_ / "redis";
    std::vector<std::string> words = {
        REDIS_SERVER, "--port", "0",         "--unixsocket", path,
        "--save",     "",       "--logfile", folder_ / "log"};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ASSERT_EQ(posix_spawn(&process_, REDIS_SERVER, nullptr, nullptr,
                          arguments.data(), environ),
              0);
  }

  void KillRedis() {
    if (process_ < 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    process_ = -1;
  }

  std::string address() const { return "unix:" + (folder_ / "redis"); }

  // Waits until Redis has answered.
  void Open(uint64_t max_bytes = uint64_t{8} << 20) {
    // Tries again every few seconds, and Redis may not have been up yet.
    Until([this] {
      return RedisConnection::Open(address(), "", Patience()).ok();
    });
    blobs_.emplace(RedisBlobs::Options{.address = address(),
                                       .patience = std::chrono::seconds(10),
                                       .max_bytes = max_bytes,
                                       .password =
                                           [this] {
                                             std::lock_guard lock(
                                                 password_mutex_);
                                             return std::string();
                                           },
                                       .tell =
                                           [this](const std::string& line) {
                                             std::lock_guard lock(mutex_);
                                             told_ += line + "\n";
                                           }});
    Until([this] { return !blobs_->is_left_alone(); });
  }

  static RedisPatience Patience() {
    return {.until =
                std::chrono::steady_clock::now() + std::chrono::seconds(10)};
  }

  absl::Status Put(const std::string& name, std::string_view body) {
    const uint64_t before = blobs_->counters().writes;
    absl::Status status =
        blobs_->Put(name, "about it",
                    std::array{body.substr(0, body.size() / 3),
                               body.substr(body.size() / 3)});
    if (status.ok()) {
      Until([&] { return blobs_->counters().writes > before; });
    }
    return status;
  }

  // The metadata and the body.
  absl::StatusOr<std::string> Read(const std::string& name) {
    std::string bytes;
    absl::Status status =
        blobs_->Read(name, [&](std::string_view metadata, BlobBody& body) {
          bytes = metadata;
          const size_t first = body.bytes_left() / 2;
          bytes.resize(metadata.size() + body.bytes_left());
          const std::span<char> into(bytes.data() + metadata.size(),
                                     body.bytes_left());
          absl::Status read = body.Read(into.first(first));
          return read.ok() ? body.Read(into.subspan(first)) : read;
        });
    if (!status.ok()) return status;
    return bytes;
  }

  std::string told() {
    std::lock_guard lock(mutex_);
    return told_;
  }

  geodesic::test::TemporaryFolder folder_;
  pid_t process_ = -1;
  std::mutex mutex_;
  std::string told_;           // guarded by mutex_
  std::mutex password_mutex_;  // held while the password is asked for
  std::optional<RedisBlobs> blobs_;
};

TEST_F(RedisBlobsTest, ValuesOfAllSizesComeBack) {
  Open();
  for (const size_t size :
       {size_t{0}, size_t{1}, kRedisPieceBytes - 176, kRedisPieceBytes - 175,
        kRedisPieceBytes, 5 * kRedisPieceBytes + 17}) {
    const std::string body = Bytes(size);
    ASSERT_TRUE(Put(Name('a'), body).ok());
    const absl::StatusOr<std::string> found = Read(Name('a'));
    ASSERT_TRUE(found.ok()) << found.status();
    EXPECT_TRUE(*found == "about it" + body) << size;
  }
  EXPECT_TRUE(absl::IsNotFound(Read(Name('b')).status()));
  const RedisCounters counters = blobs_->counters();
  EXPECT_EQ(counters.hits, 6);
  EXPECT_EQ(counters.misses, 1);
  EXPECT_EQ(counters.writes, 6);
  EXPECT_EQ(counters.bytes_read, counters.bytes_written);
}

TEST_F(RedisBlobsTest, AValueThatIsWrongBeyondTheFirstPieceIsDeleted) {
  Open();
  ASSERT_TRUE(Put(Name('a'), Bytes(3 * kRedisPieceBytes)).ok());
  auto other = RedisConnection::Open(address(), "", Patience());
  ASSERT_TRUE(other.ok()) << other.status();
  const std::string key = std::string(kRedisPrefix) + Name('a');
  ASSERT_TRUE(
      (*other)
          ->Ask(RedisCommand({"SETRANGE", key, "600000", "?"}), Patience())
          .ok());
  EXPECT_TRUE(absl::IsDataLoss(Read(Name('a')).status()));
  EXPECT_EQ(blobs_->counters().wrong, 1);
  EXPECT_THAT(told(), HasSubstr(key));
  // Written by the same thread, which deletes before.
  ASSERT_TRUE(Put(Name('b'), "x").ok());
  EXPECT_TRUE(absl::IsNotFound(Read(Name('a')).status()));
}

TEST_F(RedisBlobsTest, WhoHasSeenEnoughReadsNoMore) {
  Open();
  ASSERT_TRUE(Put(Name('a'), Bytes(3 * kRedisPieceBytes)).ok());
  const absl::Status status =
      blobs_->Read(Name('a'), [](std::string_view metadata, BlobBody& body) {
        EXPECT_EQ(metadata, "about it");
        EXPECT_EQ(body.bytes_left(), 3 * kRedisPieceBytes);
        return absl::CancelledError("enough");
      });
  EXPECT_TRUE(absl::IsCancelled(status));
  const RedisCounters counters = blobs_->counters();
  EXPECT_EQ(counters.hits + counters.misses + counters.wrong, 0);
  EXPECT_EQ(counters.bytes_read, kRedisPieceBytes);
  EXPECT_TRUE(Read(Name('a')).ok());
}

TEST_F(RedisBlobsTest, WhatWaitsIsBounded) {
  constexpr uint64_t kMost = 1000;
  Open(kMost);
  EXPECT_TRUE(
      absl::IsResourceExhausted(Put(Name('a'), std::string(kMost + 1, 'x'))));
  kill(process_, SIGSTOP);
  for (int i = 0; i < 100; ++i) {
    (void)blobs_->Put(Name('a'), "",
                      std::array{std::string_view("0123456789"
                                                  "0123456789")});
    EXPECT_LE(blobs_->waiting_bytes(), kMost);
  }
  EXPECT_GT(blobs_->counters().dropped, 0);
  kill(process_, SIGCONT);
}

TEST_F(RedisBlobsTest, DeletionsThatWaitAreBoundedToo) {
  constexpr uint64_t kMost = 200;  // three names and a little
  constexpr char kDigits[] = {'a', 'b', 'c', 'd', 'e'};
  Open(kMost);
  auto other = RedisConnection::Open(address(), "", Patience());
  ASSERT_TRUE(other.ok()) << other.status();
  for (const char digit : kDigits) {
    const std::string key = std::string(kRedisPrefix) + Name(digit);
    ASSERT_TRUE(
        (*other)->Ask(RedisCommand({"SET", key, "wrong"}), Patience()).ok());
  }
  // The thread needs a connection of its own to delete, and that a password.
  const std::lock_guard held(password_mutex_);
  for (const char digit : kDigits) {
    EXPECT_TRUE(absl::IsDataLoss(Read(Name(digit)).status()));
    EXPECT_LE(blobs_->waiting_bytes(), kMost);
  }
  EXPECT_GT(blobs_->waiting_bytes(), kMost / 2);
}

TEST_F(RedisBlobsTest, OneThatDiesIsLeftAloneAndFoundAgain) {
  Open();
  ASSERT_TRUE(Put(Name('a'), "x").ok());
  KillRedis();
  EXPECT_TRUE(absl::IsUnavailable(Read(Name('a')).status()));
  ASSERT_TRUE(Until([this] { return blobs_->is_left_alone(); }));
  EXPECT_TRUE(absl::IsUnavailable(Read(Name('a')).status()));
  EXPECT_GE(blobs_->counters().skipped, 1);
  EXPECT_TRUE(absl::IsResourceExhausted(Put(Name('a'), "x")));
  EXPECT_TRUE(Until(
      [this] { return told().find("is left alone") != std::string::npos; }));
  StartRedis();
  ASSERT_TRUE(Until([this] { return !blobs_->is_left_alone(); }));
  EXPECT_TRUE(Until(
      [this] { return told().find("answers again") != std::string::npos; }));
  ASSERT_TRUE(Put(Name('a'), "y").ok());
  EXPECT_EQ(*Read(Name('a')), "about ity");
}

}  // namespace
}  // namespace geodesic::server
