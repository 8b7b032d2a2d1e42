// Which calls gRPC repeats by itself, and when.

#ifndef GEODESIC_CLIENT_SERVICE_CONFIG_H_
#define GEODESIC_CLIENT_SERVICE_CONFIG_H_

namespace geodesic::client {

// Questions and look-ups change nothing, so they are asked again while nothing
// of an answer has come: when the server is not there, or, at the time it names
// itself, when it is full. A mesh that was deleted by a call whose answer was
// lost would then be reported missing, so DeleteMesh is not among them; and
// what CreateMesh sends is too much to be kept for a repetition by gRPC, so
// upload.cc sees to that.
// docs/service-config.json is the same, for other clients.
inline constexpr char kServiceConfig[] = R"json({
  "methodConfig": [{
    "name": [
      {"service": "geodesic.v1.FieldService"},
      {"service": "geodesic.v1.PathService"},
      {"service": "geodesic.v1.MatrixService"},
      {"service": "geodesic.v1.CapabilitiesService"},
      {"service": "geodesic.v1.MeshService", "method": "FindMissingMeshes"},
      {"service": "geodesic.v1.MeshService", "method": "GetMesh"},
      {"service": "geodesic.v1.MeshService", "method": "ReadMesh"},
      {"service": "geodesic.v1.MeshService", "method": "ListMeshes"}
    ],
    "retryPolicy": {
      "maxAttempts": 4,
      "initialBackoff": "0.2s",
      "maxBackoff": "3s",
      "backoffMultiplier": 2,
      "retryableStatusCodes": ["UNAVAILABLE", "RESOURCE_EXHAUSTED"]
    }
  }],
  "retryThrottling": {"maxTokens": 20, "tokenRatio": 0.5}
})json";

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_SERVICE_CONFIG_H_
