#include "NistProblems.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace brdf {
namespace {

using Parameters = std::span<const double>;

double saturation(const double* t, Parameters b, double* d) {  // Misra1a, BoxBOD
  const double e = std::exp(-b[1] * t[0]);
  d[0] = 1 - e;
  d[1] = b[0] * t[0] * e;
  return b[0] * (1 - e);
}

double misra1b(const double* t, Parameters b, double* d) {
  const double u = 1 + b[1] * t[0] / 2;
  d[0] = 1 - 1 / (u * u);
  d[1] = b[0] * t[0] / (u * u * u);
  return b[0] * d[0];
}

double misra1c(const double* t, Parameters b, double* d) {
  const double u = 1 + 2 * b[1] * t[0];
  d[0] = 1 - 1 / std::sqrt(u);
  d[1] = b[0] * t[0] / (u * std::sqrt(u));
  return b[0] * d[0];
}

double misra1d(const double* t, Parameters b, double* d) {
  const double u = 1 + b[1] * t[0];
  d[0] = b[1] * t[0] / u;
  d[1] = b[0] * t[0] / (u * u);
  return b[0] * d[0];
}

double chwirut(const double* t, Parameters b, double* d) {
  const double q = 1 / (b[1] + b[2] * t[0]), value = std::exp(-b[0] * t[0]) * q;
  d[0] = -t[0] * value;
  d[1] = -value * q;
  d[2] = -t[0] * value * q;
  return value;
}

double exponentials(const double* t, Parameters b, double* d) {  // Lanczos
  double value = 0;
  for (std::size_t k = 0; k < 6; k += 2) {
    d[k] = std::exp(-b[k + 1] * t[0]);
    d[k + 1] = -b[k] * t[0] * d[k];
    value += b[k] * d[k];
  }
  return value;
}

double gauss(const double* t, Parameters b, double* d) {
  const double x = t[0];
  d[0] = std::exp(-b[1] * x);
  d[1] = -b[0] * x * d[0];
  double value = b[0] * d[0];
  for (std::size_t k = 2; k < 8; k += 3) {
    const double z = (x - b[k + 1]) / b[k + 2];
    d[k] = std::exp(-z * z);
    d[k + 1] = b[k] * d[k] * 2 * z / b[k + 2];
    d[k + 2] = b[k] * d[k] * 2 * z * z / b[k + 2];
    value += b[k] * d[k];
  }
  return value;
}

double power(const double* t, Parameters b, double* d) {  // DanWood
  d[0] = std::pow(t[0], b[1]);
  d[1] = b[0] * d[0] * std::log(t[0]);
  return b[0] * d[0];
}

/// (b0 + b1 x + ...) / (1 + b_top x + ...) with `top` coefficients above.
double ratio(std::size_t top, const double* t, Parameters b, double* d) {
  double above = 0, below = 1, x = 1;
  for (std::size_t k = 0; k < top; ++k, x *= t[0]) above += b[k] * x;
  x = t[0];
  for (std::size_t k = top; k < b.size(); ++k, x *= t[0]) below += b[k] * x;
  x = 1;
  for (std::size_t k = 0; k < top; ++k, x *= t[0]) d[k] = x / below;
  x = t[0];
  for (std::size_t k = top; k < b.size(); ++k, x *= t[0]) d[k] = -above * x / (below * below);
  return above / below;
}

double nelson(const double* t, Parameters b, double* d) {
  const double e = std::exp(-b[2] * t[1]);
  d[0] = 1;
  d[1] = -t[0] * e;
  d[2] = b[1] * t[0] * t[1] * e;
  return b[0] - b[1] * t[0] * e;
}

double mgh17(const double* t, Parameters b, double* d) {
  d[0] = 1;
  d[1] = std::exp(-t[0] * b[3]);
  d[2] = std::exp(-t[0] * b[4]);
  d[3] = -t[0] * b[1] * d[1];
  d[4] = -t[0] * b[2] * d[2];
  return b[0] + b[1] * d[1] + b[2] * d[2];
}

double roszman(const double* t, Parameters b, double* d) {
  const double s = t[0] - b[3], pi = std::numbers::pi;
  d[0] = 1;
  d[1] = -t[0];
  d[2] = -s / (s * s + b[2] * b[2]) / pi;
  d[3] = -b[2] / (s * s + b[2] * b[2]) / pi;
  return b[0] - b[1] * t[0] - std::atan(b[2] / s) / pi;
}

double enso(const double* t, Parameters b, double* d) {
  const double turn = 2 * std::numbers::pi * t[0];
  d[0] = 1;
  d[1] = std::cos(turn / 12);
  d[2] = std::sin(turn / 12);
  double value = b[0] + b[1] * d[1] + b[2] * d[2];
  for (std::size_t k = 3; k < 9; k += 3) {
    d[k + 1] = std::cos(turn / b[k]);
    d[k + 2] = std::sin(turn / b[k]);
    d[k] = (b[k + 1] * d[k + 2] - b[k + 2] * d[k + 1]) * turn / (b[k] * b[k]);
    value += b[k + 1] * d[k + 1] + b[k + 2] * d[k + 2];
  }
  return value;
}

double mgh09(const double* t, Parameters b, double* d) {
  const double x = t[0], top = x * x + x * b[1], bottom = x * x + x * b[2] + b[3];
  d[0] = top / bottom;
  d[1] = b[0] * x / bottom;
  d[2] = -b[0] * top * x / (bottom * bottom);
  d[3] = -b[0] * top / (bottom * bottom);
  return b[0] * top / bottom;
}

double rat42(const double* t, Parameters b, double* d) {
  const double e = std::exp(b[1] - b[2] * t[0]), q = 1 / (1 + e);
  d[0] = q;
  d[1] = -b[0] * q * q * e;
  d[2] = b[0] * q * q * e * t[0];
  return b[0] * q;
}

double rat43(const double* t, Parameters b, double* d) {
  const double e = std::exp(b[1] - b[2] * t[0]), u = 1 + e, value = b[0] * std::pow(u, -1 / b[3]);
  d[0] = value / b[0];
  d[1] = -value * e / (u * b[3]);
  d[2] = value * e * t[0] / (u * b[3]);
  d[3] = value * std::log(u) / (b[3] * b[3]);
  return value;
}

double mgh10(const double* t, Parameters b, double* d) {
  const double s = t[0] + b[2], e = std::exp(b[1] / s);
  d[0] = e;
  d[1] = b[0] * e / s;
  d[2] = -b[0] * e * b[1] / (s * s);
  return b[0] * e;
}

double eckerle(const double* t, Parameters b, double* d) {
  const double z = (t[0] - b[2]) / b[1], e = std::exp(-0.5 * z * z) / b[1];
  d[0] = e;
  d[1] = b[0] * e * (z * z - 1) / b[1];
  d[2] = b[0] * e * z / b[1];
  return b[0] * e;
}

double bennett(const double* t, Parameters b, double* d) {
  const double s = b[1] + t[0], p = std::pow(s, -1 / b[2]);
  d[0] = p;
  d[1] = -b[0] * p / (s * b[2]);
  d[2] = b[0] * p * std::log(s) / (b[2] * b[2]);
  return b[0] * p;
}

Curve::Function ratioWith(std::size_t top) {
  return [top](const double* t, Parameters b, double* d) { return ratio(top, t, b, d); };
}

/// In NIST's order of difficulty.
const std::vector<std::pair<std::string, Curve::Function>>& models() {
  static const std::vector<std::pair<std::string, Curve::Function>> list = {
      {"Misra1a", saturation},    {"Chwirut2", chwirut},      {"Chwirut1", chwirut}, {"Lanczos3", exponentials},
      {"Gauss1", gauss},          {"Gauss2", gauss},          {"DanWood", power},    {"Misra1b", misra1b},
      {"Kirby2", ratioWith(3)},   {"Hahn1", ratioWith(4)},    {"Nelson", nelson},    {"MGH17", mgh17},
      {"Lanczos1", exponentials}, {"Lanczos2", exponentials}, {"Gauss3", gauss},     {"Misra1c", misra1c},
      {"Misra1d", misra1d},       {"Roszman1", roszman},      {"ENSO", enso},        {"MGH09", mgh09},
      {"Thurber", ratioWith(4)},  {"BoxBOD", saturation},     {"Rat42", rat42},      {"MGH10", mgh10},
      {"Eckerle4", eckerle},      {"Rat43", rat43},           {"Bennett5", bennett},
  };
  return list;
}

std::vector<double> numbersIn(const std::string& line) {
  std::istringstream in(line);
  std::vector<double> numbers;
  for (std::string word; in >> word;) {
    std::size_t used = 0;
    double value = 0;
    try {
      value = std::stod(word, &used);
    } catch (const std::exception&) {
    }
    if (used != word.size()) return {};
    numbers.push_back(value);
  }
  return numbers;
}

NistProblem read(const std::filesystem::path& path, const std::string& name, const Curve::Function& function) {
  std::ifstream file(path);
  std::vector<std::vector<double>> starts(2);
  std::vector<double> certified, t, y;
  std::string difficulty;
  double residualSum = 0;
  bool inData = false;
  for (std::string line; std::getline(file, line);) {
    const std::size_t equals = line.find('='), level = line.find(" Level of Difficulty");
    if (level != std::string::npos)
      difficulty = line.substr(line.find_first_not_of(' '), level - line.find_first_not_of(' '));
    if (line.starts_with("Residual Sum of Squares:")) residualSum = std::stod(line.substr(line.find(':') + 1));
    const std::vector<double> row = numbersIn(inData                        ? line
                                              : equals == std::string::npos ? ""
                                                                            : line.substr(equals + 1));
    if (!inData && row.size() == 4) {  // "b1 = start 1, start 2, certified, standard deviation"
      starts[0].push_back(row[0]);
      starts[1].push_back(row[1]);
      certified.push_back(row[2]);
    }
    if (inData && row.size() >= 2) {
      y.push_back(name == "Nelson" ? std::log(row[0]) : row[0]);
      t.insert(t.end(), row.begin() + 1, row.end());
    }
    if (line.starts_with("Data:") && line.find('y') != std::string::npos && line.find("Response") == std::string::npos)
      inData = true;
  }
  if (certified.empty() || y.empty() || !(residualSum > 0) || difficulty.empty())
    throw std::runtime_error(path.string() + " is not a file of NIST's nonlinear regression data sets");
  const std::size_t parameters = certified.size();
  return {name,
          difficulty,
          Curve(std::move(t), std::move(y), parameters, function),
          std::move(starts),
          std::move(certified),
          residualSum};
}

}  // namespace

Curve::Curve(std::vector<double> t, std::vector<double> y, std::size_t parameters, Function function)
    : t_(std::move(t)),
      y_(std::move(y)),
      function_(std::move(function)),
      lower_(parameters, -std::numeric_limits<double>::infinity()),
      upper_(parameters, std::numeric_limits<double>::infinity()) {}

double Curve::residual(std::size_t point, std::span<const double> b, double* row) const {
  return function_(t_.data() + point * (t_.size() / y_.size()), b, row) - y_[point];
}

double Curve::squaredError(std::span<const double> b) { return normalEquations(b).squaredError; }

NormalEquations Curve::normalEquations(std::span<const double> b) {
  const std::size_t n = b.size();
  NormalEquations equations{0, std::vector<double>(n), std::vector<double>(n * n)};
  std::vector<double> row(n);
  for (std::size_t k = 0; k < y_.size(); ++k) {
    const double r = residual(k, b, row.data());
    equations.squaredError += r * r;
    for (std::size_t i = 0; i < n; ++i) {
      equations.gradient[i] += row[i] * r;
      for (std::size_t j = 0; j < n; ++j) equations.matrix[i * n + j] += row[i] * row[j];
    }
  }
  return equations;
}

void Curve::setBounds(std::vector<double> lower, std::vector<double> upper) {
  lower_ = std::move(lower);
  upper_ = std::move(upper);
}

std::vector<NistProblem> nistProblems(const std::filesystem::path& folder) {
  std::vector<NistProblem> problems;
  for (const auto& [name, function] : models()) problems.push_back(read(folder / (name + ".dat"), name, function));
  return problems;
}

NistProblem nistProblem(const std::filesystem::path& folder, const std::string& name) {
  for (const auto& [known, function] : models())
    if (known == name) return read(folder / (name + ".dat"), name, function);
  throw std::runtime_error("no problem " + name);
}

double correctDigits(std::span<const double> found, std::span<const double> certified) {
  double digits = 11;
  for (std::size_t i = 0; i < certified.size(); ++i) {
    const double error = std::abs(found[i] - certified[i]) / std::abs(certified[i]);
    digits = std::min(digits, error < 1 ? -std::log10(std::max(error, 1e-11)) : 0.0);
  }
  return digits;
}

}  // namespace brdf
