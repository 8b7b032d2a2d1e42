#include "call_metadata.h"

#include <random>

#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

using grpc::experimental::InterceptionHookPoints;

// 128 random bits; uniqueness is all that is asked of them.
std::string MakeRequestId() {
  thread_local std::mt19937_64 random{std::random_device{}()};
  const uint64_t high = random();
  const uint64_t low = random();
  return absl::StrCat(absl::Hex(high, absl::kZeroPad16),
                      absl::Hex(low, absl::kZeroPad16));
}

class CallMetadata final : public grpc::experimental::Interceptor {
 public:
  explicit CallMetadata(const std::string& authorization)
      : authorization_(authorization) {}

  void Intercept(
      grpc::experimental::InterceptorBatchMethods* methods) override {
    if (methods->QueryInterceptionHookPoint(
            InterceptionHookPoints::PRE_SEND_INITIAL_METADATA)) {
      auto* metadata = methods->GetSendInitialMetadata();
      metadata->emplace("x-request-id", MakeRequestId());
      if (!authorization_.empty()) {
        metadata->emplace("authorization", authorization_);
      }
    }
    methods->Proceed();
  }

 private:
  const std::string& authorization_;
};

// Belongs to the channel, which outlives its calls.
class CallMetadataFactory final
    : public grpc::experimental::ClientInterceptorFactoryInterface {
 public:
  explicit CallMetadataFactory(const std::string& token)
      : authorization_(token.empty() ? "" : absl::StrCat("Bearer ", token)) {}

  grpc::experimental::Interceptor* CreateClientInterceptor(
      grpc::experimental::ClientRpcInfo*) override {
    return new CallMetadata(authorization_);
  }

 private:
  const std::string authorization_;
};

}  // namespace

std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>
MakeCallMetadata(const std::string& token) {
  return std::make_unique<CallMetadataFactory>(token);
}

}  // namespace geodesic::client
