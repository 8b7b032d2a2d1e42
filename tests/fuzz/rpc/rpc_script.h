// What a hostile client sends, as the bytes of a fuzz input: calls one after
// the other, each a method and a message that may be anything.

#ifndef GEODESIC_TESTS_FUZZ_RPC_RPC_SCRIPT_H_
#define GEODESIC_TESTS_FUZZ_RPC_RPC_SCRIPT_H_

#include <google/protobuf/message.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace geodesic::server::test {

enum class RpcMethod : uint8_t {
  kGetCapabilities,
  kFindMissingMeshes,
  kCreateMesh,
  kGetMesh,
  kReadMesh,
  kListMeshes,
  kDeleteMesh,
  kComputeField,
  kComputeLogMap,
  kSampleFarthestPoints,
  kComputePaths,
  kComputeIsolines,
  kComputeMatrix,
  kFindNearest,
  kComputePairs,
};
inline constexpr size_t kRpcMethods = 15;

// A message of a call. Messages of CreateMesh that follow each other are one
// upload, up to one with `ends_upload`; the first says when its client goes,
// the last whether it overlaps.
struct RpcFrame {
  RpcMethod method = RpcMethod::kGetCapabilities;
  // The client goes at so manyth an event since the server was last idle, of
  // whatever call; 0: it stays.
  uint8_t cancel_after = 0;
  // The next call begins while this one is under way.
  bool overlaps = false;
  bool ends_upload = false;
  std::string message;
};

using RpcScript = std::vector<RpcFrame>;

// Every byte string is a script.
RpcScript ParseScript(std::string_view bytes);
std::string SerializeScript(const RpcScript& script);

// An empty request of the method.
std::unique_ptr<google::protobuf::Message> NewRequest(RpcMethod method);

// Well-formed calls of each method: where mutations begin. A digest of one
// letter stands for one of the meshes that are there: see rpc_subject.h. In
// place of the name of an answer that is resumed, "A" stands for the last one,
// "B" for that before.
const std::vector<RpcScript>& SeedScripts();

// Changes a script in one place or a few as a client could: fields of messages
// by what their types allow, and bytes without regard to that. An empty script
// becomes a seed.
void Mutate(RpcScript& script, std::mt19937_64& random);

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_FUZZ_RPC_RPC_SCRIPT_H_
