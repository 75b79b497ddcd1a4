#include "table/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <system_error>

#include "files/outside.hpp"
#include "units/input_error.hpp"

namespace railbook::table {
namespace {

// Splits a line into cells; false when a quote is left open or text follows a closing quote.
bool split(std::string_view line, std::vector<std::string>& cells) {
  cells.clear();
  std::size_t i = 0;
  while (true) {
    std::string cell;
    if (i < line.size() && line[i] == '"') {
      for (++i;; ++i) {
        if (i >= line.size()) return false;
        if (line[i] != '"') {
          cell += line[i];
        } else if (i + 1 < line.size() && line[i + 1] == '"') {
          cell += line[i++];
        } else {
          break;
        }
      }
      ++i;
      if (i < line.size() && line[i] != ',') return false;
    } else {
      const std::size_t end = std::min(line.find(',', i), line.size());
      const std::string_view raw = line.substr(i, end - i);
      const std::size_t first = raw.find_first_not_of(" \t");
      if (first != std::string_view::npos)
        cell = raw.substr(first, raw.find_last_not_of(" \t") - first + 1);
      i = end;
    }
    cells.push_back(std::move(cell));
    if (i >= line.size()) return true;
    ++i;
  }
}

}  // namespace

CsvReader::CsvReader(const std::filesystem::path& file) : file_(file), stream_(file) {
  if (!stream_ || std::filesystem::is_directory(file))
    throw InputError{fmt::format("file \"{}\": cannot be read", file.string())};
  if (!raw_line(text_)) refuse("empty; allowed: a header line and rows");
  if (text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
  if (!split(text_, header_)) refuse("a quote is not closed");
  for (std::size_t i = 0; i < header_.size(); ++i) {
    if (header_[i].empty()) refuse(fmt::format("column {} has no name", i + 1));
    if (std::count(header_.begin(), header_.end(), header_[i]) > 1)
      refuse(fmt::format("column \"{}\" is named twice", header_[i]));
  }
}

void CsvReader::refuse(const std::string& why) const {
  throw InputError{fmt::format("file \"{}\", line {}: {}", file_.string(), line_, why)};
}

bool CsvReader::raw_line(std::string& text) {
  errno = 0;
  while (std::getline(stream_, text)) {
    ++line_;
    if (!text.empty() && text.back() == '\r') text.pop_back();
    if (text.find('\0') != std::string::npos) refuse("holds a zero byte: not a text file");
    if (!text.empty() && text[0] != '#' && text.find_first_not_of(" \t") != std::string::npos)
      return true;
  }
  if (stream_.bad())
    throw files::OutsideError{fmt::format("file {}, after line {}: cannot be read further: {}",
                                          files::shown(file_), line_,
                                          std::generic_category().message(errno))};
  return false;
}

std::size_t CsvReader::column(std::string_view name) const {
  for (std::size_t i = 0; i < header_.size(); ++i)
    if (header_[i] == name || units::parse_header(header_[i]).name == name) return i;
  std::string there;
  for (const auto& h : header_) there += (there.empty() ? "" : ", ") + h;
  throw InputError{
      fmt::format("file \"{}\": no column \"{}\"; there are: {}", file_.string(), name, there)};
}

bool CsvReader::next(std::vector<std::string>& cells) {
  if (!raw_line(text_)) return false;
  if (!split(text_, cells)) refuse("a quote is not closed");
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
  if (status != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
    refuse(fmt::format("column \"{}\" is \"{}\"; allowed: a finite number", header_[column], cell));
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
          "file \"{}\": column \"{}\" {}; allowed: a header that ends in a unit of {}, such as "
          "{}_{}",
          file.string(), reader.header()[index.back()],
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
        throw InputError{fmt::format(
            "file \"{}\", line {}: column \"{}\" is empty or NaN; allowed: a finite number",
            file.string(), reader.line(), reader.header()[index[i]])};
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
  if (text.find_first_of(",\"\n#") == std::string_view::npos) return std::string{text};
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string{"\"\""} : std::string{c};
  return quoted + "\"";
}

}  // namespace railbook::table
