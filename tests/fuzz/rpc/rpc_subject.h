// The services on an engine of their own, with neither network nor threads: the
// same script always takes the same course.

#ifndef GEODESIC_TESTS_FUZZ_RPC_RPC_SUBJECT_H_
#define GEODESIC_TESTS_FUZZ_RPC_RPC_SUBJECT_H_

#include "tests/fuzz/rpc/rpc_script.h"

namespace geodesic::server::test {

// Makes the calls of a script on a server with a few small meshes (closed,
// with saddles and a border, of genus 1, and one that is no surface), which
// the digests "A" to "D" stand for. Then aborts the program unless
//   - every call was answered once, and ended;
//   - a refusal has a code of the contract's and a reason, and no refusal says
//     that the server is at fault;
//   - an answer begins with its header, ends with its trailer, has no gap in an
//     array, and holds no distance that is negative or not a number;
//   - nothing is left: no job, no waiter, no reserved memory, no request.
void RunScript(const RpcScript& script);

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_FUZZ_RPC_RPC_SUBJECT_H_
