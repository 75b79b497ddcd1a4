#include <railbook/tool/program.hpp>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <utility>

#include <railbook/files/outside.hpp>
#include <railbook/tool/detail/manual.hpp>
#include <railbook/tool/detail/toml.hpp>
#include <railbook/tool/session.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/nearest.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::tool {
namespace {

// The words of the command line, and where those that a TOML file put in come from, by the name
// that messages use.
struct Words {
  std::vector<std::string> words;
  std::vector<std::pair<std::string, std::string>> origins;
};

std::vector<std::string> option_names(const CLI::App* app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app->get_options())
    if (option->nonpositional()) names.push_back(option->get_name());
  return names;
}

// Puts in the entries of the TOML file that the option `named` names, unless an option is given on
// the line itself. A key in a table, [body-1] radius = "18in", is the option --body-1-radius.
void add_entries(const CLI::App* command, Words& line, const std::string& named) {
  std::vector<std::string>& words = line.words;
  const auto is = [](const std::string& word, const std::string& option) {
    return word == option || word.starts_with(option + "=");
  };
  const auto at =
      std::find_if(words.begin(), words.end(), [&](const auto& w) { return is(w, named); });
  if (at == words.end() || (*at == named && at + 1 == words.end())) return;
  const std::string file = *at == named ? *(at + 1) : at->substr(named.size() + 1);

  std::vector<std::string> added, arguments;
  for (const TomlEntry& entry : read_toml(file)) {
    const std::string option = "--" + entry.name;
    const std::string place =
        fmt::format("file \"{}\", line {}", units::printable(file, 300), entry.line);
    const bool known = command->get_option_no_throw(option) != nullptr;
    if (!known && command->get_option_no_throw(entry.name) == nullptr)
      throw InputError{fmt::format("{}: not expected: {}; see --help for what there is{}", place,
                                   units::printable(option),
                                   units::did_you_mean(option, option_names(command)))};
    if (std::any_of(words.begin(), words.end(), [&](const auto& w) { return is(w, option); }))
      continue;
    for (const std::string& input : entry.inputs) {
      if (known)
        added.push_back(fmt::format("{}={}", option, input));
      else
        arguments.push_back(input);
    }
    std::string spoken = entry.name;
    std::replace(spoken.begin(), spoken.end(), '-', ' ');
    line.origins.emplace_back(spoken, place);
  }
  words.insert(words.end(), added.begin(), added.end());
  // Arguments come first: behind an option that takes several values they would be more of them.
  words.insert(words.begin() + 2, arguments.begin(), arguments.end());
}

const CLI::App* subcommand(const CLI::App* app, const std::string& name) {
  if (app == nullptr) return nullptr;
  const auto all = app->get_subcommands([&](const CLI::App* c) { return c->get_name() == name; });
  return all.empty() ? nullptr : all.front();
}

std::vector<std::string> names_below(const CLI::App* app) {
  std::vector<std::string> names;
  for (const CLI::App* one : app->get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(one->get_name());
  return names;
}

// A word where a subject or a tool is due that is none, and an option that the tool does not have.
void require_known(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* at = &app;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--") return;
    const std::string name = word.substr(0, word.find('='));
    if (i < 2 && word.starts_with('-')) return;
    const std::vector<std::string> known = i < 2 ? names_below(at) : option_names(at);
    if (i >= 2 && (!word.starts_with("--") || at->get_option_no_throw(name) != nullptr)) continue;
    if (i < 2 && subcommand(at, word) != nullptr) {
      at = subcommand(at, word);
      continue;
    }
    const std::string what = i == 0   ? "subject"
                             : i == 1 ? "tool of " + words[0]
                                      : "option of " + at->get_name();
    if (i < 2)
      throw InputError{fmt::format("\"{}\" is no {}; allowed: {}{}", units::printable(word), what,
                                   fmt::join(known, ", "), units::did_you_mean(word, known))};
    throw InputError{fmt::format("not expected: {}, no {}; see --help for what there is{}",
                                 units::printable(name), what, units::did_you_mean(name, known))};
  }
}

// The same for --config and then for every option that Options::toml declared: what comes first
// wins. `tool case.toml` is `tool --config case.toml`.
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

// What was given to the tool, and what it assumes for the rest.
void note_options(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    std::string name = option->get_name(option->get_positional() && !option->nonpositional());
    if (name == "--help" || name == "--json") continue;
    name.erase(0, name.find_first_not_of('-'));
    if (option->count() > 0)
      session().given.emplace_back(name, fmt::format("{}", fmt::join(option->results(), " ")));
    else if (!option->get_default_str().empty())
      session().assumed.emplace_back(name, option->get_default_str());
  }
}

std::string version_text(const Program& program) {
#if defined(__clang__)
  const std::string compiler = fmt::format("Clang {}", __clang_version__);
#else
  const std::string compiler = fmt::format("GCC {}", __VERSION__);
#endif
  std::string text = fmt::format(
      "{} {}\ncompiled by {}\nwith fmt {}.{}.{}, CLI11 {}, nlohmann-json {}.{}.{}", program.name,
      program.version, compiler, FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
      CLI11_VERSION, NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
      NLOHMANN_JSON_VERSION_PATCH);
  for (const auto& [library, version] : program.libraries)
    text += fmt::format(", {} {}", library, version);
  return text;
}

}  // namespace

namespace {

// The tool that the first words name.
const Tool* named_tool(const std::vector<std::string>& words,
                       const std::vector<Subject>& subjects) {
  for (const Subject& subject : subjects)
    for (const Tool& tool : subject.tools)
      if (!words.empty() && words[0] == subject.name &&
          (tool.name.empty() || (words.size() > 1 && words[1] == tool.name)))
        return &tool;
  return nullptr;
}

// A tool under its subject, or the subject itself, with what all tools have; of one that is not
// meant only the name.
std::function<void()> add_tool(CLI::App& group, const Tool& tool, bool meant) {
  CLI::App* command = tool.name.empty() ? &group : group.add_subcommand(tool.name, tool.help);
  if (!meant) return [] {};
  if (command != &group)
    command
        ->add_option("--config",
                     "the same options from a TOML file (keys without the dashes; a key in a "
                     "[table] is --table-key); the command line wins")
        ->type_name("FILE");
  command->add_flag("--json", session().json, "print the answer as JSON and nothing else");
  OptionParser parser{*command};
  return [command, action = tool.setup(parser)] {
    if (!*command) return;
    note_options(*command);
    action();
  };
}

// Reads the words and does what they say.
int run_words(CLI::App& app, const std::vector<std::string>& words, const Program& program,
              const std::vector<Subject>& subjects) {
  std::string shell;
  bool manual_wanted = false;
  app.require_subcommand(1);
  app.footer(program.help);
  app.set_version_flag("--version", [&] { return version_text(program); });
  app.add_option("--completion", shell, "print the completion of a shell, bash or zsh")->group("");
  app.add_flag("--manual", manual_wanted, "print the manual page")->group("");
  std::vector<std::function<void()>> actions;
  const Tool* const only = named_tool(words, subjects);
  for (const Subject& subject : subjects) {
    CLI::App* group = app.add_subcommand(subject.name, subject.help);
    if (subject.tools.size() > 1 || !subject.tools.front().name.empty())
      group->require_subcommand(1);
    for (const Tool& tool : subject.tools)
      actions.push_back(add_tool(*group, tool, only == nullptr || only == &tool));
  }
  try {
    if (!words.empty() && (words[0] == "--manual" || words[0].starts_with("--completion")))
      app.require_subcommand(0);
    require_known(app, words);
    parse(app, with_config(app, words));
    if (manual_wanted) fmt::print("{}", manual(app, program.version));
    if (!shell.empty()) fmt::print("{}", completion(app, shell));
    for (const auto& action : actions) action();
    return 0;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}: {}\nTry `{} --help`.\n", program.name,
               units::printable(error.what(), 2000), program.name);
    return 2;
  }
}

// The options, which are many, are built within the try: memory may end there.
int run_command(int argc, char** argv, const Program& program,
                const std::vector<Subject>& subjects) {
  try {
    Session& asked = session();
    asked.program = program.name;
    asked.version = program.version;
    asked.command = {argv, argv + argc};
    if (argc > 0) asked.command[0] = program.name;
    CLI::App app{program.about, program.name};
    return run_words(app, {argv + 1, argv + argc}, program, subjects);
  } catch (...) {
    return files::status_of_exception(program.name);
  }
}

}  // namespace

int run(int argc, char** argv, const Program& program, const std::vector<Subject>& subjects) {
  files::prepare_process();
  return files::finish_process(program.name, run_command(argc, argv, program, subjects));
}

}  // namespace railbook::tool
