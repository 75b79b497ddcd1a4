// The sections of the chapter, in reading order.
#pragma once

#include <railbook/report/chapter.hpp>

extern const railbook::report::Section opening;       // patches.cpp
extern const railbook::report::Section against_bank;  // bank.cpp
extern const railbook::report::Section below;         // below.cpp
extern const railbook::report::Section drawn;         // patches.cpp
extern const railbook::report::Section study;         // study/study.cpp
