#pragma once
// Pieces of Markdown that the pages share. Internal to libbrdf/reference.
#include <brdf/models/Library.h>
#include <brdf/models/Model.h>
#include <brdf/reference/ModelPage.h>

#include <map>
#include <string>
#include <vector>

namespace brdf::markdown {

/// Text of ours as Markdown text: letters that mean something there are escaped.
std::string escaped(std::string_view text);
/// "| a | b |" and a line end; '|' in cells is escaped.
std::string row(const std::vector<std::string>& cells);
/// A table's header and its rule.
std::string header(const std::vector<std::string>& cells);
/// A citation with its DOI as a link.
std::string citation(const Reference& reference);
std::string parameterTable(const std::vector<Parameter>& parameters);
/// A formula as a block of LaTeX; `value` names what its last statement is.
std::string mathBlock(const std::string& formula, const std::string& value,
                      const std::map<std::string, std::string>& symbols, const std::string& where);
/// A fenced block of code, its lines' common indentation removed.
std::string codeBlock(std::string_view text, std::string_view language = "");

/// A number for people: eight digits, "1e-6" rather than "1e-06".
std::string number(double value);
/// What the arguments of the library's functions and samplers are called, for formula::printMath.
const std::map<std::string, std::string>& usualSymbols();
/// The same for parameters.
std::map<std::string, std::string> symbolsOf(const std::vector<Parameter>& parameters);
/// The library's function of that name.
const LibraryFunction& functionCalled(const std::string& name);
/// The left side of its definition, in LaTeX.
std::string functionHead(const LibraryFunction& entry);
/// What a link to the heading `name` ends with.
std::string anchor(std::string_view name);
/// A model's page with albedos measured before.
std::string page(const Model& model, const std::vector<MeasuredAlbedo>& albedos);
/// The lines of `text` without their common indentation.
std::vector<std::string> unindented(std::string_view text);

}  // namespace brdf::markdown
