#include "server/acceptor.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <memory>
#include <mutex>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/support/until.h"

namespace geodesic::server {
namespace {

class AcceptorTest : public ::testing::Test {
 protected:
  void SetUp() override {
    getrlimit(RLIMIT_NOFILE, &limit_);
    auto acceptor = Acceptor::Listen("127.0.0.1:0");
    ASSERT_TRUE(acceptor.ok()) << acceptor.status();
    acceptor_ = *std::move(acceptor);
    acceptor_->Start([this](int connection, int) {
      std::lock_guard lock(mutex_);
      accepted_.emplace_back(connection);
    });
  }

  ~AcceptorTest() override { setrlimit(RLIMIT_NOFILE, &limit_); }

  void Allow(rlim_t descriptors) const {
    const rlimit limit = {descriptors, limit_.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &limit), 0);
  }

  void Connect(const FileDescriptor& client) const {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<uint16_t>(acceptor_->port()));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ASSERT_EQ(connect(client.get(), reinterpret_cast<const sockaddr*>(&address),
                      sizeof(address)),
              0);
  }

  static FileDescriptor Client() {
    return FileDescriptor(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  }

  // Waits for the other side; whether it closes the connection.
  static bool IsClosed(const FileDescriptor& client) {
    char byte = 0;
    return recv(client.get(), &byte, 1, 0) <= 0;
  }

  size_t accepted() {
    std::lock_guard lock(mutex_);
    return accepted_.size();
  }

  void CloseAccepted() {
    std::lock_guard lock(mutex_);
    accepted_.clear();
  }

  void ExpectServed() {
    const size_t before = accepted();
    const FileDescriptor client = Client();
    Connect(client);
    EXPECT_TRUE(test::Until([&] { return accepted() == before + 1; }));
  }

  rlimit limit_ = {};
  std::unique_ptr<Acceptor> acceptor_;
  std::mutex mutex_;
  std::vector<FileDescriptor> accepted_;
};

TEST_F(AcceptorTest, TheLastDescriptorsAreForOthers) {
  // An eighth of so few.
  Allow(160);
  std::vector<FileDescriptor> clients;
  for (int i = 0; i < 75; ++i) {
    clients.push_back(Client());
    Connect(clients.back());
  }
  EXPECT_TRUE(IsClosed(clients.back()));
  EXPECT_LT(accepted(), 75u);
  // So a file can be opened.
  EXPECT_GE(FileDescriptor(dup(0)).get(), 0);
  clients.clear();
  CloseAccepted();
  ExpectServed();
}

TEST_F(AcceptorTest, ServesAgainOnceThereAreDescriptors) {
  Allow(64);
  const FileDescriptor client = Client(), another = Client();
  std::vector<FileDescriptor> all;
  do {
    all.emplace_back(dup(0));
  } while (all.back().get() >= 0);
  Connect(client);
  EXPECT_TRUE(IsClosed(client));
  Connect(another);
  EXPECT_TRUE(test::Until([&] {
    char byte = 0;
    return recv(another.get(), &byte, 1, MSG_DONTWAIT) == 0;
  }));
  EXPECT_EQ(accepted(), 0u);
  all.clear();
  ExpectServed();
}

TEST_F(AcceptorTest, OneServerHasAPort) {
  const std::string address = absl::StrCat("127.0.0.1:", acceptor_->port());
  EXPECT_EQ(Acceptor::Listen(address).status().code(),
            absl::StatusCode::kUnavailable);
  acceptor_->Stop();
  EXPECT_TRUE(Acceptor::Listen(address).ok());
}

TEST_F(AcceptorTest, TakesAddressesAsPeopleWriteThem) {
  for (const char* address : {"localhost:0", "0.0.0.0:0", "[::]:0", ":0"}) {
    const auto acceptor = Acceptor::Listen(address);
    ASSERT_TRUE(acceptor.ok()) << acceptor.status();
    EXPECT_GT((*acceptor)->port(), 0);
  }
  for (const char* address :
       {"localhost", "nowhere.invalid:0", "192.0.2.1:0"}) {
    EXPECT_EQ(Acceptor::Listen(address).status().code(),
              absl::StatusCode::kUnavailable)
        << address;
  }
}

}  // namespace
}  // namespace geodesic::server
