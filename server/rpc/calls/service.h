// A service of the protocol whose requests the server reads itself.
//
// gRPC's generated services receive and decode a whole request before anybody
// has checked its token, for as long as the client likes and in memory that
// nobody counts. They also answer a malformed one with UNIMPLEMENTED. So each
// method is served as a stream of bytes, which is the same on the wire: a call
// begins with its headers and reads its messages when it is ready.
//
//   auto service = std::make_unique<Service>("geodesic.v1.QuestionService");
//   service->Add<FieldStream>(context);

#ifndef GEODESIC_SERVER_RPC_CALLS_SERVICE_H_
#define GEODESIC_SERVER_RPC_CALLS_SERVICE_H_

#include <google/protobuf/descriptor.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/impl/codegen/server_callback_handlers.h>
#include <grpcpp/impl/rpc_service_method.h>
#include <grpcpp/impl/service_type.h>
#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>

#include <deque>
#include <memory>
#include <string>

#include "server/rpc/calls/call.h"

namespace geodesic::server {

// Starts one call, which keeps itself alive until gRPC is done with it.
template <typename Type>
Type* Launch(const ServiceContext& service,
             grpc::CallbackServerContext& context) {
  const auto call = std::make_shared<Type>(service, context);
  call->Launch(call);
  return call.get();
}

class Service final : public grpc::Service {
 public:
  // `name` is that in the protocol, e.g. "geodesic.v1.MeshService".
  explicit Service(const std::string& name)
      : type_(*google::protobuf::DescriptorPool::generated_pool()
                   ->FindServiceByName(name)) {}

  const std::string& name() const { return type_.full_name(); }

  // Serves the method that takes Type's kind of request. REQUIRES: the service
  // has one; `service` outlives it.
  template <typename Type>
  void Add(const ServiceContext& service) {
    using Response = typename Type::Response;
    using Handler =
        grpc::internal::CallbackBidiHandler<grpc::ByteBuffer, Response>;
    using Method = grpc::internal::RpcServiceMethod;
    AddMethod(new Method(PathOf(*Type::Request::descriptor()),
                         Method::BIDI_STREAMING, nullptr));
    MarkMethodRawCallback(
        static_cast<int>(paths_.size()) - 1,
        new Handler([&service](grpc::CallbackServerContext* context) {
          return Launch<Type>(service, *context);
        }));
  }

 private:
  // E.g. "/geodesic.v1.MeshService/GetMesh"; lives as long as the service.
  const char* PathOf(const google::protobuf::Descriptor& request) {
    int i = 0;
    while (type_.method(i)->input_type() != &request) ++i;
    paths_.push_back("/" + type_.full_name() + "/" + type_.method(i)->name());
    return paths_.back().c_str();
  }

  const google::protobuf::ServiceDescriptor& type_;
  std::deque<std::string> paths_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_SERVICE_H_
