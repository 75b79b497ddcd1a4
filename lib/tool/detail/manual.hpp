// What the command says of itself, for man and for the shells.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace railbook::tool {

// The manual page, in the language of man.
std::string manual(const CLI::App& app, const std::string& version);

// Completion of subjects, tools, options, choices and file names. Throws InputError for a shell
// other than bash and zsh.
std::string completion(const CLI::App& app, const std::string& shell);

}  // namespace railbook::tool
