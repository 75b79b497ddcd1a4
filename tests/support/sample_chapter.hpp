// A chapter of a test, run as its program would run it, in a folder of its own.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include <railbook/report/chapter.hpp>

#include "temporary_folder.hpp"

struct Sample {
  using Section = railbook::report::Section;
  using Words = std::vector<std::string>;

  Sample() { std::filesystem::create_directories(at.path / "data"); }

  // The program with these words behind its name: its exit status.
  int run(const Section& paper, Words words, const Section& study = {}) const {
    words.insert(words.begin(), "sample");
    std::vector<char*> argv;
    argv.reserve(words.size());
    for (auto& w : words) argv.push_back(w.data());
    return railbook::report::run(static_cast<int>(argv.size()), argv.data(), info, {paper},
                                 {study});
  }
  int reproduce(const Section& paper, const Words& more = {"--no-timings"},
                const Section& study = {}) const {
    Words words{"reproduce", "--out", at.path.string()};
    words.insert(words.end(), more.begin(), more.end());
    return run(paper, words, study);
  }
  nlohmann::json record() const {
    std::ifstream stream{at.path / "results" / "00-sample.json"};
    return nlohmann::json::parse(stream);
  }

  TemporaryFolder at{"chapter"};
  railbook::report::ChapterInfo info{"00-sample", "sample", "A sample", "Nobody, 1975", at.path};
};

inline Sample::Section one(railbook::report::ItemFunction f) {
  return {railbook::report::table("t", "T", std::move(f))};
}
// The exit status of a run of one item.
inline int status(const railbook::report::ItemFunction& f) {
  return Sample{}.reproduce(one(f));
}
