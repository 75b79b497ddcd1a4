// The folder of --out: all of a tool's files, or none. With --figure, the first figure alone.
//
//   tool::OutFolder out(input.out, {"limit.csv", "limit.json", "limit.png"});   // first: refuses
//   before the work
//   ...
//   if (out) {
//     out.add("limit.csv", text);
//     out.add("limit.json", summary.json());
//     out.figure(tools::scripts("quality") / "limit.gp", {"limit.csv"}, "limit.png");
//   }
//   summary.print();
//   out.commit();
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/files/out_file.hpp>
#include <railbook/tool/options.hpp>

namespace railbook::tool {

class OutFolder {
 public:
  // Without a folder nothing is to be written, and the object is false. Checks that the folder can
  // be made, and all of `names` written there; throws InputError, with the reason, where not.
  OutFolder(const Destination& destination, std::vector<std::string> names);
  ~OutFolder();
  OutFolder(const OutFolder&) = delete;
  OutFolder& operator=(const OutFolder&) = delete;

  explicit operator bool() const { return destination_.folder.has_value(); }

  // A whole file, and one to write to as its text comes. The name is one of `names`, given once.
  void add(const std::string& name, std::string_view text);
  files::OutFile& stream(const std::string& name);
  // A file for figures only; it is not kept.
  void scratch(const std::string& name, std::string_view text);
  // Draws files added before (plot::draw), unless no figures are wanted; a curve or a range without
  // data is left out.
  void figure(const std::filesystem::path& script, const std::vector<std::string>& data,
              const std::string& png);
  // Moves all files into place, or none: throws files::OutsideError. Does nothing without a folder.
  void commit();

 private:
  Destination destination_;
  std::vector<std::string> names_;
  std::optional<files::MadeFolder> made_;
  std::optional<files::PrivateFolder> scratch_;
  std::optional<files::OutFile>
      figure_;  // of --figure; the other files then are in scratch_, and go
  bool drawn_ = false;
  std::vector<files::OutFile> files_;
  std::map<std::string, std::filesystem::path> drawable_;  // those that are complete
};

}  // namespace railbook::tool
