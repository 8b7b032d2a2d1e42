// How the engine starts a computation: the seam where tests hold a solver up.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_START_FUNCTION_H_
#define GEODESIC_SERVER_ENGINE_JOBS_START_FUNCTION_H_

#include <functional>
#include <memory>

#include "absl/status/statusor.h"
#include "geodesic/computation.h"
#include "geodesic/mesh.h"
#include "geodesic/solve_options.h"
#include "geodesic/valid_query.h"

namespace geodesic::server {

using StartFunction =
    std::function<absl::StatusOr<std::unique_ptr<Computation>>(
        const Mesh&, const ValidQuery&, const SolveOptions&)>;

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_START_FUNCTION_H_
