// rpc_fuzz: calls every RPC with requests that are mutated from well-formed
// ones, without libFuzzer and its compiler.
//
//   rpc_fuzz --inputs 100000 --seed 1
//
// Aborts at the first input after which something is wrong; --input N of the
// same seed shows that one and runs it alone. Exit codes: 0; 2 wrong usage.

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/stubs/logging.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <random>

#include "tests/fuzz/rpc/rpc_script.h"
#include "tests/fuzz/rpc/rpc_subject.h"

namespace geodesic::server::test {
namespace {

// The seed's input of this number: some calls, mutated a few times.
RpcScript Input(uint64_t seed, uint64_t number) {
  std::seed_seq words{static_cast<uint32_t>(seed),
                      static_cast<uint32_t>(number),
                      static_cast<uint32_t>(number >> 32)};
  std::mt19937_64 random(words);
  RpcScript script;
  for (size_t calls = 1 + random() % 3; calls > 0; --calls) {
    const RpcScript& call = SeedScripts()[random() % SeedScripts().size()];
    script.insert(script.end(), call.begin(), call.end());
  }
  for (size_t times = random() % 8; times > 0; --times) Mutate(script, random);
  return script;
}

void Run(uint64_t seed, uint64_t inputs) {
  for (uint64_t number = 0; number < inputs; ++number) {
    // Where to look for an input after which the program ended.
    if (number % 1000 == 0) std::cerr << "input " << number << std::endl;
    RunScript(Input(seed, number));
  }
}

void Show(const RpcScript& script) {
  for (const RpcFrame& frame : script) {
    const auto request = NewRequest(frame.method);
    const bool is_whole = request->ParsePartialFromString(frame.message);
    std::cout << request->GetDescriptor()->name()
              << (is_whole ? "" : " (malformed)")
              << " cancel_after=" << int{frame.cancel_after}
              << " overlaps=" << frame.overlaps << " {"
              << request->ShortDebugString() << "}" << std::endl;
  }
}

}  // namespace
}  // namespace geodesic::server::test

int main(int argc, char** argv) {
  CLI::App app("Calls every RPC with mutated requests.", "rpc_fuzz");
  uint64_t inputs = 10'000;
  uint64_t seed = 1;
  std::optional<uint64_t> input;
  app.add_option("--inputs", inputs, "How many")->capture_default_str();
  app.add_option("--seed", seed, "Of the mutations")->capture_default_str();
  app.add_option("--input", input, "Only the one of this number");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  namespace test = geodesic::server::test;
  // It would say of each string that is not UTF-8 that it is not.
  google::protobuf::SetLogHandler(nullptr);
  if (input.has_value()) {
    const test::RpcScript script = test::Input(seed, *input);
    test::Show(script);
    test::RunScript(script);
  } else {
    test::Run(seed, inputs);
  }
  return 0;
}
