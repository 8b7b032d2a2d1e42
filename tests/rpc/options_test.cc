#include "server/options/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "absl/strings/ascii.h"
#include "manual/settings_file.h"

namespace geodesic::server {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class OptionsTest : public ::testing::Test {
 protected:
  ~OptionsTest() override {
    for (const std::string& name : variables_) unsetenv(name.c_str());
    std::filesystem::remove(config_);
  }

  void SetVariable(const std::string& name, const std::string& value) {
    variables_.push_back(name);
    setenv(name.c_str(), value.c_str(), 1);
  }

  void WriteConfig(const std::string& text) { std::ofstream(config_) << text; }

  CommandLine Parse(std::vector<std::string> arguments) {
    std::vector<const char*> argv = {"geodesicd"};
    for (const std::string& argument : arguments) {
      argv.push_back(argument.c_str());
    }
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    CommandLine result =
        ParseCommandLine(static_cast<int>(argv.size()), argv.data(), "1.2.3");
    out_ = ::testing::internal::GetCapturedStdout();
    err_ = ::testing::internal::GetCapturedStderr();
    return result;
  }

  void ExpectUsageError(std::vector<std::string> arguments,
                        const std::string& flag) {
    EXPECT_EQ(Parse(std::move(arguments)).exit_code, 2);
    EXPECT_THAT(err_, HasSubstr(flag));
  }

  const std::string config_ =
      std::filesystem::temp_directory_path() /
      ("geodesicd_options_test_" + std::to_string(getpid()) + ".toml");
  std::vector<std::string> variables_;
  std::string out_, err_;
};

TEST_F(OptionsTest, Defaults) {
  const CommandLine result = Parse({});
  EXPECT_FALSE(result.exit_code.has_value()) << err_;
  EXPECT_EQ(result.options.listen, "127.0.0.1:50051");
  EXPECT_EQ(result.options.drain, std::chrono::seconds(30));
  EXPECT_GE(result.options.limits.max_concurrent_jobs, 1);
}

TEST_F(OptionsTest, Sockets) {
  const CommandLine result =
      Parse({"--listen", "unix:/run/geodesic/a.sock", "--exit-when-idle", "9"});
  ASSERT_FALSE(result.exit_code.has_value()) << err_;
  EXPECT_EQ(result.options.listen, "unix:/run/geodesic/a.sock");
  EXPECT_EQ(result.options.exit_when_idle, std::chrono::seconds(9));
  EXPECT_EQ(Parse({}).options.exit_when_idle, std::chrono::seconds(0));
  for (const std::string& path :
       {std::string("a.sock"), std::string(), std::string("/a b"),
        "/" + std::string(107, 'a')}) {
    ExpectUsageError({"--listen", "unix:" + path}, "--listen");
  }
  ExpectUsageError({"--metrics-listen", "unix:/run/m"}, "--metrics-listen");
}

TEST_F(OptionsTest, Flags) {
  const CommandLine result =
      Parse({"--listen", "[::1]:0", "--limit", "mesh-store=2GiB",
             "--limit=field-cache=1MB", "--threads", "3", "--limit",
             "max-queued-jobs=0", "--drain-seconds", "0", "--log-level", "warn",
             "--limit", "landmark-memory=0"});
  ASSERT_FALSE(result.exit_code.has_value()) << err_;
  EXPECT_EQ(result.options.listen, "[::1]:0");
  EXPECT_EQ(result.options.limits.mesh_store_bytes, uint64_t{2} << 30);
  EXPECT_EQ(result.options.limits.field_cache_bytes, 1'000'000);
  EXPECT_EQ(result.options.limits.landmark_memory_bytes, 0);
  EXPECT_EQ(result.options.limits.max_concurrent_jobs, 3);
  EXPECT_EQ(result.options.limits.max_queued_jobs, 0);
  EXPECT_EQ(result.options.drain, std::chrono::seconds(0));
  EXPECT_EQ(result.options.log_level, "warn");
}

TEST_F(OptionsTest, DiskIsUsedOnlyIfAFolderIsNamed) {
  const CommandLine without = Parse({"--limit", "mesh-disk=1GiB"});
  EXPECT_EQ(without.options.data_dir, "");
  EXPECT_EQ(without.options.limits.mesh_disk_bytes, 0);
  EXPECT_EQ(without.options.limits.field_disk_bytes, 0);
  const CommandLine with =
      Parse({"--data-dir", "/some/where", "--limit", "field-disk=1GiB"});
  EXPECT_EQ(with.options.data_dir, "/some/where");
  EXPECT_GT(with.options.limits.mesh_disk_bytes, 0);
  EXPECT_EQ(with.options.limits.field_disk_bytes, uint64_t{1} << 30);
}

TEST_F(OptionsTest, TheSharedTier) {
  EXPECT_EQ(Parse({}).options.shared_tier, "");
  const CommandLine tcp = Parse({"--shared-tier", "redis.example.org:6379",
                                 "--limit", "shared-tier-seconds=604800",
                                 "--limit", "shared-tier-max-value-bytes=1MiB",
                                 "--limit", "shared-tier-timeout-ms=9",
                                 "--shared-tier-password-file", "word"});
  ASSERT_FALSE(tcp.exit_code.has_value()) << err_;
  EXPECT_EQ(tcp.options.shared_tier, "redis.example.org:6379");
  EXPECT_EQ(tcp.options.shared_tier_expiry, std::chrono::hours(24 * 7));
  EXPECT_EQ(tcp.options.shared_tier_max_value_bytes, 1 << 20);
  EXPECT_EQ(tcp.options.shared_tier_timeout_ms, 9);
  EXPECT_EQ(tcp.options.shared_tier_password_file, "word");
  EXPECT_FALSE(
      Parse({"--shared-tier", "unix:/run/redis.sock"}).exit_code.has_value());
  ExpectUsageError({"--shared-tier", "redis"}, "--shared-tier");
  ExpectUsageError({"--shared-tier-password-file", "word"},
                   "--shared-tier-password-file requires --shared-tier");
}

TEST_F(OptionsTest, WhatWouldDoNothingIsRefused) {
  SetVariable("GEODESICD_SHARED_TIER_PASSWORD_FILE", "word");
  ExpectUsageError({}, "--shared-tier-password-file requires --shared-tier");
  SetVariable("GEODESICD_SHARED_TIER", "127.0.0.1:6379");
  EXPECT_FALSE(Parse({}).exit_code.has_value()) << err_;
}

TEST_F(OptionsTest, FlagsWinOverVariablesAndThoseOverTheFile) {
  WriteConfig(
      "threads = 5\nmemory = \"1GiB\"\nlimit = [\"field-cache=7KiB\"]\n");
  SetVariable("GEODESICD_THREADS", "6");
  SetVariable("GEODESICD_MEMORY", "2GiB");
  const CommandLine result = Parse({"--config", config_, "--threads", "7"});
  ASSERT_FALSE(result.exit_code.has_value()) << err_;
  EXPECT_EQ(result.options.limits.max_concurrent_jobs, 7);
  EXPECT_EQ(result.options.memory_bytes, uint64_t{2} << 30);
  EXPECT_EQ(result.options.limits.field_cache_bytes, 7 << 10);
}

TEST_F(OptionsTest, TheFileMayComeFromTheEnvironment) {
  WriteConfig("threads = 17\n");
  SetVariable("GEODESICD_CONFIG", config_);
  EXPECT_EQ(Parse({}).options.limits.max_concurrent_jobs, 17);
}

TEST_F(OptionsTest, AFileOfSettingsIsAPlainOne) {
  const std::string pipe = config_ + ".pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {pipe, std::string("/dev/zero")}) {
    ExpectUsageError({"--config", path}, path + " is no plain file");
    SetVariable("GEODESICD_CONFIG", path);
    ExpectUsageError({}, path + " is no plain file");
  }
  std::filesystem::remove(pipe);
}

TEST_F(OptionsTest, HelpExplainsEveryFlag) {
  EXPECT_EQ(Parse({"--help"}).exit_code, 0);
  for (const char* flag :
       {"--listen",          "--port-file",         "--threads",
        "--memory",          "--data-dir",          "--disk",
        "--limit",           "--drain-seconds",     "--log-level",
        "--config",          "--version",           "--tls-cert",
        "--tls-key",         "--tls-client-ca",     "--insecure-listen",
        "--token-file",      "--metrics-listen",    "  max-pairs=65536",
        "  mesh-disk=64GiB", "  receive-seconds=60"}) {
    EXPECT_THAT(out_, HasSubstr(flag));
  }
  EXPECT_THAT(out_,
              AllOf(HasSubstr("GEODESICD_DATA_DIR"), HasSubstr("Exit codes")));
}

TEST_F(OptionsTest, ThereAreAtMost25Flags) {
  const auto options = ProgramPage().options;
  EXPECT_LE(std::ranges::count_if(
                options, [](const manual::Option& o) { return o.is_setting; }),
            23);
}

TEST_F(OptionsTest, MemoryAndDiskAreDivided) {
  const ServerOptions options =
      Parse({"--memory", "20GiB", "--disk", "10GiB", "--data-dir", "d"})
          .options;
  const Limits& limits = options.limits;
  EXPECT_EQ(limits.solver_memory_bytes + limits.mesh_store_bytes +
                limits.upload_memory_bytes + limits.field_cache_bytes +
                limits.prepared_memory_bytes + limits.landmark_memory_bytes +
                options.request_memory_bytes + options.receive_memory_bytes,
            uint64_t{20} << 30);
  EXPECT_EQ(limits.mesh_disk_bytes + limits.field_disk_bytes,
            uint64_t{10} << 30);
  EXPECT_EQ(limits.max_upload_bytes, uint64_t{1} << 30);
  EXPECT_LE(Parse({"--memory", "1GiB"}).options.limits.max_upload_bytes,
            uint64_t{256} << 20);
  EXPECT_EQ(Parse({"--memory", "1GiB", "--limit", "solver-memory=2GiB"})
                .options.limits.solver_memory_bytes,
            uint64_t{2} << 30);
  ExpectUsageError({"--memory", "1MiB"}, "--memory");
}

TEST_F(OptionsTest, LimitsAreSetByName) {
  SetVariable("GEODESICD_LIMIT", "max-pairs=7,max-faces=9");
  EXPECT_EQ(Parse({}).options.limits.max_pairs, 7);
  EXPECT_EQ(Parse({}).options.limits.max_faces, 9);
  for (const char* wrong : {"max-pears=7", "max-pairs", "=7", "help=1"}) {
    ExpectUsageError({"--limit", wrong}, "a name that --help lists");
  }
  ExpectUsageError({"--limit", "max-pairs=0"}, "--limit max-pairs");
}

TEST_F(OptionsTest, Version) {
  EXPECT_EQ(Parse({"--version"}).exit_code, 0);
  EXPECT_EQ(out_, "geodesicd 1.2.3\n");
}

TEST_F(OptionsTest, ErrorsNameTheFlag) {
  ExpectUsageError({"--listen", "somewhere"}, "--listen");
  ExpectUsageError({"--listen", ":80"}, "--listen");
  ExpectUsageError({"--listen", "127.0.0.1:70000"}, "--listen");
  ExpectUsageError({"--threads", "0"}, "--threads");
  ExpectUsageError({"--threads", "-1"}, "--threads");
  ExpectUsageError({"--limit", "mesh-store=lots"}, "--limit mesh-store");
  ExpectUsageError({"--limit", "max-message-bytes=3GiB"},
                   "--limit max-message-bytes");
  ExpectUsageError({"--limit", "max-faces=2000000000"}, "--limit max-faces");
  ExpectUsageError({"--log-level", "loud"}, "--log-level");
  ExpectUsageError({"--limit", "receive-seconds=0"}, "--limit receive-seconds");
  ExpectUsageError({"--limit", "max-connection-streams=0"},
                   "--limit max-connection-streams");
  ExpectUsageError({"--limit", "receive-memory=1MiB"},
                   "--limit max-message-bytes");
  ExpectUsageError({"--limit", "request-memory=1MiB"},
                   "--limit max-message-bytes");
  ExpectUsageError({"--limit", "max-upload-bytes=8GiB"}, "upload-memory");
  ExpectUsageError({"--no-such-flag"}, "--no-such-flag");
  ExpectUsageError({"--config", "/nonexistent/file"}, "/nonexistent/file");
}

TEST_F(OptionsTest, OtherMachinesAreServedInClearOnlyWhenThatIsSaid) {
  ExpectUsageError({"--listen", "0.0.0.0:1"}, "--insecure-listen");
  ExpectUsageError({"--tls-cert", "c.pem"}, "--tls-key");
  ExpectUsageError({"--tls-client-ca", "c.pem"}, "--tls-cert");
  EXPECT_TRUE(Parse({"--listen", "0.0.0.0:1", "--insecure-listen"})
                  .options.insecure_listen);
  EXPECT_FALSE(Parse({"--listen", "0.0.0.0:1", "--tls-cert", "c.pem",
                      "--tls-key", "k.pem"})
                   .exit_code.has_value());
  SetVariable("GEODESICD_INSECURE_LISTEN", "true");
  EXPECT_FALSE(Parse({"--listen", "0.0.0.0:1"}).exit_code.has_value()) << err_;
}

TEST_F(OptionsTest, ErrorsInTheFileNameTheSetting) {
  WriteConfig("thread = 50\n");
  ExpectUsageError({"--config", config_},
                   config_ + ": \"thread\" is not a setting");
  WriteConfig("[limits]\nthreads = 50\n");
  ExpectUsageError({"--config", config_}, "\"limits\" is not a setting");
  WriteConfig("threads: 50\n");
  ExpectUsageError({"--config", config_}, "NAME = VALUE");
}

// The file that the package installs, which explains all settings.
TEST_F(OptionsTest, TheExplainedFileHoldsTheDefaults) {
  const std::string explained = manual::SettingsFile(ProgramPage(), {});
  // Every default comes into force; "#" followed by a name is one.
  std::istringstream lines(explained);
  std::string in_force;
  int settings = 0;
  for (std::string line; std::getline(lines, line);) {
    const bool is_setting =
        line.size() > 1 && line[0] == '#' && absl::ascii_islower(line[1]);
    // What has no default shows the kind of its value, in capitals.
    const size_t value = line.find(" = \"");
    if (!is_setting ||
        (value != std::string::npos && absl::ascii_isupper(line[value + 4]))) {
      continue;
    }
    in_force += line.substr(1) + "\n";
    ++settings;
  }
  EXPECT_GT(settings, 5);
  WriteConfig(in_force);
  const CommandLine result = Parse({"--config", config_});
  ASSERT_FALSE(result.exit_code.has_value()) << err_ << in_force;
  const ServerOptions defaults = Parse({}).options;
  EXPECT_EQ(result.options.listen, defaults.listen);
  EXPECT_EQ(result.options.max_requests, defaults.max_requests);
  EXPECT_EQ(result.options.drain, defaults.drain);
  EXPECT_EQ(result.options.limits.mesh_store_bytes,
            defaults.limits.mesh_store_bytes);
  EXPECT_EQ(result.options.limits.max_faces, defaults.limits.max_faces);
}

}  // namespace
}  // namespace geodesic::server
