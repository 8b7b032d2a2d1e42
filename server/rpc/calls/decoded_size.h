// How much memory a message takes once it is decoded, told before it is.

#ifndef GEODESIC_SERVER_RPC_CALLS_DECODED_SIZE_H_
#define GEODESIC_SERVER_RPC_CALLS_DECODED_SIZE_H_

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/zero_copy_stream.h>

#include <cstdint>

namespace geodesic::server {

// An upper bound on what a message of this type takes when it is parsed from
// these bytes: two bytes can become 70. Nothing is allocated for what the
// bytes say. Of malformed bytes the part before the fault counts, which is what
// a parser may have set aside. O(bytes).
uint64_t DecodedSize(const google::protobuf::Descriptor& type,
                     google::protobuf::io::ZeroCopyInputStream& bytes);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_DECODED_SIZE_H_
