// Files named by digests, in one folder, bounded in bytes.
//
//   auto store = BlobStore::Open(folder, {.kind = "mesh", .capacity = bytes});
//   absl::Status status = store->Put(name, metadata, {head, body});
//   status = store->Read(name, [&](BlobBody& b) { return b.Read(into); });
//
// Guarantees, also when the process or the machine dies at any moment:
//   1. what Put said OK to is there until it is erased, evicted or damaged;
//   2. what Erase said OK to stays away;
//   3. a blob is whole or absent: it is written beside its place, flushed, and
//      then takes its name in one step; what a crash left beside is removed by
//      the next Open;
//   4. no damaged byte is handed out: Read fails unless the digests agree. A
//      damaged file is moved to the folder "quarantine" and reported, and its
//      name is free again;
//   5. the files, those being written included, never take more than the
//      capacity together, counted in blocks of 4 KiB as disks do, nor are there
//      more than a number; room is made by removing what was unused longest;
//   6. after an error everything is as before, and the next call tries anew: a
//      disk that was full or read-only needs no restart.
//
// The index is in memory and made from the folder alone by Open. How recently a
// blob was used is kept as its file's time, at every Put and Read, so it is
// known roughly after a restart.

#ifndef GEODESIC_SERVER_STORE_BLOB_STORE_H_
#define GEODESIC_SERVER_STORE_BLOB_STORE_H_

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "digest/sha256.h"
#include "server/store/blob_format.h"
#include "server/store/data_folder.h"
#include "server/store/posix_file.h"

namespace geodesic::server {

struct BlobInfo {
  std::string name;
  std::string metadata;
  uint64_t body_bytes = 0;
  uint64_t file_bytes = 0;
};

// How often things have happened since the start.
struct BlobCounters {
  uint64_t writes = 0;  // failures included
  uint64_t write_failures = 0;
  uint64_t too_large = 0;  // for the whole store; nothing was written
  uint64_t reads = 0;      // likewise
  uint64_t read_failures = 0;
  uint64_t evictions = 0;
  uint64_t damaged = 0;
};

// A body while it is read, from its first byte to its last. What was read
// is good only when BlobStore::Read has returned OK.
class BlobBody {
 public:
  uint64_t bytes_left() const { return bytes_left_; }

  // The next bytes.
  // Errors: DATA_LOSS when so many are not left; as DiskError.
  absl::Status Read(std::span<char> bytes);

 private:
  friend class BlobStore;
  BlobBody(int file, uint64_t bytes) : file_(file), bytes_left_(bytes) {}

  const int file_;
  uint64_t bytes_left_;
  uint64_t offset_ = kBlobHeaderBytes;
  Sha256 hash_;
};

// A body while it is written.
class BlobSink {
 public:
  // Errors: as DiskError.
  absl::Status Append(std::string_view bytes);

 private:
  friend class BlobStore;
  BlobSink(int file, const std::string& path) : file_(file), path_(path) {}

  const int file_;
  const std::string& path_;  // for messages
  uint64_t bytes_ = 0;
  Sha256 hash_;
};

// Thread-safe. Put, Read and Erase wait for the disk; the others do not.
class BlobStore {
 public:
  struct Options {
    // Of the files, their ending and the name of their folder ("mesh" files
    // are in "meshes"): at most 8 letters.
    std::string kind;
    uint64_t capacity = 0;
    // Whether a blob's name is the digest of its body: then it must be.
    bool is_named_by_content = false;
    // Each takes a few hundred bytes of memory, too.
    size_t max_count = 1'000'000;
    // Hears of each blob that is gone though nobody erased it. Called without
    // a lock, when it is gone already, and never by Open.
    std::function<void(const std::string& name)> removed;
    // Hears, in a line for people, of damage and of what was done about it.
    std::function<void(const std::string& line)> warn;
  };

  // Reads the folder: O(n) files opened.
  // Errors: UNAVAILABLE naming the file or folder that cannot be used.
  // REQUIRES: `folder` outlives the store.
  static absl::StatusOr<std::unique_ptr<BlobStore>> Open(
      const DataFolder& folder, Options options);

  BlobStore(const BlobStore&) = delete;
  BlobStore& operator=(const BlobStore&) = delete;

  // What is known of the blob, which is marked as used, or nothing.
  std::optional<BlobInfo> Find(const std::string& name);

  // Up to `count` blobs in order of name, from the first above `after`. Marks
  // nothing as used.
  std::vector<BlobInfo> List(const std::string& after, size_t count) const;

  // Calls `visit` for each blob, under a lock. O(n).
  void ForEach(absl::FunctionRef<void(const std::string& name,
                                      std::string_view metadata)>
                   visit) const;

  // Whether a blob of so many bytes can ever be kept; one that cannot is
  // counted as refused. Errors: RESOURCE_EXHAUSTED with the figures and the
  // server's flag.
  absl::Status Admit(uint64_t body_bytes, uint64_t metadata_bytes);

  // Keeps a blob, whose body `write` appends, `body_bytes` in all; in place of
  // the one with this name, if there is one.
  // Errors: as Admit; RESOURCE_EXHAUSTED (larger than what others do not write
  // at the moment; disk full), UNAVAILABLE (the disk cannot be
  // written), INTERNAL (the body has not that size; the name is not its digest,
  // but should be); those of `write`.
  // REQUIRES: IsSha256Hex(name).
  absl::Status Put(const std::string& name, std::string_view metadata,
                   uint64_t body_bytes,
                   absl::FunctionRef<absl::Status(BlobSink& sink)> write);
  // The same for a body that is the parts one after the other.
  absl::Status Put(const std::string& name, std::string_view metadata,
                   std::span<const std::string_view> body);

  // Hands the body to `take`, which must read all of it unless it fails.
  // Errors: NOT_FOUND; DATA_LOSS (the file was damaged and is in quarantine);
  // UNAVAILABLE, RESOURCE_EXHAUSTED (it cannot be read now); those of `take`.
  absl::Status Read(const std::string& name,
                    absl::FunctionRef<absl::Status(BlobBody& body)> take);

  // Errors: NOT_FOUND; as Put.
  absl::Status Erase(const std::string& name);

  size_t size() const;
  uint64_t used_bytes() const;
  uint64_t capacity() const { return options_.capacity; }
  BlobCounters counters() const;

 private:
  struct Entry {
    std::string metadata;
    uint64_t body_bytes = 0;
    uint64_t file_bytes = 0;
    std::list<const std::string*>::iterator position;
  };
  using Entries = std::map<std::string, Entry>;
  struct Found;

  BlobStore(Options options, FileDescriptor folder, Quarantine& quarantine);

  std::string FileName(const std::string& name) const;
  std::string PathOf(const std::string& name) const;  // for messages
  void Warn(const std::string& line) const;

  absl::Status Scan();
  absl::StatusOr<Found> Inspect(const std::string& name);
  // The header and the metadata of an open file, and that they fit its size.
  absl::StatusOr<BlobInfo> ReadInfo(int file, uint64_t size,
                                    const std::string& name,
                                    BlobHeader& header) const;
  absl::Status MakeRoom(uint64_t bytes);
  // Put and Read, uncounted.
  absl::Status Keep(const std::string& name, std::string_view metadata,
                    uint64_t body_bytes,
                    absl::FunctionRef<absl::Status(BlobSink& sink)> write);
  absl::Status Take(const std::string& name,
                    absl::FunctionRef<absl::Status(BlobBody& body)> take);
  // A whole file beside the others.
  absl::StatusOr<std::string> WriteTemporary(
      const BlobInfo& info,
      absl::FunctionRef<absl::Status(BlobSink& sink)> write);
  // Gives it its name and puts it into the index, where it counts by itself:
  // `is_reserved` is false from then on.
  absl::Status Publish(const std::string& temporary, BlobInfo info,
                       bool& is_reserved);
  absl::Status Write(
      int file, const BlobInfo& info,
      absl::FunctionRef<absl::Status(BlobSink& sink)> write) const;
  // Takes a damaged file out of the way, if it still is the one with `inode`.
  void SetAside(const std::string& name, ino_t inode, const absl::Status& why);

  // These REQUIRE mutex_ held:
  bool HasRoom(uint64_t bytes) const;
  void Insert(BlobInfo info);
  void Remove(Entries::iterator it);

  Options options_;  // constant after Open
  const FileDescriptor folder_;
  Quarantine& quarantine_;

  // Held while room is made, so that no two count the same bytes as theirs.
  // Taken before the others.
  std::mutex room_mutex_;

  // Held while a name in the folder changes, until the change is on the disk
  // and in the index, so that these agree. Taken before mutex_.
  std::mutex names_mutex_;
  uint64_t next_temporary_ = 0;  // guarded by names_mutex_

  mutable std::mutex mutex_;
  // Guarded by mutex_:
  Entries entries_;
  std::list<const std::string*> recency_;  // keys of entries_, oldest first
  uint64_t entry_bytes_ = 0;               // of entries_
  uint64_t reserved_bytes_ = 0;            // of what is being written
  BlobCounters counters_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_BLOB_STORE_H_
