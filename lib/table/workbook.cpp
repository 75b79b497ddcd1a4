#include <railbook/table/detail/workbook.hpp>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <railbook/table/csv.hpp>
#include <railbook/table/detail/zip.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::table {
namespace {

constexpr std::size_t sheet_columns = 16384, sheet_rows = 1048576;  // of the format

[[noreturn]] void damaged_sheet() {
  throw InputError{"the sheet of the workbook is damaged"};
}

std::string utf8(std::uint32_t code) {
  const auto byte = [](std::uint32_t value) { return static_cast<char>(value); };
  const auto tail = [&](int shift) { return byte(0x80 | ((code >> shift) & 0x3f)); };
  if (code == 0 || code > 0x10ffff) return "?";
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xc0 | (code >> 6)), tail(0)};
  if (code < 0x10000) return {byte(0xe0 | (code >> 12)), tail(6), tail(0)};
  return {byte(0xf0 | (code >> 18)), tail(12), tail(6), tail(0)};
}

// Text of XML with its entities resolved.
std::string resolved(std::string_view text) {
  constexpr std::pair<std::string_view, char> names[] = {
      {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};
  std::string result;
  while (!text.empty()) {
    const std::size_t at = std::min(text.find('&'), text.size());
    result += text.substr(0, at);
    text.remove_prefix(at);
    if (text.empty()) break;
    const std::size_t end = text.substr(0, 12).find(';');
    if (end == text.npos) damaged_sheet();
    std::string_view name = text.substr(1, end - 1);
    text.remove_prefix(end + 1);
    if (name.starts_with('#')) {
      const bool hex = name.starts_with("#x");
      name.remove_prefix(hex ? 2 : 1);
      std::uint32_t code = 0;
      std::from_chars(name.data(), name.data() + name.size(), code, hex ? 16 : 10);
      result += utf8(code);
    } else {
      const auto* const known = std::find_if(std::begin(names), std::end(names),
                                             [&](const auto& one) { return one.first == name; });
      if (known == std::end(names)) damaged_sheet();
      result += known->second;
    }
  }
  return result;
}

// The tags of XML one after the other, each with the text behind it.
class Tags {
 public:
  explicit Tags(std::string_view xml) : rest_(xml) {}

  bool next() {
    const std::size_t begin = rest_.find('<');
    if (begin == rest_.npos) return false;
    rest_.remove_prefix(begin + 1);
    const std::size_t end = rest_.find('>');
    if (end == rest_.npos) damaged_sheet();
    inside_ = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    closes_ = inside_.starts_with('/');
    if (closes_) inside_.remove_prefix(1);
    name_ = inside_.substr(0, inside_.find_first_of(" \t\r\n/"));
    if (const std::size_t prefix = name_.find(':'); prefix != name_.npos)
      name_.remove_prefix(prefix + 1);
    return true;
  }

  bool opens(std::string_view name) const { return !closes_ && name_ == name; }
  bool closes(std::string_view name) const {
    return name_ == name && (closes_ || inside_.ends_with('/'));
  }
  std::string text() const { return resolved(rest_.substr(0, rest_.find('<'))); }

  // The value of an attribute, with its prefix if it has one; empty where there is none.
  std::string attribute(std::string_view name) const {
    for (std::size_t at = inside_.find(name); at != inside_.npos; at = inside_.find(name, at + 1)) {
      const std::size_t end = at + name.size();
      const bool whole =
          at > 0 && std::string_view{" \t\r\n"}.find(inside_[at - 1]) != std::string_view::npos;
      if (!whole || end + 1 >= inside_.size() || inside_[end] != '=') continue;
      const char quote = inside_[end + 1];
      const std::size_t last = inside_.find(quote, end + 2);
      if ((quote != '"' && quote != '\'') || last == inside_.npos) damaged_sheet();
      return resolved(inside_.substr(end + 2, last - end - 2));
    }
    return {};
  }

 private:
  std::string_view rest_, inside_, name_;
  bool closes_ = false;
};

// The texts that cells refer to by number, without their readings.
std::vector<std::string> shared_strings(const std::string& xml) {
  std::vector<std::string> strings;
  bool reading = false;
  for (Tags tags{xml}; tags.next();) {
    if (tags.opens("si")) strings.emplace_back();
    if (tags.opens("rPh")) reading = true;
    if (tags.closes("rPh")) reading = false;
    if (tags.opens("t") && !tags.closes("t") && !reading && !strings.empty())
      strings.back() += tags.text();
  }
  return strings;
}

// The file of a sheet.
std::string sheet_file(Zip& zip, const std::string& wanted) {
  const std::string book = zip.read("xl/workbook.xml");
  std::string id, there;
  std::size_t count = 0;
  for (Tags tags{book}; id.empty() && tags.next();) {
    if (!tags.opens("sheet")) continue;
    const std::string name = tags.attribute("name");
    there += (count++ > 0 ? ", " : "") + name;
    if (wanted.empty() || wanted == name || wanted == std::to_string(count))
      id = tags.attribute("r:id");
  }
  if (id.empty())
    throw InputError{"the workbook holds no sheet \"" + units::printable(wanted, 100) +
                     "\"; there are: " + units::printable(there, 300)};
  const std::string links = zip.read("xl/_rels/workbook.xml.rels");
  for (Tags tags{links}; tags.next();) {
    if (!tags.opens("Relationship") || tags.attribute("Id") != id) continue;
    const std::string target = tags.attribute("Target");
    return target.starts_with('/') ? target.substr(1) : "xl/" + target;
  }
  throw InputError{"the workbook is damaged: its sheet has no file"};
}

// The column of "BC12", from 0.
std::size_t sheet_column(std::string_view place) {
  std::size_t column = 0;
  for (const char c : place) {
    if (c < 'A' || c > 'Z') break;
    column = 26 * column + static_cast<std::size_t>(c - 'A') + 1;
    if (column > sheet_columns) damaged_sheet();
  }
  if (column == 0) damaged_sheet();
  return column - 1;
}

std::size_t whole(const std::string& text, std::size_t most) {
  std::size_t value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || value > most) damaged_sheet();
  return value;
}

// Few cells far apart make a long text.
void require_room(std::size_t bytes) {
  if (bytes > (std::size_t{512} << 20))
    throw InputError{"the sheet of the workbook comes to more than 512 MiB of text"};
}

}  // namespace

std::string sheet_text(const std::string& archive, const std::string& wanted) {
  Zip zip{archive};
  if (!zip.holds("xl/workbook.xml"))
    throw InputError{
        "this is a zip archive and no workbook (.xlsx); unpack it, or save the sheet as CSV, for "
        "example by libreoffice --headless --convert-to csv"};
  const std::string sheet = zip.read(sheet_file(zip, wanted));
  std::vector<std::string> strings;
  if (zip.holds("xl/sharedStrings.xml")) strings = shared_strings(zip.read("xl/sharedStrings.xml"));
  std::vector<std::pair<std::string, std::size_t>> lines;  // and how many cells each has
  std::size_t width = 0;
  std::string type, value;
  std::size_t column = 0, total = 0;
  for (Tags tags{sheet}; tags.next();) {
    if (tags.opens("row")) {
      const std::string number = tags.attribute("r");
      const std::size_t row = number.empty() ? lines.size() + 1 : whole(number, sheet_rows);
      if (row <= lines.size()) damaged_sheet();
      lines.resize(row);
    } else if (tags.opens("c")) {
      if (lines.empty()) damaged_sheet();
      const std::string place = tags.attribute("r");
      column = place.empty() ? lines.back().second : sheet_column(place);
      type = tags.attribute("t");
      value.clear();
    } else if ((tags.opens("v") || tags.opens("t")) && !tags.closes("v") && !tags.closes("t")) {
      value += tags.text();
    }
    if (!tags.closes("c") || lines.empty()) continue;
    if (type == "s") {
      const std::size_t index = whole(value, strings.size());
      if (index >= strings.size()) damaged_sheet();
      value = strings[index];
    }
    auto& [line, cells] = lines.back();
    if (column < cells) damaged_sheet();
    const std::size_t before = line.size();
    line.append(column - cells + (cells > 0 ? 1 : 0), ',');
    line += csv_cell(value);
    require_room(total += line.size() - before);
    cells = column + 1;
    width = std::max(width, cells);
    value.clear();
  }
  std::string text;
  for (auto& [line, cells] : lines) {
    require_room(total += width - std::min(width, cells));
    text += line;
    if (cells > 0) text.append(width - cells, ',');
    text += '\n';
    std::string{}.swap(line);
  }
  return text;
}

}  // namespace railbook::table
