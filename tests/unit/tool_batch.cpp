// One question to many records: whatever becomes of a record is a row, and what is done is not done again.
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <iomanip>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "../support/temporary_folder.hpp"
#include "table/csv.hpp"
#include "tool/batch.hpp"
#include "tool/session.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

// Records in a folder of their own; each call of the question leaves a mark.
struct Batch {
  TemporaryFolder at{"batch"};
  tool::BatchWish wish;
  tool::Destination out{at.path / "out"};

  explicit Batch(const std::vector<std::string>& records) {
    for (const std::string& name : records) wish.files.push_back(at.write(name, name));
  }

  std::vector<tool::Row> asked(const fs::path& record) const {
    std::ofstream(at.path / "asked", std::ios::app) << record.filename().string() << "\n";
    const std::string name = record.filename().string();
    if (name == "refused") throw InputError{"it is bad"};
    if (name == "broken") throw std::runtime_error{"it broke"};
    if (name == "large") throw std::bad_alloc{};
    if (name == "killed") raise(SIGKILL);
    if (name == "silent") _exit(0);
    if (name == "later" && !fs::exists(at.path / "now")) throw std::runtime_error{"not yet"};
    std::vector<tool::Row> rows(name == "two" ? 2 : 1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].add("kind", name == "two" ? "half" : "whole");
      rows[i].add("length", 0.5 + static_cast<double>(i));
      rows[i].add("unknown", std::nan(""));
      if (name == "two") rows[i].flag("steep"), rows[i].flag("long");
    }
    return rows;
  }

  // What is printed; `marks`: the records asked, in any order.
  std::string run() const {
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
      tool::run_batch(wish, out, "sum", [this](const fs::path& record) { return asked(record); });
    } catch (...) {
      restore();
      throw;
    }
    restore();
    return at.read("said");
  }
  long marks() const {
    const std::string all = at.read("asked");
    return std::count(all.begin(), all.end(), '\n');
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
  for (const long jobs : {1L, 3L, 20L}) {
    Batch batch({"one", "refused", "two", "broken", "killed", "large", "silent", "last"});
    batch.wish.jobs = jobs;
    const std::string said = batch.run();
    CHECK(batch.marks() == 8);
    const char* expected[][3] = {{"one", "ok", ""},
                                 {"refused", "refused", "it is bad"},
                                 {"two", "ok", ""},
                                 {"two", "ok", ""},
                                 {"broken", "failed", "it broke"},
                                 {"killed", "failed", "the process ended by signal 9"},
                                 {"large", "failed", "not enough memory"},
                                 {"silent", "failed", "the process ended without an answer"},
                                 {"last", "ok", ""}};
    const auto rows = batch.rows();
    REQUIRE(rows.size() == std::size(expected));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      CHECK(fs::path(rows[i]["record"].get<std::string>()).filename() == expected[i][0]);
      CHECK(rows[i]["status"] == expected[i][1]);
      CHECK(rows[i]["reason"] == expected[i][2]);
    }
    CHECK(rows[3]["length"] == 1.5);
    CHECK(rows[3]["flags"] == "steep;long");
    CHECK(rows[0]["unknown"].is_null());
    CHECK_FALSE(rows[0].contains("flags"));
    const std::string csv = batch.at.read("out/sum-table.csv");
    CHECK(csv.starts_with("record,status,reason,kind,length,unknown,flags\n"));
    CHECK_THAT(csv, Contains("two,ok,,half,1.5,," + table::csv_cell("steep;long") + "\n") &&
                        Contains("one,ok,,whole,0.5,,\n"));
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 10);
    CHECK_THAT(said, Contains("1 of 8 records refused") && Contains("4 of 8 records failed"));
    CHECK(batch.at.files_in(batch.at.path / "out") == 2);  // the journal is gone
  }
}

TEST_CASE("unit: a record is named in its row as its file is, in any script") {
  const std::string name = "Gleis 1 \u00e4\u00f6\u00fc \u8ecc\u9053.csv";
  Batch batch({name, "last"});
  batch.run();
  CHECK_THAT(batch.at.read("out/sum-table.jsonl"), Contains(name));
  CHECK_THAT(batch.at.read("out/sum-table.csv"), Contains(name));
}

TEST_CASE("unit: a rerun asks for what failed, what has changed, and for all with other options") {
  Batch batch({"one", "later", "refused"});
  tool::session().given.clear();
  CHECK_THAT(batch.run(), Contains("1 of 3 records failed"));
  CHECK(batch.rows()[1]["reason"] == "not yet");
  batch.run();
  CHECK(batch.at.read("asked") == "later\n");
  batch.at.write("now", "");
  CHECK_THAT(batch.run(), !Contains("failed;") && Contains("earlier run"));
  CHECK(batch.at.read("asked") == "later\n");
  CHECK(batch.rows()[1]["status"] == "ok");
  batch.run();
  CHECK(batch.marks() == 0);
  batch.at.write("one", "longer");
  batch.run();
  CHECK(batch.at.read("asked") == "one\n");
  batch.wish.stamp = "other";
  batch.run();
  CHECK(batch.marks() == 3);
  tool::session().given = {{"jobs", "3"}};  // not what an answer depends on
  batch.run();
  CHECK(batch.marks() == 0);
  tool::session().given = {{"window", "hamming"}};
  batch.run();
  CHECK(batch.marks() == 3);
  tool::session().given.clear();
}

TEST_CASE("unit: shards divide the records, and a run without a shard merges what they did") {
  Batch batch({"one", "two", "three", "four", "later"});
  for (const auto& [shard, count] : {std::pair{"1/2", 3}, {"2/2", 2}}) {
    batch.wish.shard = shard;
    batch.run();
    CHECK(batch.marks() == count);
  }
  CHECK(fs::exists(batch.at.path / "out/sum-1-of-2.jsonl"));
  CHECK(fs::exists(batch.at.path / "out/sum-2-of-2.jsonl"));
  CHECK_FALSE(fs::exists(batch.at.path / "out/sum-table.csv"));
  batch.wish.shard.clear();
  CHECK_THAT(batch.run(), Contains("done in an earlier run") && Contains("4"));
  CHECK(batch.at.read("asked") == "later\n");  // it failed there
  CHECK(batch.rows().size() == 6);
  // Lines that a kill cut off, and files of others, are no answers.
  std::ofstream(batch.at.path / "out/sum-3-of-9.jsonl") << "{\"key\":\"1\",\"status\":\"ok\"\nno\n";
  CHECK_NOTHROW(batch.run());
  for (const char* shard : {"0/2", "3/2", "1", "1/", "/2", "1/2x", "1/100001"}) {
    batch.wish.shard = shard;
    CHECK_THROWS_WITH(batch.run(), Contains("allowed: 1/4 to 4/4"));
  }
}

TEST_CASE("unit: a shard beyond the records has nothing to do, and is good") {
  Batch batch({"one", "two"});
  for (const auto& [shard, count] : {std::pair{"2/3", 1}, {"3/3", 0}, {"100000/100000", 0}}) {
    batch.wish.shard = shard;
    CHECK_THAT(batch.run(), Contains("sum of " + std::to_string(count) + " records\n"));
    CHECK(batch.marks() == count);
  }
}

TEST_CASE("unit: what a record depends on is hashed alike on every machine, by FNV-1a") {
  Batch batch({"one"});
  tool::session() = {};
  tool::session().version = "7";
  tool::session().given = {{"shard", "1/1"}, {"window", "hann"}, {"out", "x"}};
  batch.wish.stamp = "other files";
  batch.run();
  tool::session() = {};
  const fs::path file = batch.wish.files[0];
  const auto time = fs::last_write_time(file).time_since_epoch().count();
  const std::string text =
      "7\nother files\nwindow=hann\n" + file.string() + "\n3\n" + std::to_string(time);
  std::uint64_t hash = 0xcbf29ce484222325U;  // of the definition, as is the prime
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  std::ostringstream hex;
  hex << std::hex << std::setw(16) << std::setfill('0') << hash;
  CHECK(batch.rows()[0]["key"] == hex.str());
  CHECK(batch.rows()[0]["of"] == 1);
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

TEST_CASE("unit: one record or many, by files, a list or a shard") {
  tool::BatchWish wish;
  CHECK_FALSE(wish.many());
  CHECK_THROWS_WITH(wish.only(), Contains("there is no record"));
  wish.files = {"a"};
  CHECK_FALSE(wish.many());
  CHECK(wish.only() == "a");
  wish.files = {"a", "b"};
  CHECK(wish.many());
  CHECK(wish.only() == "a");
  wish.files = {"a"};
  wish.manifest = "list";
  CHECK(wish.many());
  wish.manifest.reset();
  wish.shard = "1/2";
  CHECK(wish.many());
}

TEST_CASE("unit: a list names records beside it, or from the root") {
  Batch batch({"one"});
  fs::create_directory(batch.at.path / "lists");
  batch.wish.manifest = batch.at.write(
      "lists/all", "# records\r\n\nhere\r\n" + (batch.at.path / "two").string() + "\n");
  batch.at.write("lists/here", ""), batch.at.write("two", "");
  batch.run();
  const auto rows = batch.rows();
  REQUIRE(rows.size() == 4);
  CHECK(rows[1]["record"] == (batch.at.path / "lists/here").string());
  CHECK(rows[2]["record"] == (batch.at.path / "two").string());
  batch.wish.manifest = batch.at.write("lists/zero", std::string("a\0b\n", 4));
  CHECK_THROWS_WITH(batch.run(), Contains("line 1: holds a zero byte"));
  batch.wish.manifest = batch.at.write("lists/same", (batch.at.path / "one").string() + "\n");
  CHECK_THROWS_WITH(batch.run(), Contains("is named twice"));
}

TEST_CASE("unit: many records that nothing can be made of are refused") {
  Batch batch({"refused", "broken"});
  CHECK_THROWS_WITH(batch.run(), Contains("none of 2 records") && Contains("the first: it is bad"));
  CHECK(batch.rows().size() == 2);  // the table says why
  batch.wish.files.clear();
  CHECK_THROWS_WITH(batch.run(), Contains("there is no record"));
  Batch other({"one", "two"});
  other.out.figure = other.at.path / "x.png";
  CHECK_THROWS_WITH(other.run(), Contains("figure is given with many records"));
  other.out = {};
  other.wish.shard = "1/2";
  CHECK_THROWS_WITH(other.run(), Contains("shard is given without out"));
}
