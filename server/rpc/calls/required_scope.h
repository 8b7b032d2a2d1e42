// The scope each RPC needs.

#ifndef GEODESIC_SERVER_RPC_CALLS_REQUIRED_SCOPE_H_
#define GEODESIC_SERVER_RPC_CALLS_REQUIRED_SCOPE_H_

#include <string_view>

#include "server/security/scope.h"

namespace geodesic::server {

// `method` without its service, e.g. "ComputeField". A method that was
// forgotten here needs the scope admin.
Scope RequiredScope(std::string_view method);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_REQUIRED_SCOPE_H_
