// What the contract promises of an answer, whatever was asked.

#ifndef GEODESIC_TESTS_FUZZ_RPC_ANSWER_CHECK_H_
#define GEODESIC_TESTS_FUZZ_RPC_ANSWER_CHECK_H_

#include <google/protobuf/message.h>
#include <grpcpp/support/status.h>

#include <cstdlib>

#include "geodesic/v1/field_service.pb.h"
#include "geodesic/v1/query.pb.h"

namespace geodesic::server::test {

// Aborts the program unless it holds: a fuzzer takes that for a crash.
inline void Require(bool holds) {
  if (!holds) std::abort();
}

// Aborts the program unless the status has a code that says nothing of faults
// of the server, a message, and a google.rpc.ErrorInfo.
// REQUIRES: it is not OK.
void CheckRefusal(const grpc::Status& status, bool was_cancelled);

// The messages of one streamed answer, in order. Aborts the program unless they
// begin with a header and, if the method has one, end with a trailer, and no
// distance is negative or not a number.
class AnswerCheck {
 public:
  void Take(const google::protobuf::Message& message);

  // After the last message.
  void End(const grpc::Status& status, bool was_cancelled) const;

 private:
  void CheckField(const v1::ComputeFieldResponse& message);

  bool has_begun_ = false;
  bool has_trailer_ = false;
  bool promises_trailer_ = true;
  v1::ValueType value_type_ = v1::VALUE_TYPE_UNSPECIFIED;
};

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_FUZZ_RPC_ANSWER_CHECK_H_
