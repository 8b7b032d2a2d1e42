// Files named by digests, in one folder, bounded in bytes.
//
//   auto store = BlobStore::Open(folder, {.kind = "mesh", .capacity = bytes});
//   absl::Status status = store->Put(name, metadata, {head, body});
//   status = store->Read(name, [&](std::string_view, BlobBody& body) {
//     return body.Read(into);
//   });
//
// Guarantees, even if the process or the machine dies at any moment:
//   1. a blob for which Put returned OK stays until erased, evicted or damaged;
//   2. a blob for which Erase returned OK does not come back;
//   3. a blob is whole or absent: it is written under a temporary name, flushed
//      and then renamed; the next Open removes what a crash left;
//   4. Read fails unless the digests agree. A damaged file is moved to the
//      folder "quarantine" and reported, and its name is free again;
//   5. all files together, including those being written, never exceed the
//      capacity, counted in blocks of 4 KiB as disks do, nor max_count; room is
//      made by removing the least recently used;
//   6. after an error everything is as before, and the next call tries again:
//      no restart is needed after a disk was full or read-only.
//
// The index is in memory; Open makes it from the folder alone. Put and Read
// store the time of last use as the file's time, so a restart roughly knows it.

#ifndef GEODESIC_SERVER_STORE_BLOB_STORE_H_
#define GEODESIC_SERVER_STORE_BLOB_STORE_H_

#include <sys/types.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "digest/sha256.h"
#include "server/locks/mutex.h"
#include "server/store/blob_format.h"
#include "server/store/blobs.h"
#include "server/store/data_folder.h"
#include "server/store/posix_file.h"
#include "server/store/shared_flush.h"

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
  uint64_t reads = 0;      // failures included
  uint64_t read_failures = 0;
  uint64_t evictions = 0;
  uint64_t damaged = 0;
};

// A body that is being written.
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

// Thread-safe. Put, Read, Look and Erase wait for the disk; the others do not.
class BlobStore final : public Blobs {
 public:
  struct Options {
    // The ending of the files and, in plural, the name of their folder ("mesh"
    // files are in "meshes"): at most 8 letters.
    std::string kind;
    uint64_t capacity = 0;
    // Whether a blob's name must be the digest of its body.
    bool is_named_by_content = false;
    // Bounds memory, of which each blob takes a few hundred bytes.
    size_t max_count = 1'000'000;
    // Called for each blob that is gone though nobody erased it: without a
    // lock, after it is gone, and never by Open.
    std::function<void(const std::string& name)> removed;
    // Called with a line for people about damage and what was done about it.
    std::function<void(const std::string& line)> warn;
  };

  // Reads the folder: O(n) files opened.
  // Errors: UNAVAILABLE naming the file or folder that cannot be used.
  // REQUIRES: `folder` outlives the store.
  static absl::StatusOr<std::unique_ptr<BlobStore>> Open(
      const DataFolder& folder, Options options);

  BlobStore(const BlobStore&) = delete;
  BlobStore& operator=(const BlobStore&) = delete;

  // Describes the blob and marks it as used; empty if it is not there.
  std::optional<BlobInfo> Find(const std::string& name);

  // Up to `count` blobs in order of name, from the first above `after`. Marks
  // nothing as used.
  std::vector<BlobInfo> List(const std::string& after, size_t count) const;

  // Calls `visit` for each blob, under a lock. O(n).
  void ForEach(absl::FunctionRef<void(const std::string& name,
                                      std::string_view metadata)>
                   visit) const;

  // Whether a blob of this size can ever be kept. Errors: with the figures and
  // the server's flag.
  absl::Status Admit(uint64_t body_bytes, uint64_t metadata_bytes) override;

  // Keeps a blob, in place of the one with this name, if there is one. `write`
  // appends its body, `body_bytes` in all.
  // Errors: as Admit; RESOURCE_EXHAUSTED (writes under way take the room; disk
  // full), UNAVAILABLE (the disk cannot be written), INTERNAL (the body has
  // another size or, if it is_named_by_content, another digest); those of
  // `write`.
  // REQUIRES: IsSha256Hex(name).
  absl::Status Put(const std::string& name, std::string_view metadata,
                   uint64_t body_bytes,
                   absl::FunctionRef<absl::Status(BlobSink& sink)> write);
  // The same for a body that is given in parts.
  absl::Status Put(const std::string& name, std::string_view metadata,
                   std::span<const std::string_view> body) override;

  // A file that is damaged goes into quarantine. If `take` fails with NOT_FOUND
  // or CANCELLED, that counts as no failure of the disk.
  absl::Status Read(const std::string& name, TakeBlob take) override;

  // Whether the blob's file is there, with its size. One that somebody has
  // removed is forgotten. Errors: NOT_FOUND; as DiskError.
  absl::Status Look(const std::string& name);

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
  // Held while a name in the folder changes, until the change is on disk and in
  // the index, so they agree. Taken before mutex_.
  class NameHold;

  BlobStore(Options options, FileDescriptor folder, Quarantine& quarantine);

  std::string FileName(const std::string& name) const;
  std::string PathOf(const std::string& name) const;  // for messages
  void Warn(const std::string& line) const;

  // The folder. `path`: whose change waits for it.
  absl::Status Flush(const std::string& path);

  absl::Status Scan();
  absl::StatusOr<Found> Inspect(const std::string& name);
  // Reads header and metadata of an open file; checks that they fit its size.
  absl::StatusOr<BlobInfo> ReadInfo(int file, uint64_t size,
                                    const std::string& name,
                                    BlobHeader& header) const;
  // Removes the file and its entry, on the disk with the next flush. Errors: as
  // Erase. REQUIRES: the name is held.
  absl::Status Unlink(const std::string& name);
  // Reserves room for `count` files that take `bytes` together. Does not wait
  // for the disk: what is evicted may come back if the machine dies.
  absl::Status MakeRoom(uint64_t bytes, size_t count);
  // Put and Read without counting.
  absl::Status Keep(const std::string& name, std::string_view metadata,
                    uint64_t body_bytes,
                    absl::FunctionRef<absl::Status(BlobSink& sink)> write);
  absl::Status Take(const std::string& name, TakeBlob take);
  // Writes and flushes a whole file under a temporary name, which it returns.
  absl::StatusOr<std::string> WriteTemporary(
      const BlobInfo& info,
      absl::FunctionRef<absl::Status(BlobSink& sink)> write);
  // Renames it to its own name and puts it into the index, which then counts
  // its bytes; `is_reserved` becomes false.
  absl::Status Publish(const std::string& temporary, BlobInfo info,
                       bool& is_reserved);
  absl::Status Write(
      int file, const BlobInfo& info,
      absl::FunctionRef<absl::Status(BlobSink& sink)> write) const;
  // Moves a damaged file to quarantine if it still is the one with `inode`.
  void SetAside(const std::string& name, ino_t inode, const absl::Status& why);

  // Whether so much fits beside what is being written.
  bool HasRoom(uint64_t bytes, size_t count) const
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  void Insert(BlobInfo info) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  void Remove(Entries::iterator it) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);

  Options options_;  // constant after Open
  const FileDescriptor folder_;
  Quarantine& quarantine_;

  // Held while room is made, so no two writers count on the same bytes.
  Mutex room_mutex_ ABSL_ACQUIRED_BEFORE(names_mutex_, mutex_);

  SharedFlush flush_;  // of the folder
  std::atomic<uint64_t> next_temporary_ = 0;

  Mutex names_mutex_ ABSL_ACQUIRED_BEFORE(mutex_);
  std::condition_variable_any name_is_free_;
  // See NameHold.
  std::set<std::string> held_names_ ABSL_GUARDED_BY(names_mutex_);

  mutable Mutex mutex_;
  Entries entries_ ABSL_GUARDED_BY(mutex_);
  // Keys of entries_, oldest first.
  std::list<const std::string*> recency_ ABSL_GUARDED_BY(mutex_);
  uint64_t entry_bytes_ ABSL_GUARDED_BY(mutex_) = 0;  // of entries_
  // Of what is being written.
  uint64_t reserved_bytes_ ABSL_GUARDED_BY(mutex_) = 0;
  size_t reserved_count_ ABSL_GUARDED_BY(mutex_) = 0;
  BlobCounters counters_ ABSL_GUARDED_BY(mutex_);
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_BLOB_STORE_H_
