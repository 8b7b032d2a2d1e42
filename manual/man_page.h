// Man pages.

#ifndef GEODESIC_MANUAL_MAN_PAGE_H_
#define GEODESIC_MANUAL_MAN_PAGE_H_

#include <string>

#include "manual/pages.h"

namespace geodesic::manual {

struct ManPageOptions {
  // 1: commands, 8: servers.
  int section = 1;
  std::string version;
};

// The page of a program, in troff's language. Its commands have pages of their
// own, "program-command".
std::string ManPage(const Page& program, const ManPageOptions& options);

// The page of a command of `program`.
std::string ManPage(const Page& program, const Page& command,
                    const ManPageOptions& options);

}  // namespace geodesic::manual

#endif  // GEODESIC_MANUAL_MAN_PAGE_H_
