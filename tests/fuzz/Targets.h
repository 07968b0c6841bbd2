#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// What is fuzzed: the reader of every registered format under the format's name, then what else reads files. A format
/// that joins the registry is a target without further ado.
struct FuzzTarget {
  std::string name;
  /// Reads the bytes. A brdf::Error is a right answer and is swallowed; anything else that escapes is a defect.
  std::function<void(std::string_view bytes)> run;
};

std::vector<FuzzTarget> fuzzTargets();
