#include <railbook/tool/options.hpp>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include <railbook/units/nearest.hpp>

namespace railbook::tool {
namespace {

// "--tie-spacing" is called "tie spacing" in messages.
std::string spoken(std::string name) {
  name.erase(0, name.find_first_not_of('-'));
  std::replace(name.begin(), name.end(), '-', ' ');
  return name;
}

double read(const std::string& name, const std::string& text, const units::Dimension& dimension,
            const Range& range) {
  const double value = units::parse_quantity(spoken(name), text, dimension);
  const std::string unit = dimension == units::number ? "" : units::si_name(dimension);
  if (range.open_low) units::require_positive(spoken(name), value, unit);
  return units::require_between(spoken(name), value, range.low, range.high, unit);
}

std::string default_text(double value, const units::Dimension& dimension) {
  if (dimension == units::number) return fmt::format("{:g}", value);
  return fmt::format("{:g} {}", value, units::si_name(dimension));
}

}  // namespace

void OptionParser::quantity(const std::string& name, double& value,
                            const units::Dimension& dimension, const std::string& help,
                            Range range) {
  const auto set = [=, &value](const std::string& text) {
    value = read(name, text, dimension, range);
  };
  last_ = app_->add_option_function<std::string>(name, set, help)
              ->type_name("QUANTITY")
              ->default_str(default_text(value, dimension));
}

void OptionParser::quantity(const std::string& name, std::optional<double>& value,
                            const units::Dimension& dimension, const std::string& help,
                            Range range) {
  const auto set = [=, &value](const std::string& text) {
    value = read(name, text, dimension, range);
  };
  auto* option = app_->add_option_function<std::string>(name, set, help)->type_name("QUANTITY");
  if (value) option->default_str(default_text(*value, dimension));
  last_ = option;
}

void OptionParser::quantities(const std::string& name, std::vector<double>& values,
                              const units::Dimension& dimension, const std::string& help,
                              Range range) {
  const auto set = [=, &values](const std::vector<std::string>& texts) {
    values.clear();
    for (const std::string& text : texts) values.push_back(read(name, text, dimension, range));
  };
  last_ = app_->add_option_function<std::vector<std::string>>(name, set, help)
              ->type_name("QUANTITY ...");
}

void OptionParser::count(const std::string& name, long& value, const std::string& help, long low,
                         long high) {
  const auto set = [=, &value](const std::string& text) {
    const double number = units::parse_quantity(spoken(name), text, units::number);
    units::require_between(spoken(name), number, static_cast<double>(low),
                           static_cast<double>(high));
    value = static_cast<long>(number);
    if (static_cast<double>(value) != number)
      throw InputError{fmt::format("{} is {}; allowed: a whole number", spoken(name), text)};
  };
  last_ = app_->add_option_function<std::string>(name, set, help)
              ->type_name("COUNT")
              ->default_str(std::to_string(value));
}

void OptionParser::text(const std::string& name, std::string& value, const std::string& help) {
  last_ = app_->add_option(name, value, help)->type_name("TEXT")->capture_default_str();
}

void OptionParser::choice(const std::string& name, std::string& value,
                          const std::vector<std::string>& allowed, const std::string& help) {
  const auto set = [=, &value](const std::string& text) {
    if (std::find(allowed.begin(), allowed.end(), text) == allowed.end()) {
      throw InputError{fmt::format("{} is \"{}\"; allowed: {}{}", spoken(name), text,
                                   fmt::join(allowed, ", "), units::did_you_mean(text, allowed))};
    }
    value = text;
  };
  last_ = app_->add_option_function<std::string>(name, set, help)
              ->type_name(fmt::format("{{{}}}", fmt::join(allowed, ",")))
              ->default_str(value);
}

void OptionParser::texts(const std::string& name, std::vector<std::string>& values,
                         const std::string& help, bool by_blanks) {
  const auto set = [&values](const std::vector<std::string>& texts) {
    values.clear();
    for (std::string_view text : texts) {
      for (std::size_t end = text.find(','); end != text.npos; end = text.find(',')) {
        values.emplace_back(text.substr(0, end));
        text.remove_prefix(end + 1);
      }
      values.emplace_back(text);
    }
  };
  last_ = app_->add_option_function<std::vector<std::string>>(name, set, help)
              ->allow_extra_args(by_blanks)
              ->type_name("TEXT,...")
              ->default_str(fmt::format("{}", fmt::join(values, ",")));
}

void OptionParser::records(RecordFiles& records) {
  const auto set = [&records](const std::vector<std::string>& texts) {
    records.files.assign(texts.begin(), texts.end());
  };
  app_->add_option_function<std::vector<std::string>>(
          "record", set,
          "CSV files, with headers, separated by commas, semicolons or tabs, packed by gzip or "
          "not; - is "
          "standard input. Many make a table with a row for each, in the folder of --out")
      ->type_name("FILE ...");
  app_->add_option_function<std::string>(
          "--manifest", [&records](const std::string& text) { records.manifest = text; },
          "text file that lists records, one a line, relative to its own folder")
      ->type_name("FILE");
}

void OptionParser::file(const std::string& name, std::filesystem::path& value,
                        const std::string& help) {
  last_ = app_->add_option(name, value, help)->type_name("FILE");
}

void OptionParser::files(const std::string& name, std::vector<std::filesystem::path>& values,
                         const std::string& help) {
  last_ = app_->add_option_function<std::vector<std::string>>(
                  name,
                  [&values](const std::vector<std::string>& texts) {
                    values.assign(texts.begin(), texts.end());
                  },
                  help)
              ->type_name("FILE ...");
}

void OptionParser::toml(const std::string& name, const std::string& help) {
  last_ = app_->add_option(name, help)->type_name(toml_type);
}

void OptionParser::flag(const std::string& name, bool& value, const std::string& help) {
  last_ = app_->add_flag(name, value, help);
}

void OptionParser::required() {
  static_cast<CLI::Option*>(last_)->required()->default_str("");  // it has none
}

void OptionParser::help(const std::string& text) {
  app_->footer(text);
}

void OptionParser::out(Destination& destination) {
  app_->add_flag("--no-figures", destination.no_figures, "with --out: do not draw");
  last_ = app_->add_option_function<std::string>(
                  "--out", [&destination](const std::string& text) { destination.folder = text; },
                  "folder for the CSV, JSON and figure files (made if missing)")
              ->type_name("DIR");
  app_->add_option_function<std::string>(
          "--figure", [&destination](const std::string& text) { destination.figure = text; },
          "file for the figure, without the other files: PNG, or SVG if its name ends in .svg; "
          "- is standard output")
      ->type_name("FILE");
}

}  // namespace railbook::tool
