// crowd: many who only take up room. Readers that ask for a large field, take
// the first message and no more; uploads that come a byte at a time;
// connections on which nothing is asked. Meanwhile others ask as ever.
//
//   crowd --readers 1000 --uploads 1000 --idle 1000 --seconds 60
//
// At the end the readers read on and the uploads hurry: every field and every
// mesh must be right. Prints a line of JSON: latencies of the others before,
// during and after, and the server's memory. Exit codes: 0 every answer was
// right, nobody was refused, memory stayed within the budgets, a tenth, and
// what those in the crowd may take each, half of what they took went back to
// the machine, and what requests hold to zero; 1 not so, said on standard
// error; 2 wrong usage.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/reliability/open_loop.h"
#include "tests/reliability/raw_call.h"
#include "tests/reliability/watched_server.h"
#include "tests/reliability/workload.h"

namespace geodesic::client {
namespace {

struct Options {
  size_t readers = 1000;
  size_t uploads = 1000;
  size_t idle = 1000;
  uint32_t vertices = 100'000;
  double seconds = 10;
  double rate = 30;
  uint64_t seed = 1;
  WatchedServer::Options server = {.program = GEODESICD_BINARY};
};

// What the server may hold for each: a message that is made and one that gRPC
// has taken; what HTTP/2 keeps of a stream; of a connection.
constexpr double kReaderMib = 1.25;
constexpr double kUploadMib = 0.25;
constexpr double kIdleMib = 0.125;

constexpr std::chrono::milliseconds kByteInterval{1000};

// How long half of what the crowd took may take to go back to the machine.
constexpr std::chrono::seconds kMemoryWait{60};
constexpr std::chrono::milliseconds kMemoryInterval{100};

WatchedServer::Options ServerOptions(const Options& options) {
  WatchedServer::Options server = options.server;
  // One client has three quarters of them.
  const size_t requests = (options.readers + options.uploads + 100) * 4 / 3;
  // Each upload has a message that comes slowly.
  constexpr size_t kMessageMib = 4;
  server.flags = {
      "--limit", absl::StrCat("max-requests=", requests), "--limit",
      absl::StrCat("receive-memory=", kMessageMib * requests, "MiB")};
  return server;
}

// Somebody in the crowd, and what is wrong with an answer.
struct Member {
  std::unique_ptr<PacedCall> call;
  std::function<std::string(const std::vector<std::string>&)> check;
};

// Each at once would be a crowd of handshakes.
std::vector<std::shared_ptr<grpc::Channel>> ConnectIdly(
    const std::string& address, size_t count) {
  std::vector<std::shared_ptr<grpc::Channel>> channels;
  for (size_t i = 0; i < count; ++i) {
    channels.push_back(OwnConnection(address));
    if (!channels.back()->WaitForConnected(std::chrono::system_clock::now() +
                                           std::chrono::seconds(30))) {
      throw std::runtime_error("a connection was not taken");
    }
  }
  return channels;
}

// Lets each of the uploads send a byte every kByteInterval.
void Trickle(const std::stop_token& stop, const std::vector<Member>& uploads) {
  auto moment = std::chrono::steady_clock::now();
  while (!uploads.empty()) {
    for (const Member& upload : uploads) {
      if (stop.stop_requested()) return;
      upload.call->AllowWrite();
      moment += kByteInterval / uploads.size();
      std::this_thread::sleep_until(moment);
    }
  }
}

class Crowd {
 public:
  explicit Crowd(const Options& options)
      : options_(options),
        random_(options.seed),
        large_(options.vertices, options.seed),
        small_(4096, options.seed + 1),
        server_(ServerOptions(options)) {
    large_.Prepare(server_.address());
    small_.Prepare(server_.address());
    connections_ = Connect(server_.address(), 4);
  }

  nlohmann::ordered_json Run() {
    nlohmann::ordered_json result;
    result["before"] = Others();
    const double before = server_.Now().resident_mib;
    result["resident_mib_before"] = before;
    result["seconds_to_gather"] = Gather();
    {
      const std::jthread trickle(
          [this](const std::stop_token& stop) { Trickle(stop, uploads_); });
      result["during"] = Others();
    }
    const double active = server_.Metric("geodesic_active_requests");
    const size_t crowd = readers_.size() + uploads_.size();
    if (active < static_cast<double>(crowd)) {
      faults_.push_back(absl::StrCat(active, " requests active of ", crowd));
    }
    result["active_requests"] = active;
    const double during = server_.Now().resident_mib;
    result["resident_mib_during"] = during;
    Disperse();
    if (!options_.server.ignores_memory) {
      result["seconds_to_give_back"] = AwaitMemory((before + during) / 2);
    }
    result["resident_mib_dispersed"] = server_.Now().resident_mib;
    result["after"] = Others();
    connections_.clear();
    result["server"] = server_.Summary();
    return result;
  }

  std::vector<std::string> Faults() const {
    std::vector<std::string> faults =
        server_.Faults(kReaderMib * static_cast<double>(options_.readers) +
                       kUploadMib * static_cast<double>(options_.uploads) +
                       kIdleMib * static_cast<double>(options_.idle));
    faults.insert(faults.begin(), faults_.begin(), faults_.end());
    return faults;
  }

 private:
  // Latencies of those who ask and read as they should.
  nlohmann::ordered_json Others() {
    constexpr Mix kMix = {1, 2, 6, 1, 0};
    const LoadFigures figures = RunOpenLoop(
        connections_, small_, kMix, options_.rate, options_.seconds, random_);
    const std::vector<std::string> faults = figures.Faults();
    faults_.insert(faults_.end(), faults.begin(), faults.end());
    if (figures.refused.count() > 0) {
      faults_.push_back(absl::StrCat(figures.refused.count(), " refused"));
    }
    return figures.Summary();
  }

  // Returns once everybody is there; the seconds that it took.
  double Gather() {
    const auto start = std::chrono::steady_clock::now();
    idle_ = ConnectIdly(server_.address(), options_.idle);
    constexpr size_t kAny = std::numeric_limits<size_t>::max();
    for (size_t i = 0; i < options_.readers; ++i) {
      Enter(readers_, large_.Next(QuestionKind::kCached), kAny, 1);
    }
    for (size_t i = 0; i < options_.uploads; ++i) {
      Enter(uploads_, small_.UploadByteByByte(), 1, 0);
    }
    const std::chrono::duration<double> took =
        std::chrono::steady_clock::now() - start;
    return took.count();
  }

  void Enter(std::vector<Member>& members, Question question, size_t writes,
             size_t reads) {
    members.push_back({std::make_unique<PacedCall>(
                           server_.address(), question.request, writes, reads),
                       question.check});
    members.back().call->AwaitStall();
  }

  // The readers read on, the uploads hurry, and all go.
  void Disperse() {
    for (const auto* members : {&readers_, &uploads_}) {
      for (const Member& member : *members) Judge(member);
    }
    readers_.clear();
    uploads_.clear();
    idle_.clear();
  }

  // Waits until the server has no more memory than `mib`; the seconds that it
  // took.
  double AwaitMemory(double mib) {
    const auto start = std::chrono::steady_clock::now();
    std::chrono::duration<double> took{0};
    while (server_.Now().resident_mib > mib) {
      took = std::chrono::steady_clock::now() - start;
      if (took > kMemoryWait) {
        faults_.push_back(absl::StrCat(server_.Now().resident_mib,
                                       " MiB kept; at most ", mib,
                                       " expected"));
        break;
      }
      std::this_thread::sleep_for(kMemoryInterval);
    }
    return took.count();
  }

  void Judge(const Member& member) {
    const RawAnswer answer = member.call->Finish();
    const std::string fault = answer.status.ok()
                                  ? member.check(answer.messages)
                                  : answer.status.error_message();
    if (!fault.empty()) faults_.push_back("in the crowd: " + fault);
  }

  const Options& options_;
  std::mt19937_64 random_;
  Workload large_;
  Workload small_;
  WatchedServer server_;
  std::vector<std::unique_ptr<RawConnection>> connections_;
  std::vector<std::shared_ptr<grpc::Channel>> idle_;
  std::vector<Member> readers_;
  std::vector<Member> uploads_;
  std::vector<std::string> faults_;
};

std::vector<std::string> Run(const Options& options) {
  Crowd crowd(options);
  std::cout << crowd.Run() << std::endl;
  return crowd.Faults();
}

}  // namespace
}  // namespace geodesic::client

int main(int argc, char** argv) {
  geodesic::client::Options options;
  CLI::App app("Takes up a server's room and looks what others feel of it.",
               "crowd");
  app.option_defaults()->always_capture_default();
  app.add_option("--readers", options.readers, "That stall");
  app.add_option("--uploads", options.uploads, "A byte a second each");
  app.add_option("--idle", options.idle, "Connections without a question");
  app.add_option("--vertices", options.vertices, "Of the readers' fields")
      ->check(CLI::Range(10'000, 1'000'000));
  app.add_option("--seconds", options.seconds,
                 "That others ask before, during, and after")
      ->check(CLI::PositiveNumber);
  app.add_option("--rate", options.rate, "Questions of others a second")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", options.seed, "Of moments and questions");
  geodesic::client::AddServerOptions(app, options.server);
  return geodesic::client::RunMain(
      app, argc, argv, [&] { return geodesic::client::Run(options); });
}
