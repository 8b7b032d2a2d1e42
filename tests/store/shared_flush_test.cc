#include "server/store/shared_flush.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace geodesic::server {
namespace {

// What was written before a call is flushed when it returns.
TEST(SharedFlushTest, CoversWhatCameBefore) {
  SharedFlush flush;
  std::atomic<int> written = 0;
  std::atomic<int> flushed = 0;
  std::atomic<int> running = 0;
  std::atomic<int> late = 0;
  std::vector<std::jthread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      for (int round = 0; round < 1000; ++round) {
        const int mine = ++written;
        const absl::Status status = flush.Run([&] {
          late += running++ > 0;
          const int reached = written;
          std::this_thread::yield();
          flushed = reached;
          --running;
          return absl::OkStatus();
        });
        late += !status.ok() || flushed < mine;
      }
    });
  }
  threads.clear();
  EXPECT_EQ(late, 0);
  EXPECT_EQ(flushed, 8000);
}

TEST(SharedFlushTest, AllWhoShareItHearItsError) {
  SharedFlush flush;
  const absl::Status full = absl::ResourceExhaustedError("full");
  std::atomic<int> calls = 0;
  std::atomic<int> flushes = 0;
  std::atomic<int> fine = 0;
  // Until some have shared one.
  while (flushes == calls) {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 8; ++i) {
      threads.emplace_back([&] {
        for (int round = 0; round < 100; ++round) {
          ++calls;
          fine += flush
                      .Run([&] {
                        ++flushes;
                        std::this_thread::yield();
                        return full;
                      })
                      .ok();
        }
      });
    }
  }
  EXPECT_EQ(fine, 0);
}

TEST(SharedFlushTest, TellsItsErrorAndTriesAgain) {
  SharedFlush flush;
  const absl::Status full = absl::ResourceExhaustedError("full");
  EXPECT_EQ(flush.Run([&] { return full; }), full);
  EXPECT_TRUE(flush.Run([] { return absl::OkStatus(); }).ok());
}

}  // namespace
}  // namespace geodesic::server
