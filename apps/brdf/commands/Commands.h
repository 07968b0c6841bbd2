#pragma once
#include <functional>
#include <span>
#include <string>

namespace brdf::app {

class Arguments;
class Output;

/// One command of the program: what it is called, what it takes, what it does. Each is made in a file of its own.
struct Command {
  std::string name;
  std::string summary;                      ///< one line
  std::string examples;                     ///< lines that start with "  brdf ", run one after the other by a test
  std::function<void(Arguments&)> declare;  ///< declares the arguments
  std::function<void(const Output&)> run;   ///< throws brdf::Error when the request cannot be met
};

Command modelsCommand();
Command infoCommand();
Command evalCommand();
Command convertCommand();
Command exportCommand();
Command fitCommand();
Command batchCommand();
Command checkCommand();
Command compareCommand();
Command lobeCommand();
Command sliceCommand();
Command errorCommand();
Command renderCommand();
Command surfaceCommand();
Command simulateCommand();
Command baselineCommand();
Command wavesCommand();
Command pluginsCommand();

/// All commands in the order in which help shows them.
std::span<Command> allCommands();

}  // namespace brdf::app
