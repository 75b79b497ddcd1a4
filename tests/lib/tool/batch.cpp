// One question to many records: whatever becomes of a record is a row, and the status says whether
// all were answered.
#include <railbook/tool/batch.hpp>

#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include <railbook/files/outside.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/session.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

// Records in a folder of their own; each call of the question leaves a mark.
struct Batch {
  TemporaryFolder at{"batch"};
  tool::RecordFiles input;
  tool::Destination out{at.path / "out"};

  explicit Batch(const std::vector<std::string>& records) {
    for (const std::string& name : records) input.files.push_back(at.write(name, name));
  }

  std::vector<tool::Row> asked(const fs::path& record) const {
    std::ofstream(at.path / "asked", std::ios::app) << record.filename().string() << "\n";
    const std::string name = record.filename().string();
    if (name == "refused") throw InputError{"it is bad"};
    if (name == "broken") throw std::runtime_error{"it broke"};
    if (name == "large") throw std::bad_alloc{};
    std::vector<tool::Row> rows(name == "two" ? 2 : 1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].add("kind", name == "two" ? "half" : "whole");
      rows[i].add("length", 0.5 + static_cast<double>(i));
      rows[i].add("unknown", std::nan(""));
      if (name == "two") rows[i].warn("steep"), rows[i].warn("long");
    }
    if (name == "partly") {
      rows.emplace_back().add("kind", "whole");
      rows.back().refuse("this row is bad");
    }
    return rows;
  }

  // What is printed; `error`: what run_batch throws at its end.
  std::string run(std::string* error = nullptr) const {
    std::fflush(stdout);
    const int kept = dup(STDOUT_FILENO);
    std::FILE* const file = std::fopen((at.path / "said").c_str(), "w");
    dup2(fileno(file), STDOUT_FILENO);
    std::fclose(file);
    const auto restore = [&] {
      std::fflush(stdout);
      dup2(kept, STDOUT_FILENO);
      close(kept);
    };
    fs::remove(at.path / "asked");
    try {
      tool::run_batch(input, out, "sum", [this](const fs::path& record) { return asked(record); });
    } catch (const std::exception& thrown) {
      restore();
      if (error == nullptr) throw;
      *error = thrown.what();
      return at.read("said");
    }
    restore();
    return at.read("said");
  }
  std::vector<nlohmann::json> rows() const {
    std::vector<nlohmann::json> all;
    std::istringstream lines(at.read("out/sum-table.jsonl"));
    for (std::string line; std::getline(lines, line);) all.push_back(nlohmann::json::parse(line));
    return all;
  }
};

}  // namespace

TEST_CASE("unit: whatever becomes of a record is a row, in the order of the records") {
  const Batch batch({"one", "refused", "two", "broken", "large", "last"});
  std::string error;
  const std::string said = batch.run(&error);
  CHECK(batch.at.read("asked") == "one\nrefused\ntwo\nbroken\nlarge\nlast\n");
  const char* expected[][3] = {{"one", "ok", ""},
                               {"refused", "refused", "it is bad"},
                               {"two", "ok", ""},
                               {"two", "ok", ""},
                               {"broken", "failed", "it broke"},
                               {"large", "failed", "not enough memory"},
                               {"last", "ok", ""}};
  const auto rows = batch.rows();
  REQUIRE(rows.size() == std::size(expected));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CHECK(fs::path(rows[i]["record"].get<std::string>()).filename() == expected[i][0]);
    CHECK(rows[i]["status"] == expected[i][1]);
    CHECK(rows[i]["reason"] == expected[i][2]);
  }
  CHECK(rows[3]["length"] == 1.5);
  CHECK(rows[3]["warnings"] == "steep;long");
  CHECK(rows[0]["unknown"].is_null());
  CHECK_FALSE(rows[0].contains("warnings"));
  const std::string csv = batch.at.read("out/sum-table.csv");
  CHECK(csv.starts_with("record,status,reason,kind,length,unknown,warnings\n"));
  CHECK_THAT(csv, Contains("two,ok,,half,1.5,," + table::csv_cell("steep;long") + "\n") &&
                      Contains("one,ok,,whole,0.5,,\n"));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 8);
  CHECK_THAT(said, Contains("1 of 6 records refused") && Contains("2 of 6 records failed"));
  CHECK_THAT(error, Contains("2 of 6 records failed; the first: ") && Contains("it broke"));
  CHECK(batch.at.files_in(batch.at.path / "out") == 2);
}

TEST_CASE("unit: a record is named in its row as its file is, in any script") {
  const std::string name = "Gleis 1 \u00e4\u00f6\u00fc \u8ecc\u9053.csv";
  Batch batch({name, "last"});
  batch.run();
  CHECK_THAT(batch.at.read("out/sum-table.jsonl"), Contains(name));
  CHECK_THAT(batch.at.read("out/sum-table.csv"), Contains(name));
}

TEST_CASE("unit: the error at the end says that not all records were answered") {
  const auto thrown_by = [](const std::vector<std::string>& records) {
    const Batch batch(records);
    try {
      batch.run();
    } catch (const files::OutsideError&) {
      return 3;
    } catch (const InputError&) {
      return 2;
    }
    return 0;
  };
  CHECK(thrown_by({"one", "two"}) == 0);
  CHECK(thrown_by({"one", "refused"}) == 2);
  CHECK(thrown_by({"one", "partly"}) == 2);
  CHECK(thrown_by({"one", "refused", "large"}) == 3);
}

TEST_CASE(
    "unit: a record of which one row is refused counts as refused, and its other rows stand") {
  const Batch batch({"one", "partly"});
  std::string error;
  const std::string said = batch.run(&error);
  const auto rows = batch.rows();
  REQUIRE(rows.size() == 3);
  CHECK(rows[1]["status"] == "ok");
  CHECK(rows[1]["reason"] == "");
  CHECK(rows[1]["length"] == 0.5);
  CHECK(rows[2]["status"] == "refused");
  CHECK(rows[2]["reason"] == "this row is bad");
  CHECK(batch.at.read("out/sum-table.csv").starts_with("record,status,reason,kind,"));
  CHECK_THAT(said, Contains("1 of 2 records refused"));
  CHECK_THAT(error, Contains("1 of 2 records refused; the first: ") && Contains("this row is bad"));
}

TEST_CASE("unit: without a folder the rows are printed, and nothing is kept") {
  Batch batch({"one", "two"});
  batch.out = {};
  tool::session().json = true;
  const std::string said = batch.run();
  tool::session().json = false;
  CHECK(std::count(said.begin(), said.end(), '\n') == 3);
  CHECK(nlohmann::json::parse(said.substr(0, said.find('\n')))["kind"] == "whole");
  CHECK(batch.at.files_in(batch.at.path) == 4);  // both records, what was asked and said
}

TEST_CASE("unit: one record or many, by files or by a list") {
  tool::RecordFiles input;
  CHECK_FALSE(input.many());
  CHECK_THROWS_WITH(input.only(), Contains("there is no record"));
  input.files = {"a"};
  CHECK_FALSE(input.many());
  CHECK(input.only() == "a");
  input.files = {"a", "b"};
  CHECK(input.many());
  CHECK(input.only() == "a");
  input.files = {"a"};
  input.manifest = "list";
  CHECK(input.many());
}

TEST_CASE("unit: a list names records beside it, or from the root") {
  Batch batch({"one"});
  fs::create_directory(batch.at.path / "lists");
  batch.input.manifest = batch.at.write(
      "lists/all", "# records\r\n\nhere\r\n" + (batch.at.path / "two").string() + "\n");
  batch.at.write("lists/here", ""), batch.at.write("two", "");
  batch.run();
  const auto rows = batch.rows();
  REQUIRE(rows.size() == 4);
  CHECK(rows[1]["record"] == (batch.at.path / "lists/here").string());
  CHECK(rows[2]["record"] == (batch.at.path / "two").string());
  batch.input.manifest = batch.at.write("lists/zero", std::string("a\0b\n", 4));
  CHECK_THROWS_WITH(batch.run(), Contains("line 1: holds a zero byte"));
  batch.input.manifest = batch.at.write("lists/same", (batch.at.path / "one").string() + "\n");
  CHECK_THROWS_WITH(batch.run(), Contains("is named twice"));
}

TEST_CASE("unit: a table of unreadable records states the reason of each") {
  Batch batch({"refused", "broken"});
  CHECK_THROWS_WITH(batch.run(), Contains("1 of 2 records failed"));
  CHECK(batch.rows().size() == 2);
  batch.input.files.clear();
  CHECK_THROWS_WITH(batch.run(), Contains("there is no record"));
  Batch other({"one", "two"});
  other.out.figure = other.at.path / "x.png";
  CHECK_THROWS_WITH(other.run(), Contains("figure is given with many records"));
}
