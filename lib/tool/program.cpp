#include "tool/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <string_view>
#include <system_error>
#include <utility>

#include "files/outside.hpp"
#include "tool/toml.hpp"
#include "units/input_error.hpp"
#include "units/printable.hpp"

namespace railbook::tool {
namespace {

// The words of the command line, and where those that a TOML file put in come from, by the name that messages use.
struct Words {
  std::vector<std::string> words;
  std::vector<std::pair<std::string, std::string>> origins;
};

// Puts in the entries of the TOML file that the option `named` names, unless an option is given on the line itself. A key in
// a table, [body-1] radius = "18in", is the option --body-1-radius. (CLI11 reads configuration files for the whole program
// only, not for a subcommand, and knows no line numbers.)
void add_entries(const CLI::App* command, Words& line, const std::string& named) {
  std::vector<std::string>& words = line.words;
  const auto is = [](const std::string& word, const std::string& option) {
    return word == option || word.starts_with(option + "=");
  };
  const auto at =
      std::find_if(words.begin(), words.end(), [&](const auto& w) { return is(w, named); });
  if (at == words.end() || (*at == named && at + 1 == words.end())) return;
  const std::string file = *at == named ? *(at + 1) : at->substr(named.size() + 1);

  std::vector<std::string> added;
  for (const TomlEntry& entry : read_toml(file)) {
    const std::string option = "--" + entry.name;
    const std::string place =
        fmt::format("file \"{}\", line {}", units::printable(file, 300), entry.line);
    const bool known = command->get_option_no_throw(option) != nullptr;
    if (!known && command->get_option_no_throw(entry.name) == nullptr)
      throw InputError{fmt::format("{}: not expected: {}; see --help for what there is", place,
                                   units::printable(option))};
    if (std::any_of(words.begin(), words.end(), [&](const auto& w) { return is(w, option); }))
      continue;
    for (const std::string& input : entry.inputs)
      added.push_back(known ? fmt::format("{}={}", option, input) : input);
    std::string spoken = entry.name;
    std::replace(spoken.begin(), spoken.end(), '-', ' ');
    line.origins.emplace_back(spoken, place);
  }
  words.insert(words.end(), added.begin(), added.end());
}

const CLI::App* subcommand(const CLI::App* app, const std::string& name) {
  if (app == nullptr) return nullptr;
  const auto all = app->get_subcommands([&](const CLI::App* c) { return c->get_name() == name; });
  return all.empty() ? nullptr : all.front();
}

// The same for --config and then for every option that Options::toml declared: what comes first wins. `tool case.toml` is
// `tool --config case.toml`.
Words with_config(const CLI::App& app, std::vector<std::string> given) {
  Words line{std::move(given), {}};
  std::vector<std::string>& words = line.words;
  if (words.size() < 2) return line;
  const CLI::App* command = subcommand(subcommand(&app, words[0]), words[1]);
  if (command == nullptr) return line;
  if (words.size() > 2 && !words[2].starts_with('-') && words[2].ends_with(".toml"))
    words.insert(words.begin() + 2, "--config");
  add_entries(command, line, "--config");
  for (const CLI::Option* option : command->get_options())
    if (option->get_type_name() == toml_type) add_entries(command, line, option->get_name());
  return line;
}

// As CLI11's, but an error about a value from a file says where it stands.
void parse(CLI::App& app, Words line) {
  std::reverse(line.words.begin(), line.words.end());  // as CLI11 wants them
  try {
    app.parse(line.words);
  } catch (const InputError& error) {
    for (const auto& [name, place] : line.origins)
      if (std::string_view{error.what()}.starts_with(name + " is "))
        throw InputError{fmt::format("{}: {}", place, error.what())};
    throw;
  }
}

}  // namespace

namespace {

int run_command(int argc, char** argv, const std::string& name, const std::string& about,
                const std::vector<Subject>& subjects) {
  CLI::App app{name + ": " + about, name};
  app.require_subcommand(1);
  std::vector<std::pair<CLI::App*, std::function<void()>>> actions;
  for (const Subject& subject : subjects) {
    CLI::App* group = app.add_subcommand(subject.name, subject.help);
    group->require_subcommand(1);
    for (const Tool& tool : subject.tools) {
      CLI::App* command = group->add_subcommand(tool.name, tool.help);
      command->add_option("--config", "the same options from a TOML file; the command line wins")
          ->type_name("FILE");
      Options options{*command};
      actions.emplace_back(command, tool.setup(options));
    }
  }
  try {
    parse(app, with_config(app, {argv + 1, argv + argc}));
    for (const auto& [command, action] : actions)
      if (*command) action();
    return 0;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}: {}\nTry `{} --help`.\n", name, units::printable(error.what(), 2000),
               name);
    return 2;
  } catch (...) {
    return files::status_of_exception(name);
  }
}

}  // namespace

int run(int argc, char** argv, const std::string& name, const std::string& about,
        const std::vector<Subject>& subjects) {
  files::prepare_process();
  return files::finish_process(name, run_command(argc, argv, name, about, subjects));
}

}  // namespace railbook::tool
