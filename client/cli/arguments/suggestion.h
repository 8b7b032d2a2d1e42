// What somebody who mistyped a word may have meant.

#ifndef GEODESIC_CLIENT_CLI_ARGUMENTS_SUGGESTION_H_
#define GEODESIC_CLIENT_CLI_ARGUMENTS_SUGGESTION_H_

#include <string>
#include <string_view>
#include <vector>

namespace geodesic::client {

// The candidate nearest to `typed` by letters inserted, removed and replaced;
// empty if that takes more than one, and one more for three letters typed.
std::string Suggestion(std::string_view typed,
                       const std::vector<std::string>& candidates);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_ARGUMENTS_SUGGESTION_H_
