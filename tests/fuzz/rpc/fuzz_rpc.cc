// Every RPC with whatever a client may send survives it: see rpc_subject.h.

#include <google/protobuf/stubs/logging.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>

#include "tests/fuzz/rpc/rpc_script.h"
#include "tests/fuzz/rpc/rpc_subject.h"

namespace {

std::string_view View(const uint8_t* data, size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  // It would say of each string that is not UTF-8 that it is not.
  google::protobuf::SetLogHandler(nullptr);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace test = geodesic::server::test;
  test::RunScript(test::ParseScript(View(data, size)));
  return 0;
}

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size,
                                          size_t max_size, unsigned int seed) {
  namespace test = geodesic::server::test;
  std::mt19937_64 random(seed);
  test::RpcScript script = test::ParseScript(View(data, size));
  test::Mutate(script, random);
  std::string bytes = test::SerializeScript(script);
  // What is too long is cut: every byte string is a script.
  if (bytes.size() > max_size) bytes.resize(max_size);
  std::memcpy(data, bytes.data(), bytes.size());
  return bytes.size();
}
