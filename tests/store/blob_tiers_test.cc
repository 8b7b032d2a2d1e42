#include "server/store/blob_tiers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

#include "tests/store/blob_fixture.h"

namespace geodesic::server {
namespace {

using test::Name;

// The second tier, which cannot fail.
class MapBlobs final : public Blobs {
 public:
  absl::Status Read(const std::string& name, TakeBlob take) override {
    ++reads;
    const auto it = bodies.find(name);
    if (it == bodies.end()) return absl::NotFoundError("not shared");
    Body body(it->second);
    return take("about it", body);
  }
  absl::Status Admit(uint64_t, uint64_t) override { return absl::OkStatus(); }
  absl::Status Put(const std::string& name, std::string_view,
                   std::span<const std::string_view> body) override {
    bodies[name] = body.front();
    return absl::OkStatus();
  }

  int reads = 0;
  std::map<std::string, std::string> bodies;

 private:
  class Body final : public BlobBody {
   public:
    explicit Body(const std::string& bytes)
        : BlobBody(bytes.size()), bytes_(bytes) {}

   private:
    absl::Status ReadNext(std::span<char> bytes) override {
      bytes_.copy(bytes.data(), bytes.size(), offset_);
      offset_ += bytes.size();
      return absl::OkStatus();
    }
    const std::string& bytes_;
    size_t offset_ = 0;
  };
};

class BlobTiersTest : public test::BlobTest {
 protected:
  void SetUp() override { ASSERT_TRUE(Open().ok()); }

  // Where the body was found, and what it says. `refused` is of no use.
  static std::string Read(BlobTiers& tiers, char name,
                          const std::string& refused = "") {
    std::string bytes;
    const absl::StatusOr<BlobTier> tier =
        tiers.Read(Name(name), [&](std::string_view, BlobBody& body) {
          bytes.resize(body.bytes_left());
          absl::Status status = body.Read(bytes);
          if (status.ok() && bytes == refused) {
            return absl::NotFoundError("of no use");
          }
          return status;
        });
    if (!tier.ok()) return std::string(tier.status().message());
    return (*tier == BlobTier::kDisk ? "disk: " : "shared: ") + bytes;
  }

  MapBlobs shared_;
};

constexpr std::array<std::string_view, 1> kBody = {"here"};

TEST_F(BlobTiersTest, TheDiskIsAskedFirst) {
  BlobTiers tiers(store_.get(), &shared_);
  shared_.bodies = {{Name('a'), "elsewhere"}, {Name('b'), "elsewhere"}};
  ASSERT_TRUE(tiers.Keep(Name('a'), "about it", kBody).ok());
  EXPECT_EQ(Read(tiers, 'a'), "disk: here");
  EXPECT_EQ(shared_.reads, 0);
  EXPECT_EQ(Read(tiers, 'b'), "shared: elsewhere");
  EXPECT_EQ(Read(tiers, 'c'), "not shared");
  // What is shared is not known to be here.
  EXPECT_TRUE(tiers.Find(Name('a')).has_value());
  EXPECT_FALSE(tiers.Find(Name('b')).has_value());
}

TEST_F(BlobTiersTest, WhatIsOfNoUseOrDamagedHereIsSoughtElsewhere) {
  BlobTiers tiers(store_.get(), &shared_);
  shared_.bodies = {{Name('a'), "elsewhere"}};
  ASSERT_TRUE(tiers.Keep(Name('a'), "about it", kBody).ok());
  EXPECT_EQ(Read(tiers, 'a', /*refused=*/"here"), "shared: elsewhere");
  EXPECT_EQ(store_->counters().read_failures, 0);
  {
    std::ofstream file(FileOf(Name('a')), std::ios::binary | std::ios::app);
    file << "more";
  }
  EXPECT_EQ(Read(tiers, 'a'), "shared: elsewhere");
  EXPECT_EQ(quarantined(), 1);
}

TEST_F(BlobTiersTest, KeepingIsForTheDiskAndSharingForTheOther) {
  BlobTiers tiers(store_.get(), &shared_);
  ASSERT_TRUE(tiers.Keep(Name('a'), "about it", kBody).ok());
  EXPECT_TRUE(shared_.bodies.empty());
  tiers.Share(Name('b'), "about it", kBody);
  EXPECT_EQ(store_->size(), 1);
  EXPECT_EQ(shared_.bodies.at(Name('b')), "here");
  // Others may still want it.
  tiers.Share(Name('a'), "about it", kBody);
  EXPECT_TRUE(tiers.Erase(Name('a')).ok());
  EXPECT_EQ(Read(tiers, 'a'), "shared: here");
}

TEST_F(BlobTiersTest, EitherMayBeMissing) {
  BlobTiers none(nullptr, nullptr);
  EXPECT_TRUE(none.Keep(Name('a'), "", kBody).ok());
  none.Share(Name('a'), "", kBody);
  EXPECT_THAT(Read(none, 'a'), ::testing::HasSubstr("there is no"));
  EXPECT_TRUE(absl::IsNotFound(none.Erase(Name('a'))));
  BlobTiers no_disk(nullptr, &shared_);
  no_disk.Share(Name('a'), "", kBody);
  EXPECT_EQ(Read(no_disk, 'a'), "shared: here");
  BlobTiers no_tier(store_.get(), nullptr);
  ASSERT_TRUE(no_tier.Keep(Name('a'), "", kBody).ok());
  EXPECT_EQ(Read(no_tier, 'a'), "disk: here");
}

}  // namespace
}  // namespace geodesic::server
