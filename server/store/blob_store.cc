#include "server/store/blob_store.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <tuple>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/strip.h"

namespace geodesic::server {
namespace {

constexpr absl::string_view kTemporaryEnding = ".tmp";

// Metadata is small; a header that claims more is refused before allocation.
constexpr uint64_t kMaxMetadataBytes = uint64_t{256} << 20;

std::string Plural(const std::string& kind) {
  return absl::StrCat(kind, absl::EndsWith(kind, "h") ? "es" : "s");
}

// As DiskError, where a name is made in the folder: it is the folder that is
// not found then.
absl::Status FolderError(int error, std::string_view verb,
                         const std::string& path) {
  if (error != ENOENT) return DiskError(error, verb, path);
  return absl::UnavailableError(absl::StrCat(
      "the server cannot write ", path,
      ": its data folder has been removed while it ran; start it again"));
}

class FileBody final : public BlobBody {
 public:
  FileBody(int file, uint64_t bytes) : BlobBody(bytes), file_(file) {}

 private:
  absl::Status ReadNext(std::span<char> bytes) override {
    absl::Status status = ReadAt(file_, offset_, bytes, "the file");
    offset_ += bytes.size();
    return status;
  }

  const int file_;
  uint64_t offset_ = kBlobHeaderBytes;
};

}  // namespace

absl::Status BlobSink::Append(std::string_view bytes) {
  hash_.Update(bytes);
  absl::Status status = WriteAt(file_, kBlobHeaderBytes + bytes_, bytes, path_);
  bytes_ += bytes.size();
  return status;
}

// A file that Scan found, and when it was last used.
struct BlobStore::Found {
  BlobInfo info;
  timespec used;
};

class BlobStore::NameHold {
 public:
  NameHold(BlobStore& store, const std::string& name)
      : store_(store), name_(name) {
    MutexLock lock(store_.names_mutex_);
    while (store_.held_names_.contains(name_)) store_.name_is_free_.wait(lock);
    store_.held_names_.insert(name_);
  }
  NameHold(const NameHold&) = delete;
  NameHold& operator=(const NameHold&) = delete;
  ~NameHold() {
    MutexLock lock(store_.names_mutex_);
    store_.held_names_.erase(name_);
    store_.name_is_free_.notify_all();
  }

 private:
  BlobStore& store_;
  const std::string name_;
};

absl::StatusOr<std::unique_ptr<BlobStore>> BlobStore::Open(
    const DataFolder& folder, Options options) {
  absl::StatusOr<FileDescriptor> files =
      OpenFolder(folder.descriptor(), Plural(options.kind));
  if (!files.ok()) return files.status();
  // The names of the folders must survive a crash of the machine, too.
  absl::Status status = Sync(folder.descriptor(), "--data-dir");
  if (!status.ok()) return status;
  auto removed = std::exchange(options.removed, nullptr);
  std::unique_ptr<BlobStore> store(new BlobStore(
      std::move(options), *std::move(files), folder.quarantine()));
  if (status = store->Scan(); !status.ok()) return status;
  store->options_.removed = std::move(removed);
  return store;
}

BlobStore::BlobStore(Options options, FileDescriptor folder,
                     Quarantine& quarantine)
    : options_(std::move(options)),
      folder_(std::move(folder)),
      quarantine_(quarantine) {}

std::string BlobStore::FileName(const std::string& name) const {
  return absl::StrCat(name, ".", options_.kind);
}

std::string BlobStore::PathOf(const std::string& name) const {
  return absl::StrCat(Plural(options_.kind), "/", FileName(name));
}

void BlobStore::Warn(const std::string& line) const {
  if (options_.warn) options_.warn(line);
}

absl::Status BlobStore::Flush(const std::string& path) {
  return flush_.Run([&] { return Sync(folder_.get(), path); });
}

absl::Status BlobStore::Scan() {
  absl::StatusOr<std::vector<std::string>> names = NamesIn(folder_.get());
  if (!names.ok()) return names.status();
  std::vector<Found> found;
  for (const std::string& file : *names) {
    if (absl::EndsWith(file, kTemporaryEnding)) {
      // No Put has returned OK for it.
      unlinkat(folder_.get(), file.c_str(), 0);
      continue;
    }
    absl::string_view stem = file;
    if (!absl::ConsumeSuffix(&stem, absl::StrCat(".", options_.kind)) ||
        !IsSha256Hex({stem.data(), stem.size()})) {
      continue;
    }
    const std::string name(stem);
    absl::StatusOr<Found> blob = Inspect(name);
    if (blob.ok()) {
      found.push_back(*std::move(blob));
    } else if (!absl::IsDataLoss(blob.status())) {
      // It may be readable at the next start, or by another version.
      Warn(absl::StrCat(PathOf(name),
                        " is left out: ", blob.status().message()));
    }
  }
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return std::tie(a.used.tv_sec, a.used.tv_nsec, a.info.name) <
           std::tie(b.used.tv_sec, b.used.tv_nsec, b.info.name);
  });
  {
    MutexLock lock(mutex_);
    for (Found& blob : found) Insert(std::move(blob.info));
  }
  // The capacity may have been larger before.
  if (absl::Status status = MakeRoom(0, 0); !status.ok()) {
    Warn(absl::StrCat(Plural(options_.kind), "/ holds more than its ",
                      options_.capacity, " bytes: ", status.message()));
  }
  return absl::OkStatus();
}

absl::StatusOr<BlobStore::Found> BlobStore::Inspect(const std::string& name) {
  const absl::StatusOr<FileDescriptor> file =
      OpenToRead(folder_.get(), FileName(name), PathOf(name));
  if (!file.ok()) return file.status();
  struct stat facts {};
  if (fstat(file->get(), &facts) != 0) {
    return DiskError(errno, "examine", PathOf(name));
  }
  BlobHeader header;
  absl::StatusOr<BlobInfo> info =
      ReadInfo(file->get(), facts.st_size, name, header);
  if (absl::IsDataLoss(info.status())) {
    SetAside(name, facts.st_ino, info.status());
  }
  if (!info.ok()) return info.status();
  return Found{*std::move(info), facts.st_mtim};
}

absl::StatusOr<BlobInfo> BlobStore::ReadInfo(int file, uint64_t size,
                                             const std::string& name,
                                             BlobHeader& header) const {
  std::string bytes(kBlobHeaderBytes, '\0');
  absl::Status status = ReadAt(file, 0, bytes, PathOf(name));
  if (!status.ok()) return status;
  absl::StatusOr<BlobHeader> decoded = DecodeBlobHeader(bytes);
  if (!decoded.ok()) return decoded.status();
  header = *std::move(decoded);
  if (header.kind != options_.kind || header.name != name) {
    return absl::DataLossError(
        absl::StrCat("the file holds the ", header.kind, " ", header.name));
  }
  if (options_.is_named_by_content && header.body_sha256 != name) {
    return absl::DataLossError(
        absl::StrCat("the file has a body of digest ", header.body_sha256));
  }
  if (header.metadata_bytes > kMaxMetadataBytes || header.body_bytes > size ||
      kBlobHeaderBytes + header.body_bytes + header.metadata_bytes != size) {
    return absl::DataLossError(absl::StrCat(
        "the file has ", size, " bytes; its header tells of ", kBlobHeaderBytes,
        " + ", header.body_bytes, " + ", header.metadata_bytes));
  }
  BlobInfo info{.name = name,
                .metadata = std::string(header.metadata_bytes, '\0'),
                .body_bytes = header.body_bytes,
                .file_bytes = size};
  status = ReadAt(file, kBlobHeaderBytes + header.body_bytes, info.metadata,
                  PathOf(name));
  if (!status.ok()) return status;
  if (Sha256Hex(info.metadata) != header.metadata_sha256) {
    return absl::DataLossError(
        "the metadata does not have the digest the header names");
  }
  return info;
}

std::optional<BlobInfo> BlobStore::Find(const std::string& name) {
  MutexLock lock(mutex_);
  const auto it = entries_.find(name);
  if (it == entries_.end()) return std::nullopt;
  recency_.splice(recency_.end(), recency_, it->second.position);
  return BlobInfo{name, it->second.metadata, it->second.body_bytes,
                  it->second.file_bytes};
}

std::vector<BlobInfo> BlobStore::List(const std::string& after,
                                      size_t count) const {
  MutexLock lock(mutex_);
  std::vector<BlobInfo> page;
  for (auto it = entries_.upper_bound(after);
       it != entries_.end() && page.size() < count; ++it) {
    page.push_back({it->first, it->second.metadata, it->second.body_bytes,
                    it->second.file_bytes});
  }
  return page;
}

void BlobStore::ForEach(
    absl::FunctionRef<void(const std::string&, std::string_view)> visit) const {
  MutexLock lock(mutex_);
  for (const auto& [name, entry] : entries_) visit(name, entry.metadata);
}

absl::Status BlobStore::Admit(uint64_t body_bytes, uint64_t metadata_bytes) {
  const uint64_t bytes = OnDisk(kBlobHeaderBytes + body_bytes + metadata_bytes);
  if (bytes <= options_.capacity) return absl::OkStatus();
  MutexLock lock(mutex_);
  ++counters_.too_large;
  return absl::ResourceExhaustedError(absl::StrCat(
      bytes, " bytes of disk are needed, more than the ", options_.capacity,
      " that the server may use for ", Plural(options_.kind), "; --",
      options_.kind, "-disk sets that"));
}

absl::Status BlobStore::Put(const std::string& name, std::string_view metadata,
                            std::span<const std::string_view> body) {
  uint64_t bytes = 0;
  for (const std::string_view part : body) bytes += part.size();
  return Put(name, metadata, bytes, [&](BlobSink& sink) {
    for (const std::string_view part : body) {
      absl::Status status = sink.Append(part);
      if (!status.ok()) return status;
    }
    return absl::OkStatus();
  });
}

absl::Status BlobStore::Put(
    const std::string& name, std::string_view metadata, uint64_t body_bytes,
    absl::FunctionRef<absl::Status(BlobSink& sink)> write) {
  absl::Status status = Admit(body_bytes, metadata.size());
  if (!status.ok()) return status;
  status = Keep(name, metadata, body_bytes, write);
  MutexLock lock(mutex_);
  ++counters_.writes;
  if (!status.ok()) ++counters_.write_failures;
  return status;
}

absl::Status BlobStore::Keep(
    const std::string& name, std::string_view metadata, uint64_t body_bytes,
    absl::FunctionRef<absl::Status(BlobSink& sink)> write) {
  BlobInfo info{.name = name,
                .metadata = std::string(metadata),
                .body_bytes = body_bytes,
                .file_bytes = kBlobHeaderBytes + body_bytes + metadata.size()};
  const uint64_t bytes = OnDisk(info.file_bytes);
  if (absl::Status status = MakeRoom(bytes, 1); !status.ok()) return status;
  bool is_reserved = true;
  absl::StatusOr<std::string> temporary = WriteTemporary(info, write);
  absl::Status status = temporary.status();
  if (temporary.ok()) {
    status = Publish(*temporary, std::move(info), is_reserved);
  }
  if (is_reserved) {
    MutexLock lock(mutex_);
    reserved_bytes_ -= bytes;
    --reserved_count_;
  }
  return status;
}

absl::Status BlobStore::MakeRoom(uint64_t bytes, size_t count) {
  MutexLock room_lock(room_mutex_);
  for (bool is_first = true;; is_first = false) {
    std::string victim;
    {
      MutexLock lock(mutex_);
      if (HasRoom(entry_bytes_ + bytes, entries_.size() + count)) {
        reserved_bytes_ += bytes;
        reserved_count_ += count;
        return absl::OkStatus();
      }
      // If evicting everything would not help, nothing is evicted.
      if (recency_.empty() || (is_first && !HasRoom(bytes, count))) {
        return absl::ResourceExhaustedError(absl::StrCat(
            bytes, " bytes of disk are needed, but of the ", options_.capacity,
            " bytes and ", options_.max_count,
            " files that the server may use for ", Plural(options_.kind),
            " too many are being written; try again later"));
      }
      victim = *recency_.front();
    }
    absl::Status status;
    {
      const NameHold hold(*this, victim);
      status = Unlink(victim);
    }
    if (!status.ok() && !absl::IsNotFound(status)) return status;
    if (!status.ok()) continue;
    {
      MutexLock lock(mutex_);
      ++counters_.evictions;
    }
    if (options_.removed) options_.removed(victim);
  }
}

absl::StatusOr<std::string> BlobStore::WriteTemporary(
    const BlobInfo& info,
    absl::FunctionRef<absl::Status(BlobSink& sink)> write) {
  const std::string temporary =
      absl::StrCat(info.name, ".", next_temporary_++, kTemporaryEnding);
  const FileDescriptor file(
      openat(folder_.get(), temporary.c_str(),
             O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600));
  if (file.get() < 0) return FolderError(errno, "write", PathOf(info.name));
  absl::Status status = Write(file.get(), info, write);
  if (status.ok()) return temporary;
  unlinkat(folder_.get(), temporary.c_str(), 0);
  return status;
}

absl::Status BlobStore::Publish(const std::string& temporary, BlobInfo info,
                                bool& is_reserved) {
  const std::string file = FileName(info.name);
  const NameHold hold(*this, info.name);
  if (renameat(folder_.get(), temporary.c_str(), folder_.get(), file.c_str()) !=
      0) {
    const int error = errno;
    unlinkat(folder_.get(), temporary.c_str(), 0);
    return FolderError(error, "name", PathOf(info.name));
  }
  absl::Status status = Flush(PathOf(info.name));
  MutexLock lock(mutex_);
  const auto old = entries_.find(info.name);
  if (!status.ok() && old == entries_.end()) {
    // It may not survive a crash, so it is removed and Put fails.
    unlinkat(folder_.get(), file.c_str(), 0);
    return status;
  }
  // The old blob is replaced, if Sync failed perhaps only until a power cut.
  if (old != entries_.end()) Remove(old);
  is_reserved = false;
  reserved_bytes_ -= OnDisk(info.file_bytes);
  --reserved_count_;
  Insert(std::move(info));
  return status;
}

absl::Status BlobStore::Write(
    int file, const BlobInfo& info,
    absl::FunctionRef<absl::Status(BlobSink& sink)> write) const {
  const std::string path = PathOf(info.name);
  BlobSink sink(file, path);
  if (absl::Status status = write(sink); !status.ok()) return status;
  if (sink.bytes_ != info.body_bytes) {
    return absl::InternalError(absl::StrCat(path, " would have a body of ",
                                            sink.bytes_, " bytes, not ",
                                            info.body_bytes));
  }
  const BlobHeader header{.kind = options_.kind,
                          .name = info.name,
                          .body_bytes = info.body_bytes,
                          .metadata_bytes = info.metadata.size(),
                          .body_sha256 = sink.hash_.FinishHex(),
                          .metadata_sha256 = Sha256Hex(info.metadata)};
  if (options_.is_named_by_content && header.body_sha256 != info.name) {
    return absl::InternalError(absl::StrCat(
        path, " would have a body of digest ", header.body_sha256));
  }
  absl::Status status =
      WriteAt(file, kBlobHeaderBytes + info.body_bytes, info.metadata, path);
  if (!status.ok()) return status;
  status = WriteAt(file, 0, EncodeBlobHeader(header), path);
  if (!status.ok()) return status;
  return Sync(file, path);
}

absl::Status BlobStore::Read(const std::string& name, TakeBlob take) {
  if (!Find(name).has_value()) {
    return absl::NotFoundError(absl::StrCat("there is no ", PathOf(name)));
  }
  bool is_refused = false;
  absl::Status status =
      Take(name, [&](std::string_view metadata, BlobBody& body) {
        absl::Status taken = take(metadata, body);
        is_refused = absl::IsNotFound(taken) || absl::IsCancelled(taken) ||
                     absl::IsResourceExhausted(taken);
        return taken;
      });
  MutexLock lock(mutex_);
  ++counters_.reads;
  if (!status.ok() && !is_refused) ++counters_.read_failures;
  return status;
}

absl::Status BlobStore::Take(const std::string& name, TakeBlob take) {
  const absl::StatusOr<FileDescriptor> file =
      OpenToRead(folder_.get(), FileName(name), PathOf(name));
  if (!file.ok()) {
    // Erase, or somebody outside the server, has removed the file.
    if (absl::IsNotFound(file.status())) (void)Look(name);
    return file.status();
  }
  struct stat facts {};
  if (fstat(file->get(), &facts) != 0) {
    return DiskError(errno, "examine", PathOf(name));
  }
  // Sets the time of last use. If that fails, a restart only knows it roughly.
  const timespec now[2] = {{0, UTIME_NOW}, {0, UTIME_NOW}};
  futimens(file->get(), now);

  BlobHeader header;
  absl::StatusOr<BlobInfo> info =
      ReadInfo(file->get(), facts.st_size, name, header);
  absl::Status status = info.status();
  if (status.ok()) {
    FileBody body(file->get(), header.body_bytes);
    status = take(info->metadata, body);
    if (status.ok()) status = body.Finish(header.body_sha256);
  }
  if (absl::IsDataLoss(status)) {
    SetAside(name, facts.st_ino, status);
    return absl::DataLossError(absl::StrCat(
        PathOf(name),
        " was damaged and has been set aside: ", status.message()));
  }
  return status;
}

absl::Status BlobStore::Look(const std::string& name) {
  const NameHold hold(*this, name);
  struct stat facts {};
  const bool is_there =
      fstatat(folder_.get(), FileName(name).c_str(), &facts, 0) == 0;
  if (!is_there && errno != ENOENT) {
    return DiskError(errno, "examine", PathOf(name));
  }
  MutexLock lock(mutex_);
  const auto it = entries_.find(name);
  if (it != entries_.end() && is_there &&
      it->second.file_bytes == static_cast<uint64_t>(facts.st_size)) {
    return absl::OkStatus();
  }
  if (it != entries_.end() && !is_there) Remove(it);
  return absl::NotFoundError(absl::StrCat("there is no ", PathOf(name)));
}

void BlobStore::SetAside(const std::string& name, ino_t inode,
                         const absl::Status& why) {
  {
    const NameHold hold(*this, name);
    struct stat facts {};
    if (fstatat(folder_.get(), FileName(name).c_str(), &facts, 0) != 0 ||
        facts.st_ino != inode) {
      return;
    }
    const absl::StatusOr<std::string> aside =
        quarantine_.Take(folder_.get(), FileName(name));
    Warn(absl::StrCat(PathOf(name), " is damaged (", why.message(), "): ",
                      aside.ok() ? "moved to quarantine/" + *aside
                                 : std::string(aside.status().message()),
                      "; it is not served"));
    MutexLock lock(mutex_);
    ++counters_.damaged;
    if (const auto it = entries_.find(name); it != entries_.end()) Remove(it);
  }
  if (options_.removed) options_.removed(name);
}

absl::Status BlobStore::Erase(const std::string& name) {
  const NameHold hold(*this, name);
  absl::Status status = Unlink(name);
  return status.ok() ? Flush(PathOf(name)) : status;
}

absl::Status BlobStore::Unlink(const std::string& name) {
  {
    MutexLock lock(mutex_);
    if (!entries_.contains(name)) {
      return absl::NotFoundError(absl::StrCat("there is no ", PathOf(name)));
    }
  }
  if (unlinkat(folder_.get(), FileName(name).c_str(), 0) != 0 &&
      errno != ENOENT) {
    return DiskError(errno, "remove", PathOf(name));
  }
  MutexLock lock(mutex_);
  if (const auto it = entries_.find(name); it != entries_.end()) Remove(it);
  return absl::OkStatus();
}

bool BlobStore::HasRoom(uint64_t bytes, size_t count) const {
  return reserved_bytes_ + bytes <= options_.capacity &&
         reserved_count_ + count <= options_.max_count;
}

void BlobStore::Insert(BlobInfo info) {
  const auto [it, is_new] = entries_.try_emplace(std::move(info.name));
  it->second = {std::move(info.metadata), info.body_bytes, info.file_bytes,
                recency_.insert(recency_.end(), &it->first)};
  entry_bytes_ += OnDisk(info.file_bytes);
}

void BlobStore::Remove(Entries::iterator it) {
  entry_bytes_ -= OnDisk(it->second.file_bytes);
  recency_.erase(it->second.position);
  entries_.erase(it);
}

size_t BlobStore::size() const {
  MutexLock lock(mutex_);
  return entries_.size();
}

BlobCounters BlobStore::counters() const {
  MutexLock lock(mutex_);
  return counters_;
}

uint64_t BlobStore::used_bytes() const {
  MutexLock lock(mutex_);
  return entry_bytes_ + reserved_bytes_;
}

}  // namespace geodesic::server
