#include "client/cli/commands/command.h"

namespace geodesic::client {

std::vector<Command> AllCommands() {
  return {UploadCommand(),   MeshesCommand(), InfoCommand(),
          DeleteCommand(),   FieldCommand(),  PathCommand(),
          IsolinesCommand(), MatrixCommand(), NearestCommand(),
          SampleCommand(),   LogMapCommand(), CapabilitiesCommand()};
}

}  // namespace geodesic::client
