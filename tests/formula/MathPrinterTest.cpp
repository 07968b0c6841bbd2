// Formulas as mathematics: what is printed means what was written.
#include <brdf/base/Error.h>
#include <brdf/formula/MathPrinter.h>
#include <gtest/gtest.h>

namespace brdf::formula {
namespace {

std::string printed(const std::string& text, MathStyle style) {
  std::string lines;
  for (const MathStatement& statement : printMath(text, style, {{"ior", "n"}, {"ax", "alpha_x"}}, "test"))
    lines +=
        (lines.empty() ? "" : "; ") + (statement.target.empty() ? "" : statement.target + " = ") + statement.expression;
  return lines;
}
std::string text(const std::string& formula) { return printed(formula, MathStyle::Unicode); }
std::string latex(const std::string& formula) { return printed(formula, MathStyle::Latex); }

TEST(MathSymbol, GivesGreekLettersAndIndices) {
  EXPECT_EQ(mathSymbol("alpha_x", MathStyle::Unicode), "α_x");
  EXPECT_EQ(mathSymbol("alpha_x", MathStyle::Latex), "\\alpha_{x}");
  EXPECT_EQ(mathSymbol("K_alpha,p", MathStyle::Latex), "K_{\\alpha,p}");
  EXPECT_EQ(mathSymbol("F0", MathStyle::Latex), "F_{0}");
  EXPECT_EQ(mathSymbol("sheen", MathStyle::Latex), "\\mathrm{sheen}");
  EXPECT_EQ(mathSymbol("D_GGX", MathStyle::Latex), "D_{\\mathrm{GGX}}");
  EXPECT_EQ(mathSymbol("pi_", MathStyle::Latex), "\\mathrm{pi\\_}");
}

TEST(MathPrinter, KeepsTheParenthesesThatMatter) {
  EXPECT_EQ(text("(a + b) * c"), "(a + b) c");
  EXPECT_EQ(text("a + (b + c)"), "a + b + c");
  EXPECT_EQ(text("a - (b - c)"), "a − (b − c)");
  EXPECT_EQ(text("a / (b * c)"), "a / (b c)");
  EXPECT_EQ(text("a / b * c"), "(a / b) c");
  EXPECT_EQ(text("a * -b"), "a (−b)");
  EXPECT_EQ(text("-(a + b)"), "−(a + b)");
  EXPECT_EQ(text("-a^2"), "−a²");
  EXPECT_EQ(text("(-a)^2"), "(−a)²");
  EXPECT_EQ(text("(a^2)^3"), "(a²)³");
  EXPECT_EQ(text("a^(b + 1)"), "a^(b + 1)");
  EXPECT_EQ(text("2 * 3"), "2 · 3");
  EXPECT_EQ(latex("(a + b) / (c * d)"), "\\frac{a + b}{c\\,d}");
  EXPECT_EQ(latex("-a / b"), "-\\frac{a}{b}");
  EXPECT_EQ(latex("(a / b)^2"), "\\left(\\frac{a}{b}\\right)^{2}");
  EXPECT_EQ(latex("2 * select(a > b, 1, 2)"),
            "2\\,\\left(\\begin{cases}1 & \\text{if } a > b \\\\ 2 & \\text{otherwise}\\end{cases}\\right)");
}

TEST(MathPrinter, WritesTheLanguagesWordsAsMathematicsDoes) {
  EXPECT_EQ(text("sqr(cos_d) * sqr(cos2_h)"), "cos² θ_d cos⁴ θ_h");
  EXPECT_EQ(text("tan2_h^3"), "(tan² θ_h)³");
  EXPECT_EQ(text("log1p(-a) + expm1(b)"), "ln(1 − a) + exp(b) − 1");
  EXPECT_EQ(text("c * expm1(b)"), "c (exp(b) − 1)");
  EXPECT_EQ(text("hypot(a, b) + abs(c) + sqrt(pi)"), "√(a² + b²) + |c| + √(π)");
  EXPECT_EQ(text("1e-14 + 2.5e8 * a"), "10⁻¹⁴ + 2.5·10⁸ a");
  EXPECT_EQ(text("sum(k, 1, 3, a * k)"), "Σ[k = 1 .. 3] a k");
  EXPECT_EQ(text("V_groove() * ior / ax"), "V_groove n / α_x");
  EXPECT_EQ(text("f(x) = x^2; y = f(3); y"), "f(x) = x²; y = f(3); y");
  EXPECT_EQ(text("a <= b && !c || 1 != 2 ? a : b"), "[a if a ≤ b and not c or 1 ≠ 2, else b]");
  EXPECT_EQ(latex("atan2(a, b)"), "\\mathrm{atan2}\\left(a,\\,b\\right)");
  EXPECT_EQ(latex("uz"), "\\cos\\theta_i");
  EXPECT_EQ(text("besselj1(a) + gammaq(a, b)"), "J₁(a) + Q(a, b)");
  EXPECT_EQ(latex("besselk0(a)"), "K_0\\left(a\\right)");
}

TEST(MathPrinter, ThrowsOnWhatDoesNotParse) { EXPECT_THROW(text("1 +"), Error); }

}  // namespace
}  // namespace brdf::formula
