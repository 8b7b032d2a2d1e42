// Calls services of which the tests have no stubs.

#ifndef GEODESIC_TESTS_RPC_GENERIC_CALL_H_
#define GEODESIC_TESTS_RPC_GENERIC_CALL_H_

#include <google/protobuf/descriptor.h>
#include <grpcpp/channel.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace geodesic::server::test {

// The payload under which errors carry their serialized google.rpc.Status.
inline constexpr char kDetails[] = "test/grpc-status-details-bin";

// What goes beside the messages of a call, by name.
using Metadata = std::multimap<std::string, std::string>;

// All methods of the contract.
std::vector<const google::protobuf::MethodDescriptor*> AllMethods();

// "/geodesic.v1.Service/Method".
std::string PathOf(const google::protobuf::MethodDescriptor& method);

// Sends one serialized message to `method` ("/package.Service/Method") and
// returns the first one that comes back.
absl::StatusOr<std::string> CallMethod(
    const std::shared_ptr<grpc::Channel>& channel, const std::string& method,
    const std::string& request, const Metadata& metadata = {});

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_RPC_GENERIC_CALL_H_
