#include "tests/fuzz/rpc/answer_check.h"

#include <google/protobuf/descriptor.h>
#include <google/rpc/error_details.pb.h>
#include <google/rpc/status.pb.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace geodesic::server::test {
namespace {

using google::protobuf::Message;

void CheckDistances(const std::string& bytes) {
  std::vector<double> values(bytes.size() / sizeof(double));
  bytes.copy(reinterpret_cast<char*>(values.data()),
             values.size() * sizeof(double));
  for (const double value : values) Require(value >= 0);
}

}  // namespace

void CheckRefusal(const grpc::Status& status, bool was_cancelled) {
  switch (status.error_code()) {
    case grpc::StatusCode::INVALID_ARGUMENT:
    case grpc::StatusCode::NOT_FOUND:
    case grpc::StatusCode::RESOURCE_EXHAUSTED:
      break;
    case grpc::StatusCode::CANCELLED:
      Require(was_cancelled);
      break;
    default:
      std::abort();
  }
  Require(!status.error_message().empty());
  google::rpc::Status details;
  Require(details.ParseFromString(status.error_details()));
  Require(std::any_of(details.details().begin(), details.details().end(),
                      [](const auto& any) {
                        return any.template Is<google::rpc::ErrorInfo>();
                      }));
}

void AnswerCheck::Take(const Message& message) {
  const auto* type = message.GetDescriptor();
  const auto* part = message.GetReflection()->GetOneofFieldDescriptor(
      message, type->FindOneofByName("part"));
  Require(part != nullptr);
  const bool is_header = part->name() == "header";
  Require(is_header == !has_begun_ && !has_trailer_);
  has_begun_ = true;
  has_trailer_ = part->name() == "trailer";
  promises_trailer_ = type->name() != "ReadMeshResponse";
  if (type->name() == "ComputeFieldResponse") {
    CheckField(static_cast<const v1::ComputeFieldResponse&>(message));
  }
}

void AnswerCheck::End(const grpc::Status& status, bool was_cancelled) const {
  if (status.ok()) {
    Require(has_begun_ && has_trailer_ == promises_trailer_);
  } else {
    CheckRefusal(status, was_cancelled);
  }
}

void AnswerCheck::CheckField(const v1::ComputeFieldResponse& message) {
  if (message.has_header()) value_type_ = message.header().value_type();
  if (value_type_ != v1::VALUE_TYPE_FLOAT64) return;
  CheckDistances(message.chunk().distances());
  CheckDistances(message.targets().distances());
  CheckDistances(message.settled().distances());
}

}  // namespace geodesic::server::test
