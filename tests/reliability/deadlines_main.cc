// deadlines: whether every question on every hard mesh stops at its deadline.
//
//   deadlines --rounds 3 --law 100
//
// Asks each with a deadline of 20 ms to 1.5 s, or cancels it as late, and then
// looks at the page of metrics until nothing of it is left: no request, no job,
// no waiter, no memory. The client's quota is one job, so whoever counts a
// question for too long refuses the next. Landmarks, which are made when a
// question has ended, end with their mesh: it is deleted when a job goes on
// that may be theirs. At last SIGTERM comes in the midst of some questions.
//
// Prints a line of JSON: how questions ended, how long the server took to
// become idle, and where that took longest. Exit codes: 0 nothing stayed, all
// ended as they may, and so did the server; 1 not so, said on standard error;
// 2 wrong usage.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <future>
#include <iostream>
#include <limits>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "geodesic_client/client.h"
#include "tests/client/temporary_folder.h"
#include "tests/integration/meshes.h"
#include "tests/reliability/hard_questions.h"
#include "tests/reliability/watched_server.h"
#include "tests/support/random.h"
#include "tests/support/until.h"

namespace geodesic::client {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

struct Options {
  int rounds = 1;
  size_t questions = std::numeric_limits<size_t>::max();
  uint32_t faces = 300'000;
  bool made_only = false;
  bool cancels = false;
  double law = 0;
  size_t drains = 6;
  uint64_t seed = 1;
  std::string mesh;
  std::string question;
  WatchedServer::Options server = {.program = GEODESICD_BINARY, .times = 8};
};

constexpr double kShortest = 0.02;
constexpr double kLongest = 1.5;
// After which a question counts as one that stays, and is given up on.
constexpr Seconds kStays{10};
constexpr Seconds kGivenUp{120};
// A job that goes on for so long, and no request, may make landmarks.
constexpr double kPatienceMs = 20;

constexpr char kToken[] = "deadlines";
constexpr char kTokens[] = R"({
  "tokens": [{"name": "asker", "scopes": ["read", "upload", "delete"], "sha256":
    "6062c9072b431143e21b11f50f2faa8c677c9a9b1214f0ed9af712cb19129837"}],
  "quotas": {"asker": {"jobs": 1}}})";
constexpr char kRunning[] = R"(geodesic_jobs{state="running"})";
constexpr char kSolvers[] = R"(geodesic_used_bytes{budget="solvers"})";
// Budgets of what outlives requests, beside those of WatchedServer.
constexpr int kKeptMib = 256;

Clock::duration ToClock(Seconds seconds) {
  return std::chrono::duration_cast<Clock::duration>(seconds);
}

double MillisecondsSince(Clock::time_point moment) {
  return 1e3 * Seconds(Clock::now() - moment).count();
}

bool IsEnded(const absl::Status& status) {
  return absl::IsDeadlineExceeded(status) || absl::IsCancelled(status);
}

// Whether a mesh or a question may be such that the server says no.
bool IsRefused(const absl::Status& status) {
  const std::string reason = ErrorReason(status);
  return absl::IsInvalidArgument(status) ||
         absl::IsFailedPrecondition(status) || reason == "LIMIT_EXCEEDED" ||
         reason == "MEMORY_FULL";
}

// Of a refusal, without what differs from one to the next.
std::string KindOf(const absl::Status& status) {
  std::string text;
  for (const char c : absl::StrCat(absl::StatusCodeToString(status.code()),
                                   ": ", status.message())) {
    if (!absl::ascii_isdigit(static_cast<unsigned char>(c))) {
      text += c;
    } else if (!text.ends_with('#')) {
      text += '#';
    }
  }
  const size_t path = text.find(" /");
  if (path != std::string::npos) {
    text.erase(path, text.find(':', path) - path);
  }
  return text.substr(0, 160);
}

struct Stop {
  std::string mesh;
  std::string question;
  double deadline_ms = 0;
  double ms = 0;
};

class Deadlines {
 public:
  explicit Deadlines(const Options& options)
      : options_(options),
        random_(options.seed),
        meshes_(HardMeshes(options.faces)),
        questions_(HardQuestions()),
        server_(ServerOptions({})),
        client_(Connect(server_)) {}

  void Run() {
    for (int round = 0; round < options_.rounds; ++round) Round();
    const std::vector<std::string> left = server_.Faults(1.1 * 2 * kKeptMib);
    faults_.insert(faults_.end(), left.begin(), left.end());
    for (const auto& [mesh, question] : Shuffled()) {
      if (drains_.size() >= options_.drains) break;
      if (!meshes_[mesh].make) continue;
      Drain(meshes_[mesh], questions_[question],
            /*in_time=*/drains_.size() % 2 == 0);
    }
  }

  nlohmann::ordered_json Summary() {
    std::ranges::sort(stops_, std::ranges::greater(), &Stop::ms);
    nlohmann::ordered_json summary = {{"questions", asked_},
                                      {"answered", answered_},
                                      {"ended", stops_.size()},
                                      {"refused", refused_}};
    if (!stops_.empty()) {
      summary["worst_ms"] = stops_.front().ms;
      summary["p99_ms"] = stops_[stops_.size() / 100].ms;
    }
    summary["slowest"] = nlohmann::json::array();
    for (const Stop& stop : stops_) {
      if (summary["slowest"].size() == 10) break;
      summary["slowest"].push_back({{"mesh", stop.mesh},
                                    {"question", stop.question},
                                    {"deadline_ms", stop.deadline_ms},
                                    {"ms", stop.ms}});
    }
    summary["drains"] = drains_;
    summary["server"] = server_.Summary();
    return summary;
  }

  std::vector<std::string> Faults() const {
    std::vector<std::string> faults = faults_;
    const auto slow = std::ranges::count_if(
        stops_, [this](const Stop& stop) { return stop.ms > options_.law; });
    if (options_.law > 0 && slow > 0) {
      faults.push_back(absl::StrCat(slow, " questions took longer than ",
                                    options_.law, " ms to stop"));
    }
    return faults;
  }

 private:
  WatchedServer::Options ServerOptions(std::vector<std::string> flags) const {
    WriteFile(folder_ / "tokens", kTokens);
    WatchedServer::Options server = options_.server;
    server.flags = std::move(flags);
    server.flags.insert(server.flags.end(),
                        {"--token-file", folder_ / "tokens", "--limit",
                         absl::StrCat("landmark-memory=", kKeptMib,
                                      "MiB,prepared-memory=", kKeptMib,
                                      "MiB,max-queued-jobs-per-client=1")});
    return server;
  }

  static Client Connect(const WatchedServer& server) {
    return Client(server.address(), {.token = kToken, .retry = false});
  }

  // The numbers of meshes and questions, in any order.
  std::vector<std::pair<size_t, size_t>> Shuffled() {
    std::vector<std::pair<size_t, size_t>> all;
    for (size_t i = 0; i < meshes_.size(); ++i) {
      if (!absl::StrContains(meshes_[i].name, options_.mesh) ||
          (options_.made_only && !meshes_[i].make)) {
        continue;
      }
      for (size_t j = 0; j < questions_.size(); ++j) {
        if (!absl::StrContains(questions_[j].name, options_.question)) continue;
        all.emplace_back(i, j);
      }
    }
    for (size_t i = 1; i < all.size(); ++i) {
      std::swap(all[i], all[random_.Below(static_cast<uint32_t>(i + 1))]);
    }
    return all;
  }

  // Every question about every mesh, or some of them.
  void Round() {
    std::vector<std::pair<size_t, size_t>> all = Shuffled();
    if (options_.questions < all.size()) all.resize(options_.questions);
    std::map<size_t, std::vector<size_t>> by_mesh;
    for (const auto& [mesh, question] : all) by_mesh[mesh].push_back(question);
    for (const auto& [mesh, questions] : by_mesh) AskAbout(mesh, questions);
  }

  Subject Make(const HardMesh& mesh) {
    if (!mesh.make) return {.arrays = {}, .path = mesh.path, .info = {}};
    TriangleSoup soup = mesh.make();
    Subject subject = {.arrays = {.positions = std::move(soup.positions),
                                  .triangles = std::move(soup.triangles)},
                       .path = folder_ / "mesh.off",
                       .info = {}};
    WriteFile(subject.path, OffText(subject.arrays));
    return subject;
  }

  // Makes the mesh resident, unless it is refused.
  bool Upload(Client& client, const std::string& mesh, Subject& subject) {
    const absl::StatusOr<UploadOutcome> outcome =
        subject.Upload(client, {.timeout = kGivenUp});
    if (outcome.ok()) {
      subject.info = outcome->mesh;
      return true;
    }
    Count(mesh, "upload without a deadline", outcome.status());
    return false;
  }

  void AskAbout(size_t mesh, const std::vector<size_t>& numbers) {
    const std::string& name = meshes_[mesh].name;
    Subject subject = Make(meshes_[mesh]);
    is_resident_ = false;
    for (const size_t number : numbers) {
      const HardQuestion& question = questions_[number];
      if (question.is_upload) {
        Delete(subject);
      } else if (!is_resident_) {
        is_resident_ = Upload(client_, name, subject);
        if (!is_resident_) continue;
      }
      Ask(name, subject, question);
    }
    Delete(subject);
  }

  void Delete(const Subject& subject) {
    if (!is_resident_) return;
    is_resident_ = false;
    if (const absl::Status status = client_.DeleteMesh(subject.info.digest);
        !status.ok()) {
      faults_.push_back("a mesh cannot be deleted: " + status.ToString());
    }
  }

  void Ask(const std::string& mesh, const Subject& subject,
           const HardQuestion& question) {
    // Searches may be kept.
    const double kept = question.searches
                            ? std::numeric_limits<double>::infinity()
                            : server_.Held().at(kSolvers);
    const Seconds limit{random_.OfAnySize(kShortest, kLongest)};
    const std::string what =
        absl::StrCat(question.name, ", ", 1e3 * limit.count(), " ms");
    const auto end = Clock::now() + ToClock(limit);
    absl::Status status;
    if (options_.cancels) {
      std::stop_source stop;
      const std::jthread canceller([&](const std::stop_token& is_over) {
        std::mutex mutex;
        std::condition_variable_any over;
        std::unique_lock lock(mutex);
        over.wait_until(lock, is_over, end, [] { return false; });
        stop.request_stop();
      });
      status =
          question.ask(client_, subject, random_, {.stop = stop.get_token()});
    } else {
      status = question.ask(client_, subject, random_, {.timeout = limit});
    }
    // Uploads take several calls, each with the deadline.
    auto from = Clock::now();
    if (IsEnded(status) && (options_.cancels || !question.is_upload)) {
      from = std::min(from, end);
    }
    const double ms = AwaitIdle(subject, mesh + ", " + what, from, kept);
    ++asked_;
    Count(mesh, what, status);
    if (IsEnded(status)) {
      stops_.push_back({mesh, question.name, 1e3 * limit.count(), ms});
    }
  }

  // Returns once the solvers hold no more memory than `kept`, and nobody
  // anything else; the milliseconds that it took.
  double AwaitIdle(const Subject& subject, const std::string& what,
                   Clock::time_point from, double kept) {
    for (;;) {
      std::map<std::string, double> left = server_.Held();
      if (left[kSolvers] <= kept) left.erase(kSolvers);
      std::erase_if(left, [](const auto& held) { return held.second == 0; });
      const double ms = MillisecondsSince(from);
      if (left.empty()) {
        if (ms > 1e3 * kStays.count()) {
          faults_.push_back(absl::StrCat(what, " stayed for ", ms, " ms"));
        }
        return ms;
      }
      if (ms > 1e3 * kGivenUp.count()) {
        throw std::runtime_error(
            absl::StrCat(what, " never ends: ", left.begin()->first));
      }
      left.erase(kSolvers);
      left.erase(kRunning);
      if (left.empty() && ms > kPatienceMs) Delete(subject);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  void Count(const std::string& mesh, const std::string& what,
             const absl::Status& status) {
    if (status.ok()) {
      ++answered_;
    } else if (IsRefused(status)) {
      ++refused_[KindOf(status)];
    } else if (!IsEnded(status)) {
      faults_.push_back(
          absl::StrCat(mesh, ", ", what, ": ", status.ToString()));
    }
  }

  // Asks a server to stop while a question is under way, which ends before the
  // server has to, or has no deadline. Notes how long the server takes then.
  void Drain(const HardMesh& mesh, const HardQuestion& question, bool in_time) {
    constexpr Seconds kDrain{1};
    const WatchedServer server(ServerOptions({"--drain-seconds", "1"}));
    Subject subject = Make(mesh);
    if (!question.is_upload) {
      Client client = Connect(server);
      if (!Upload(client, mesh.name, subject)) return;
    }
    test::Until([&] { return server.Metric(kRunning) == 0; });
    CallOptions options;
    if (in_time) options.timeout = kDrain / 2;
    auto due = Clock::now() + ToClock(kDrain / 2);
    Clock::time_point end;
    // With a connection that ends when it does.
    std::future<absl::Status> asking = std::async(std::launch::async, [&] {
      Client client = Connect(server);
      absl::Status status = question.ask(client, subject, random_, options);
      end = Clock::now();
      return status;
    });
    test::Until([&] {
      return server.Metric(kRunning) > 0 ||
             asking.wait_for(Seconds(0)) == std::future_status::ready;
    });
    const auto asked = Clock::now();
    if (!in_time) due = asked + ToClock(kDrain);
    const int code = server.Stop();
    const auto stopped = Clock::now();
    const absl::Status status = asking.get();
    const double ms =
        1e3 * Seconds(stopped - std::max(asked, std::min(due, end))).count();
    const std::string what =
        absl::StrCat(question.name, in_time ? ", 500 ms" : "", ", and SIGTERM");
    // Also those in time may be refused: who waits for a mesh to be prepared
    // needs another job then.
    if (!absl::IsUnavailable(status)) Count(mesh.name, what, status);
    // 3: requests were cancelled (docs/operations.md).
    if (code != 0 && (in_time || code != 3)) {
      faults_.push_back(absl::StrCat(mesh.name, ", ", what,
                                     ": the server ended with ", code));
    }
    if (ms > 1e3 * kStays.count()) {
      faults_.push_back(absl::StrCat(mesh.name, ", ", what,
                                     ": the server stayed for ", ms, " ms"));
    }
    drains_.push_back({{"mesh", mesh.name},
                       {"question", question.name},
                       {"status", absl::StatusCodeToString(status.code())},
                       {"exit_code", code},
                       {"ms", ms}});
  }

  const Options& options_;
  test::Random random_;
  const TemporaryFolder folder_;
  const std::vector<HardMesh> meshes_;
  const std::vector<HardQuestion> questions_;
  WatchedServer server_;
  Client client_;
  bool is_resident_ = false;

  uint64_t asked_ = 0;
  uint64_t answered_ = 0;
  std::vector<Stop> stops_;
  std::map<std::string, uint64_t> refused_;
  nlohmann::ordered_json drains_ = nlohmann::json::array();
  std::vector<std::string> faults_;
};

std::vector<std::string> Run(const Options& options) {
  Deadlines deadlines(options);
  deadlines.Run();
  std::cout << deadlines.Summary() << std::endl;
  return deadlines.Faults();
}

}  // namespace
}  // namespace geodesic::client

int main(int argc, char** argv) {
  geodesic::client::Options options;
  CLI::App app("Lets questions miss their deadlines and looks what stays.",
               "deadlines");
  app.option_defaults()->always_capture_default();
  app.add_option("--rounds", options.rounds, "Each asks all questions");
  app.add_option("--questions", options.questions,
                 "Of a round, drawn at random");
  app.add_option("--faces", options.faces, "Of the largest meshes")
      ->check(CLI::Range(1000, 300'000));
  app.add_flag("--made-only", options.made_only, "No files of the test meshes");
  app.add_flag("--cancel", options.cancels,
               "Cancel questions instead of giving them deadlines");
  app.add_option("--law", options.law,
                 "Milliseconds that no question may take to stop; 0: any");
  app.add_option("--drains", options.drains, "Servers that are asked to stop");
  app.add_option("--mesh", options.mesh, "Only those with this in their names");
  app.add_option("--question", options.question, "The same of questions");
  app.add_option("--seed", options.seed, "Of questions and moments");
  geodesic::client::AddServerOptions(app, options.server);
  return geodesic::client::RunMain(
      app, argc, argv, [&] { return geodesic::client::Run(options); });
}
