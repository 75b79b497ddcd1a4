#include "table/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "units/input_error.hpp"
#include "units/printable.hpp"

namespace railbook::table {
namespace {

enum class Split { done, open_quote, after_quote };

// Splits a line into cells: what else it finds is a quote left open, or text after a closing quote.
Split split(std::string_view line, std::vector<std::string>& cells) {
  cells.clear();
  std::size_t i = 0;
  while (true) {
    std::string cell;
    if (i < line.size() && line[i] == '"') {
      for (++i;; ++i) {
        if (i >= line.size()) return Split::open_quote;
        if (line[i] != '"') {
          cell += line[i];
        } else if (i + 1 < line.size() && line[i + 1] == '"') {
          cell += line[i++];
        } else {
          break;
        }
      }
      ++i;
      if (i < line.size() && line[i] != ',') return Split::after_quote;
    } else {
      const std::size_t end = std::min(line.find(',', i), line.size());
      const std::string_view raw = line.substr(i, end - i);
      const std::size_t first = raw.find_first_not_of(" \t");
      if (first != std::string_view::npos)
        cell = raw.substr(first, raw.find_last_not_of(" \t") - first + 1);
      i = end;
    }
    cells.push_back(std::move(cell));
    if (i >= line.size()) return Split::done;
    ++i;
  }
}

// Whether a carriage return ends the line; it is taken off.
bool drop_return(std::string& line) {
  if (line.empty() || line.back() != '\r') return false;
  line.pop_back();
  return true;
}

std::string said(const std::filesystem::path& file) {
  return fmt::format("file \"{}\"", units::printable(file.string(), 300));
}

}  // namespace

CsvReader::CsvReader(const std::filesystem::path& file) : source_(file) {
  if (!record(header_)) {
    line_ = 1;
    refuse("empty; allowed: a header line and rows");
  }
  for (std::size_t i = 0; i < header_.size(); ++i) {
    if (header_[i].empty()) refuse(fmt::format("column {} has no name", i + 1));
    if (std::count(header_.begin(), header_.end(), header_[i]) > 1)
      refuse(fmt::format("column \"{}\" is named twice", units::printable(header_[i])));
  }
}

void CsvReader::refuse(const std::string& why) const {
  throw InputError{fmt::format("{}, line {}: {}", said(file()), line_, why)};
}

bool CsvReader::raw_line(std::string& text) {
  if (!source_.next(text)) return false;
  if (source_.line() == 1 && text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (text.find('\0') != std::string::npos) {
    line_ = source_.line();
    refuse("holds a zero byte: not a text file");
  }
  return true;
}

// The cells of the next line that is not skipped, and of those after it that a quoted cell goes on in.
bool CsvReader::record(std::vector<std::string>& cells) {
  do {
    if (!raw_line(text_)) return false;
  } while (text_.starts_with('#') || text_.find_first_not_of(" \t\r") == std::string::npos);
  line_ = source_.line();
  std::string more;
  for (int breaks = 0;; ++breaks) {
    const bool returned = drop_return(text_);
    const Split found = split(text_, cells);
    if (found == Split::done) return true;
    if (found == Split::after_quote) refuse("text after a closing quote; allowed: a comma");
    if (breaks == 100 || text_.size() > (1 << 20) || !raw_line(more))
      refuse("a quote is not closed");
    text_ += (returned ? "\r\n" : "\n") + more;
  }
}

std::size_t CsvReader::column(std::string_view name) const {
  for (std::size_t i = 0; i < header_.size(); ++i)
    if (header_[i] == name || units::parse_header(header_[i]).name == name) return i;
  std::string there;
  for (const auto& h : header_) there += (there.empty() ? "" : ", ") + h;
  throw InputError{fmt::format("{}: no column \"{}\"; there are: {}", said(file()),
                               units::printable(name), units::printable(there, 1000))};
}

bool CsvReader::next(std::vector<std::string>& cells) {
  if (!record(cells)) return false;
  if (cells.size() != header_.size())
    refuse(fmt::format("{} cells; allowed: {}, one a column", cells.size(), header_.size()));
  return true;
}

double CsvReader::number(const std::vector<std::string>& cells, std::size_t column) const {
  const std::string& cell = cells[column];
  if (cell.empty() || cell == "NaN" || cell == "nan" || cell == "NA")
    return std::numeric_limits<double>::quiet_NaN();
  const char* first = cell.data() + (cell[0] == '+' ? 1 : 0);
  double value = 0;
  const auto [end, status] = std::from_chars(first, cell.data() + cell.size(), value);
  if (status != std::errc{} || cell.starts_with("+-") || end != cell.data() + cell.size() ||
      !std::isfinite(value))
    refuse(fmt::format("column \"{}\" is \"{}\"; allowed: a finite number",
                       units::printable(header_[column]), units::printable(cell)));
  return value;
}

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
  std::vector<std::string> cells;
  while (reader.next(cells)) table.rows.push_back(cells);
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
    const units::Header header = units::parse_header(reader.header()[index.back()]);
    if (!(header.unit.dimension == w.dimension)) {
      throw InputError{fmt::format(
          "{}: column \"{}\" {}; allowed: a header that ends in a unit of {}, such as {}_{}",
          said(file), units::printable(reader.header()[index.back()]),
          header.unit_text.empty() ? "names no unit" : "has the unit " + header.unit_text,
          units::si_name(w.dimension), w.name, units::si_name(w.dimension))};
    }
    si.push_back(header.unit.si);
  }
  std::vector<std::vector<double>> columns(wanted.size());
  std::vector<std::string> cells;
  while (reader.next(cells)) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double value = reader.number(cells, index[i]);
      if (std::isnan(value) && !allow_nan) {
        throw InputError{
            fmt::format("{}, line {}: column \"{}\" is empty or NaN; allowed: a finite number",
                        said(file), reader.line(), units::printable(reader.header()[index[i]]))};
      }
      if (std::isinf(value * si[i])) {
        throw InputError{fmt::format("{}, line {}: column \"{}\" overflows in SI", said(file),
                                     reader.line(), units::printable(reader.header()[index[i]]))};
      }
      columns[i].push_back(value * si[i]);
    }
  }
  return columns;
}

std::string csv_number(double value) {
  if (std::isnan(value))
    return "nan";  // fmt compares NaNs, which the floating-point traps would stop
  return fmt::format("{:.12g}", value);
}

std::string csv_cell(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  const bool quote = text.find_first_of(",\"\r\n#") != std::string_view::npos ||
                     text.starts_with("\xEF\xBB\xBF") ||
                     (!text.empty() && (blank(text.front()) || blank(text.back())));
  if (!quote) return std::string{text};
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string{"\"\""} : std::string{c};
  return quoted + "\"";
}

}  // namespace railbook::table
