// The commands, one file each. They receive the arguments after their name. A command throws
// Failure if its exit status is not 0. Before that, it writes to standard output only in the cases
// that cli.md names under "Exit status and errors".
#pragma once

#include <string>
#include <vector>

namespace evenlift::native {

using Arguments = std::vector<std::string>;

void cmd_place(const Arguments& arguments);
void cmd_link(const Arguments& arguments);
void cmd_generate(const Arguments& arguments);
void cmd_trace(const Arguments& arguments);
void cmd_optimum(const Arguments& arguments);
void cmd_check(const Arguments& arguments);
void cmd_experiment(const Arguments& arguments);

}  // namespace evenlift::native
