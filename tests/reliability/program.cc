#include "tests/reliability/program.h"

#include <exception>
#include <iostream>

namespace geodesic::client {

int RunMain(CLI::App& app, int argc, char** argv,
            const std::function<std::vector<std::string>()>& run) {
  std::vector<std::string> faults;
  try {
    app.parse(argc, argv);
    faults = run();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    faults = {error.what()};
  }
  for (const std::string& fault : faults) {
    std::cerr << app.get_name() << ": " << fault << '\n';
  }
  return faults.empty() ? 0 : 1;
}

}  // namespace geodesic::client
