#include <railbook/containers/container.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <string_view>
#include <utility>

#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::containers {
namespace {

// Arrays of one length.
using Table = std::vector<const DataSet*>;

std::string plural(std::size_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    std::string name = list.substr(at, end - at);
    while (name.starts_with('/') || name.starts_with(' ')) name.erase(0, 1);
    while (name.ends_with('/') || name.ends_with(' ')) name.pop_back();
    names.push_back(name);
    at = end + 1;
  }
  return names;
}

// The tables of a group, one for each length of its arrays; of all groups where none is named.
std::vector<Table> tables_of(const Contents& contents, const std::string* group) {
  std::map<std::pair<std::string, std::size_t>, Table> tables;
  for (const DataSet& set : contents.sets)
    if (group == nullptr || set.group == *group) tables[{set.group, set.rows}].push_back(&set);
  std::vector<Table> result;
  result.reserve(tables.size());
  for (auto& [key, table] : tables) result.push_back(std::move(table));
  return result;
}

// How --dataset names it: by its group where that has no other.
std::string name_of(const Table& table, const Contents& contents) {
  const std::string& group = table.front()->group;
  if (!group.empty() && tables_of(contents, &group).size() == 1) return group;
  std::string name;
  for (const DataSet* set : table) name += (name.empty() ? "" : ",") + set->path();
  return name;
}

[[noreturn]] void refuse(const std::vector<Table>& tables, const Contents& contents,
                         const std::string& why) {
  std::string there;
  for (const Table& table : tables) {
    std::size_t columns = 0;
    for (const DataSet* set : table) columns += set->columns.size();
    there += (there.empty() ? "" : "; ") + units::printable(name_of(table, contents), 200) + " (" +
             plural(columns, "column") + " of " + std::to_string(table.front()->rows) + ")";
    if (there.size() > 900) {
      there += "; ...";
      break;
    }
  }
  std::string unread;
  for (const std::string& name : contents.unread)
    if (unread.size() < 400) unread += (unread.empty() ? "" : ", ") + units::printable(name, 200);
  throw InputError{why + (there.empty() ? "" : "; there are: " + there) +
                   (unread.empty() ? "" : "; not read: " + unread)};
}

Table chosen(const Contents& contents, const std::string& wanted) {
  if (wanted.empty()) {
    const std::vector<Table> all = tables_of(contents, nullptr);
    if (all.empty()) refuse(all, contents, "it holds no array of numbers with two rows");
    if (all.size() > 1)
      refuse(all, contents, "it holds several tables; allowed: one of them, by --dataset");
    return all.front();
  }
  Table table;
  for (const std::string& name : names_in(wanted)) {
    const auto set = std::find_if(contents.sets.begin(), contents.sets.end(), [&](const auto& s) {
      std::string dotted = s.path();  // as MATLAB writes it
      std::replace(dotted.begin(), dotted.end(), '/', '.');
      return s.path() == name || dotted == name;
    });
    if (set != contents.sets.end()) {
      table.push_back(&*set);
      continue;
    }
    const std::vector<Table> of_group = tables_of(contents, &name);
    if (of_group.size() > 1)
      refuse(of_group, contents,
             "the arrays of \"" + units::printable(name) +
                 "\" have several lengths; allowed: those of one, by --dataset A,B");
    if (of_group.empty())
      refuse(tables_of(contents, nullptr), contents,
             "it holds no data set \"" + units::printable(name) + "\"");
    table.insert(table.end(), of_group.front().begin(), of_group.front().end());
  }
  for (const DataSet* set : table)
    if (set->rows != table.front()->rows)
      throw InputError{"the data sets \"" + units::printable(table.front()->path()) + "\" and \"" +
                       units::printable(set->path()) + "\" have " +
                       std::to_string(table.front()->rows) + " and " + std::to_string(set->rows) +
                       " rows; allowed: as many"};
  return table;
}

// With its unit, if that is one: "left [mm]".
std::string header_of_column(const Column& column) {
  const std::string with_unit = column.name + " [" + column.unit + "]";
  const bool is_unit = !column.unit.empty() && table::parse_column(column.name).unit_text.empty() &&
                       !table::parse_column(with_unit).unit_text.empty();
  return is_unit ? with_unit : column.name;
}

// One line of headers, which must not look like numbers.
std::string headers(const Table& table) {
  std::vector<std::string> names;
  for (const DataSet* set : table)
    for (const Column& column : set->columns) {
      // Of channels that are groups, "left/data" and "right/data", the group says which.
      const bool twice = std::any_of(table.begin(), table.end(), [&](const DataSet* other) {
        return other != set && std::any_of(other->columns.begin(), other->columns.end(),
                                           [&](const Column& c) { return c.name == column.name; });
      });
      const std::string group = set->group.substr(set->group.rfind('/') + 1);
      names.push_back(header_of_column(
          twice && !group.empty() ? Column{group + "/" + column.name, column.unit} : column));
    }
  const bool all_numbers = std::all_of(names.begin(), names.end(), [](const std::string& name) {
    return name.find_first_not_of("0123456789.+-eE") == std::string::npos;
  });
  std::string line;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::replace_if(
        names[i].begin(), names[i].end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    line += (i > 0 ? "," : "") + table::csv_cell((all_numbers ? "column " : "") + names[i]);
  }
  return line + "\n";
}

template <class Number>
void append_shortest(std::string& text, Number value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), end.ptr);
}

void append_cell(std::string& text, double value) {
  if (std::isnan(value)) text += "nan";  // never "-nan"
  if (!std::isnan(value)) append_shortest(text, value);
}
void append_cell(std::string& text, float value) {
  if (std::isnan(value)) text += "nan";
  if (!std::isnan(value)) append_shortest(text, value);
}
void append_cell(std::string& text, std::int64_t value) {
  append_shortest(text, value);
}
void append_cell(std::string& text, std::uint64_t value) {
  append_shortest(text, value);
}
void append_cell(std::string& text, const std::string& value) {
  std::string line = value.substr(0, std::min(value.find('\0'), value.size()));
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  text += table::csv_cell(line);
}

}  // namespace

Contents contents_of(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file))
    throw InputError{"an HDF5 or MAT file must be a file, no pipe"};
  std::string first(8, '\0');
  std::ifstream{file, std::ios::binary}.read(first.data(), std::ssize(first));
  if (first == "\x89HDF\r\n\x1a\n" || first == "MATLAB 7") return hdf5_contents(file);
  if (first.starts_with("\x1f\x8b"))
    throw InputError{"an HDF5 or MAT file packed by gzip; allowed: unpacked, by gunzip"};
  return mat_contents(file);
}

void write_table(const Contents& contents, const std::string& wanted, const TextSink& sink) {
  const Table table = chosen(contents, wanted);
  std::size_t width = 0;
  for (const DataSet* set : table) width += set->columns.size();
  sink(headers(table));
  const std::size_t rows = table.front()->rows;
  const std::size_t block = std::clamp<std::size_t>(65536 / width, 1, 8192);
  std::string text;
  for (std::size_t first = 0; first < rows; first += block) {
    const std::size_t count = std::min(block, rows - first);
    std::vector<Values> values;
    for (const DataSet* set : table)
      for (Values& column : set->read(first, count)) values.push_back(std::move(column));
    text.clear();
    for (std::size_t row = 0; row < count; ++row) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) text += ',';
        std::visit([&](const auto& column) { append_cell(text, column.at(row)); }, values[i]);
      }
      text += '\n';
    }
    sink(text);
  }
}

}  // namespace railbook::containers
