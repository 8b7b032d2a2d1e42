#include "tests/reliability/disturbers.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <stdexcept>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic_client/client.h"
#include "tests/integration/meshes.h"
#include "tests/reliability/workload.h"

namespace geodesic::client {
namespace {

// Where many faces meet at an edge, at a vertex or along a line, or where there
// are very many: names and sizes of HardMeshes.
struct Sized {
  const char* name;
  uint32_t faces;
};
constexpr std::array kMeshes = {
    Sized{"pages", 4000},  Sized{"needles", 50'000}, Sized{"one point", 50'000},
    Sized{"book", 60'000}, Sized{"hubs", 60'000},    Sized{"grid", 300'000}};

constexpr uint32_t kReadVertices = 90'000;
constexpr uint32_t kUploadCells = 50;
constexpr size_t kMostExamples = 10;

MeshArrays Make(const Sized& sized) {
  const std::vector<HardMesh> meshes = HardMeshes(sized.faces);
  TriangleSoup soup =
      std::ranges::find(meshes, sized.name, &HardMesh::name)->make();
  return {std::move(soup.positions), std::move(soup.triangles)};
}

// Whether a call may end so that is late, is left, or is refused: for want of
// room, or since its question is not for its mesh.
bool IsExpected(const absl::Status& status) {
  return status.ok() || absl::IsDeadlineExceeded(status) ||
         absl::IsCancelled(status) || absl::IsResourceExhausted(status) ||
         absl::IsInvalidArgument(status) || absl::IsFailedPrecondition(status);
}

}  // namespace

Disturbers::Disturbers(const std::string& address, int send_seconds,
                       uint64_t seed)
    : address_(address), send_seconds_(send_seconds), random_(seed) {
  for (const Sized& sized : kMeshes) {
    subjects_.push_back({.arrays = Make(sized)});
  }
  Workload large(kReadVertices, seed, "reader");
  large.Prepare(address);
  for (size_t i = 0; i < kReaders; ++i) {
    reads_.push_back(large.Next(QuestionKind::kCached).request);
  }
}

void Disturbers::Start() {
  Client client(address_, {.token = "asker"});
  for (Subject& subject : subjects_) {
    const auto upload = subject.Upload(client, {});
    if (!upload.ok()) throw std::runtime_error(upload.status().ToString());
    subject.info = upload->mesh;
  }
  using Token = std::stop_token;
  const auto start = [this](auto work) {
    threads_.emplace_back([work](const Token& stop) {
      // They are on other machines: what they compute delays no server. Of
      // Linux, for the calling thread alone.
      setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + 10);
      work(stop);
    });
  };
  for (const RawRequest& request : reads_) {
    start([this, &request](const Token& stop) { Read(stop, request); });
  }
  for (size_t i = 0; i < kUploaders; ++i) {
    start([this](const Token& stop) { Upload(stop); });
  }
  start([this](const Token& stop) { Ask(stop); });
}

void Disturbers::Stop() {
  for (std::jthread& thread : threads_) thread.request_stop();
  threads_.clear();
  Client client(address_, {.token = "asker"});
  for (const Subject& subject : subjects_) {
    const absl::Status status = client.DeleteMesh(subject.info.digest);
    if (!status.ok()) throw std::runtime_error(status.ToString());
  }
}

void Disturbers::Read(const std::stop_token& stop, const RawRequest& request) {
  // gRPC does not tell who reads nothing that a call has ended.
  const std::chrono::seconds wait(send_seconds_ + 1);
  std::mutex mutex;
  std::condition_variable_any stopped;
  while (!stop.stop_requested()) {
    PacedCall call(address_, request, 1, 1);
    call.AwaitStall();
    {
      std::unique_lock lock(mutex);
      stopped.wait_for(lock, stop, wait, [] { return false; });
    }
    if (stop.stop_requested()) return;
    const grpc::Status status = call.Finish().status;
    Note(stop, "stalled reader",
         {static_cast<absl::StatusCode>(status.error_code()),
          status.error_message()});
  }
}

void Disturbers::Upload(const std::stop_token& stop) {
  Client client(address_, {.token = "uploader"});
  MeshArrays mesh = PlanarGrid(kUploadCells);
  while (!stop.stop_requested()) {
    mesh.positions[0][2] = 1e-6 * static_cast<double>(++uploads_);
    Note(stop, "upload", client.UploadArrays(mesh, {.stop = stop}).status());
  }
}

void Disturbers::Ask(const std::stop_token& stop) {
  std::vector<HardQuestion> questions = HardQuestions();
  std::erase_if(questions, [](const auto& asked) { return asked.is_upload; });
  const auto any = [this](const auto& items) -> const auto& {
    return items[random_.Below(static_cast<uint32_t>(items.size()))];
  };
  Client client(address_, {.token = "asker"});
  while (!stop.stop_requested()) {
    const HardQuestion& question = any(questions);
    const std::chrono::duration<double> timeout(random_.Uniform(0.02, 1.5));
    Note(stop, question.name,
         question.ask(client, any(subjects_), random_,
                      {.timeout = timeout, .stop = stop}));
  }
}

void Disturbers::Note(const std::stop_token& stop, const std::string& what,
                      const absl::Status& status) {
  std::lock_guard lock(mutex_);
  ++ended_[stop.stop_requested() ? what + " at the end" : what]
          [absl::StatusCodeToString(status.code())];
  if (!IsExpected(status) && faults_.size() < kMostExamples) {
    faults_.push_back(absl::StrCat(what, ": ", status.ToString()));
  }
}

}  // namespace geodesic::client
