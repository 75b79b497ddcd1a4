#pragma once

#include <string>

namespace railbook::creep_tool {

// Says on standard error what memory the full theory is about to take, if it is more than a quarter of a gigabyte.
void say_memory(const std::string& theory, long cells);

}  // namespace railbook::creep_tool
