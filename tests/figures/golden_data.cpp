#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include <railbook/table/csv.hpp>

#include "golden.hpp"

namespace railbook::figures {
namespace {

namespace fs = std::filesystem;

constexpr double visible = 1e-3;

struct Tolerance {
  double relative = figures::relative;
  double absolute = -1;  // negative: of_largest of the column's largest
};

struct Notes {
  std::map<std::string, Tolerance> columns;
  bool compared = true;
  std::size_t every = 1, rows = 0;  // of a thinned file: what was kept, and of how many rows
};

// The lines of a file that begin with #.
Notes read_notes(const fs::path& file) {
  Notes notes;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with('#')) continue;
    Tolerance t;
    int column = 0;
    if (std::sscanf(line.c_str(), "# holds to relative %lf, absolute %lf in %n", &t.relative,
                    &t.absolute, &column) == 2 &&
        column > 0) {
      const auto begin = static_cast<std::size_t>(column);
      notes.columns[line.substr(begin, line.find(": ", begin) - begin)] = t;
    } else if (line.starts_with("# not compared: ")) {
      notes.compared = false;
    } else {
      std::sscanf(line.c_str(), "# every %zu of %zu rows", &notes.every, &notes.rows);
    }
  }
  return notes;
}

bool is_number(const std::string& text, double& value) {
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0';
}

// Whether two cells say the same; `largest` is the column's.
bool same(const std::string& a, const std::string& b, const Tolerance& t, double largest) {
  double x = 0, y = 0;
  if (a == b || std::isinf(t.absolute)) return true;
  if (!is_number(a, x) || !is_number(b, y)) return false;
  if (std::isnan(x) && std::isnan(y)) return true;
  if (!std::isfinite(x) || !std::isfinite(y)) return x == y;
  const double allowed = t.relative * std::max(std::abs(x), std::abs(y));
  return std::abs(x - y) <= std::max(allowed, t.absolute < 0 ? of_largest * largest : t.absolute);
}

std::vector<double> largest_of_columns(const table::CsvTable& table) {
  std::vector<double> largest(table.header.size(), 0.0);
  for (const auto& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      double value = 0;
      if (is_number(row[c], value) && std::isfinite(value))
        largest[c] = std::max(largest[c], std::abs(value));
    }
  }
  return largest;
}

}  // namespace

bool is_compared(const fs::path& data) {
  return read_notes(data).compared;
}

bool fixes_the_picture(const fs::path& data) {
  const table::CsvTable table = table::read_table(data);
  const std::vector<double> largest = largest_of_columns(table);
  for (const auto& [column, t] : read_notes(data).columns) {
    const auto at =
        std::find(table.header.begin(), table.header.end(), column) - table.header.begin();
    const double size =
        column == "*" || at == std::ssize(table.header) ? 0 : largest[static_cast<std::size_t>(at)];
    if (t.relative > visible || t.absolute > visible * size) return false;
  }
  return true;
}

std::string data_fault(const fs::path& drawn, const fs::path& golden) {
  const table::CsvTable have = table::read_table(drawn);
  const table::CsvTable want = table::read_table(golden);
  Notes notes = read_notes(drawn);
  const Notes kept = read_notes(golden);
  for (const auto& [column, t] : notes.columns) {
    if (column != "*" &&
        std::find(have.header.begin(), have.header.end(), column) == have.header.end())
      return fmt::format("an accuracy is stated of \"{}\", which is no column", column);
  }
  if (have.header != want.header) return "the columns are others than those of the golden";
  const std::size_t rows = kept.every > 1 ? kept.rows : want.rows.size();
  if (have.rows.size() != rows)
    return fmt::format("{} rows, the golden has {}", have.rows.size(), rows);
  const std::vector<double> largest = largest_of_columns(want);
  std::size_t off = 0;
  std::string first;
  for (std::size_t r = 0; r < want.rows.size(); ++r) {
    for (std::size_t c = 0; c < want.header.size(); ++c) {
      const auto stated = notes.columns.find(want.header[c]);
      const Tolerance t = stated != notes.columns.end() ? stated->second : notes.columns["*"];
      const std::string& is = have.rows[r * kept.every][c];
      if (same(is, want.rows[r][c], t, largest[c])) continue;
      ++off;
      if (first.empty())
        first = fmt::format("row {}, {}: {}, the golden has {}", r * kept.every + 1, want.header[c],
                            is, want.rows[r][c]);
    }
  }
  return off == 0 ? "" : fmt::format("{} ({} cells off)", first, off);
}

std::string golden_text(const fs::path& drawn) {
  const table::CsvTable table = table::read_table(drawn);
  const auto size = static_cast<std::size_t>(fs::file_size(drawn));
  const std::size_t every = (size + kept_bytes - 1) / kept_bytes;
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      double value = 0;
      const bool number = is_number(cells[c], value) && std::isfinite(value);
      text +=
          (c == 0 ? "" : ",") + (number ? fmt::format("{:.8g}", value) : table::csv_cell(cells[c]));
    }
    return text + "\n";
  };
  std::string text = line(table.header);
  for (std::size_t r = 0; r < table.rows.size(); r += std::max<std::size_t>(every, 1))
    text += line(table.rows[r]);
  std::ifstream in(drawn);
  for (std::string note; std::getline(in, note);)
    if (note.starts_with('#')) text += note + "\n";
  if (every > 1) text += fmt::format("# every {} of {} rows\n", every, table.rows.size());
  return text;
}

}  // namespace railbook::figures
