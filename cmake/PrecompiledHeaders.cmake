# geodesic_precompiled_headers(<name> HEADERS <header>... [LIBRARIES <target>...])
#
# Headers that many files include, read once instead of once a file. A target
# takes them by target_precompile_headers(<target> REUSE_FROM <name>) and must
# be compiled with the options of geodesic_options, as these are.
#
# Each file still includes what it uses: scripts/checks/clang-tidy reads them
# without.
function(geodesic_precompiled_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;LIBRARIES")
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cc)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Nothing but ${name}.\n")
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE geodesic_options ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

set(GEODESIC_STANDARD_HEADERS
  <algorithm> <array> <atomic> <chrono> <cmath> <condition_variable> <cstddef>
  <cstdint> <functional> <limits> <memory> <mutex> <optional> <span>
  <stop_token> <string> <string_view> <thread> <utility> <variant> <vector>
  <absl/status/status.h> <absl/status/statusor.h> <absl/strings/str_cat.h>)
geodesic_precompiled_headers(geodesic_standard_headers
  HEADERS ${GEODESIC_STANDARD_HEADERS}
  LIBRARIES absl::status absl::statusor absl::strings)
