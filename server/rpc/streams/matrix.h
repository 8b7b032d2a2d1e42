// ComputeMatrix and FindNearest.

#ifndef GEODESIC_SERVER_RPC_STREAMS_MATRIX_H_
#define GEODESIC_SERVER_RPC_STREAMS_MATRIX_H_

#include <cstdint>
#include <type_traits>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "codec/answer_writer.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/query_engine.h"
#include "server/rpc/messages/translation.h"
#include "server/rpc/streams/row_question.h"

namespace geodesic::server {

template <typename Request>
class RowStream final : public RowQuestion<Request, MatrixCall> {
 public:
  using RowQuestion<Request, MatrixCall>::RowQuestion;

 private:
  using RowQuestion<Request, MatrixCall>::mutex_;
  static constexpr bool kIsNearest =
      std::is_same_v<Request, v1::FindNearestRequest>;

  absl::Status AskEngine() override {
    const Request& request = this->request();
    const Limits& limits = this->engine().limits();
    MatrixRequest question;
    this->BeginQuestion(question);
    if constexpr (kIsNearest) {
      question.filter.nearest = request.count();
    } else {
      question.filter.sparse = request.layout() == v1::MATRIX_LAYOUT_SPARSE;
      if (!v1::MatrixLayout_IsValid(request.layout())) {
        return Unknown("layout", request.layout());
      }
    }
    absl::Status status = AddRows(request.sources(), request.vertex_sources(),
                                  limits, question.query);
    if (status.ok()) {
      status = AddTargets(request.targets(), request.vertex_targets(), limits,
                          question.query);
    }
    if (!status.ok()) return status;
    if (request.has_radius()) question.filter.radius = request.radius();
    is_sparse_ = kIsNearest || question.filter.sparse;
    if (!is_sparse_ && request.resumption().received_size() > 0) {
      question.received_values = request.resumption().received(0);
    }
    absl::StatusOr<MatrixCall> call =
        this->engine().rows().ComputeMatrix(std::move(question), this->OnRow());
    if (!call.ok()) return call.status();
    MutexLock lock(mutex_);
    this->SetCall(*std::move(call));
    Announce();
    return absl::OkStatus();
  }

  void Announce() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    codec::AnswerWriter& writer = this->writer();
    const v1::ValueType type = this->value_type();
    const auto rows = static_cast<int64_t>(this->call().row_count);
    const auto columns = static_cast<int64_t>(this->call().column_count);
    if (is_sparse_) {
      row_end_ = writer.Announce("row_end", v1::VALUE_TYPE_UINT64, {rows});
      column_ = writer.Announce(kIsNearest ? "target" : "column",
                                v1::VALUE_TYPE_UINT32, {-1});
      distance_ = writer.Announce("distance", type, {-1});
    } else {
      distance_ = writer.Announce("distance", type, {rows, columns});
      rows_ = this->call().first_row;
      end_ = rows_ * this->call().column_count;
    }
  }

  bool HasMoreRows() const override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return rows_ < this->call().row_count;
  }
  uint64_t ItemsFinished() const override {
    return this->call().rows->rows_finished();
  }

  void Take(const AnswerRow& row) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    ++rows_;
    first_ = end_;
    end_ += row.values.size();
  }

  bool Put(const AnswerRow& row) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    codec::AnswerWriter& writer = this->writer();
    return (!is_sparse_ || (writer.PutOne(row_end_, rows_ - 1, end_) &&
                            writer.Put(column_, first_, row.columns))) &&
           writer.Put(distance_, first_, row.values);
  }

  // Set by AskEngine, then constant:
  bool is_sparse_ = false;
  uint32_t row_end_ = 0;
  uint32_t column_ = 0;
  uint32_t distance_ = 0;

  // That were taken, or left out.
  uint64_t rows_ ABSL_GUARDED_BY(mutex_) = 0;
  uint64_t first_ ABSL_GUARDED_BY(mutex_) = 0;  // value of the last of them
  uint64_t end_ ABSL_GUARDED_BY(mutex_) = 0;
};

using MatrixStream = RowStream<v1::ComputeMatrixRequest>;
using NearestStream = RowStream<v1::FindNearestRequest>;

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_MATRIX_H_
