// Workbooks (.xlsx), packed here.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace workbook {

using Files = std::vector<std::pair<std::string, std::string>>;

inline std::string number(std::size_t value, int bytes) {
  std::string text;
  for (; bytes > 0; --bytes, value /= 256) text += static_cast<char>(value % 256);
  return text;
}

// A zip archive of these files, deflated by `pack`, or stored; their sizes are said to be `liar`
// where it is not 0.
inline std::string zipped(const Files& files,
                          const std::function<std::string(const std::string&)>& pack = {},
                          std::size_t liar = 0) {
  std::string archive, directory;
  for (const auto& [name, text] : files) {
    const std::string data = pack ? pack(text) : text;
    const std::string common = number(pack ? 8 : 0, 2) + number(0, 8) + number(data.size(), 4) +
                               number(liar > 0 ? liar : text.size(), 4) + number(name.size(), 2);
    directory += "PK\x01\x02" + number(20, 2) + number(20, 2) + number(0, 2) + common +
                 number(0, 12) + number(archive.size(), 4) + name;
    archive += "PK\x03\x04" + number(20, 2) + number(0, 2) + common + number(0, 2) + name + data;
  }
  return archive + directory + "PK\x05\x06" + number(0, 4) + number(files.size(), 2) +
         number(files.size(), 2) + number(directory.size(), 4) + number(archive.size(), 4) +
         number(0, 2);
}

// The second of the book's files is its first sheet.
inline Files book(const std::string& rows, const std::string& strings = "") {
  return {
      {"xl/workbook.xml",
       "<?xml version=\"1.0\"?><workbook><sheets><sheet name=\"Run\" sheetId=\"1\" r:id=\"rId7\"/>"
       "<sheet name=\"Old\" sheetId=\"2\" r:id=\"rId1\"/></sheets></workbook>"},
      {"xl/_rels/workbook.xml.rels",
       "<Relationships><Relationship Id=\"rId1\" Target=\"worksheets/old.xml\"/>"
       "<Relationship Id=\"rId7\" Target=\"worksheets/run.xml\"/></Relationships>"},
      {"xl/worksheets/run.xml", "<worksheet><sheetData>" + rows + "</sheetData></worksheet>"},
      {"xl/sharedStrings.xml", "<sst>" + strings + "</sst>"}};
}

}  // namespace workbook
