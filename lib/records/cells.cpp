#include <railbook/records/detail/cells.hpp>

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

#include <railbook/table/dates.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::records {

Cells::Cells(const RecordFile& source, const table::CsvReader& reader) : reader_(reader) {
  for (const std::string& text : source.missing) {
    double number = 0;
    std::string point = text;
    std::replace(point.begin(), point.end(), ',', '.');
    const auto [end, status] = std::from_chars(point.data(), point.data() + point.size(), number);
    if (status == std::errc{} && end == point.data() + point.size())
      numbers_.push_back(number);
    else
      texts_.push_back(text);
  }
}

double Cells::number(std::size_t column) const {
  const std::string_view cell = reader_.cell(column);
  if (!texts_.empty() && std::find(texts_.begin(), texts_.end(), cell) != texts_.end()) return lost;
  try {
    return reader_.number(column);
  } catch (const InputError& error) {
    if (table::is_date_or_time(cell))
      throw InputError{error.what() + std::string{"; this is a date or a time"}};
    throw InputError{error.what() + std::string{" (--missing \""} + units::printable(cell, 40) +
                     "\" if it stands for a lost sample)"};
  }
}

Where::Where(const std::vector<std::string>& wanted, const table::CsvReader& reader)
    : reader_(reader) {
  for (const std::string& one : wanted) {
    const std::size_t at = one.find('=');
    if (at == std::string::npos || at == 0)
      throw InputError{"where is \"" + units::printable(one, 100) +
                       "\"; allowed: COLUMN=VALUE, as rail=left"};
    columns_.push_back(reader.column(one.substr(0, at)));
    values_.push_back(one.substr(at + 1));
  }
}

bool Where::fits() {
  bool fit = true;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::string cell{reader_.cell(columns_[i])};
    fit = fit && cell == values_[i];
    if (seen_.size() < 8 && std::find(seen_.begin(), seen_.end(), cell) == seen_.end())
      seen_.push_back(cell);
  }
  found_ = found_ || fit;
  return fit;
}

void Where::require_found() const {
  if (all() || found_) return;
  std::string there;
  for (const std::string& cell : seen_) there += (there.empty() ? "" : ", ") + cell;
  throw InputError{table::quoted_name(reader_.file()) +
                   ": no row is as --where asks; there are: " + units::printable(there, 300)};
}

}  // namespace railbook::records
