// The command line of a program of tools: what it says, word by word, and with which status it
// ends.
#include <railbook/tool/program.hpp>

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include <railbook/tool/session.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>

#include "support/captured.hpp"

using namespace railbook;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Options = std::vector<std::pair<std::string, std::string>>;

namespace {

// One subject with two tools; what the last run was given.
struct Program {
  double speed = 2;
  std::optional<double> mass, depth = 3;
  long count = 5;
  std::string name = "x", kind = "one", file;
  std::vector<double> loads{7};
  std::vector<std::string> columns{"a", "b"};
  bool loud = false;
  std::filesystem::path path;
  bool ran = false;

  Captured run(std::vector<std::string> words) {
    tool::session() = {};
    ran = false;
    words.insert(words.begin(), "/usr/bin/other");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    const tool::Tool solve{
        "solve", "solves it", [this](tool::OptionParser& o) {
          o.quantity("--run-speed", speed, units::speed, "of it", tool::positive);
          o.quantity("--mass", mass, units::mass, "of that", {1, 9});
          o.quantity("--depth", depth, units::length, "below", tool::non_negative);
          o.quantity("--share", share, units::number, "of all", {-1, 1});
          o.quantities("--load", loads, units::force, "of them", {0, 10});
          o.count("--count", count, "of those", 2, 6);
          o.text("--name", name, "its name");
          o.choice("--kind", kind, {"one", "two"}, "its kind");
          o.texts("--column", columns, "of a table");
          o.flag("--loud", loud, "or not");
          o.toml("--car", "a car");
          o.file("record", path, "a record");
          o.help("The end.");
          return [this] {
            ran = true;
            tool::Summary answer("an answer");
            answer.add("speed", "speed", speed, "m/s");
            answer.absent("peak", "peak", "none");
            answer.print();
          };
        }};
    const tool::Tool other{"other", "does nothing", [](tool::OptionParser& o) {
                             static double needed = 0;
                             o.quantity("--needed", needed, units::length, "is needed");
                             o.required();
                             return [] { throw InputError("it cannot be"); };
                           }};
    return captured([&] {
      return tool::run(static_cast<int>(arguments.size()), arguments.data(),
                       {.name = "prog",
                        .about = "about it",
                        .version = "1.2",
                        .libraries = {{"Lib", "3.4"}, {"Other", "5"}},
                        .help = "More."},
                       {{"sample", "a subject", {solve, other}}, {"plain", "another", {other}}});
    });
  }
  double share = 0;
};

}  // namespace

TEST_CASE("unit: a program says what it does not know, and what comes nearest") {
  Program p;
  const std::pair<std::vector<std::string>, std::string> refused[] = {
      {{"sampel"}, "\"sampel\" is no subject; allowed: sample, plain; did you mean \"sample\"?"},
      {{"sampel", "--help"},
       "\"sampel\" is no subject; allowed: sample, plain; did you mean \"sample\"?"},
      {{"sample", "solv"},
       "\"solv\" is no tool of sample; allowed: solve, other; did you mean \"solve\"?"},
      {{"sample", "solve", "--mas=3kg"},
       "not expected: --mas, no option of solve; see --help for what there is; did you mean "
       "\"--mass\"?"},
      {{"sample", "solve", "--zzzzzzz", "3"},
       "not expected: --zzzzzzz, no option of solve; see --help for what there is"},
      {{"sample", "solve", "--run-speed", "3"},
       "run speed is \"3\", without a unit; allowed: a unit of m/s"},
      {{"sample", "solve", "--run-speed", "0m/s"},
       "run speed is 0 m/s; allowed: greater than 0, finite"},
      {{"sample", "solve", "--mass", "0.9kg"}, "mass is 0.9 kg; allowed: from 1 to 9"},
      {{"sample", "solve", "--mass", "9.1kg"}, "mass is 9.1 kg; allowed: from 1 to 9"},
      {{"sample", "solve", "--depth=-1m"}, "depth is -1 m; allowed: at least 0"},
      {{"sample", "solve", "--share=2"}, "share is 2; allowed: from -1 to 1"},
      {{"sample", "solve", "--load", "3N", "11N"}, "load is 11 N; allowed: from 0 to 10"},
      {{"sample", "solve", "--count", "7"}, "count is 7; allowed: from 2 to 6"},
      {{"sample", "solve", "--count", "2.5"}, "count is 2.5; allowed: a whole number"},
      {{"sample", "solve", "--kind", "tow"},
       "kind is \"tow\"; allowed: one, two; did you mean \"two\"?"},
      {{"sample", "other", "--needed", "1m"}, "it cannot be"}};
  for (const auto& [words, said] : refused) {
    const Captured got = p.run(words);
    CHECK(got.err == "prog: " + said + "\n");
    CHECK(got.status == 2);
    CHECK(got.out.empty());
    CHECK_FALSE(p.ran);
  }
  // CLI11's own words, and where there is more.
  for (const auto& [words, said] : {std::pair<std::vector<std::string>, std::string>{
                                        {"sample", "other"}, "--needed is required"},
                                    {{"sample"}, "subcommand"},
                                    {{}, "subcommand"},
                                    {{"-x"}, "subcommand"},
                                    {{"sample", "-x"}, "subcommand"},
                                    {{"sample", "solve", "a", "b"}, "b"}}) {
    const Captured got = p.run(words);
    CHECK_THAT(got.err, StartsWith("prog: ") && Contains(said) &&
                            Catch::Matchers::EndsWith("\nTry `prog --help`.\n"));
    CHECK(got.status == 2);
  }
}

TEST_CASE("unit: options are read, noted as given or assumed, and kept in the answer") {
  Program p;
  const Captured plain = p.run({"sample", "solve"});
  CHECK(plain.status == 0);
  CHECK(plain.out == "an answer\n  speed  2 m/s\n  peak   none\n");
  CHECK(plain.err.empty());
  CHECK(tool::session().program == "prog");
  CHECK(tool::session().version == "1.2");
  CHECK(tool::session().command == std::vector<std::string>{"prog", "sample", "solve"});
  CHECK(tool::session().given.empty());
  CHECK(tool::session().assumed == Options{{"run-speed", "2 m/s"},
                                           {"depth", "3 m"},
                                           {"share", "0"},
                                           {"count", "5"},
                                           {"name", "x"},
                                           {"kind", "one"},
                                           {"column", "a,b"}});
  const Captured got = p.run({"sample", "solve", "rec.csv", "--run-speed", "36km/h", "--mass=9kg",
                              "--load", "1N", "2N", "--count=6", "--column", "c,,d", "--column",
                              "e", "--loud", "--share=-0.5", "--kind", "two", "--json"});
  CHECK(got.status == 0);
  CHECK(p.speed == Approx(10));
  CHECK(*p.mass == Approx(9));
  CHECK(p.loads == std::vector<double>{1, 2});
  CHECK(p.count == 6);
  CHECK(p.columns == std::vector<std::string>{"c", "", "d", "e"});
  CHECK(p.loud);
  CHECK(p.share == -0.5);
  CHECK(p.kind == "two");
  CHECK(p.path == "rec.csv");
  CHECK(tool::session().json);
  CHECK(tool::session().given == Options{{"run-speed", "36km/h"},
                                         {"mass", "9kg"},
                                         {"share", "-0.5"},
                                         {"load", "1N 2N"},
                                         {"count", "6"},
                                         {"kind", "two"},
                                         {"column", "c,,d e"},
                                         {"loud", "true"},
                                         {"record", "rec.csv"}});
  CHECK(tool::session().assumed == Options{{"depth", "3 m"}, {"name", "x"}});
  CHECK_THAT(got.out, StartsWith("{\n \"title\": \"an answer\"") &&
                          Contains("\"assumed\": {\n  \"depth\": \"3 m\",\n"));
  // An answer beside a file on standard output goes to standard error.
  tool::session() = {};
  tool::session().taken = true;
  const tool::Summary beside("beside");
  const Captured aside = captured([&] { return beside.print(), 0; });
  tool::session() = {};
  CHECK(aside.err == "beside\n");
  CHECK(aside.out.empty());
}

TEST_CASE(
    "unit: a file of options stands for words, the line wins, and its errors have their place") {
  const TemporaryFolder at("program");
  const std::string file =
      at.write("a.toml",
               "run-speed = \"5m/s\"\nload = [\"1N\", \"2N\"]\nrecord = \"r.csv\"\n"
               "loud = true\n")
          .string();
  for (const std::vector<std::string>& words : {std::vector<std::string>{"sample", "solve", file},
                                                {"sample", "solve", "--config", file},
                                                {"sample", "solve", "--config=" + file},
                                                {"sample", "solve", "--car", file},
                                                {"sample", "solve", "--car=" + file}}) {
    Program p;
    const Captured got = p.run(words);
    CHECK(got.err == "");
    CHECK(got.status == 0);
    CHECK(p.ran);
    CHECK(p.speed == Approx(5));
    CHECK(p.loads == std::vector<double>{1, 2});
    CHECK(p.path == "r.csv");
    CHECK(p.loud);
  }
  Program p;
  for (const std::vector<std::string>& line :
       {std::vector<std::string>{"--run-speed", "6m/s"}, {"--run-speed=6m/s"}}) {
    std::vector<std::string> words{"sample", "solve", file};
    words.insert(words.end(), line.begin(), line.end());
    CHECK(p.run(words).status == 0);
    CHECK(p.speed == Approx(6));
  }
  // An option whose name begins like another's is another; of two files the first wins.
  const std::string first = at.write("first.toml", "name = \"f\"\n").string(),
                    second = at.write("second.toml", "name = \"s\"\nkind = \"two\"\n").string();
  CHECK(p.run({"sample", "solve", "--config", first, "--car", second}).status == 0);
  CHECK(p.name == "f");
  CHECK(p.kind == "two");
  const std::string bad =
      at.write("bad.toml", "\nrun-speed = \"5kg\"\n[record]\nx = \"y\"\n").string();
  CHECK(p.run({"sample", "solve", "--config", bad}).err ==
        "prog: file \"" + bad +
            "\", line 4: not expected: --record-x; see --help for what there is\n");
  const std::string unit = at.write("unit.toml", "\nrun-speed = \"5kg\"\n").string();
  CHECK(p.run({"sample", "solve", "--config", unit}).err ==
        "prog: file \"" + unit +
            "\", line 2: run speed is \"5kg\", a quantity in kg; allowed: a unit of m/s\n");
  const std::string near = at.write("near.toml", "run-sped = \"5m/s\"\n").string();
  CHECK(p.run({"sample", "solve", near}).err ==
        "prog: file \"" + near +
            "\", line 1: not expected: --run-sped; see --help for what there is; did you mean "
            "\"--run-speed\"?\n");
  // What is no name of a file of options, or has none behind it.
  CHECK(p.run({"sample", "solve", "--config"}).status == 2);
  CHECK_THAT(p.run({"sample", "solve", "--name", "none.toml"}).err, Catch::Matchers::Equals(""));
  CHECK(p.name == "none.toml");
  CHECK_THAT(p.run({"sample", "solve", "none.toml"}).err,
             Contains("none.toml\": cannot be read: No such file"));
  CHECK(p.run({"sample", "solve", "--", "--mass"}).status == 0);
  CHECK(p.path == "--mass");
}

TEST_CASE("unit: a program tells its version, its help, its manual and its completion") {
  Program p;
  const Captured version = p.run({"--version"});
  CHECK(version.status == 0);
  CHECK_THAT(version.out, StartsWith("prog 1.2\ncompiled by ") &&
                              Catch::Matchers::Matches("[^]*\nwith fmt [0-9]+\\.[0-9]+\\.[0-9]+, "
                                                       "CLI11 [0-9.]+, nlohmann-json [0-9.]+, Lib "
                                                       "3\\.4, Other 5\n"));
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--help"}, {"sample", "--help"}, {"sample", "solve", "--help"}}) {
    const Captured help = p.run(words);
    CHECK(help.status == 0);
    CHECK(help.err.empty());
    CHECK_THAT(help.out, Contains(words.size() == 3   ? "The end."
                                  : words.size() == 2 ? "solves it"
                                                      : "More."));
  }
  const Captured manual = p.run({"--manual"});
  CHECK(manual.status == 0);
  CHECK_THAT(manual.out, StartsWith(".TH RAILBOOK 1 \"\" \"railbook 1.2\"") &&
                             Contains(".SH railbook sample solve\nsolves it\n"));
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--completion", "bash"}, {"--completion=bash"}}) {
    const Captured completion = p.run(words);
    CHECK(completion.status == 0);
    CHECK_THAT(completion.out, Contains("'sample') offer='solve other --help' ;;"));
  }
  CHECK(p.run({"--completion", "fish"}).status == 2);
}
