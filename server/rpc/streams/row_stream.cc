#include "server/rpc/streams/row_stream.h"

namespace geodesic::server {

absl::Status AddRest(const v1::ComputeMatrixRequest& request,
                     MatrixRequest& question) {
  switch (request.layout()) {
    case v1::MATRIX_LAYOUT_UNSPECIFIED:
    case v1::MATRIX_LAYOUT_DENSE:
      return absl::OkStatus();
    case v1::MATRIX_LAYOUT_SPARSE:
      question.sparse = true;
      return absl::OkStatus();
    default:
      return Unknown("layout", request.layout());
  }
}

absl::Status AddRest(const v1::FindNearestRequest& request,
                     MatrixRequest& question) {
  question.nearest = request.count();
  return absl::OkStatus();
}

}  // namespace geodesic::server
