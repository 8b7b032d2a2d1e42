#include <gtest/gtest.h>

#include "server/security/tls_files.h"

namespace geodesic::server {
namespace {

TEST(ListenAddress, LoopbackIsThisMachineAlone) {
  for (const char* address :
       {"127.0.0.1:50051", "127.1.2.3:0", "[::1]:80", "[0:0:0:0:0:0:0:1]:80",
        "localhost:50051", "unix:/run/socket"}) {
    EXPECT_TRUE(IsLoopback(address)) << address;
  }
  for (const char* address :
       {"0.0.0.0:50051", "[::]:50051", "10.0.0.1:1", "128.0.0.1:1",
        "[::ffff:127.0.0.1]:1", "127.0.0.1.example:1", "localhost.example:1",
        "ipv4:127.0.0.1:1", "", ":1"}) {
    EXPECT_FALSE(IsLoopback(address)) << address;
  }
}

}  // namespace
}  // namespace geodesic::server
