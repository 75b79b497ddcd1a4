#include "tool/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>

#include "files/outside.hpp"
#include "num/fp_trap.hpp"
#include "units/input_error.hpp"

namespace railbook::tool {
namespace {

// The words of the command line with the entries of the TOML file that `option` names put in, unless an option is given on
// the line itself. A key in a table, [body-1] radius = "18in", is the option --body-1-radius. (CLI11 reads configuration
// files for the whole program only, not for a subcommand.)
std::vector<std::string> with_entries(const CLI::App* command, std::vector<std::string> words,
                                      const std::string& named) {
  const auto is = [](const std::string& word, const std::string& option) {
    return word == option || word.starts_with(option + "=");
  };
  const auto at =
      std::find_if(words.begin(), words.end(), [&](const auto& w) { return is(w, named); });
  if (at == words.end() || (*at == named && at + 1 == words.end())) return words;
  const std::string file = *at == named ? *(at + 1) : at->substr(named.size() + 1);
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw InputError{
        fmt::format("{} is \"{}\", a folder; allowed: a TOML file", named.substr(2), file)};

  std::vector<std::string> added;
  for (const CLI::ConfigItem& entry : CLI::ConfigTOML{}.from_file(file)) {
    if (entry.name == "++" || entry.name == "--") continue;  // begin and end of a table
    std::string name = entry.fullname();
    std::replace(name.begin(), name.end(), '.', '-');
    const bool positional = command->get_option_no_throw("--" + name) == nullptr &&
                            command->get_option_no_throw(name) != nullptr;
    const std::string option = "--" + name;
    if (std::any_of(words.begin(), words.end(), [&](const auto& w) { return is(w, option); }))
      continue;
    for (const std::string& input : entry.inputs)
      added.push_back(positional ? input : fmt::format("{}={}", option, input));
  }
  words.insert(words.end(), added.begin(), added.end());
  return words;
}

const CLI::App* subcommand(const CLI::App* app, const std::string& name) {
  if (app == nullptr) return nullptr;
  const auto all = app->get_subcommands([&](const CLI::App* c) { return c->get_name() == name; });
  return all.empty() ? nullptr : all.front();
}

// The same for --config and then for every option that Options::toml declared: what comes first wins. `tool case.toml` is
// `tool --config case.toml`.
std::vector<std::string> with_config(const CLI::App& app, std::vector<std::string> words) {
  if (words.size() < 2) return words;
  const CLI::App* command = subcommand(subcommand(&app, words[0]), words[1]);
  if (command == nullptr) return words;
  if (words.size() > 2 && words[2].ends_with(".toml")) words.insert(words.begin() + 2, "--config");
  words = with_entries(command, std::move(words), "--config");
  for (const CLI::Option* option : command->get_options())
    if (option->get_type_name() == toml_type)
      words = with_entries(command, std::move(words), option->get_name());
  return words;
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
    std::vector<std::string> words = with_config(app, {argv + 1, argv + argc});
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(words);
    const num::FpTraps traps;
    for (const auto& [command, action] : actions)
      if (*command) action();
    return 0;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForAllHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}: {}\nTry `{} --help`.\n", name, error.what(), name);
    return 2;
  } catch (const InputError& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 2;
  } catch (const files::OutsideError& error) {
    return files::report(name, error);
  } catch (const std::system_error& error) {
    return files::report(name, error);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 1;
  }
}

}  // namespace

int run(int argc, char** argv, const std::string& name, const std::string& about,
        const std::vector<Subject>& subjects) {
  files::prepare_process();
  return files::finish_process(name, run_command(argc, argv, name, about, subjects));
}

}  // namespace railbook::tool
