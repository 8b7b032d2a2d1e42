// A real process is killed before each of its system calls in turn; the next
// one finds all or nothing.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "server/store/blob_store.h"
#include "tests/store/blob_fixture.h"
#include "tests/store/traced_child.h"

namespace geodesic::server {
namespace {

using test::Name;
using test::Put;
using test::Read;
using test::RunTraced;
using test::TracedRun;
using ::testing::IsEmpty;

class BlobCrashTest : public test::BlobTest {
 protected:
  // Makes the folder as it is before, has a child do `work` on the store until
  // it is killed before a call, and lets `check` see what the next process
  // finds; for each call.
  void KillBeforeEachCall(const std::function<void()>& before,
                          const std::function<bool()>& work,
                          const std::function<void(bool acknowledged)>& check) {
    for (size_t call = 0;; ++call) {
      SCOPED_TRACE("killed before call " + std::to_string(call));
      std::filesystem::remove_all(data_dir());
      ASSERT_TRUE(Open().ok());
      before();
      Close();
      const TracedRun run = RunTraced([&] { (void)Open(); }, work, call);
      if (!run.is_permitted) {
        GTEST_SKIP() << "this machine forbids to trace a child";
      }
      // Nobody is left who would hold the folder.
      ASSERT_TRUE(Open().ok());
      EXPECT_EQ(files(), store_->size()) << "something was left beside";
      EXPECT_EQ(quarantined(), 0);
      EXPECT_THAT(warnings_, IsEmpty());
      EXPECT_EQ(*Read(*store_, Name('b')), "a bystander");
      check(run.has_acknowledged);
      if (run.has_ended) {
        EXPECT_TRUE(run.has_acknowledged);
        // It was killed in the midst often enough.
        EXPECT_GT(call, 5);
        return;
      }
    }
  }

  void PutBystander() {
    ASSERT_TRUE(Put(*store_, Name('b'), "a bystander").ok());
  }
};

TEST_F(BlobCrashTest, WhilePutting) {
  const std::string body(100'000, 'x');
  KillBeforeEachCall([&] { PutBystander(); },
                     [&] { return Put(*store_, Name('a'), body).ok(); },
                     [&](bool acknowledged) {
                       const auto found = Read(*store_, Name('a'));
                       if (acknowledged || found.ok()) {
                         ASSERT_TRUE(found.ok()) << found.status();
                         EXPECT_TRUE(*found == body);
                       } else {
                         EXPECT_TRUE(absl::IsNotFound(found.status()));
                       }
                     });
}

TEST_F(BlobCrashTest, WhileReplacing) {
  KillBeforeEachCall(
      [&] {
        PutBystander();
        ASSERT_TRUE(Put(*store_, Name('a'), "the old").ok());
      },
      [&] { return Put(*store_, Name('a'), "the new one").ok(); },
      [&](bool acknowledged) {
        const auto found = Read(*store_, Name('a'));
        ASSERT_TRUE(found.ok()) << found.status();
        if (acknowledged || *found != "the old") {
          EXPECT_EQ(*found, "the new one");
        }
      });
}

TEST_F(BlobCrashTest, WhileErasing) {
  // Two, for one takes few calls.
  KillBeforeEachCall(
      [&] {
        PutBystander();
        for (const char digit : {'a', 'c', 'd'}) {
          ASSERT_TRUE(Put(*store_, Name(digit), "in the way").ok());
        }
      },
      [&] {
        return store_->Erase(Name('a')).ok() && store_->Erase(Name('c')).ok() &&
               store_->Erase(Name('d')).ok();
      },
      [&](bool acknowledged) {
        for (const char digit : {'a', 'c', 'd'}) {
          const auto found = Read(*store_, Name(digit));
          if (found.ok() && !acknowledged) {
            EXPECT_EQ(*found, "in the way");
          } else {
            EXPECT_TRUE(absl::IsNotFound(found.status())) << found.status();
          }
        }
      });
}

TEST_F(BlobCrashTest, WhileOpening) {
  KillBeforeEachCall(
      [&] {
        PutBystander();
        geodesic::test::WriteFile(
            data_dir() + "/things/" + Name('a') + ".0.tmp", "half of");
      },
      [&] { return Open().ok(); },
      [&](bool) {
        EXPECT_TRUE(absl::IsNotFound(Read(*store_, Name('a')).status()));
      });
}

// What a kill cannot show, for the kernel keeps what was written: the order
// in which a power cut finds things on the disk.
TEST_F(BlobCrashTest, BytesAreOnTheDiskBeforeTheirNameAndThatBeforeTheAnswer) {
  ASSERT_TRUE(Open().ok());
  Close();
  const TracedRun run =
      RunTraced([&] { (void)Open(); },
                [&] { return Put(*store_, Name('a'), "body").ok(); });
  if (!run.is_permitted) {
    GTEST_SKIP() << "this machine forbids to trace a child";
  }
  const auto next = [&](auto from, auto is_wanted) {
    return std::find_if(from, run.calls.end(), is_wanted);
  };
  const auto is_sync = [](uint64_t call) { return call == SYS_fsync; };
  const auto is_rename = [](uint64_t call) {
#ifdef SYS_renameat
    if (call == SYS_renameat) return true;
#endif
    return call == SYS_renameat2;
  };
  const auto is_write = [](uint64_t call) {
    return call == SYS_pwrite64 || call == SYS_write;
  };
  const auto end = run.calls.end();
  const auto sync = next(run.calls.begin(), is_sync);
  const auto rename = next(run.calls.begin(), is_rename);
  ASSERT_NE(rename, end);
  ASSERT_LT(sync, rename);
  // Between, nothing is written any more.
  EXPECT_EQ(std::find_if(sync, rename, is_write), rename);
  const auto folder_sync = next(rename, is_sync);
  const auto answer = next(rename, is_write);
  ASSERT_NE(folder_sync, end);
  ASSERT_NE(answer, end);
  EXPECT_LT(folder_sync, answer);
}

// So that what was deleted does not come back.
TEST_F(BlobCrashTest, AnErasureIsOnTheDiskBeforeTheAnswer) {
  ASSERT_TRUE(Open().ok());
  PutBystander();
  Close();
  const TracedRun run = RunTraced(
      [&] { (void)Open(); }, [&] { return store_->Erase(Name('b')).ok(); });
  if (!run.is_permitted) {
    GTEST_SKIP() << "this machine forbids to trace a child";
  }
  const auto erased = std::ranges::find(run.calls, SYS_unlinkat);
  ASSERT_NE(erased, run.calls.end());
  EXPECT_NE(std::find(erased, run.calls.end(), SYS_fsync), run.calls.end());
}

}  // namespace
}  // namespace geodesic::server
