// Tables read as a whole, and what is written into one.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::table {

const std::string& CsvTable::at(std::size_t row, std::string_view column) const {
  const auto it = std::find(header.begin(), header.end(), column);
  if (it == header.end() || row >= rows.size())
    throw std::logic_error{
        fmt::format("{}: no column \"{}\" or row {}", file.string(), column, row)};
  return rows[row][static_cast<std::size_t>(it - header.begin())];
}

const std::string& CsvTable::at(std::string_view key, std::string_view column) const {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i][0] == key) return at(i, column);
  throw std::logic_error{fmt::format("{}: no row \"{}\"", file.string(), key)};
}

CsvTable read_table(const std::filesystem::path& file) {
  CsvReader reader{file};
  CsvTable table{file, reader.header(), {}};
  while (reader.next()) {
    std::vector<std::string>& row = table.rows.emplace_back();
    for (std::size_t i = 0; i < reader.header().size(); ++i) row.emplace_back(reader.cell(i));
  }
  return table;
}

std::vector<std::vector<double>> read_columns(const std::filesystem::path& file,
                                              const std::vector<ColumnWanted>& wanted,
                                              bool allow_nan) {
  CsvReader reader{file};
  std::vector<std::size_t> index;
  std::vector<double> si;
  for (const ColumnWanted& w : wanted) {
    index.push_back(reader.column(w.name));
    const units::Header header = parse_column(reader.header()[index.back()]);
    if (!(header.unit.dimension == w.dimension)) {
      throw InputError{fmt::format(
          "{}: column \"{}\" {}; allowed: a header that ends in a unit of {}, such as {}_{}",
          quoted_name(file), units::printable(reader.header()[index.back()]),
          header.unit_text.empty() ? "names no unit" : "has the unit " + header.unit_text,
          units::si_name(w.dimension), w.name, units::si_name(w.dimension))};
    }
    si.push_back(header.unit.si);
  }
  std::vector<std::vector<double>> columns(wanted.size());
  while (reader.next()) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double value = reader.number(index[i]);
      if (std::isnan(value) && !allow_nan) {
        throw InputError{fmt::format(
            "{}, line {}: column \"{}\" is empty or NaN; allowed: a finite number",
            quoted_name(file), reader.line(), units::printable(reader.header()[index[i]]))};
      }
      if (std::isinf(value * si[i])) {
        throw InputError{fmt::format("{}, line {}: column \"{}\" overflows in SI",
                                     quoted_name(file), reader.line(),
                                     units::printable(reader.header()[index[i]]))};
      }
      columns[i].push_back(value * si[i]);
    }
  }
  return columns;
}

void append_number(std::string& text, double value, int digits) {
  if (std::isnan(value)) {
    text += "nan";  // never "-nan"
    return;
  }
  std::array<char, 64> cell;
  const auto end = std::to_chars(cell.data(), cell.data() + cell.size(), value,
                                 std::chars_format::general, digits);
  text.append(cell.data(), end.ptr);
}

std::string csv_number(double value, int digits) {
  std::string text;
  append_number(text, value, digits);
  return text;
}

std::string csv_cell(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  const bool quote = text.find_first_of(",;|\t\"\r\n#") != std::string_view::npos ||
                     text.starts_with("\xEF\xBB\xBF") ||
                     (!text.empty() && (blank(text.front()) || blank(text.back())));
  if (!quote) return std::string{text};
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string{"\"\""} : std::string{c};
  return quoted + "\"";
}

}  // namespace railbook::table
