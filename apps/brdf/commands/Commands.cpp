#include "Commands.h"

namespace brdf::app {

std::span<Command> allCommands() {
  static Command commands[] = {modelsCommand(), infoCommand(),  evalCommand(),    convertCommand(),
                               exportCommand(), fitCommand(),   compareCommand(), checkCommand(),
                               lobeCommand(),   errorCommand(), renderCommand()};
  return commands;
}

}  // namespace brdf::app
