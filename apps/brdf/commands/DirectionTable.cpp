#include "DirectionTable.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Parallel.h>
#include <brdf/base/Text.h>

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

namespace brdf::app {
namespace {

constexpr std::array<std::string_view, 6> kColumns = {"wi_x", "wi_y", "wi_z", "wo_x", "wo_y", "wo_z"};
constexpr std::size_t kBlock = 4096;         // rows evaluated at once
constexpr std::size_t kBatch = 64 * kBlock;  // rows whose text is held before it is written

[[noreturn]] void fail(const std::string& file, std::size_t line, const std::string& what, const std::string& found,
                       const std::string& allowed) {
  throw Error(Error::Kind::Format, {what, file + ", line " + std::to_string(line), found, allowed});
}

struct Row {
  std::string_view text;  // without its line end
  std::size_t line;       // counted from 1
};

/// The file's lines that are not blank.
std::vector<Row> rowsOf(std::string_view text) {
  std::vector<Row> rows;
  std::size_t line = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view row = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line;
    if (row.ends_with('\r')) row.remove_suffix(1);
    if (!trimmed(row).empty()) rows.push_back({row, line});
  }
  return rows;
}

/// For each column of the header, which component it is (0..5) or -1.
std::vector<int> readHeader(const std::string& file, const Row& header) {
  std::vector<int> meaning;
  std::array<bool, 6> seen{};
  for (const auto name : split(header.text, ',')) {
    int found = -1;
    for (std::size_t k = 0; k < kColumns.size(); ++k)
      if (name == kColumns[k]) found = static_cast<int>(k);
    if (found >= 0 && std::exchange(seen[static_cast<std::size_t>(found)], true))
      fail(file, header.line, "a column is there twice", std::string(name), "each column once");
    meaning.push_back(found);
  }
  for (std::size_t k = 0; k < kColumns.size(); ++k)
    if (!seen[k])
      fail(file, header.line, "no column " + std::string(kColumns[k]),
           "'" + std::string(header.text.substr(0, 80)) + "'", "a header with " + joined(kColumns, ","));
  return meaning;
}

void normalizeDirection(const std::string& file, const Row& row, double* w, const char* name) {
  const double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
  if (!(std::abs(square - 1) <= 2e-3))
    fail(file, row.line, std::string(name) + " is not a unit vector", "length " + formatNumber(std::sqrt(square), 6),
         "length 1 to within 0.001");
  if (std::abs(square - 1) <= 1e-14) return;
  for (int axis = 0; axis < 3; ++axis) w[axis] /= std::sqrt(square);
}

std::array<double, 6> readRow(const std::string& file, const Row& row, const std::vector<int>& meaning) {
  std::array<double, 6> numbers{};
  std::string_view rest = row.text;
  for (std::size_t column = 0; column < meaning.size(); ++column) {
    const std::size_t comma = rest.find(',');
    if ((comma == std::string_view::npos) != (column + 1 == meaning.size()))
      fail(file, row.line, "wrong number of columns", std::to_string(split(row.text, ',').size()),
           std::to_string(meaning.size()) + " as in the header");
    const std::string_view cell = rest.substr(0, comma);
    if (comma != std::string_view::npos) rest.remove_prefix(comma + 1);
    if (meaning[column] < 0) continue;
    const auto component = static_cast<std::size_t>(meaning[column]);
    const auto value = parseNumber(cell);
    if (!value || !std::isfinite(*value))
      fail(file, row.line, "not a finite number in column " + std::string(kColumns[component]),
           "'" + std::string(cell.substr(0, 40)) + "'", "a component of a unit vector");
    numbers[component] = *value;
  }
  normalizeDirection(file, row, numbers.data(), "wi");
  normalizeDirection(file, row, numbers.data() + 3, "wo");
  return numbers;
}

void append(std::string& text, double value) {
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 17).ptr;
  text += ',';
  text.append(buffer, end);
}

}  // namespace

TableResult evaluateTable(const std::string& in, const std::string& out, std::size_t channels, bool withDensity,
                          const BlockEvaluator& evaluate,
                          const std::function<bool(std::size_t, std::size_t)>& progress) {
  const std::string text = readFile(in);
  const auto rows = rowsOf(text);
  if (rows.empty()) fail(in, 1, "empty file", "", "a header with " + joined(kColumns, ","));
  const auto meaning = readHeader(in, rows[0]);

  AtomicFile file(out);
  std::ofstream stream(file.temporaryPath(), std::ios::binary);
  stream << rows[0].text;
  for (std::size_t c = 0; c < channels; ++c) stream << ",value_" << c;
  stream << (withDensity ? ",pdf\n" : "\n");

  const std::size_t count = rows.size() - 1;
  std::vector<std::size_t> invalid((count + kBlock - 1) / kBlock);
  std::vector<std::string> texts;
  for (std::size_t start = 0; start < count; start += kBatch) {
    if (!progress(start, count)) throw Error(Error::Kind::Value, {"interrupted; nothing written", out, "", ""});
    const std::size_t length = std::min(kBatch, count - start);
    texts.assign((length + kBlock - 1) / kBlock, {});
    parallelFor(length, kBlock, [&](std::size_t first, std::size_t last) {
      const std::size_t n = last - first;
      const Row* block = &rows[1 + start + first];
      DirectionPairBuffer<double> pairs(n);
      for (std::size_t i = 0; i < n; ++i) {
        const auto w = readRow(in, block[i], meaning);
        pairs.set(i, {w[0], w[1], w[2]}, {w[3], w[4], w[5]});
      }
      std::vector<double> values(channels * n), density(withDensity ? n : 0);
      std::vector<std::uint8_t> valid(n);
      evaluate(pairs.view(), values.data(), valid.data(), withDensity ? density.data() : nullptr);
      std::string& chunk = texts[first / kBlock];
      chunk.reserve(n * (block[0].text.size() + 26 * (channels + 1)));
      for (std::size_t i = 0; i < n; ++i) {
        chunk += block[i].text;
        for (std::size_t c = 0; c < channels; ++c) append(chunk, valid[i] ? values[c * n + i] : std::nan(""));
        if (withDensity) append(chunk, density[i]);
        chunk += '\n';
        invalid[(start + first) / kBlock] += valid[i] == 0;
      }
    });
    for (const std::string& chunk : texts) stream.write(chunk.data(), static_cast<std::streamsize>(chunk.size()));
  }
  stream.close();
  if (!stream) throw Error(Error::Kind::File, {"cannot be written", out, "", ""});
  file.commit();

  TableResult result;
  result.rows = count;
  for (const std::size_t n : invalid) result.invalid += n;
  return result;
}

}  // namespace brdf::app
