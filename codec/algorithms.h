// Algorithms, as geodesic/v1/query.proto numbers them.

#ifndef GEODESIC_CODEC_ALGORITHMS_H_
#define GEODESIC_CODEC_ALGORITHMS_H_

#include <optional>

#include "absl/status/statusor.h"
#include "geodesic/v1/query.pb.h"
#include "geodesic_types/algorithms.h"

namespace geodesic::codec {

v1::Algorithm ToProto(Algorithm algorithm);
v1::Algorithm ToProto(ApproximateMethod method);
v1::Algorithm ToProto(const AlgorithmChoice& choice);
// The parameter of the method.
v1::Approximation ToProto(const MethodChoice& choice);

// The algorithm of this number, a method with default parameters; nothing if
// there is none.
std::optional<AlgorithmChoice> FromProto(v1::Algorithm algorithm);

// The default algorithm, if none is named. Whether parameters are in range is
// not checked. Errors: INVALID_ARGUMENT with the path "algorithm" (it is not
// known) or "approximation.lambda" and the like (not this algorithm's).
absl::StatusOr<AlgorithmChoice> FromProto(
    v1::Algorithm algorithm, const v1::Approximation& approximation);

}  // namespace geodesic::codec

#endif  // GEODESIC_CODEC_ALGORITHMS_H_
