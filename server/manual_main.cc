// Writes the man page of geodesicd, and the configuration file of its package,
// into a folder.

#include <filesystem>
#include <fstream>
#include <iostream>

#include "manual/man_page.h"
#include "manual/settings_file.h"
#include "server/options/options.h"

int main(int argc, char** argv) {
  using namespace geodesic::manual;
  if (argc != 2) return std::cerr << "usage: geodesicd_manual FOLDER\n", 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);

  const Page program = geodesic::server::ProgramPage();
  const bool all_written =
      (std::ofstream(folder / "geodesicd.8")
       << ManPage(program, {.section = 8, .version = GEODESIC_VERSION})
       << std::flush) &&
      // The folder that deploy/geodesicd.service.in lets the server write to.
      (std::ofstream(folder / "geodesicd.toml")
       << SettingsFile(program, {{"data-dir", "/var/lib/geodesicd"}})
       << std::flush);
  return all_written ? 0 : 1;
}
