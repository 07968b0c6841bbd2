// Names as mathematics.
#include <brdf/base/Text.h>
#include <brdf/formula/MathSymbols.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace brdf::formula {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

constexpr std::array kGreek = {Pair{"alpha", "α"},   Pair{"beta", "β"},  Pair{"gamma", "γ"},  Pair{"delta", "δ"},
                               Pair{"epsilon", "ε"}, Pair{"theta", "θ"}, Pair{"eta", "η"},    Pair{"kappa", "κ"},
                               Pair{"lambda", "λ"},  Pair{"mu", "μ"},    Pair{"nu", "ν"},     Pair{"pi", "π"},
                               Pair{"rho", "ρ"},     Pair{"sigma", "σ"}, Pair{"tau", "τ"},    Pair{"phi", "φ"},
                               Pair{"psi", "ψ"},     Pair{"omega", "ω"}, Pair{"Lambda", "Λ"}, Pair{"Gamma", "Γ"},
                               Pair{"Delta", "Δ"},   Pair{"Theta", "Θ"}, Pair{"Phi", "Φ"},    Pair{"Psi", "Ψ"}};

struct Variable {
  std::string_view name, latex, unicode;
};

/// Light u, viewer v, half vector h (H before normalisation), polar angles theta and azimuths phi of each.
constexpr std::array kVariables = {Variable{"pi", "\\pi", "π"},
                                   Variable{"_pi", "\\pi", "π"},
                                   Variable{"ux", "u_x", "u_x"},
                                   Variable{"uy", "u_y", "u_y"},
                                   Variable{"uz", "\\cos\\theta_i", "cos θ_i"},
                                   Variable{"cos_i", "\\cos\\theta_i", "cos θ_i"},
                                   Variable{"vx", "v_x", "v_x"},
                                   Variable{"vy", "v_y", "v_y"},
                                   Variable{"vz", "\\cos\\theta_o", "cos θ_o"},
                                   Variable{"cos_o", "\\cos\\theta_o", "cos θ_o"},
                                   Variable{"random1", "\\xi_1", "ξ_1"},
                                   Variable{"random2", "\\xi_2", "ξ_2"},
                                   Variable{"Hx", "H_x", "H_x"},
                                   Variable{"Hy", "H_y", "H_y"},
                                   Variable{"Hz", "H_z", "H_z"},
                                   Variable{"H2", "|H|^2", "|H|²"},
                                   Variable{"H", "|H|", "|H|"},
                                   Variable{"hx", "h_x", "h_x"},
                                   Variable{"hy", "h_y", "h_y"},
                                   Variable{"hz", "\\cos\\theta_h", "cos θ_h"},
                                   Variable{"cos_h", "\\cos\\theta_h", "cos θ_h"},
                                   Variable{"cos2_h", "\\cos^2\\theta_h", "cos² θ_h"},
                                   Variable{"tan2_h", "\\tan^2\\theta_h", "tan² θ_h"},
                                   Variable{"cos_d", "\\cos\\theta_d", "cos θ_d"},
                                   Variable{"sin2_d", "\\sin^2\\theta_d", "sin² θ_d"},
                                   Variable{"cos_io", "u\\cdot v", "u·v"},
                                   Variable{"cos_r", "\\cos\\theta_r", "cos θ_r"},
                                   Variable{"sin2_r2", "\\sin^2(\\theta_r/2)", "sin²(θ_r/2)"},
                                   Variable{"sin2_i", "\\sin^2\\theta_i", "sin² θ_i"},
                                   Variable{"sin2_o", "\\sin^2\\theta_o", "sin² θ_o"},
                                   Variable{"tan2_i", "\\tan^2\\theta_i", "tan² θ_i"},
                                   Variable{"tan2_o", "\\tan^2\\theta_o", "tan² θ_o"},
                                   Variable{"dot_xy", "(u_x v_x + u_y v_y)", "(u_x v_x + u_y v_y)"},
                                   Variable{"theta_i", "\\theta_i", "θ_i"},
                                   Variable{"phi_i", "\\phi_i", "φ_i"},
                                   Variable{"theta_o", "\\theta_o", "θ_o"},
                                   Variable{"phi_o", "\\phi_o", "φ_o"},
                                   Variable{"theta_h", "\\theta_h", "θ_h"},
                                   Variable{"phi_h", "\\phi_h", "φ_h"},
                                   Variable{"theta_d", "\\theta_d", "θ_d"}};

/// `text` between the tokens of an index: one word or number.
std::string word(std::string_view text, bool latex) {
  for (const auto& [name, letter] : kGreek)
    if (name == text) return latex ? "\\" + std::string(name) : std::string(letter);
  if (!latex || text.size() <= 1) return std::string(text);
  std::string escaped;
  for (const char c : text) escaped += c == '_' ? std::string("\\_") : std::string(1, c);
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); })
             ? escaped
             : "\\mathrm{" + escaped + "}";
}

}  // namespace

std::string variableSymbol(std::string_view name, MathStyle style) {
  for (const Variable& variable : kVariables)
    if (variable.name == name) return std::string(style == MathStyle::Latex ? variable.latex : variable.unicode);
  return {};
}

std::string mathSymbol(std::string_view name, MathStyle style) {
  const bool latex = style == MathStyle::Latex;
  std::string_view base = name, index;
  if (const std::size_t at = name.find('_'); at != std::string_view::npos && at > 0 && at + 1 < name.size()) {
    base = name.substr(0, at);
    index = name.substr(at + 1);
  } else if (at == std::string_view::npos) {
    std::size_t end = name.size();
    while (end > 1 && std::isdigit(static_cast<unsigned char>(name[end - 1]))) --end;
    base = name.substr(0, end);
    index = name.substr(end);
  }
  if (index.empty()) return word(base, latex);
  std::string indices;
  for (const std::string_view piece : split(index, ',')) indices += (indices.empty() ? "" : ",") + word(piece, latex);
  return word(base, latex) + (latex ? "_{" + indices + "}" : "_" + indices);
}

}  // namespace brdf::formula
