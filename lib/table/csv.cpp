#include <railbook/table/csv.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <utility>

#include <railbook/table/detail/dialect.hpp>
#include <railbook/table/detail/foreign_format.hpp>
#include <railbook/table/detail/parse_number.hpp>
#include <railbook/table/detail/table_bytes.hpp>
#include <railbook/table/detail/trim.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/nearest.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::table {
namespace {

constexpr std::size_t most_columns = 65536;

// Letters and digits, in lower case.
std::string folded(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || byte > 127) result += static_cast<char>(std::tolower(byte));
  }
  return result;
}

}  // namespace

CsvReader::CsvReader(const std::filesystem::path& file, const TextOptions& options)
    : CsvReader(file, table_bytes(file, options), options) {}

CsvReader::CsvReader(const std::filesystem::path& file, std::unique_ptr<ByteSource> bytes,
                     const TextOptions& options)
    : source_(file, std::move(bytes), options.encoding), decimal_(options.decimal) {
  std::string_view text;
  for (std::size_t skip = options.skip; skip > 0; --skip)
    if (!raw_line(text)) refuse("has no more lines than are to be skipped");
  line_ = 1;
  do {
    if (!raw_line(text)) refuse("empty; allowed: a header line and rows");
  } while (is_skipped(text));
  first_ahead_ = source_.line();
  const auto more = [&] {
    if (ahead_.size() >= 100 || !raw_line(text)) return false;
    ahead_.emplace_back(text);
    return true;
  };
  // With the lines that its quotes go on in.
  const auto whole = [&] {
    std::string record{ahead_.back()};
    while (std::count(record.begin(), record.end(), '"') % 2 == 1 && record.size() <= 1 << 20 &&
           more())
      record += text;
    return record;
  };
  ahead_.emplace_back(text);
  const std::string header = whole();
  std::vector<std::string> rows;
  while (rows.size() < options.header_lines + 2 && more())
    if (!is_skipped(text)) rows.push_back(whole());
  separator_ = separator_of(header, rows);
  const std::size_t columns =
      separator_ == ' ' ? words_of(rows.back(), words_of(header).size()).size() : 0;
  std::reverse(ahead_.begin(), ahead_.end());
  read_header(options.header_lines, columns);
}

void CsvReader::read_header(std::size_t lines, std::size_t columns) {
  const std::vector<std::string> ahead = ahead_;
  const std::size_t first = first_ahead_;
  record();
  double ignored = 0;
  const auto is_number = [&](std::string_view cell) {
    std::string text{cell};
    if (separator_ != ',') std::replace(text.begin(), text.end(), ',', '.');
    return parse_number(text, ignored);
  };
  const bool none = lines == 1 && std::all_of(cells_.begin(), cells_.end(), is_number);
  ahead_ = ahead;
  first_ahead_ = first;
  if (!none) return join_headers(lines, columns);
  for (std::size_t i = 0; i < cells_.size(); ++i) header_.push_back(std::to_string(i + 1));
}

// An empty cell in a line above the last belongs to the header before it, "Left,,Right,".
void CsvReader::join_headers(std::size_t lines, std::size_t columns) {
  for (std::size_t line = 0; line < lines; ++line) {
    if (!record()) refuse("ends within the header lines");
    if (columns > 0) cells_ = headers_of(kept_, columns);
    if (line == 0) header_.resize(cells_.size());
    if (cells_.size() != header_.size())
      refuse(fmt::format("{} headers; allowed: {}, as in the line before (--header-lines)",
                         cells_.size(), header_.size()));
    std::string_view before;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (!cells_[i].empty() || line + 1 == lines) before = cells_[i];
      if (!before.empty()) header_[i] += (header_[i].empty() ? "" : " ") + std::string{before};
    }
  }
  for (std::size_t i = 0; i < header_.size(); ++i)
    if (header_[i].empty()) header_[i] = std::to_string(i + 1);
}

void CsvReader::refuse(const std::string& why) const {
  throw InputError{fmt::format("{}, line {}: {}", quoted_name(file()), line_, why)};
}

void CsvReader::require_column(std::size_t before) const {
  if (before >= most_columns)
    refuse(fmt::format("more than {} columns; allowed: up to as many", most_columns));
}

bool CsvReader::raw_line(std::string_view& text) {
  if (!source_.next(text)) return false;
  if (source_.line() == 1) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (const std::string_view format = foreign_format(text); !format.empty())
      throw InputError{fmt::format("{}: this is {}", quoted_name(file()), format)};
  }
  if (text.find('\0') != std::string_view::npos) {
    line_ = source_.line();
    const bool wide =
        text.size() > 3 && text[0] != 0 && text[1] == 0 && text[2] != 0 && text[3] == 0;
    refuse(std::string{"holds a zero byte: not a text file"} +
           (wide ? "; --encoding UTF-16LE if it is UTF-16 without its mark" : ""));
  }
  return true;
}

// The next line that is not skipped, into its cells.
bool CsvReader::record() {
  std::string_view text;
  do {
    if (ahead_.empty()) {
      if (!raw_line(text)) return false;
      line_ = source_.line();
    } else {
      kept_ = std::move(ahead_.back());
      ahead_.pop_back();
      line_ = first_ahead_++;
      text = kept_;
    }
  } while (is_skipped(text));
  return split(text) || split_quoted(std::string{text});
}

// A line without quotes; false when it has one.
bool CsvReader::split(std::string_view text) {
  cells_.clear();
  if (text.ends_with('\r')) text.remove_suffix(1);
  if (separator_ == ' ') {
    cells_ = words_of(text, header_.size());
    if (cells_.size() > most_columns) require_column(most_columns);
    return true;
  }
  const char* begin = text.data();
  const char* const end = begin + text.size();
  for (const char* at = begin;; ++at) {
    if (at == end || *at == separator_) {
      require_column(cells_.size());
      cells_.push_back(trim({begin, static_cast<std::size_t>(at - begin)}));
      if (at == end) return true;
      begin = at + 1;
    } else if (*at == '"') {
      return false;
    }
  }
}

// A line with cells in quotes, and the lines after it that such a cell goes on in.
bool CsvReader::split_quoted(std::string text) {
  enum class Found { all, open_quote, after_quote };
  const auto cut = [&]() {
    quoted_.clear();
    std::size_t i = 0;
    while (true) {
      std::string cell;
      if (i < text.size() && text[i] == '"') {
        for (++i;; ++i) {
          if (i >= text.size()) return Found::open_quote;
          if (text[i] != '"') {
            cell += text[i];
          } else if (i + 1 < text.size() && text[i + 1] == '"') {
            cell += text[i++];
          } else {
            break;
          }
        }
        ++i;
        if (i < text.size() && text[i] != separator_) return Found::after_quote;
      } else {
        const std::size_t end = std::min(text.find(separator_, i), text.size());
        cell = trim(std::string_view{text}.substr(i, end - i));
        i = end;
      }
      require_column(quoted_.size());
      quoted_.push_back(std::move(cell));
      if (i >= text.size()) return Found::all;
      ++i;
    }
  };
  for (int breaks = 0;; ++breaks) {
    const bool returned = text.ends_with('\r');
    if (returned) text.pop_back();
    const Found found = cut();
    if (found == Found::all) break;
    if (found == Found::after_quote)
      refuse(fmt::format("text after a closing quote; allowed: a {}", separator_ == ',' ? "comma"
                                                                      : separator_ == ';'
                                                                          ? "semicolon"
                                                                      : separator_ == '|' ? "stroke"
                                                                                          : "tab"));
    std::string_view more;
    std::string kept;
    bool there = breaks < 100 && text.size() <= (1 << 20);
    if (there && !ahead_.empty()) {
      kept = std::move(ahead_.back());
      ahead_.pop_back();
      ++first_ahead_;
      more = kept;
    } else {
      there = there && raw_line(more);
    }
    if (!there) refuse("a quote is not closed");
    text += (returned ? "\r\n" : "\n") + std::string{more};
  }
  cells_.assign(quoted_.begin(), quoted_.end());
  return true;
}

const std::vector<CsvReader::Name>& CsvReader::names() const {
  for (std::size_t i = names_.size(); i < header_.size(); ++i) {
    const std::string name = parse_column(header_[i]).name;
    names_.push_back({name, folded(name), folded(header_[i])});
  }
  return names_;
}

std::optional<std::size_t> CsvReader::find(std::string_view name) const {
  std::vector<std::size_t> found;
  const auto collect = [&](const auto& fits) {
    for (std::size_t i = 0; i < header_.size() && found.size() < 2; ++i)
      if (fits(i)) found.push_back(i);
    if (found.size() > 1)
      throw InputError{fmt::format(
          "{}: column \"{}\" is there twice, as number {} and {}; allowed: the number of one",
          quoted_name(file()), units::printable(name), found[0] + 1, found[1] + 1)};
    return !found.empty();
  };
  const std::string fold = folded(name);
  if (collect([&](std::size_t i) { return header_[i] == name; }) ||
      collect([&](std::size_t i) { return names()[i].name == name; }) ||
      (!fold.empty() && collect([&](std::size_t i) {
        return names()[i].folded_header == fold || names()[i].folded_name == fold;
      })) ||
      (!fold.empty() && collect([&](std::size_t i) {  // "Level [mV]": what stands before it
        const std::string_view header = header_[i];
        return (header.ends_with(']') || header.ends_with(')')) &&
               folded(header.substr(0, header.find_first_of("[("))) == fold;
      })))
    return found[0];
  std::size_t number = 0;
  const std::string_view digits = name.starts_with('#') ? name.substr(1) : name;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (status == std::errc{} && end == digits.data() + digits.size() && number >= 1 &&
      number <= header_.size())
    return number - 1;
  return std::nullopt;
}

std::string CsvReader::columns_there() const {
  std::string there;
  for (const auto& h : header_) there += (there.empty() ? "" : ", ") + h;
  const std::string shown = units::printable(there, 1000);
  const bool other_text = shown.find("\\x") != shown.npos && there.find("\\x") == there.npos;
  return "there are: " + shown +
         (other_text ? "; --encoding if its text is not UTF-8, such as cp1252 or GBK" : "");
}

std::size_t CsvReader::column(std::string_view name) const {
  if (const auto found = find(name)) return *found;
  std::vector<std::string> known;
  for (const auto& n : names()) known.push_back(n.name);
  throw InputError{fmt::format("{}: no column \"{}\"; {}{}", quoted_name(file()),
                               units::printable(name), columns_there(),
                               units::did_you_mean(name, known))};
}

bool CsvReader::next() {
  if (!record()) return false;
  if (cells_.size() != header_.size())
    refuse(fmt::format("{} cells; allowed: {}, one a column, or a # before a line that is no row",
                       cells_.size(), header_.size()));
  return true;
}

}  // namespace railbook::table
