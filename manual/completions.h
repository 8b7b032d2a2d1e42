// What shells offer when Tab is pressed: commands, options, the words that an
// option takes, and files.

#ifndef GEODESIC_MANUAL_COMPLETIONS_H_
#define GEODESIC_MANUAL_COMPLETIONS_H_

#include <string>

#include "manual/pages.h"

namespace geodesic::manual {

// A program with commands, whose own options may follow a command too.
// Each is a file for the shell's folder of completions.
std::string BashCompletion(const Page& program);
std::string ZshCompletion(const Page& program);
std::string FishCompletion(const Page& program);

}  // namespace geodesic::manual

#endif  // GEODESIC_MANUAL_COMPLETIONS_H_
