// The server that the command starts by itself when none is named.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"
#include "tests/support/http_get.h"
#include "tests/support/until.h"

namespace geodesic::client {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

// Sets an environment variable until its end; without a value, unsets it.
class Variable {
 public:
  Variable(std::string name, const std::string& value) : Variable(name) {
    setenv(name_.c_str(), value.c_str(), 1);
  }
  explicit Variable(std::string name) : name_(std::move(name)) {
    const char* before = getenv(name_.c_str());
    if (before != nullptr) before_ = before;
    unsetenv(name_.c_str());
  }
  ~Variable() {
    unsetenv(name_.c_str());
    if (before_) setenv(name_.c_str(), before_->c_str(), 1);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const std::string name_;
  std::optional<std::string> before_;
};

// A server is this test's alone: it lives in a folder that only it uses.
class OwnServerTest : public ::testing::Test {
 protected:
  void SetUp() override { WriteFile(mesh_, OffText(PlanarGrid(4))); }

  void TearDown() override {
    if (!fs::is_directory(home_) || fs::is_symlink(home_)) return;
    const ProcessResult stopped = Run({"server", "stop"});
    EXPECT_EQ(stopped.exit_code, 0) << stopped.err;
    EXPECT_TRUE(NoneLives());
  }

  static ProcessResult Run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), GEODESIC_BINARY);
    return RunProgram(arguments);
  }

  static json Status() {
    const ProcessResult result = Run({"server", "status", "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::parse(result.out, nullptr, false);
  }

  // The path of a server's file, by its ending; empty if there is none.
  std::string FileOf(const std::string& ending) const {
    for (const fs::directory_entry& entry : fs::directory_iterator(home_)) {
      if (entry.path().extension() == ending) return entry.path();
    }
    return "";
  }

  // Whether no process holds the lock that a server holds while it lives.
  bool NoneLives() const {
    const std::string path = FileOf(".alive");
    if (path.empty()) return true;
    const int file = open(path.c_str(), O_RDWR | O_CLOEXEC);
    const bool is_free = flock(file, LOCK_EX | LOCK_NB) == 0;
    close(file);
    return is_free;
  }

  // Makes the command refuse to start a server, naming its folder.
  void ExpectRefused(const std::string& why) const {
    const ProcessResult result = Run({"meshes"});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, AllOf(HasSubstr(home_), HasSubstr(why)));
  }

  TemporaryFolder folder_;
  const std::string home_ = folder_ / "geodesic";
  const std::string mesh_ = folder_ / "grid.off";

 private:
  const Variable runtime_{"XDG_RUNTIME_DIR", folder_.path().string()};
  const Variable server_{"GEODESIC_SERVER"};
  // Ends what a test that is killed would leave behind.
  const Variable idle_{"GEODESICD_EXIT_WHEN_IDLE", "60"};
  const Variable log_{"GEODESICD_LOG_LEVEL", "info"};
};

TEST_F(OwnServerTest, IsItsUsersAloneAndHoldsNothingOfTheCommand) {
  ASSERT_EQ(Run({"meshes"}).exit_code, 0);
  struct stat file = {};
  ASSERT_EQ(stat(home_.c_str(), &file), 0);
  EXPECT_EQ(file.st_mode & 0777, 0700);
  for (const fs::directory_entry& entry : fs::directory_iterator(home_)) {
    ASSERT_EQ(lstat(entry.path().c_str(), &file), 0);
    EXPECT_EQ(file.st_mode & 0077, 0) << entry.path();
  }
  const auto process = Status()["pid"].get<pid_t>();
  // Ctrl-C goes to the terminal's session.
  EXPECT_EQ(getsid(process), process);
  const fs::path open_files = "/proc/" + std::to_string(process) + "/fd";
  EXPECT_EQ(fs::read_symlink(open_files / "0"), "/dev/null");
  EXPECT_EQ(fs::read_symlink(open_files / "1"), FileOf(".log"));
  EXPECT_EQ(fs::read_symlink(open_files / "2"), FileOf(".log"));
}

TEST_F(OwnServerTest, TenCommandsAtOnceStartOne) {
  std::vector<std::unique_ptr<Process>> commands;
  for (int i = 0; i < 10; ++i) {
    commands.push_back(std::make_unique<Process>(
        std::vector<std::string>{GEODESIC_BINARY, "info", mesh_}));
  }
  for (const auto& command : commands) {
    const ProcessResult result = command->Wait();
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  const std::string log = FileBytes(FileOf(".log"));
  size_t starts = 0;
  for (size_t at = log.find(" serves on "); at != std::string::npos;
       at = log.find(" serves on ", at + 1)) {
    ++starts;
  }
  EXPECT_EQ(starts, 1) << log;
}

TEST_F(OwnServerTest, AKilledOneIsReplaced) {
  ASSERT_EQ(Run({"meshes"}).exit_code, 0);
  const auto first = Status()["pid"].get<pid_t>();
  ASSERT_EQ(kill(first, SIGKILL), 0);
  ASSERT_TRUE(test::Until([this] { return NoneLives(); }));
  EXPECT_NE(FileOf(".sock"), "") << "the socket is to be stale";
  EXPECT_EQ(Run({"server", "status"}).exit_code, 1);
  const ProcessResult next = Run({"meshes"});
  EXPECT_EQ(next.exit_code, 0) << next.err;
  EXPECT_NE(Status()["pid"].get<pid_t>(), first);
}

TEST_F(OwnServerTest, OneKilledInTheMiddleIsReported) {
  WriteFile(mesh_, OffText(HillyGrid(500)));
  Process field({GEODESIC_BINARY, "field", mesh_, "--source", "0",
                 "--algorithm", "ich", "-o", folder_ / "d.npy"});
  ASSERT_TRUE(field.AwaitError("solving"));
  ASSERT_EQ(kill(Status()["pid"].get<pid_t>(), SIGKILL), 0);
  const ProcessResult result = field.Wait();
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_THAT(result.err, AllOf(HasSubstr("ended in the middle"),
                                HasSubstr("run the command again")));
}

TEST_F(OwnServerTest, OneThatDrainsIsWaitedFor) {
  WriteFile(mesh_, OffText(HillyGrid(400)));
  Process field({GEODESIC_BINARY, "field", mesh_, "--source", "0",
                 "--algorithm", "ich", "-o", folder_ / "d.npy"});
  const auto has_logged = [this](const std::string& words) {
    if (!fs::exists(home_)) return false;
    const std::string log = FileOf(".log");
    return !log.empty() && FileBytes(log).find(words) != std::string::npos;
  };
  ASSERT_TRUE(test::Until([&] { return has_logged("CreateMesh code=OK"); }));
  const auto first = Status()["pid"].get<pid_t>();
  ASSERT_EQ(kill(first, SIGTERM), 0);
  ASSERT_TRUE(test::Until([&] { return has_logged("draining"); }));
  const ProcessResult next = Run({"meshes"});
  EXPECT_EQ(next.exit_code, 0) << next.err;
  EXPECT_NE(Status()["pid"].get<pid_t>(), first);
  field.Wait();
}

// As one under a debugger is. Its queue of connections is filled, too, as far
// as this process may open sockets.
TEST_F(OwnServerTest, OneThatIsStoppedIsNotWaitedForWithoutBound) {
  ASSERT_EQ(Run({"meshes"}).exit_code, 0);
  const auto process = Status()["pid"].get<pid_t>();
  ASSERT_EQ(kill(process, SIGSTOP), 0);
  const ProcessResult unanswered = Run({"--timeout", "1", "meshes"});
  EXPECT_EQ(unanswered.exit_code, 7) << unanswered.err;
  EXPECT_THAT(unanswered.err, HasSubstr("does not answer"));

  sockaddr_un address = {.sun_family = AF_UNIX};
  FileOf(".sock").copy(address.sun_path, sizeof(address.sun_path) - 1);
  std::vector<int> waiting;
  int error = 0;
  while (error == 0) {
    waiting.push_back(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0));
    error = waiting.back() < 0 ||
            connect(waiting.back(), reinterpret_cast<sockaddr*>(&address),
                    sizeof(address));
  }
  for (const auto& words : std::vector<std::vector<std::string>>{
           {"--timeout", "1", "meshes"},
           {"--timeout", "1", "server", "status"},
           {"--timeout", "1", "server", "stop"}}) {
    EXPECT_NE(Run(words).exit_code, 0) << words.back();
  }
  for (const int descriptor : waiting) close(descriptor);
  ASSERT_EQ(kill(process, SIGCONT), 0);
}

TEST_F(OwnServerTest, AFolderThatOthersOpenIsRefused) {
  ASSERT_EQ(mkdir(home_.c_str(), 0700), 0);
  ASSERT_EQ(chmod(home_.c_str(), 0750), 0);
  ExpectRefused("can be opened by other users");
  EXPECT_TRUE(fs::is_empty(home_));
  ASSERT_EQ(chmod(home_.c_str(), 0700), 0);
}

TEST_F(OwnServerTest, ALinkIsRefused) {
  const std::string elsewhere = folder_ / "elsewhere";
  ASSERT_EQ(mkdir(elsewhere.c_str(), 0700), 0);
  fs::create_directory_symlink(elsewhere, home_);
  ExpectRefused("is not a folder");
  EXPECT_TRUE(fs::is_empty(elsewhere));
}

TEST_F(OwnServerTest, AnothersFolderIsRefused) {
  constexpr uid_t kNobody = 65534;
  ASSERT_EQ(mkdir(home_.c_str(), 0700), 0);
  if (chown(home_.c_str(), kNobody, kNobody) != 0) {
    GTEST_SKIP() << "only root can give a folder away";
  }
  ExpectRefused("belongs to user 65534");
  EXPECT_TRUE(fs::is_empty(home_));
  ASSERT_EQ(chown(home_.c_str(), geteuid(), getegid()), 0);
}

TEST_F(OwnServerTest, APathTooLongForASocketIsRefused) {
  const std::string deep = folder_ / std::string(100, 'a');
  ASSERT_EQ(mkdir(deep.c_str(), 0700), 0);
  const Variable runtime("XDG_RUNTIME_DIR", deep);
  const ProcessResult result = Run({"meshes"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("too long for a socket"));
}

TEST_F(OwnServerTest, EndsWhenIdleAndIsStartedAgain) {
  const Variable idle("GEODESICD_EXIT_WHEN_IDLE", "1");
  ASSERT_EQ(Run({"meshes"}).exit_code, 0);
  EXPECT_TRUE(test::Until([this] { return NoneLives(); }));
  EXPECT_EQ(FileOf(".sock"), "");
  EXPECT_THAT(FileBytes(FileOf(".log")), HasSubstr("no request for 1 s"));
  EXPECT_EQ(Run({"meshes"}).exit_code, 0);
}

TEST_F(OwnServerTest, StatusTellsAllAndStopEndsIt) {
  const ProcessResult none = Run({"server", "status"});
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.err, HasSubstr("no server of this version runs"));
  EXPECT_EQ(Run({"server", "stop"}).exit_code, 0);

  ASSERT_EQ(Run({"upload", mesh_}).exit_code, 0);
  const json status = Status();
  EXPECT_EQ(status["running"], true);
  EXPECT_EQ(status["address"], "unix:" + FileOf(".sock"));
  EXPECT_THAT(FileOf(".sock"), HasSubstr(status["version"]));
  EXPECT_EQ(status["meshes"], 1);
  EXPECT_GT(status["memory_bytes"], 1 << 20);
  EXPECT_THAT(status["since"], HasSubstr("T"));
  const ProcessResult text = Run({"server", "status"});
  EXPECT_THAT(text.out, HasSubstr(std::to_string(status["pid"].get<pid_t>())));

  const ProcessResult stop = Run({"server", "stop"});
  EXPECT_EQ(stop.exit_code, 0) << stop.err;
  EXPECT_THAT(stop.out, HasSubstr("stopped the server"));
  EXPECT_TRUE(NoneLives());
  EXPECT_EQ(FileOf(".sock"), "");
  EXPECT_EQ(Run({"server", "status", "--json"}).exit_code, 1);
}

// The answer of the page's port to ListMeshes with this token; empty for none.
std::string ListByPage(const std::string& page, const std::string& token) {
  const std::string body(5, '\0');
  std::string request =
      "POST /geodesic.v1.MeshService/ListMeshes HTTP/1.1\r\n"
      "Host: 127.0.0.1\r\nConnection: close\r\nContent-Length: 5\r\n"
      "Content-Type: application/grpc-web+proto\r\n";
  if (!token.empty()) request += "Authorization: Bearer " + token + "\r\n";
  const int port = std::stoi(page.substr(page.rfind(':') + 1));
  return test::HttpExchange(port, request + "\r\n" + body);
}

TEST_F(OwnServerTest, ViewShowsThePageToItsUserAlone) {
  // A server without the page gives way to one that has it.
  ASSERT_EQ(Run({"upload", mesh_}).exit_code, 0);
  const json before = Status();
  const ProcessResult view = Run({"view", mesh_, "--no-browser", "--json"});
  ASSERT_EQ(view.exit_code, 0) << view.err;
  const json shown = json::parse(view.out);
  EXPECT_NE(Status()["pid"], before["pid"]);
  const std::string url = shown["url"];
  const size_t hash = url.find("/#token=");
  const size_t end = url.find("&mesh=" + shown["mesh"].get<std::string>());
  ASSERT_NE(hash, url.npos) << url;
  ASSERT_NE(end, url.npos) << url;
  const std::string page = url.substr(0, hash);
  const std::string token = url.substr(hash + 8, end - hash - 8);
  EXPECT_EQ(token.size(), 64);
  EXPECT_THAT(ListByPage(page, ""), HasSubstr("grpc-status: 16"));
  EXPECT_THAT(ListByPage(page, std::string(64, '0')),
              HasSubstr("grpc-status: 16"));
  EXPECT_THAT(ListByPage(page, token), HasSubstr("grpc-status: 0"));
  // The same page again, and the same server for other commands.
  const json again =
      json::parse(Run({"view", mesh_, "--no-browser", "--json"}).out);
  EXPECT_EQ(again["url"], url);
  EXPECT_EQ(Run({"info", mesh_}).exit_code, 0);
  for (const std::string ending : {".web-token", ".json"}) {
    struct stat file = {};
    ASSERT_EQ(stat(FileOf(ending).c_str(), &file), 0) << ending;
    EXPECT_EQ(file.st_mode & 0777, 0600) << ending;
  }
}

TEST_F(OwnServerTest, ViewGivesTheBrowserAFileAndNoToken) {
  const std::string opened = folder_ / "opened";
  const std::string program = folder_ / "xdg-open";
  // Renamed when it is whole.
  WriteFile(program, "#!/bin/sh\nprintf %s \"$1\" >" + opened + ".part\nmv " +
                         opened + ".part " + opened + "\n");
  ASSERT_EQ(chmod(program.c_str(), 0700), 0);
  const Variable path("PATH", folder_.path().string() + ":" + getenv("PATH"));
  const ProcessResult view = Run({"view", mesh_});
  ASSERT_EQ(view.exit_code, 0) << view.err;
  ASSERT_TRUE(test::Until([&] { return fs::exists(opened); }));
  const std::string link = FileBytes(opened);
  EXPECT_EQ(link, FileOf(".html"));
  const std::string token = view.out.substr(view.out.find("token="), 70);
  EXPECT_THAT(FileBytes(link), HasSubstr(token));
  struct stat file = {};
  ASSERT_EQ(stat(link.c_str(), &file), 0);
  EXPECT_EQ(file.st_mode & 0777, 0600);
}

TEST_F(OwnServerTest, NamedServersWin) {
  RunningServer server(folder_);
  const ProcessResult named =
      Run({"--server", server.address(), "upload", mesh_});
  EXPECT_EQ(named.exit_code, 0) << named.err;
  const Variable configured("GEODESIC_SERVER", server.address());
  const ProcessResult listed = Run({"meshes", "--json"});
  EXPECT_EQ(json::parse(listed.out, nullptr, false)["meshes"].size(), 1);
  EXPECT_FALSE(fs::exists(home_));
}

TEST_F(OwnServerTest, SharedServersSettingsAreNotTaken) {
  const Variable listen("GEODESICD_LISTEN", "127.0.0.1:1");
  const Variable tokens("GEODESICD_TOKEN_FILE", folder_ / "missing");
  const Variable threads("GEODESICD_THREADS", "3");
  const ProcessResult result = Run({"capabilities", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["limits"]["max_concurrent_jobs"], 3);
}

TEST_F(OwnServerTest, AServerThatDoesNotStartIsHeard) {
  const Variable threads("GEODESICD_THREADS", "many");
  const ProcessResult result = Run({"meshes"});
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_THAT(result.err,
              AllOf(HasSubstr("does not start: it ended with exit code 2"),
                    HasSubstr("many"), HasSubstr(FileOf(".log"))));
}

TEST_F(OwnServerTest, IsFoundInThePathOrMissed) {
  const std::string alone = folder_ / "alone";
  fs::create_directory(alone);
  fs::copy_file(GEODESIC_BINARY, alone + "/geodesic");
  {
    const Variable path("PATH", alone);
    const ProcessResult missed = RunProgram({alone + "/geodesic", "meshes"});
    EXPECT_EQ(missed.exit_code, 7);
    EXPECT_THAT(missed.err, AllOf(HasSubstr(alone + "/geodesicd"),
                                  HasSubstr("--server HOST:PORT")));
  }
  const Variable path(
      "PATH", "/nowhere:" + fs::path(GEODESICD_BINARY).parent_path().string());
  const ProcessResult found = RunProgram({alone + "/geodesic", "meshes"});
  EXPECT_EQ(found.exit_code, 0) << found.err;
}

TEST_F(OwnServerTest, OneOfAnotherVersionIsRefused) {
  ASSERT_EQ(Run({"meshes"}).exit_code, 0);
  const Variable path("PATH",
                      fs::path(GEODESICD_BINARY).parent_path().string());
  const ProcessResult other =
      RunProgram({GEODESIC_OF_ANOTHER_VERSION, "meshes"});
  EXPECT_EQ(other.exit_code, 7);
  EXPECT_THAT(other.err, AllOf(HasSubstr("this is geodesic 0.0.0, but the "
                                         "geodesicd found has version"),
                               HasSubstr("name a server with --server")));
  // The one that it had started is gone, and this version's is still there.
  EXPECT_EQ(
      RunProgram({GEODESIC_OF_ANOTHER_VERSION, "server", "status"}).exit_code,
      1);
  EXPECT_TRUE(Status()["running"].get<bool>());
}

TEST_F(OwnServerTest, AnotherBuildHasItsOwn) {
  ASSERT_EQ(Run({"upload", mesh_}).exit_code, 0);
  const fs::path folder = folder_ / "other";
  fs::create_directory(folder);
  for (const char* program : {GEODESIC_BINARY, GEODESICD_BINARY}) {
    fs::copy_file(program, folder / fs::path(program).filename());
  }
  const std::string other = folder / fs::path(GEODESIC_BINARY).filename();
  const ProcessResult meshes = RunProgram({other, "meshes", "--json"});
  EXPECT_EQ(meshes.exit_code, 0) << meshes.err;
  EXPECT_TRUE(json::parse(meshes.out)["meshes"].empty()) << meshes.out;
  EXPECT_EQ(RunProgram({other, "server", "stop"}).exit_code, 0);
  EXPECT_EQ(Status()["meshes"], 1);
}

}  // namespace
}  // namespace geodesic::client
