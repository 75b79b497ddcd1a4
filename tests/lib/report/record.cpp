// What a chapter leaves behind: its record, its checks as a table, its headline, its inventory.
#include <railbook/report/record.hpp>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <railbook/report/detail/headline.hpp>
#include <railbook/report/detail/inventory.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using namespace report;

namespace {

CheckRecord check(const std::string& id, const std::string& source, const std::string& outcome) {
  CheckRecord c;
  c.id = id, c.item = "t", c.what = "w, x", c.unit = "m", c.source = source, c.outcome = outcome;
  c.reference = "1,5", c.by = "B", c.computed = 1.25, c.computed_text = "1.2", c.allowed = 0.5;
  c.error = 0.25, c.kind = "relative", c.why = "y", c.pass = true;
  return c;
}

}  // namespace

TEST_CASE("unit: a record holds all that was found, and what is no number as null") {
  ChapterRecord r;
  r.chapter = "00-s", r.title = "T", r.paper = "P", r.doi = "D", r.level = "full", r.seconds = 4;
  r.only = {"t"};
  r.checks = {check("t/a", "print", "confirmed"), check("t/b", "claim", "confirmed")};
  r.checks[1].computed = r.checks[1].error = units::nan;
  r.checks[1].kind = "exact";
  r.items.resize(2);
  r.items[0] = {.id = "t",
                .kind = "table",
                .title = "One",
                .page = "study",
                .input = "added",
                .reason = "ours",
                .failure = "none",
                .png = "t.png",
                .not_drawn = "no GL",
                .csv = {"t.csv"},
                .script = "t.gp",
                .columns = {"c"},
                .rows = {{"1"}},
                .seconds = 5};
  r.values = {{"v", "2 m", 2, "m"}, {"n", "word", units::nan, ""}};
  r.work_precision = {{"w", "F", "a", "s", 1, 2, 3, 4, 5, 6, 7, 8, "cells", false, "slow"}};
  r.stability = {{"s", "c", "x", "found", "ref", 1, units::nan, "holds", "fails", 2, true}};
  r.inventory = {{"p. 1", "claim", "(1)", "what", {"t/a"}, "sym", "test", "why"}};
  r.problems = {"a problem"};
  const TemporaryFolder at("record");
  write_record(r, at.path / "r.json");
  auto found = nlohmann::json::parse(at.read("r.json"));
  CHECK(found["version"].is_string());
  CHECK(found["headline"].size() == 11);
  for (const char* key : {"version", "headline", "machine"}) found.erase(key);
  CHECK(found == nlohmann::json::parse(R"json({
    "chapter": "00-s", "title": "T", "paper": "P", "doi": "D", "level": "full", "seconds": 4, "only": ["t"],
    "checks": [
      {"id": "t/a", "item": "t", "what": "w, x", "unit": "m", "source": "print", "outcome": "confirmed",
       "place": "", "by": "B", "printed": "1,5", "computed": 1.25, "computed_text": "1.2", "allowed": 0.5,
       "error": 0.25, "kind": "relative", "why": "y", "pass": true},
      {"id": "t/b", "item": "t", "what": "w, x", "unit": "m", "source": "claim", "outcome": "confirmed",
       "place": "", "by": "B", "reference": "1,5", "computed": "1.2", "computed_text": "1.2", "allowed": 0.5,
       "error": null, "kind": "exact", "why": "y", "pass": true}],
    "items": [
      {"id": "t", "kind": "table", "title": "One", "page": "study", "input": "added", "reason": "ours",
       "failure": "none", "png": "t.png", "csv": ["t.csv"], "script": "t.gp", "seconds": 5, "not_drawn": "no GL",
       "columns": ["c"], "rows": [["1"]]},
      {"id": "", "kind": "", "title": "", "page": "paper", "input": "paper", "reason": "", "failure": "",
       "png": "", "csv": [], "script": "", "seconds": 0}],
    "values": [{"id": "v", "text": "2 m", "value": 2, "unit": "m"},
               {"id": "n", "text": "word", "value": null, "unit": ""}],
    "work_precision": [
      {"id": "w", "quantity": "F", "method": "a", "setting": "s", "error": 1, "reference_uncertainty": 2,
       "seconds_min": 3, "seconds_q1": 4, "seconds_median": 5, "seconds_q3": 6, "samples": 7, "work": 8,
       "work_unit": "cells", "converged": false, "reason": "slow"}],
    "stability": [
      {"id": "s", "case": "c", "stress": "x", "result": "found", "reference": "ref", "error": 1, "allowed": null,
       "expect": "holds", "found": "fails", "seconds": 2, "pass": true}],
    "inventory": [{"place": "p. 1", "kind": "claim", "number": "(1)", "what": "what", "treated": ["t/a"],
                   "symbol": "sym", "test": "test", "reason": "why"
}],
    "problems": ["a problem"]
})json"));
}

TEST_CASE("unit: a headline counts each outcome of the print, of claims, figures and routes") {
  ChapterRecord r;
  const auto add = [&](int n, const char* source, const char* outcome) {
    for (int k = 0; k < n; ++k) r.checks.push_back(check("t/a", source, outcome));
  };
  add(1, "print", "confirmed"), add(2, "print", "consistent"), add(3, "print", "fitted");
  add(4, "print", "corrected"), add(5, "print", "restored"), add(6, "print", "not confirmed");
  add(7, "claim", "confirmed"), add(8, "claim", "not confirmed"), add(3, "claim", "consistent");
  add(9, "route", "verified"), add(20, "publication", "verified"), add(1, "route", "failed");
  for (const char* reason : {"unreadable: a fold", "unreadable", "not testable: gone", "left out"})
    r.inventory.emplace_back().reason = reason;
  const auto figures = [&](int n, const char* kind, const char* page, const char* input) {
    for (int k = 0; k < n; ++k) {
      ItemRecord& item = r.items.emplace_back();
      item.kind = kind, item.page = page, item.input = input;
    }
  };
  figures(1, "figure", "paper", "paper"), figures(2, "figure", "paper", "rebuilt");
  figures(3, "figure", "paper", "sketch"), figures(4, "figure", "paper", "lost");
  figures(9, "table", "paper", "paper"), figures(9, "figure", "study", "paper");
  CHECK(headline(r) == std::vector<std::string>{"23", "1", "2", "3", "4", "5", "6", "2",
                                                "7 / 3 / 8 / 1", "1 / 5 / 4", "29"});
}

TEST_CASE("unit: the inventory's row that is most closely about a check gives its place") {
  ChapterRecord r;
  for (const char* source : {"print", "claim"})
    r.checks.push_back(check(std::string("t/") + source, source, "confirmed"));
  const auto place = [&](const std::vector<InventoryRow>& rows, std::size_t i) {
    audit(rows, r);
    return r.checks[i].place;
  };
  const InventoryRow wild{"p. 1", "number", "", "", {"t/*"}, "", "", ""};
  const InventoryRow many{"p. 2", "number", "", "", {"t/print", "t/claim"}, "", "", ""};
  const InventoryRow few{"p. 3", "number", "", "", {"t/print"}, "", "", ""};
  const InventoryRow claim{"p. 4", "claim", "", "", {"t/*"}, "", "", ""};
  CHECK(place({wild, many, few, claim}, 0) == "p. 3");
  CHECK(place({wild, many, claim}, 0) == "p. 2");
  CHECK(place({claim, wild}, 0) == "p. 1");  // its own kind, although it comes second
  CHECK(place({many, wild, claim}, 1) == "p. 4");
  CHECK(place({wild, {"p. 5", "number", "", "", {"t/*"}, "", "", ""}}, 0) == "p. 1");
}

TEST_CASE("input: an inventory says which row is of no kind") {
  const TemporaryFolder at("kind");
  const auto file = at.write("i.csv",
                             "place,kind,number,what,treated,symbol,test,reason\n"
                             "p. 1,claim,(2),w,a b,s,t,r\np. 3,picture,,c,,,,\n");
  CHECK_THROWS_WITH(
      read_inventory(file),
      "file \"" + file.string() +
          "\", row 2: kind is \"picture\"; allowed: equation, table, figure, number, claim");
  at.write("i.csv",
           "place,kind,number,what,treated,symbol,test,reason\np. 1,claim,(2),w,a b,s,t,r\n");
  const auto rows = read_inventory(file);
  REQUIRE(rows.size() == 1);
  const InventoryRow& row = rows[0];
  CHECK(row.treated == std::vector<std::string>{"a", "b"});
  CHECK(row.place + row.kind + row.number + row.what + row.symbol + row.test + row.reason ==
        "p. 1claim(2)wstr");
}

TEST_CASE("unit: the paper's text stands under printed, another's under reference") {
  ChapterRecord r;
  r.checks = {check("t/a", "print", "confirmed"), check("t/b", "route", "verified"),
              check("t/c", "claim", "confirmed")};
  r.checks[0].place = "p. 1, Table 2";
  r.checks[2].computed = units::nan;
  CHECK(checks_csv(r) ==
        "id,place,source,outcome,what,unit,printed,reference,by,computed,error,allowed,kind\n"
        "t/a,\"p. 1, Table 2\",print,confirmed,\"w, x\",m,\"1,5\",,B,1.25,0.25,0.5,relative\n"
        "t/b,,route,verified,\"w, x\",m,,\"1,5\",B,1.25,0.25,0.5,relative\n"
        "t/c,,claim,confirmed,\"w, x\",m,,\"1,5\",B,1.2,0.25,0.5,relative\n");
}
