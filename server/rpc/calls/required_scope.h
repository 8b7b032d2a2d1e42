// What a caller needs for each RPC.

#ifndef GEODESIC_SERVER_RPC_CALLS_REQUIRED_SCOPE_H_
#define GEODESIC_SERVER_RPC_CALLS_REQUIRED_SCOPE_H_

#include <string_view>

#include "server/security/caller.h"

namespace geodesic::server {

// The scope that an RPC needs: `method` without its service, e.g.
// "ComputeField". A method that was forgotten here needs the scope admin.
Scope RequiredScope(std::string_view method);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_REQUIRED_SCOPE_H_
