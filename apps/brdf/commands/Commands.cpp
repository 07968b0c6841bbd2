#include "Commands.h"

namespace brdf::app {

std::span<Command> allCommands() {
  static Command commands[] = {
      modelsCommand(), infoCommand(),    evalCommand(),     convertCommand(), exportCommand(),   fitCommand(),
      batchCommand(),  compareCommand(), checkCommand(),    lobeCommand(),    sliceCommand(),    errorCommand(),
      renderCommand(), surfaceCommand(), simulateCommand(), wavesCommand(),   baselineCommand(), pluginsCommand()};
  return commands;
}

}  // namespace brdf::app
