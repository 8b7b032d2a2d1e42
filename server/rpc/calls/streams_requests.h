// Whether a method takes more than one message, so that it waits for their end.

#ifndef GEODESIC_SERVER_RPC_CALLS_STREAMS_REQUESTS_H_
#define GEODESIC_SERVER_RPC_CALLS_STREAMS_REQUESTS_H_

#include <string>

namespace geodesic::server {

// Of a path such as "/geodesic.v1.MeshService/CreateMesh"; false of what is no
// method. Thread-safe.
bool StreamsRequests(std::string path);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_STREAMS_REQUESTS_H_
