#include "server/store/blob_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/store/blob_fixture.h"
#include "tests/support/until.h"

namespace {

std::atomic<int> flushes = 0;

}  // namespace

// The C library's, counted.
extern "C" int fsync(int file) {
  ++flushes;
  return static_cast<int>(syscall(SYS_fsync, file));
}

namespace geodesic::server {
namespace {

using geodesic::test::Until;
using test::Name;
using test::Put;
using test::Read;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using BlobStoreTest = test::BlobTest;

std::vector<std::string> Names(const BlobStore& store) {
  std::vector<std::string> names;
  for (const BlobInfo& info : store.List("", 1000)) names.push_back(info.name);
  return names;
}

TEST_F(BlobStoreTest, KeepsWhatItIsGiven) {
  ASSERT_TRUE(Open().ok());
  const std::string_view parts[] = {"in ", "", "parts"};
  ASSERT_TRUE(store_->Put(Name('a'), "metadata", parts).ok());
  EXPECT_EQ(*Read(*store_, Name('a')), "in parts");
  const auto info = store_->Find(Name('a'));
  ASSERT_TRUE(info.has_value());
  EXPECT_EQ(info->metadata, "metadata");
  EXPECT_EQ(info->body_bytes, 8);
  EXPECT_EQ(info->file_bytes, std::filesystem::file_size(FileOf(Name('a'))));
  EXPECT_EQ(store_->used_bytes(), kBlock);
}

TEST_F(BlobStoreTest, ABodyThatIsWrittenOtherwiseThanAnnouncedIsRefused) {
  ASSERT_TRUE(Open().ok());
  const auto put = [&](absl::Status result) {
    return store_->Put(Name('a'), "", 5, [&](BlobSink& sink) {
      absl::Status status = sink.Append("four");
      return status.ok() ? result : status;
    });
  };
  EXPECT_TRUE(absl::IsInternal(put(absl::OkStatus())));
  EXPECT_EQ(put(absl::AbortedError("enough")), absl::AbortedError("enough"));
  EXPECT_EQ(files(), 0);
  EXPECT_EQ(store_->used_bytes(), 0);
}

TEST_F(BlobStoreTest, WhatIsNotThereIsNotFound) {
  ASSERT_TRUE(Open().ok());
  EXPECT_EQ(store_->Find(Name('a')), std::nullopt);
  EXPECT_TRUE(absl::IsNotFound(Read(*store_, Name('a')).status()));
  EXPECT_TRUE(absl::IsNotFound(store_->Erase(Name('a'))));
}

TEST_F(BlobStoreTest, EverythingIsThereAfterARestart) {
  ASSERT_TRUE(Open().ok());
  ASSERT_TRUE(Put(*store_, Name('a'), "first", "one").ok());
  ASSERT_TRUE(Put(*store_, Name('b'), "", "").ok());
  ASSERT_TRUE(Put(*store_, Name('c'), "third", "three").ok());
  ASSERT_TRUE(store_->Erase(Name('a')).ok());
  const uint64_t used = store_->used_bytes();

  ASSERT_TRUE(Open().ok());
  EXPECT_THAT(Names(*store_), ElementsAre(Name('b'), Name('c')));
  EXPECT_EQ(*Read(*store_, Name('b')), "");
  EXPECT_EQ(*Read(*store_, Name('c')), "third");
  EXPECT_EQ(store_->Find(Name('c'))->metadata, "three");
  EXPECT_EQ(store_->used_bytes(), used);
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(BlobStoreTest, TheLaterPutWins) {
  ASSERT_TRUE(Open().ok());
  ASSERT_TRUE(Put(*store_, Name('a'), "a longer one").ok());
  ASSERT_TRUE(Put(*store_, Name('a'), "short").ok());
  EXPECT_EQ(*Read(*store_, Name('a')), "short");
  EXPECT_EQ(store_->used_bytes(), kBlock);
  EXPECT_EQ(files(), 1);
  ASSERT_TRUE(Open().ok());
  EXPECT_EQ(*Read(*store_, Name('a')), "short");
}

TEST_F(BlobStoreTest, FilesAreForThisUserAlone) {
  ASSERT_TRUE(Open().ok());
  ASSERT_TRUE(Put(*store_, Name('a'), "secret").ok());
  struct stat facts {};
  ASSERT_EQ(stat(FileOf(Name('a')).c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0600);
  for (const char* folder : {"/things", "/quarantine"}) {
    ASSERT_EQ(stat((data_dir() + folder).c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777, 0700) << folder;
  }
}

TEST_F(BlobStoreTest, ListsInPages) {
  ASSERT_TRUE(Open().ok());
  for (const char digit : {'3', '1', '2'}) {
    ASSERT_TRUE(Put(*store_, Name(digit), "x").ok());
  }
  const auto page = store_->List(Name('1'), 1);
  ASSERT_EQ(page.size(), 1);
  EXPECT_EQ(page[0].name, Name('2'));
  EXPECT_THAT(store_->List(Name('3'), 10), IsEmpty());
  std::vector<std::string> names;
  store_->ForEach([&](const std::string& name, std::string_view) {
    names.push_back(name);
  });
  EXPECT_THAT(names, ElementsAre(Name('1'), Name('2'), Name('3')));
}

// Room for two blobs of 10 bytes.
class TwoBlobsTest : public BlobStoreTest {
 protected:
  static constexpr uint64_t kTwo = 2 * kBlock;
  void SetUp() override { ASSERT_TRUE(Open(kTwo).ok()); }
  const std::string ten_ = std::string(10, 'x');
};

TEST_F(TwoBlobsTest, WhatWasUnusedLongestMakesWay) {
  ASSERT_TRUE(Put(*store_, Name('a'), ten_).ok());
  ASSERT_TRUE(Put(*store_, Name('b'), ten_).ok());
  ASSERT_TRUE(store_->Find(Name('a')).has_value());
  ASSERT_TRUE(Put(*store_, Name('c'), ten_).ok());
  EXPECT_THAT(Names(*store_), ElementsAre(Name('a'), Name('c')));
  EXPECT_THAT(removed_, ElementsAre(Name('b')));
  EXPECT_EQ(files(), 2);
  EXPECT_EQ(store_->used_bytes(), kTwo);
  ASSERT_TRUE(Read(*store_, Name('a')).ok());
  ASSERT_TRUE(Put(*store_, Name('d'), ten_).ok());
  EXPECT_THAT(Names(*store_), ElementsAre(Name('a'), Name('d')));
}

// Those who write wait for each other while room is made: on a disk that takes
// its time they would stand in line for it.
TEST_F(TwoBlobsTest, MakingRoomDoesNotWaitForTheDisk) {
  const auto flushes_of_put = [&](char name) {
    flushes = 0;
    EXPECT_TRUE(Put(*store_, Name(name), ten_).ok());
    return flushes.load();
  };
  const int without = flushes_of_put('a');
  EXPECT_GT(without, 0);
  EXPECT_EQ(flushes_of_put('b'), without);
  EXPECT_EQ(flushes_of_put('c'), without);
  EXPECT_THAT(removed_, ElementsAre(Name('a')));
}

TEST_F(TwoBlobsTest, ErasingIsNotReportedAsRemoval) {
  ASSERT_TRUE(Put(*store_, Name('a'), ten_).ok());
  ASSERT_TRUE(store_->Erase(Name('a')).ok());
  EXPECT_THAT(removed_, IsEmpty());
  EXPECT_EQ(store_->used_bytes(), 0);
}

TEST_F(TwoBlobsTest, WhatCannotFitEvictsNothing) {
  ASSERT_TRUE(Put(*store_, Name('a'), ten_).ok());
  const absl::Status status =
      Put(*store_, Name('b'), std::string(kTwo - kExtra + 1, 'x'));
  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr(std::to_string(kTwo)));
  EXPECT_THAT(Names(*store_), ElementsAre(Name('a')));
  EXPECT_TRUE(Put(*store_, Name('b'), std::string(kTwo - kExtra, 'x')).ok());
}

// Nor does what could, but for another that is being written.
TEST_F(TwoBlobsTest, WhatFindsNoRoomEvictsNothing) {
  ASSERT_TRUE(Put(*store_, Name('a'), ten_).ok());
  EXPECT_TRUE(
      store_
          ->Put(Name('b'), "", 1,
                [&](BlobSink& sink) {
                  const absl::Status status =
                      Put(*store_, Name('c'), std::string(kTwo - kExtra, 'x'));
                  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
                  return sink.Append("x");
                })
          .ok());
  EXPECT_THAT(Names(*store_), ElementsAre(Name('a'), Name('b')));
}

TEST_F(TwoBlobsTest, RecencyOutlivesARestart) {
  ASSERT_TRUE(Put(*store_, Name('a'), ten_).ok());
  ASSERT_TRUE(Put(*store_, Name('b'), ten_).ok());
  // Times are as fine as the file system's clock; these are an hour apart.
  namespace fs = std::filesystem;
  const fs::path a = FileOf(Name('a'));
  const fs::path b = FileOf(Name('b'));
  fs::last_write_time(a, fs::last_write_time(b) - std::chrono::hours(1));
  ASSERT_TRUE(Open(kTwo).ok());
  ASSERT_TRUE(Put(*store_, Name('c'), ten_).ok());
  EXPECT_THAT(Names(*store_), ElementsAre(Name('b'), Name('c')));

  // To be read is to be used.
  const fs::path c = FileOf(Name('c'));
  fs::last_write_time(b, fs::last_write_time(c) - std::chrono::hours(2));
  fs::last_write_time(c, fs::last_write_time(c) - std::chrono::hours(1));
  ASSERT_TRUE(Read(*store_, Name('b')).ok());
  ASSERT_TRUE(Open(kTwo).ok());
  ASSERT_TRUE(Put(*store_, Name('d'), ten_).ok());
  EXPECT_THAT(Names(*store_), ElementsAre(Name('b'), Name('d')));
}

TEST_F(TwoBlobsTest, ASmallerCapacityEvictsAtTheStart) {
  ASSERT_TRUE(Put(*store_, Name('a'), ten_).ok());
  ASSERT_TRUE(Put(*store_, Name('b'), ten_).ok());
  ASSERT_TRUE(Open(kTwo / 2).ok());
  EXPECT_EQ(store_->size(), 1);
  EXPECT_EQ(files(), 1);
}

TEST_F(BlobStoreTest, ANameByContentIsChecked) {
  ASSERT_TRUE(Open().ok());
  store_.reset();
  const BlobStore::Options options = {.kind = "thing",
                                      .capacity = uint64_t{1} << 20,
                                      .is_named_by_content = true};
  auto store = BlobStore::Open(*folder_, options);
  ASSERT_TRUE(store.ok());
  EXPECT_TRUE(Put(**store, Sha256Hex("body"), "body").ok());
  EXPECT_TRUE(absl::IsInternal(Put(**store, Name('a'), "body")));
  EXPECT_EQ(files(), 1);

  // A file that is sound but for that.
  ASSERT_TRUE(Open().ok());
  ASSERT_TRUE(Put(*store_, Name('a'), "body").ok());
  store_.reset();
  store = BlobStore::Open(*folder_, options);
  ASSERT_TRUE(store.ok());
  EXPECT_THAT(Names(**store), ElementsAre(Sha256Hex("body")));
  EXPECT_EQ(quarantined(), 1);
}

TEST_F(BlobStoreTest, CountsWholeBlocks) {
  ASSERT_TRUE(Open().ok());
  ASSERT_TRUE(Put(*store_, Name('a'), std::string(kBlock - kExtra, 'x')).ok());
  EXPECT_EQ(store_->used_bytes(), kBlock);
  ASSERT_TRUE(
      Put(*store_, Name('a'), std::string(kBlock - kExtra + 1, 'x')).ok());
  EXPECT_EQ(store_->used_bytes(), 2 * kBlock);
}

TEST_F(BlobStoreTest, TheirNumberIsBoundedToo) {
  ASSERT_TRUE(Open().ok());
  store_.reset();
  const absl::StatusOr<std::unique_ptr<BlobStore>> store = BlobStore::Open(
      *folder_,
      {.kind = "thing", .capacity = uint64_t{1} << 20, .max_count = 2});
  ASSERT_TRUE(store.ok());
  for (const char digit : {'c', 'b', 'a'}) {
    ASSERT_TRUE(Put(**store, Name(digit), "x").ok());
  }
  EXPECT_THAT(Names(**store), ElementsAre(Name('a'), Name('b')));
}

TEST_F(BlobStoreTest, TheirNumberIncludesThoseBeingWritten) {
  ASSERT_TRUE(Open().ok());
  store_.reset();
  const absl::StatusOr<std::unique_ptr<BlobStore>> store = BlobStore::Open(
      *folder_,
      {.kind = "thing", .capacity = uint64_t{1} << 20, .max_count = 2});
  ASSERT_TRUE(store.ok());
  ASSERT_TRUE(Put(**store, Name('a'), "x").ok());
  const absl::Status outer =
      (*store)->Put(Name('b'), "", 1, [&](BlobSink& sink) {
        const absl::Status inner =
            (*store)->Put(Name('c'), "", 1, [&](BlobSink& inner_sink) {
              EXPECT_EQ((*store)->size(), 0);
              const absl::Status third = Put(**store, Name('d'), "x");
              EXPECT_TRUE(absl::IsResourceExhausted(third)) << third;
              return inner_sink.Append("x");
            });
        EXPECT_TRUE(inner.ok()) << inner;
        return sink.Append("x");
      });
  EXPECT_TRUE(outer.ok()) << outer;
  EXPECT_THAT(Names(**store), ElementsAre(Name('b'), Name('c')));
  // What is written, or failed to be, takes no place any more.
  EXPECT_TRUE(absl::IsInternal((*store)->Put(
      Name('d'), "", 1, [](BlobSink&) { return absl::OkStatus(); })));
  ASSERT_TRUE(Put(**store, Name('e'), "x").ok());
  ASSERT_TRUE(Put(**store, Name('f'), "x").ok());
  EXPECT_THAT(Names(**store), ElementsAre(Name('e'), Name('f')));
}

TEST_F(BlobStoreTest, FilesOfOthersAreLeftAlone) {
  ASSERT_TRUE(Open().ok());
  const std::string notes = data_dir() + "/things/notes.txt";
  const std::string other = data_dir() + "/things/" + Name('a') + ".other";
  geodesic::test::WriteFile(notes, "mine");
  geodesic::test::WriteFile(other, "mine");
  ASSERT_TRUE(Open().ok());
  EXPECT_EQ(store_->size(), 0);
  EXPECT_EQ(geodesic::test::FileBytes(notes), "mine");
  EXPECT_EQ(geodesic::test::FileBytes(other), "mine");
  EXPECT_EQ(quarantined(), 0);
}

TEST_F(BlobStoreTest, WhatACrashLeftBesideIsRemoved) {
  ASSERT_TRUE(Open().ok());
  geodesic::test::WriteFile(data_dir() + "/things/" + Name('a') + ".3.tmp",
                            "half of");
  ASSERT_TRUE(Open().ok());
  EXPECT_EQ(files(), 0);
  EXPECT_EQ(quarantined(), 0);
  EXPECT_EQ(store_->size(), 0);
}

TEST_F(BlobStoreTest, AFileThatVanishedIsForgotten) {
  ASSERT_TRUE(Open().ok());
  ASSERT_TRUE(Put(*store_, Name('a'), "x").ok());
  std::filesystem::remove(FileOf(Name('a')));
  EXPECT_TRUE(absl::IsNotFound(Read(*store_, Name('a')).status()));
  EXPECT_EQ(store_->Find(Name('a')), std::nullopt);
  EXPECT_EQ(store_->used_bytes(), 0);
  EXPECT_TRUE(Put(*store_, Name('a'), "y").ok());
  EXPECT_EQ(*Read(*store_, Name('a')), "y");
}

TEST_F(BlobStoreTest, ErrorsOfTheReaderAreItsOwn) {
  ASSERT_TRUE(Open().ok());
  ASSERT_TRUE(Put(*store_, Name('a'), "xy").ok());
  const absl::Status failed = store_->Read(
      Name('a'),
      [](std::string_view, BlobBody&) { return absl::AbortedError("enough"); });
  EXPECT_EQ(failed, absl::AbortedError("enough"));
  const absl::Status partial = store_->Read(
      Name('a'), [](std::string_view, BlobBody&) { return absl::OkStatus(); });
  EXPECT_TRUE(absl::IsInternal(partial)) << partial;
  EXPECT_TRUE(Read(*store_, Name('a')).ok());
  EXPECT_EQ(quarantined(), 0);
}

TEST_F(BlobStoreTest, WhatReplacedADamagedBlobIsNotSetAside) {
  ASSERT_TRUE(Open().ok());
  ASSERT_TRUE(Put(*store_, Name('a'), "the old").ok());
  EXPECT_TRUE(absl::IsDataLoss(
      store_->Read(Name('a'), [&](std::string_view, BlobBody&) {
        EXPECT_TRUE(Put(*store_, Name('a'), "the new").ok());
        return absl::DataLossError("damaged");
      })));
  EXPECT_EQ(Read(*store_, Name('a')).value_or("gone"), "the new");
  EXPECT_EQ(quarantined(), 0);
}

// Of one name, each time: whichever comes first, the index has what the folder
// has.
TEST_F(BlobStoreTest, AReplacementAndAnErasureFollowEachOther) {
  ASSERT_TRUE(Open().ok());
  const auto inode = [this] {
    struct stat facts {};
    return stat(FileOf(Name('a')).c_str(), &facts) == 0 ? facts.st_ino : 0;
  };
  for (int round = 0; round < 50; ++round) {
    ASSERT_TRUE(Put(*store_, Name('a'), "the old").ok());
    const ino_t old = inode();
    const bool is_late = round % 2 != 0;
    {
      const std::jthread put(
          [&] { EXPECT_TRUE(Put(*store_, Name('a'), "the new").ok()); });
      const std::jthread erase([&] {
        // As soon as the new file has its name, before it is flushed.
        if (is_late) EXPECT_TRUE(Until([&] { return inode() != old; }));
        EXPECT_TRUE(store_->Erase(Name('a')).ok());
      });
    }
    ASSERT_EQ(store_->size(), files()) << round;
    if (is_late) EXPECT_EQ(store_->size(), 0);
    EXPECT_EQ(store_->used_bytes(), store_->size() * kBlock);
    if (store_->size() > 0) EXPECT_EQ(*Read(*store_, Name('a')), "the new");
  }
}

// Puts, reads and erasures of the same few names from many threads: the index
// agrees with the folder at the end, and the bound held throughout.
TEST_F(BlobStoreTest, ThreadsAgree) {
  constexpr uint64_t kCapacity = 3 * kBlock;
  ASSERT_TRUE(Open(kCapacity).ok());
  store_.reset();
  absl::StatusOr<std::unique_ptr<BlobStore>> store =
      BlobStore::Open(*folder_, {.kind = "thing", .capacity = kCapacity});
  ASSERT_TRUE(store.ok());
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 60; ++i) {
        const std::string name = Name("abcdef"[(7 * t + i) % 6]);
        const std::string body(10, name[0]);
        if ((i + t) % 3 == 0) {
          const absl::Status put = Put(**store, name, body);
          EXPECT_TRUE(put.ok() || absl::IsResourceExhausted(put)) << put;
        } else if ((i + t) % 3 == 1) {
          const auto read = Read(**store, name);
          if (read.ok()) {
            EXPECT_EQ(*read, body);
          } else {
            EXPECT_TRUE(absl::IsNotFound(read.status())) << read.status();
          }
        } else {
          const absl::Status erased = (*store)->Erase(name);
          EXPECT_TRUE(erased.ok() || absl::IsNotFound(erased)) << erased;
        }
        EXPECT_LE((*store)->used_bytes(), kCapacity);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ((*store)->size(), files());
  const std::vector<std::string> names = Names(**store);
  EXPECT_EQ((*store)->used_bytes(), names.size() * kBlock);
  for (const std::string& name : names) {
    EXPECT_EQ(*Read(**store, name), std::string(10, name[0]));
  }
}

}  // namespace
}  // namespace geodesic::server
