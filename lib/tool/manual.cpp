#include <railbook/tool/detail/manual.hpp>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <vector>

#include <railbook/units/input_error.hpp>

namespace railbook::tool {
namespace {

std::vector<const CLI::App*> below(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

// Text as man shows it: no line begins a request, no hyphen is broken.
std::string roff(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (safe.empty() || safe.back() == '\n')
      if (c == '.' || c == '\'') safe += "\\&";
    safe += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return safe;
}

std::string described(const CLI::Option& option) {
  const std::string value = option.get_type_name();
  const std::string preset = option.get_default_str();
  return fmt::format(".TP\n.B {}{}\n{}{}{}\n", roff(option.get_name(option.get_positional())),
                     value.empty() ? "" : " " + roff(value), roff(option.get_description()),
                     option.get_required() ? " (required)" : "",
                     preset.empty() ? "" : roff(" [" + preset + "]"));
}

// The choices in a type name "{a,b}", one word each.
std::string choices(const CLI::Option& option) {
  std::string name = option.get_type_name();
  if (!name.starts_with('{')) return "";
  name = name.substr(1, name.size() - 2);
  for (char& c : name)
    if (c == ',') c = ' ';
  return name;
}

std::string names(const std::vector<const CLI::App*>& apps) {
  std::string text;
  for (const CLI::App* app : apps) text += (text.empty() ? "" : " ") + app->get_name();
  return text;
}

std::vector<const CLI::App*> tools_of(const CLI::App& subject) {
  const auto tools = below(subject);
  return tools.empty() ? std::vector{&subject} : tools;
}

// "psd classify", or "verify".
std::string place_of(const CLI::App& subject, const CLI::App& tool) {
  return &subject == &tool ? tool.get_name() : subject.get_name() + " " + tool.get_name();
}

// One shell case a place: what may follow "railbook", "railbook psd", "railbook psd classify", an
// option with choices.
std::string cases(const CLI::App& app) {
  std::string text = fmt::format("    '') offer='{} --help --version' ;;\n", names(below(app)));
  for (const CLI::App* subject : below(app)) {
    if (!below(*subject).empty())
      text += fmt::format("    '{}') offer='{} --help' ;;\n", subject->get_name(),
                          names(below(*subject)));
    for (const CLI::App* tool : tools_of(*subject)) {
      std::string parser, values;
      for (const CLI::Option* o : tool->get_options()) {
        if (!o->nonpositional()) continue;
        parser += o->get_name() + " ";
        if (const std::string words = choices(*o); !words.empty())
          values += fmt::format("      '{}') offer='{}' ;;\n", o->get_name(), words);
      }
      text += fmt::format("    '{}') offer='{}'\n", place_of(*subject, *tool), parser);
      if (!values.empty()) text += fmt::format("      case $before in\n{}      esac\n", values);
      text += "      ;;\n";
    }
  }
  return text;
}

}  // namespace

std::string manual(const CLI::App& app, const std::string& version) {
  std::string text = fmt::format(
      ".TH RAILBOOK 1 \"\" \"railbook {}\" \"User Commands\"\n.SH NAME\n{}\n.SH SYNOPSIS\n"
      ".B railbook\nSUBJECT TOOL [OPTIONS]\n.SH DESCRIPTION\n.nf\n{}\n.fi\n",
      version, roff(app.get_description()), roff(app.get_footer()));
  for (const CLI::App* subject : below(app)) {
    for (const CLI::App* tool : tools_of(*subject)) {
      text += fmt::format(".SH railbook {}\n{}\n", place_of(*subject, *tool),
                          roff(tool->get_description()));
      for (const CLI::Option* option : tool->get_options()) text += described(*option);
      text += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(tool->get_footer()));
    }
  }
  return text;
}

std::string completion(const CLI::App& app, const std::string& shell) {
  if (shell != "bash" && shell != "zsh")
    throw InputError{"completion is \"" + shell + "\"; allowed: bash, zsh"};
  const std::string body = cases(app);
  if (shell == "bash")
    return fmt::format(
        "# bash completion of railbook, written by railbook --completion bash\n"
        "_railbook() {{\n  local offer='' before=${{COMP_WORDS[COMP_CWORD-1]}} place=''\n"
        "  ((COMP_CWORD > 1)) && place=${{COMP_WORDS[1]}}\n"
        "  ((COMP_CWORD > 2)) && place+=\" ${{COMP_WORDS[2]}}\"\n"
        "  case $place in\n{}  esac\n"
        "  COMPREPLY=($(compgen -W \"$offer\" -- \"${{COMP_WORDS[COMP_CWORD]}}\"))\n}}\n"
        "complete -o default -F _railbook railbook\n",
        body);
  return fmt::format(
      "#compdef railbook\n# zsh completion of railbook, written by railbook --completion zsh\n"
      "_railbook() {{\n  local offer='' before=${{words[CURRENT-1]}} place=''\n"
      "  ((CURRENT > 2)) && place=${{words[2]}}\n"
      "  ((CURRENT > 3)) && place+=\" ${{words[3]}}\"\n"
      "  case $place in\n{}  esac\n"
      "  compadd -- ${{=offer}}\n  [[ $PREFIX == -* ]] || _files\n}}\n_railbook \"$@\"\n",
      body);
}

}  // namespace railbook::tool
