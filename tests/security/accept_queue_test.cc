#include "server/operations/accept_queue.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <vector>

namespace geodesic::server {
namespace {

class AcceptQueueTest : public ::testing::Test {
 protected:
  ~AcceptQueueTest() override {
    for (const int descriptor : open_) close(descriptor);
  }

  int Open() {
    open_.push_back(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    return open_.back();
  }

  std::vector<int> open_;
};

TEST_F(AcceptQueueTest, ConnectionsWaitUntilTheyAreAccepted) {
  const int listener = Open();
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  socklen_t size = sizeof(address);
  ASSERT_EQ(bind(listener, any, size), 0);
  ASSERT_EQ(listen(listener, 16), 0);
  ASSERT_EQ(getsockname(listener, any, &size), 0);
  const int port = ntohs(address.sin_port);
  EXPECT_EQ(WaitingConnections(port), 0);
  for (int i = 0; i < 3; ++i) ASSERT_EQ(connect(Open(), any, size), 0);
  EXPECT_EQ(WaitingConnections(port), 3);
  open_.push_back(accept(listener, nullptr, nullptr));
  EXPECT_EQ(WaitingConnections(port), 2);
  close(listener);
  open_.erase(open_.begin());
  EXPECT_EQ(WaitingConnections(port), std::nullopt);
}

TEST(AcceptWatchTest, APortIsGivenUpWhenSomeHaveWaitedForLong) {
  const AcceptWatch::Clock::time_point begin;
  AcceptWatch watch;
  EXPECT_TRUE(watch.IsServed(5, begin));
  EXPECT_TRUE(watch.IsServed(0, begin + std::chrono::seconds(9)));
  // They wait from here on, as far as is known.
  EXPECT_TRUE(watch.IsServed(1, begin + std::chrono::seconds(11)));
  EXPECT_TRUE(watch.IsServed(2, begin + std::chrono::seconds(20)));
  EXPECT_FALSE(watch.IsServed(1, begin + std::chrono::seconds(21)));
  EXPECT_TRUE(watch.IsServed(0, begin + std::chrono::seconds(22)));
}

}  // namespace
}  // namespace geodesic::server
