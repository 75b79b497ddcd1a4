#include "report/chapter.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "num/fp_trap.hpp"
#include "num/stopwatch.hpp"
#include "units/input_error.hpp"

namespace railbook::report {
namespace {

template <class Records>
auto count_if(const Records& records, std::string_view verdict) {
  return std::count_if(records.begin(), records.end(),
                       [&](const auto& r) { return r.verdict == verdict; });
}

// "01-contact: 9 reproduced, 3 explained; checks 57/57, worst 93 % of its tolerance; 3.2 s"
std::string summary_line(const ChapterRecord& record) {
  std::string verdicts;
  for (const char* verdict :
       {"reproduced", "explained", "reconstructed", "sketch", "not-reproducible", "failed"}) {
    const auto n = count_if(record.items, verdict);
    if (n > 0) verdicts += fmt::format("{}{} {}", verdicts.empty() ? "" : ", ", n, verdict);
  }
  std::size_t passed = 0;
  double worst = 0;
  for (const CheckRecord& c : record.checks) {
    passed += c.pass ? 1 : 0;
    const bool has_share = c.allowed > 0 && c.kind != "at_most" && c.kind != "at_least";
    if (has_share && std::isfinite(c.error)) worst = std::max(worst, c.error / c.allowed);
  }
  return fmt::format("{}: {}; checks {}/{}, worst {:.0f} % of its tolerance; {:.1f} s",
                     record.chapter, verdicts, passed, record.checks.size(), 100 * worst,
                     record.seconds);
}

void print_failures(const ChapterRecord& record) {
  for (const ItemRecord& item : record.items)
    if (item.verdict == "failed") fmt::print(stderr, "FAILED {}: {}\n", item.id, item.reason);
  for (const CheckRecord& c : record.checks) {
    if (!c.pass) {
      fmt::print(stderr,
                 "  {} ({}): printed {}, computed {} {}; error {:.3g}, allowed {:.3g} ({})\n", c.id,
                 c.what, c.printed, c.computed_text, c.unit, c.error, c.allowed, c.kind);
    }
  }
}

// The bite test passes when no shifted check does.
int judge_bite(const ChapterRecord& record) {
  std::size_t toothless = 0;
  for (const CheckRecord& c : record.checks) {
    if (!c.pass) continue;
    ++toothless;
    fmt::print(stderr, "does not bite: {} (computed {}, kind {})\n", c.id, c.computed_text, c.kind);
  }
  fmt::print("{}: bite test, {} of {} shifted checks fail\n", record.chapter,
             record.checks.size() - toothless, record.checks.size());
  return toothless == 0 && !record.checks.empty() ? 0 : 1;
}

// The folder for what a run writes, before anything is computed.
void make_folder(const std::filesystem::path& folder, bool anew) {
  std::error_code error;
  if (anew) std::filesystem::remove_all(folder, error);
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InputError{
        fmt::format("folder \"{}\": cannot be made: {}", folder.string(), error.message())};
}

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
  if (std::filesystem::is_directory(file))
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

// The same for --config and then for every option that Options::toml declared: what comes first wins. `tool case.toml` is
// `tool --config case.toml`.
std::vector<std::string> with_config(CLI::App& app, std::vector<std::string> words) {
  if (words.empty()) return words;
  const auto commands =
      app.get_subcommands([&](const CLI::App* c) { return c->get_name() == words.front(); });
  if (commands.empty()) return words;
  const CLI::App* command = commands.front();
  if (words.size() > 1 && words[1].ends_with(".toml")) words.insert(words.begin() + 1, "--config");
  words = with_entries(command, std::move(words), "--config");
  for (const CLI::Option* option : command->get_options())
    if (option->get_type_name() == toml_type)
      words = with_entries(command, std::move(words), option->get_name());
  return words;
}

}  // namespace

void Chapter::table(std::string id, std::string title, ItemFunction compute) {
  add(std::move(id), "table", std::move(title), std::move(compute));
}
void Chapter::figure(std::string id, std::string title, ItemFunction compute) {
  add(std::move(id), "figure", std::move(title), std::move(compute));
}

void Chapter::add(std::string id, std::string kind, std::string title, ItemFunction compute) {
  const auto same = [&](const Entry& e) { return e.id == id; };
  if (std::any_of(entries_.begin(), entries_.end(), same))
    throw std::logic_error{"item " + id + " is named twice"};
  entries_.push_back({std::move(id), std::move(kind), std::move(title), std::move(compute)});
}

void Chapter::tool(std::string name, std::string help, ToolSetup setup) {
  tools_.push_back({std::move(name), std::move(help), std::move(setup)});
}

void Chapter::list() const {
  for (const Entry& e : entries_) fmt::print("{:<22} {:<7} {}\n", e.id, e.kind, e.title);
}

int Chapter::reproduce(const Reproduce& wish) const {
  for (const std::string& id : wish.only) {
    if (std::none_of(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.id == id; }))
      throw InputError{
          fmt::format("only is \"{}\"; allowed: a name that `{} list` shows", id, info_.name)};
  }
  const std::filesystem::path out = wish.out;
  RunSettings settings;
  settings.sources = info_.sources;
  settings.results = out / "results" / info_.id;
  settings.figures = out / "figures" / info_.id;
  settings.full = wish.level == "full";
  settings.draw = !wish.no_figures;
  settings.timings = !wish.no_timings;
  settings.bite = wish.bite;

  ChapterRecord record;
  record.chapter = info_.id;
  record.title = info_.title;
  record.paper = info_.paper;
  record.level = wish.level;
  record.only = wish.only;
  const bool anew = wish.only.empty() && !wish.bite;  // then nothing of an earlier run may remain
  make_folder(settings.results, anew);
  make_folder(settings.figures, anew);
  const num::Stopwatch total;
  for (const Entry& e : entries_) {
    if (!wish.only.empty() &&
        std::find(wish.only.begin(), wish.only.end(), e.id) == wish.only.end())
      continue;
    const num::Stopwatch one;
    Item item{e.id, e.kind, e.title, settings};
    try {
      {
        const num::FpTraps traps;
        e.compute(item);
      }
      item.finish(record);
    } catch (const std::exception& error) {
      item.fail(error.what(), record);
    }
    record.items.back().seconds = wish.no_timings ? 0 : one.seconds();
  }
  record.seconds = wish.no_timings ? 0 : total.seconds();
  if (wish.bite) return judge_bite(record);

  write_file(settings.results / "checks.csv", checks_csv(record));
  write_record(record, out / "results" / (info_.id + ".json"));
  const std::string summary = summary_line(record);
  write_file(out / "results" / (info_.id + ".txt"), summary + "\n");
  print_failures(record);
  fmt::print("{}\n", summary);
  const bool good = count_if(record.items, "failed") == 0 && !record.items.empty();
  return good ? 0 : 1;
}

int Chapter::run(int argc, char** argv) {
  CLI::App app{fmt::format("{}: {}", info_.name, info_.title), info_.name};
  app.require_subcommand(1);

  Reproduce wish;
  wish.out = RAILBOOK_BUILD_DIR;
  CLI::App* reproduce_command =
      app.add_subcommand("reproduce", "recompute the paper's tables and figures and check them");
  reproduce_command->add_option("--only", wish.only, "only these items (see list)")->delimiter(',');
  reproduce_command
      ->add_option("--level", wish.level, "quick, or full: longer Monte Carlo, finer references")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  reproduce_command->add_option("--out", wish.out, "folder for results/ and figures/")
      ->capture_default_str();
  reproduce_command->add_flag("--no-figures", wish.no_figures, "do not draw");
  reproduce_command->add_flag("--no-timings", wish.no_timings,
                              "measure no time: the same record on every run");
  reproduce_command->add_flag(
      "--bite", wish.bite,
      "shift every computed value by twice its tolerance: every check must fail");
  CLI::App* list_command = app.add_subcommand("list", "name the tables and figures");

  std::vector<std::pair<CLI::App*, std::function<void()>>> tools;
  for (const Tool& tool : tools_) {
    CLI::App* command = app.add_subcommand(tool.name, tool.help);
    command->add_option("--config", "the same options from a TOML file; the command line wins")
        ->type_name("FILE");
    Options options{*command};
    tools.emplace_back(command, tool.setup(options));
  }

  try {
    std::vector<std::string> words = with_config(app, {argv + 1, argv + argc});
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(words);
    if (*reproduce_command) return reproduce(wish);
    if (*list_command) list();
    for (const auto& [command, action] : tools)
      if (*command) {
        const num::FpTraps traps;
        action();
      }
    return 0;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForAllHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}: {}\nTry `{} --help`.\n", info_.name, error.what(), info_.name);
    return 2;
  } catch (const InputError& error) {
    fmt::print(stderr, "{}: {}\n", info_.name, error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", info_.name, error.what());
    return 1;
  }
}

}  // namespace railbook::report
