#pragma once
#include <brdf/measured/ReadOptions.h>

#include <string>
#include <vector>

namespace brdf::app {

/// What --assume says of the measured files that this run of the program reads; every command loads its materials with
/// it.
const ReadOptions& assumptions();

/// Sets it, once, from the command line's KEY=VALUE items. Throws Error::Kind::Usage.
void setAssumptions(const std::vector<std::string>& items);

/// The items that were given, as they were given.
const std::vector<std::string>& assumptionItems();

/// The keys and their values, for help.
std::string assumptionsHelp();

}  // namespace brdf::app
