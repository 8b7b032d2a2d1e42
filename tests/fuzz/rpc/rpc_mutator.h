// Changes scripts as a client could: fields of messages by what their types
// allow, and bytes without regard to that.

#ifndef GEODESIC_TESTS_FUZZ_RPC_RPC_MUTATOR_H_
#define GEODESIC_TESTS_FUZZ_RPC_RPC_MUTATOR_H_

#include <random>

#include "tests/fuzz/rpc/rpc_script.h"

namespace geodesic::server::test {

// Changes it in one place or a few. An empty script becomes a seed.
void Mutate(RpcScript& script, std::mt19937_64& random);

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_FUZZ_RPC_RPC_MUTATOR_H_
