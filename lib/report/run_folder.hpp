// Where a chapter's run writes: what an earlier run left there is replaced, what anybody else put
// there is not.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace railbook::report {

// OUT/results/NN-name, OUT/figures/NN-name, and beside the record OUT/results/NN-name.json a list
// of all files that runs made, OUT/results/NN-name.files, written before the files are.
class RunFolder {
 public:
  // Makes the folders. Throws InputError, with nothing touched, when it cannot, or when there is
  // anything in one of the two that neither the list nor the record names. Where all is to be made
  // anew, what they name is removed, the record first.
  RunFolder(std::filesystem::path out, std::string chapter, bool anew);

  std::filesystem::path results() const { return out_ / "results" / chapter_; }
  std::filesystem::path figures() const { return out_ / "figures" / chapter_; }
  std::filesystem::path record() const { return out_ / "results" / (chapter_ + ".json"); }
  std::filesystem::path summary() const { return out_ / "results" / (chapter_ + ".txt"); }

  // The record goes before its files change, so that a run that is ended leaves none that looks
  // good.
  void forget_record() const;

  // To be called before a file is written. Throws InputError when it is there and no run made it.
  void announce(const std::filesystem::path& file);

 private:
  std::filesystem::path list() const { return out_ / "results" / (chapter_ + ".files"); }
  std::set<std::string> known_files() const;

  std::filesystem::path out_;
  std::string chapter_;
  std::set<std::string> known_;  // "figures/NN-name/fig-01.png"
};

}  // namespace railbook::report
