#include <railbook/tool/detail/toml.hpp>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <sstream>
#include <string_view>
#include <unordered_map>

#include <railbook/table/line_source.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::tool {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

// The line without its comment; where a quote is not closed, without its end.
std::string_view without_comment(std::string_view line) {
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote == '\0' && line[i] == '#') return line.substr(0, i);
    if (quote == '\0' ? line[i] == '"' || line[i] == '\'' : line[i] == quote)
      quote = quote == '\0' ? line[i] : '\0';
  }
  return line;
}

std::string_view value_of(std::string_view statement) {
  return trimmed(statement.substr(std::min(statement.find('='), statement.size() - 1) + 1));
}

// What is wrong with a statement that CLI11 would read as something else, or nothing.
std::string_view fault(std::string_view statement, const std::vector<CLI::ConfigItem>& items) {
  const std::string_view value = value_of(statement);
  if (value.empty()) return "lacks \"= VALUE\"";
  if (items.size() != 1 || items[0].name.empty()) return "lacks a key";
  if (value.find('\\') != value.npos && value.find('"') != value.npos)
    return "holds an escape; allowed: 'single quotes', in which \\ is itself";
  for (const std::string& input : items[0].inputs)
    if (!input.empty() && (std::string_view{"[{\"'"}.find(input.front()) != input.npos ||
                           std::string_view{"\"'"}.find(input.back()) != input.npos))
      return "is no value; allowed: a word, a text in quotes, or an array of them";
  if (value.starts_with('[')) return "";
  const std::string_view text = value.substr(1, value.size() - 2);  // CLI11 peels twice
  if (text.find_first_of("\"'") == 0 && text.find_last_of("\"'") + 1 == text.size())
    return "has quotes within quotes";
  if (items[0].inputs.size() != 1)
    return "is more than one value; allowed: one, in quotes if it holds blanks or commas";
  return "";
}

}  // namespace

std::vector<TomlEntry> read_toml(const std::filesystem::path& file) {
  table::LineSource source{file};
  std::vector<TomlEntry> entries;
  std::unordered_map<std::string, std::size_t> lines;  // of the entries
  std::string table, statement;
  std::string_view text;
  std::size_t line = 0;
  const auto refuse = [&](std::string_view what, std::string_view why) {
    throw InputError{fmt::format("file \"{}\", line {}: \"{}\" {}",
                                 units::printable(file.string(), 300), line, units::printable(what),
                                 why)};
  };
  while (source.next(text)) {
    if (source.line() == 1 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (statement.empty()) line = source.line();
    if (text.find('\0') != text.npos) refuse(text, "holds a zero byte: not a text file");
    text = trimmed(without_comment(text));
    if (text.empty()) continue;
    if (statement.empty() && text.starts_with('[')) {
      if (!text.ends_with(']') || text.starts_with("[[")) refuse(text, "is no [table]");
      table = text;
      continue;
    }
    statement += text;
    if (value_of(statement).starts_with('[') && !statement.ends_with(']')) continue;
    std::istringstream one{table + '\n' + statement + '\n'};
    std::vector<CLI::ConfigItem> items = CLI::ConfigBase{}.comment('\0')->from_config(one);
    std::erase_if(items, [](const auto& i) { return i.name == "++" || i.name == "--"; });
    if (const auto why = fault(statement, items); !why.empty()) refuse(statement, why);
    items[0].parents.push_back(items[0].name);
    TomlEntry entry{fmt::format("{}", fmt::join(items[0].parents, "-")), items[0].inputs, line};
    if (const auto [first, added] = lines.emplace(entry.name, line); !added)
      refuse(entry.name, fmt::format("is given again; the first is in line {}", first->second));
    entries.push_back(std::move(entry));
    statement.clear();
  }
  if (!statement.empty()) refuse(statement, "is an array that is not closed");
  return entries;
}

}  // namespace railbook::tool
