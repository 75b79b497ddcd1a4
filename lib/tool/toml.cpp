#include <railbook/tool/detail/toml.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include <railbook/table/line_source.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::tool {
namespace {

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : source_(file) {}

  std::vector<TomlEntry> entries() {
    while (next_line()) {
      if (at_end()) continue;
      if (take('[')) {
        if (rest_.starts_with('[')) refuse("an array of tables; allowed: a [table]");
        table_ = key(']') + "-";
        expect(']');
        expect_end();
      } else {
        entry();
      }
    }
    return std::move(entries_);
  }

 private:
  void entry() {
    TomlEntry entry{table_ + key('='), {}, source_.line()};
    constexpr std::size_t most_keys = 1000;  // each is compared with those before it
    if (entries_.size() >= most_keys)
      refuse(fmt::format("more than {} keys; allowed: up to as many", most_keys));
    for (const TomlEntry& before : entries_)
      if (before.name == entry.name)
        refuse(fmt::format("\"{}\" is given again; the first is in line {}",
                           units::printable(entry.name), before.line));
    expect('=');
    if (take('[')) {
      skip_to_item();
      while (!take(']')) {
        entry.inputs.push_back(value(",]#"));
        skip_to_item();
        if (take(','))
          skip_to_item();
        else if (!rest_.starts_with(']'))
          refuse("an array lacks a comma or its ]");
      }
    } else {
      entry.inputs.push_back(value("#"));
    }
    expect_end();
    entries_.push_back(std::move(entry));
  }

  // A bare, quoted or dotted key that ends before `end`; dots become dashes.
  std::string key(char end) {
    std::string name;
    do {
      blanks();
      if (!name.empty()) name += '-';
      const std::string before = name;
      if (rest_.starts_with('"') || rest_.starts_with('\''))
        name += quoted();
      else
        while (!rest_.empty() && plain(rest_.front())) name += take_one();
      if (name == before) refuse(fmt::format("a key is missing before \"{}\"", end));
      blanks();
    } while (take('.'));
    return name;
  }
  static bool plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  }

  std::string value(std::string_view ends) {
    blanks();
    if (rest_.starts_with('"') || rest_.starts_with('\'')) return quoted();
    if (rest_.starts_with('{')) refuse("an inline table; allowed: a value or an array");
    if (rest_.starts_with('[')) refuse("an array in an array");
    std::string_view bare = rest_.substr(0, rest_.find_first_of(ends));
    rest_.remove_prefix(bare.size());
    while (!bare.empty() && (bare.back() == ' ' || bare.back() == '\t')) bare.remove_suffix(1);
    if (bare.empty()) refuse("a value is missing");
    if (bare.find_first_of("\"'") != std::string_view::npos)
      refuse(fmt::format("the value {} has a quote that is not opened", units::printable(bare)));
    return std::string{bare};
  }

  std::string quoted() {
    const std::string_view whole = rest_;
    const char quote = take_one();
    if (rest_.starts_with(std::string(2, quote)))
      refuse("a string over several lines; allowed: one in single quotes or \"...\"");
    std::string text;
    while (!rest_.empty() && rest_.front() != quote) {
      const char c = take_one();
      text += c == '\\' && quote == '"' ? escape() : std::string(1, c);
    }
    if (rest_.empty())
      refuse(fmt::format("the quote of {} is not closed", units::printable(whole)));
    rest_.remove_prefix(1);
    return text;
  }

  std::string escape() {
    constexpr std::string_view letters = "btnfr\"\\", meant = "\b\t\n\f\r\"\\";
    const char c = rest_.empty() ? '\0' : take_one();
    const std::size_t at = letters.find(c);
    if (at != std::string_view::npos) return std::string(1, meant[at]);
    if (c != 'u' && c != 'U')
      refuse(
          "an unknown escape after \\; allowed: \\b \\t \\n \\f \\r \\\" \\\\ \\uXXXX \\UXXXXXXXX");
    unsigned long code = 0;
    for (int i = 0; i < (c == 'u' ? 4 : 8); ++i) {
      const std::size_t digit =
          rest_.empty() ? 16 : std::string_view{"0123456789abcdef"}.find(lower(take_one()));
      if (digit > 15) refuse("an escape \\u lacks its 4 hexadecimal digits, or \\U its 8");
      code = 16 * code + digit;
    }
    if (code == 0 || code > 0x10ffff || (code >= 0xd800 && code < 0xe000))
      refuse("an escape \\u names no character");
    return utf8(code);
  }
  static char lower(char c) { return c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c; }
  static std::string utf8(unsigned long code) {
    const auto byte = [](unsigned long bits) { return static_cast<char>(bits); };
    const auto more = [&](int shift) { return byte(0x80 | ((code >> shift) & 0x3f)); };
    if (code < 0x80) return {byte(code)};
    if (code < 0x800) return {byte(0xc0 | (code >> 6)), more(0)};
    if (code < 0x10000) return {byte(0xe0 | (code >> 12)), more(6), more(0)};
    return {byte(0xf0 | (code >> 18)), more(12), more(6), more(0)};
  }

  // Within an array: past blanks, comments and line ends.
  void skip_to_item() {
    while (at_end())
      if (!next_line()) refuse("an array is not closed");
  }
  bool next_line() {
    if (!source_.next(text_)) return false;
    if (text_.find('\0') != std::string::npos) refuse("holds a zero byte: not a text file");
    if (source_.line() == 1 && text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
    if (!text_.empty() && text_.back() == '\r') text_.pop_back();
    rest_ = text_;
    return true;
  }
  void blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size())); }
  bool at_end() {
    blanks();
    return rest_.empty() || rest_.front() == '#';
  }
  char take_one() {
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }
  bool take(char c) {
    blanks();
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char c) {
    if (!take(c))
      refuse(fmt::format("\"{}\" where \"{}\" is due",
                         rest_.empty() ? "the end of the line" : units::printable(rest_), c));
  }
  void expect_end() {
    if (!at_end()) refuse(fmt::format("\"{}\" where the line should end", units::printable(rest_)));
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError{fmt::format("file \"{}\", line {}: {}",
                                 units::printable(source_.file().string(), 300), source_.line(),
                                 why)};
  }

  table::LineSource source_;
  std::string text_, table_;
  std::string_view rest_;
  std::vector<TomlEntry> entries_;
};

}  // namespace

std::vector<TomlEntry> read_toml(const std::filesystem::path& file) {
  return Reader{file}.entries();
}

}  // namespace railbook::tool
