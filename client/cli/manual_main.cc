// Writes the man pages and completions of `geodesic` into a folder.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "client/cli/command_line.h"
#include "manual/completions.h"
#include "manual/man_page.h"

int main(int argc, char** argv) {
  using namespace geodesic::manual;
  if (argc != 2) return std::cerr << "usage: geodesic_manual FOLDER\n", 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  bool all_written = true;
  const auto write = [&](const std::string& name, const std::string& text) {
    all_written &= bool(std::ofstream(folder / name) << text << std::flush);
  };

  const Page program = geodesic::client::ProgramPage();
  const ManPageOptions options = {.section = 1, .version = GEODESIC_VERSION};
  write("geodesic.1", ManPage(program, options));
  for (const Page& command : program.commands) {
    write("geodesic-" + command.name + ".1",
          ManPage(program, command, options));
  }
  write("geodesic.bash", BashCompletion(program));
  write("_geodesic", ZshCompletion(program));
  write("geodesic.fish", FishCompletion(program));
  return all_written ? 0 : 1;
}
