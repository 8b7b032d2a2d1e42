#include "tests/fuzz/rpc/rpc_script.h"

#include <google/protobuf/text_format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "absl/strings/str_cat.h"
#include "geodesic/v1/capabilities_service.pb.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "geodesic/v1/question_service.pb.h"

namespace geodesic::server::test {
namespace {

// A frame: method, flags, length (two bytes, the lower first), message.
constexpr size_t kHeaderBytes = 4;
constexpr uint8_t kOverlaps = 0x80;
constexpr uint8_t kEndsUpload = 0x40;
constexpr uint8_t kCancelAfter = 0x3f;
constexpr size_t kMostBytes = 0xffff;

struct Seed {
  RpcMethod method;
  const char* text;
};

constexpr Seed kSeeds[] = {
    {RpcMethod::kGetCapabilities, ""},
    {RpcMethod::kFindMissingMeshes,
     R"(mesh_digests: "A" files { format: MESH_FORMAT_OFF sha256: "A" })"},
    {RpcMethod::kGetMesh, R"(digest: "A")"},
    {RpcMethod::kReadMesh, R"(digest: "B")"},
    {RpcMethod::kListMeshes, "page_size: 2"},
    {RpcMethod::kDeleteMesh, R"(digest: "C")"},
    {RpcMethod::kComputeField,
     R"(mesh_digest: "A" sources { vertex: 0 offset: 0.5 })"},
    {RpcMethod::kComputeField,
     R"(mesh_digest: "B" algorithm: ALGORITHM_MMP value_type: VALUE_TYPE_FLOAT32
        sources { edge { from: 0 to: 1 t: 0.25 } }
        targets { vertex: 3 } targets { face { face: 2 weights: 0.5
          weights: 0.25 weights: 0.25 } } stop_after_targets: 1)"},
    {RpcMethod::kComputeField,
     R"(mesh_digest: "C" radius: 1.5 progressive: true
        sources { face { face: 1 weights: 0.2 weights: 0.3 weights: 0.5 } })"},
    {RpcMethod::kComputeField,
     R"(mesh_digest: "D" quantities: FIELD_QUANTITY_NEAREST_SOURCE
        quantities: FIELD_QUANTITY_GRADIENT
        sources { curve { points { vertex: 0 } points { vertex: 1 } } })"},
    {RpcMethod::kComputeLogMap,
     R"(mesh_digest: "C" source { vertex: 5 } radius: 2)"},
    {RpcMethod::kSampleFarthestPoints,
     R"(mesh_digest: "B" sources { vertex: 1 } count: 3)"},
    {RpcMethod::kComputePaths,
     R"(mesh_digest: "C" sources { vertex: 0 } sources { vertex: 9 }
        targets { vertex: 7 } targets { edge { from: 1 to: 2 t: 0.5 } })"},
    {RpcMethod::kComputeIsolines,
     R"(mesh_digest: "C" sources { vertex: 2 } levels: 0.5 levels: 1)"},
    {RpcMethod::kComputeMatrix,
     R"(mesh_digest: "B" sources { vertex: 0 } sources { vertex: 1 }
        targets { vertex: 2 } layout: MATRIX_LAYOUT_SPARSE radius: 1)"},
    {RpcMethod::kFindNearest,
     R"(mesh_digest: "C" sources { vertex: 0 } targets { vertex: 1 }
        targets { vertex: 4 } count: 1)"},
    {RpcMethod::kComputePairs,
     R"(mesh_digest: "C" pairs { source { vertex: 0 } target { vertex: 4 } }
        pairs { source { edge { from: 1 to: 2 t: 0.5 } }
                target { face { face: 0 weights: [0.5, 0.5, 0] } } })"},
    {RpcMethod::kComputePairs,
     R"(mesh_digest: "B" vertex_pairs: [0, 1, 2, 3] value_type:
        VALUE_TYPE_FLOAT32)"},
};

constexpr const char* kUpload[] = {
    "header { format: MESH_FORMAT_OFF size_bytes: 38 }",
    R"(chunk { data: "OFF\n3 1 0\n0 0 0\n1 0 0\n" })",
    R"(chunk { offset: 22 data: "0 1 0\n3 0 1 2\n\n\n" })",
};

RpcFrame FrameOf(RpcMethod method, const char* text) {
  const auto request = NewRequest(method);
  if (!google::protobuf::TextFormat::ParseFromString(text, request.get())) {
    std::abort();
  }
  return {.method = method, .message = request->SerializeAsString()};
}

std::vector<RpcScript> MakeSeeds() {
  std::vector<RpcScript> seeds;
  for (const Seed& seed : kSeeds) {
    seeds.push_back({FrameOf(seed.method, seed.text)});
    if (seed.method < RpcMethod::kComputeField) continue;
    const std::string rest = absl::StrCat(
        seed.text, R"( resumption { answer_id: "A" received: 1 })");
    seeds.push_back({seeds.back()[0], FrameOf(seed.method, rest.c_str())});
  }
  RpcScript upload;
  for (const char* text : kUpload) {
    upload.push_back(FrameOf(RpcMethod::kCreateMesh, text));
  }
  seeds.push_back(upload);
  return seeds;
}

}  // namespace

RpcScript ParseScript(std::string_view bytes) {
  const auto byte = [&](size_t i) { return static_cast<uint8_t>(bytes[i]); };
  RpcScript script;
  while (bytes.size() >= kHeaderBytes) {
    const size_t length = byte(2) + size_t{256} * byte(3);
    script.push_back(
        {.method = static_cast<RpcMethod>(byte(0) % kRpcMethods),
         .cancel_after = static_cast<uint8_t>(byte(1) & kCancelAfter),
         .overlaps = (byte(1) & kOverlaps) != 0,
         .ends_upload = (byte(1) & kEndsUpload) != 0,
         .message = std::string(bytes.substr(kHeaderBytes, length))});
    bytes.remove_prefix(std::min(bytes.size(), kHeaderBytes + length));
  }
  return script;
}

std::string SerializeScript(const RpcScript& script) {
  std::string bytes;
  for (const RpcFrame& frame : script) {
    const size_t length = std::min(frame.message.size(), kMostBytes);
    const int flags = frame.cancel_after | (frame.overlaps ? kOverlaps : 0) |
                      (frame.ends_upload ? kEndsUpload : 0);
    bytes.push_back(static_cast<char>(frame.method));
    bytes.push_back(static_cast<char>(flags));
    bytes.push_back(static_cast<char>(length % 256));
    bytes.push_back(static_cast<char>(length / 256));
    bytes.append(frame.message, 0, length);
  }
  return bytes;
}

std::unique_ptr<google::protobuf::Message> NewRequest(RpcMethod method) {
  // In the order of RpcMethod.
  static const google::protobuf::Message* const kRequests[kRpcMethods] = {
      &v1::GetCapabilitiesRequest::default_instance(),
      &v1::FindMissingMeshesRequest::default_instance(),
      &v1::CreateMeshRequest::default_instance(),
      &v1::GetMeshRequest::default_instance(),
      &v1::ReadMeshRequest::default_instance(),
      &v1::ListMeshesRequest::default_instance(),
      &v1::DeleteMeshRequest::default_instance(),
      &v1::ComputeFieldRequest::default_instance(),
      &v1::ComputeLogMapRequest::default_instance(),
      &v1::SampleFarthestPointsRequest::default_instance(),
      &v1::ComputePathsRequest::default_instance(),
      &v1::ComputeIsolinesRequest::default_instance(),
      &v1::ComputeMatrixRequest::default_instance(),
      &v1::FindNearestRequest::default_instance(),
      &v1::ComputePairsRequest::default_instance()};
  return std::unique_ptr<google::protobuf::Message>(
      kRequests[static_cast<size_t>(method)]->New());
}

const std::vector<RpcScript>& SeedScripts() {
  static const auto& seeds = *new std::vector<RpcScript>(MakeSeeds());
  return seeds;
}

}  // namespace geodesic::server::test
