// A store in a folder of the test's own, that can be opened again.

#ifndef GEODESIC_TESTS_STORE_BLOB_FIXTURE_H_
#define GEODESIC_TESTS_STORE_BLOB_FIXTURE_H_

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/store/blob_store.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::server::test {

// A name: any 64 digits will do.
inline std::string Name(char digit) { return std::string(64, digit); }

inline absl::Status Put(BlobStore& store, const std::string& name,
                        std::string_view body,
                        std::string_view metadata = "about it") {
  return store.Put(name, metadata, std::array{body});
}

inline absl::StatusOr<std::string> Read(BlobStore& store,
                                        const std::string& name) {
  std::string bytes;
  absl::Status status = store.Read(name, [&](std::string_view, BlobBody& body) {
    bytes.resize(body.bytes_left());
    return body.Read(bytes);
  });
  if (!status.ok()) return status;
  return bytes;
}

class BlobTest : public ::testing::Test {
 protected:
  // What a blob's file has beside its body, and in what files are counted.
  static constexpr uint64_t kExtra = kBlobHeaderBytes + 8;
  static constexpr uint64_t kBlock = 4096;

  // Opens the folder as the next process would.
  absl::Status Open(uint64_t capacity = uint64_t{1} << 20) {
    store_.reset();
    folder_.reset();
    absl::StatusOr<DataFolder> folder = DataFolder::Open(data_dir());
    if (!folder.ok()) return folder.status();
    folder_.emplace(*std::move(folder));
    absl::StatusOr<std::unique_ptr<BlobStore>> store = BlobStore::Open(
        *folder_,
        {.kind = "thing",
         .capacity = capacity,
         .removed = [this](const std::string& n) { removed_.push_back(n); },
         .warn = [this](const std::string& l) { warnings_.push_back(l); }});
    if (!store.ok()) return store.status();
    store_ = *std::move(store);
    return absl::OkStatus();
  }

  void Close() {
    store_.reset();
    folder_.reset();
  }

  std::string data_dir() const { return temporary_ / "data"; }
  std::string FileOf(const std::string& name) const {
    return data_dir() + "/things/" + name + ".thing";
  }
  static size_t FilesIn(const std::string& folder) {
    size_t count = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      count += file.is_regular_file() ? 1 : 0;
    }
    return count;
  }
  size_t files() const { return FilesIn(data_dir() + "/things"); }
  size_t quarantined() const { return FilesIn(data_dir() + "/quarantine"); }

  geodesic::test::TemporaryFolder temporary_;
  std::vector<std::string> removed_;
  std::vector<std::string> warnings_;
  std::optional<DataFolder> folder_;
  std::unique_ptr<BlobStore> store_;
};

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_STORE_BLOB_FIXTURE_H_
