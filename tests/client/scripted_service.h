// A service that plays answers back from a script, and the answers to play.

#ifndef GEODESIC_TESTS_CLIENT_SCRIPTED_SERVICE_H_
#define GEODESIC_TESTS_CLIENT_SCRIPTED_SERVICE_H_

#include <gmock/gmock.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/v1/capabilities_service.grpc.pb.h"
#include "geodesic/v1/question_service.grpc.pb.h"
#include "geodesic_client/client.h"
#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace geodesic::client {

// What one call is answered with.
struct Stream {
  std::vector<v1::Answer> messages;
  grpc::Status status = grpc::Status::OK;
};

class ScriptedService final : public v1::QuestionService::Service {
 public:
  // What the next calls are answered with.
  void Play(std::deque<Stream> script) {
    const std::lock_guard lock(mutex_);
    script_ = std::move(script);
    resumptions_.clear();
  }

  // Of the calls since then.
  std::vector<v1::Resumption> Resumptions() {
    const std::lock_guard lock(mutex_);
    return resumptions_;
  }

  using Writer = grpc::ServerWriter<v1::Answer>;
  using Context = grpc::ServerContext;
  grpc::Status ComputeField(Context*, const v1::ComputeFieldRequest* request,
                            Writer* writer) override {
    return Play(*request, writer);
  }
  grpc::Status ComputePaths(Context*, const v1::ComputePathsRequest* request,
                            Writer* writer) override {
    return Play(*request, writer);
  }
  grpc::Status ComputePairs(Context*, const v1::ComputePairsRequest* request,
                            Writer* writer) override {
    return Play(*request, writer);
  }
  grpc::Status ComputeMatrix(Context*, const v1::ComputeMatrixRequest* request,
                             Writer* writer) override {
    return Play(*request, writer);
  }
  grpc::Status FindNearest(Context*, const v1::FindNearestRequest* request,
                           Writer* writer) override {
    return Play(*request, writer);
  }
  grpc::Status ComputeIsolines(Context*,
                               const v1::ComputeIsolinesRequest* request,
                               Writer* writer) override {
    return Play(*request, writer);
  }
  grpc::Status ComputeLogMap(Context*, const v1::ComputeLogMapRequest* request,
                             Writer* writer) override {
    return Play(*request, writer);
  }

 private:
  template <typename Request>
  grpc::Status Play(const Request& request, Writer* writer) {
    Stream stream = {{}, {grpc::StatusCode::INTERNAL, "no more script"}};
    {
      const std::lock_guard lock(mutex_);
      resumptions_.push_back(request.resumption());
      if (!script_.empty()) {
        stream = std::move(script_.front());
        script_.pop_front();
      }
    }
    for (const v1::Answer& message : stream.messages) writer->Write(message);
    return stream.status;
  }

  std::mutex mutex_;
  std::deque<Stream> script_;
  std::vector<v1::Resumption> resumptions_;
};

// That one call takes one pair.
class OnePairCapabilities final : public v1::CapabilitiesService::Service {
 public:
  grpc::Status GetCapabilities(grpc::ServerContext*,
                               const v1::GetCapabilitiesRequest*,
                               v1::GetCapabilitiesResponse* response) override {
    response->mutable_limits()->set_max_message_bytes(1 << 20);
    response->mutable_limits()->set_max_pairs(1);
    return grpc::Status::OK;
  }
};

template <typename Detail>
grpc::Status Rich(grpc::StatusCode code, const Detail& detail) {
  google::rpc::Status rich;
  rich.add_details()->PackFrom(detail);
  return {code, "scripted", rich.SerializeAsString()};
}

// A break after which the client need not wait.
inline grpc::Status Broken() {
  google::rpc::RetryInfo retry;
  retry.mutable_retry_delay()->set_nanos(1000);
  return Rich(grpc::StatusCode::UNAVAILABLE, retry);
}

inline grpc::Status NotKept() {
  google::rpc::ErrorInfo info;
  info.set_reason("ANSWER_NOT_KEPT");
  return Rich(grpc::StatusCode::NOT_FOUND, info);
}

// Builds the messages of an answer about a mesh of three vertices. Arrays are
// numbered as they are announced.
class Message {
 public:
  Message& Array(const std::string& name, v1::ValueType type,
                 const std::vector<int64_t>& shape) {
    v1::AnswerHeader& header = *answer_.mutable_header();
    header.set_vertex_count(3);
    header.set_mesh_digest("abc");
    header.set_algorithm(v1::ALGORITHM_FWP_MMP);
    header.set_server_version("1.2.3");
    v1::ArrayInfo& info = *header.add_arrays();
    info.set_name(name);
    info.set_type(type);
    info.mutable_shape()->Add(shape.begin(), shape.end());
    return *this;
  }
  Message& Doubles(const std::string& name, const std::vector<int64_t>& shape) {
    return Array(name, v1::VALUE_TYPE_FLOAT64, shape);
  }
  Message& Words(const std::string& name, const std::vector<int64_t>& shape) {
    return Array(name, v1::VALUE_TYPE_UINT32, shape);
  }
  Message& Longs(const std::string& name, const std::vector<int64_t>& shape) {
    return Array(name, v1::VALUE_TYPE_UINT64, shape);
  }
  Message& Bytes(const std::string& name, const std::vector<int64_t>& shape) {
    return Array(name, v1::VALUE_TYPE_UINT8, shape);
  }
  template <typename Number>
  Message& Put(uint32_t array, uint64_t first,
               const std::vector<Number>& numbers) {
    v1::Block& block = *answer_.add_blocks();
    block.set_array(array);
    block.set_first(first);
    block.set_values(numbers.data(), numbers.size() * sizeof(Number));
    answer_.set_answer_id("the answer");
    return *this;
  }
  Message& Unnamed() {
    answer_.clear_answer_id();
    return *this;
  }
  Message& Trailer() {
    v1::AnswerTrailer& trailer = *answer_.mutable_trailer();
    trailer.set_origin(v1::ANSWER_ORIGIN_CACHED);
    trailer.set_relative_tolerance(1e-10);
    trailer.set_compute_seconds(7);
    trailer.mutable_statistics()->set_iterations(5);
    trailer.set_settled_radius(2);
    return *this;
  }
  operator v1::Answer() const { return answer_; }

 private:
  v1::Answer answer_;
};

using D = std::vector<double>;
using W = std::vector<uint32_t>;
using L = std::vector<uint64_t>;
using B = std::vector<uint8_t>;

class AnswersTest : public ::testing::Test {
 protected:
  void SetUp() override {
    int port = 0;
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(),
                             &port);
    builder.RegisterService(&service_);
    builder.RegisterService(&capabilities_);
    server_ = builder.BuildAndStart();
    ASSERT_NE(server_, nullptr);
    client_ = std::make_unique<Client>(absl::StrCat("127.0.0.1:", port));
  }

  void Play(std::deque<Stream> script) { service_.Play(std::move(script)); }
  // A stream that ends well.
  void Play(const std::vector<v1::Answer>& messages) {
    Play(std::deque<Stream>{{messages}});
  }

  // How much of each array the calls say they have received.
  std::vector<std::vector<uint64_t>> Received() {
    std::vector<std::vector<uint64_t>> received;
    for (const v1::Resumption& resumption : service_.Resumptions()) {
      received.emplace_back(resumption.received().begin(),
                            resumption.received().end());
    }
    return received;
  }

  ScriptedService service_;
  OnePairCapabilities capabilities_;
  std::unique_ptr<grpc::Server> server_;
  std::unique_ptr<Client> client_;
};

inline void ExpectDataLoss(const absl::Status& status,
                           const std::string& words) {
  EXPECT_EQ(status.code(), absl::StatusCode::kDataLoss) << status;
  EXPECT_THAT(std::string(status.message()), ::testing::HasSubstr(words));
}

inline Message FieldHeader() { return Message().Doubles("distance", {3}); }

// Keeps what a matrix hands out.
struct Matrix {
  std::vector<uint64_t> shape;
  std::vector<std::pair<W, D>> rows;
  absl::Status status;  // returned by on_row

  MatrixReceiver Receiver() {
    return {
        .on_shape =
            [this](const MatrixShape& announced) {
              shape.insert(shape.end(), {announced.rows, announced.columns});
              return absl::OkStatus();
            },
        .on_row =
            [this](const MatrixRow& row) {
              EXPECT_EQ(row.row, rows.size());
              rows.emplace_back(W(row.columns.begin(), row.columns.end()),
                                D(row.values.begin(), row.values.end()));
              return status;
            }};
  }
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_CLIENT_SCRIPTED_SERVICE_H_
