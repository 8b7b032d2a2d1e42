#include "server/engine/base/lru_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Store = LruStore<std::string, int>;

// Puts a value of 10 bytes into the store.
Store::Handle Put(Store& store, const std::string& key, int value) {
  absl::StatusOr<ByteReservation> room = store.Reserve(10);
  EXPECT_TRUE(room.ok()) << room.status();
  if (!room.ok()) return nullptr;
  return store.Insert(key, value, *std::move(room)).value;
}

TEST(LruStore, ThePresentEntryWins) {
  Store store("test store", 100);
  Put(store, "a", 1);
  const auto again = store.Insert("a", 2, *store.Reserve(10));
  EXPECT_FALSE(again.is_new);
  EXPECT_EQ(*again.value, 1);
  EXPECT_EQ(store.used_bytes(), 10);
}

TEST(LruStore, TheLeastRecentlyUsedGoesFirst) {
  Store store("test store", 30);
  Put(store, "a", 1);
  Put(store, "b", 2);
  Put(store, "c", 3);
  store.Find("a");
  EXPECT_EQ(store.evictions(), 0);
  Put(store, "d", 4);
  EXPECT_EQ(store.evictions(), 1);
  EXPECT_NE(store.Find("a"), nullptr);
  EXPECT_EQ(store.Find("b"), nullptr);
  EXPECT_NE(store.Find("c"), nullptr);
  EXPECT_NE(store.Find("d"), nullptr);
}

TEST(LruStore, AsManyGoAsMakeRoom) {
  Store store("test store", 30);
  Put(store, "a", 1);
  Put(store, "b", 2);
  Put(store, "c", 3);
  const auto room = store.Reserve(15);
  ASSERT_TRUE(room.ok());
  EXPECT_EQ(store.size(), 1);
  EXPECT_NE(store.Find("c"), nullptr);
  EXPECT_EQ(store.used_bytes(), 25);
}

TEST(LruStore, EntriesArePinnedWhileHeld) {
  Store store("test store", 30);
  Store::Handle pinned = Put(store, "a", 1);
  Put(store, "b", 2);
  Put(store, "c", 3);
  Put(store, "d", 4);
  EXPECT_EQ(store.Find("b"), nullptr);
  EXPECT_EQ(store.Find("a"), pinned);
  pinned.reset();
  store.Find("c");
  store.Find("d");
  Put(store, "e", 5);
  EXPECT_EQ(store.Find("a"), nullptr);
}

TEST(LruStore, ARequestInVainEvictsNothing) {
  Store store("test store", 30);
  const Store::Handle pinned = Put(store, "a", 1);
  Put(store, "b", 2);
  const absl::Status status = store.Reserve(25).status();
  EXPECT_TRUE(absl::IsResourceExhausted(status));
  EXPECT_THAT(std::string(status.message()), HasSubstr("test store"));
  EXPECT_TRUE(RetryAfter(status).has_value());
  EXPECT_NE(store.Find("b"), nullptr);

  const absl::Status never = store.Reserve(31).status();
  EXPECT_TRUE(absl::IsResourceExhausted(never));
  EXPECT_EQ(RetryAfter(never), std::nullopt);
  EXPECT_EQ(store.size(), 2);
}

TEST(LruStore, AReservationTakesRoom) {
  Store store("test store", 30);
  Put(store, "a", 1);
  {
    const auto room = store.Reserve(20);
    ASSERT_TRUE(room.ok());
    const auto more = store.Reserve(15);
    EXPECT_TRUE(absl::IsResourceExhausted(more.status()));
    EXPECT_NE(store.Find("a"), nullptr);
  }
  EXPECT_TRUE(store.Reserve(20).ok());
}

TEST(LruStore, ErasedEntriesCountUntilNobodyHoldsThem) {
  Store store("test store", 30);
  Store::Handle held = Put(store, "a", 1);
  EXPECT_TRUE(store.Erase("a"));
  EXPECT_FALSE(store.Erase("a"));
  EXPECT_EQ(store.Find("a"), nullptr);
  EXPECT_EQ(*held, 1);
  EXPECT_EQ(store.used_bytes(), 10);
  EXPECT_FALSE(store.Reserve(25).ok());
  held.reset();
  EXPECT_EQ(store.used_bytes(), 0);
}

TEST(LruStore, HandlesOutliveTheStore) {
  Store::Handle held;
  {
    Store store("test store", 30);
    held = Put(store, "a", 7);
  }
  EXPECT_EQ(*held, 7);
}

TEST(LruStore, ErasesByPredicate) {
  Store store("test store", 100);
  Put(store, "a1", 1);
  Put(store, "a2", 2);
  Put(store, "b1", 3);
  store.EraseIf([](const std::string& key) { return key[0] == 'a'; });
  EXPECT_EQ(store.size(), 1);
  EXPECT_EQ(store.used_bytes(), 10);
  // The order of use has no dangling ends: everything can still be evicted.
  EXPECT_TRUE(store.Reserve(100).ok());
}

TEST(LruStore, ListsPagesInOrderOfKey) {
  Store store("test store", 100);
  for (const char* key : {"d", "a", "c", "b"}) Put(store, key, key[0]);
  const auto values = [](const std::vector<Store::Handle>& page) {
    std::vector<int> result;
    for (const Store::Handle& handle : page) result.push_back(*handle);
    return result;
  };
  EXPECT_THAT(values(store.List("", 3)), ElementsAre('a', 'b', 'c'));
  EXPECT_THAT(values(store.List("c", 3)), ElementsAre('d'));
  EXPECT_THAT(values(store.List("aa", 1)), ElementsAre('b'));
  EXPECT_TRUE(store.List("d", 3).empty());
}

TEST(LruStore, TellsWhatItForgets) {
  std::vector<std::string> removed;
  Store store("test store", 20,
              [&](const std::string& key) { removed.push_back(key); });
  Put(store, "a", 1);
  Put(store, "b", 2);
  Put(store, "c", 3);
  store.Erase("c");
  EXPECT_THAT(removed, ElementsAre("a", "c"));
}

TEST(LruStore, ABetterValueTakesThePlaceOfAPresentOne) {
  LruStore<int, int> store("test store", 100);
  store.Insert(1, 10, *store.Reserve(30));
  const auto held = store.Find(1);
  const auto keep_larger = [](int value) {
    return [value](int present) { return present >= value; };
  };
  EXPECT_EQ(*store.Insert(1, 5, *store.Reserve(20), keep_larger(5)).value, 10);
  EXPECT_EQ(*store.Insert(1, 15, *store.Reserve(20), keep_larger(15)).value,
            15);
  EXPECT_EQ(*store.Find(1), 15);
  EXPECT_EQ(store.size(), 1);
  // Who holds the old one keeps it, and its charge.
  EXPECT_EQ(*held, 10);
  EXPECT_EQ(store.used_bytes(), 50);
}

}  // namespace
}  // namespace geodesic::server
