// A configuration file with every setting explained.

#ifndef GEODESIC_MANUAL_SETTINGS_FILE_H_
#define GEODESIC_MANUAL_SETTINGS_FILE_H_

#include <map>
#include <string>

#include "manual/pages.h"

namespace geodesic::manual {

// TOML with a line for each setting. They are comments that show the defaults,
// but for those of `values`, which are set. Keys are names of options without
// dashes.
std::string SettingsFile(const Page& program,
                         const std::map<std::string, std::string>& values);

}  // namespace geodesic::manual

#endif  // GEODESIC_MANUAL_SETTINGS_FILE_H_
