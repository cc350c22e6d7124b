// Submissions that own their process: what runs in place of drawing when this program is started as
// a worker. The job's recipe, NAME.lua, says which.
#pragma once

namespace shadowlab::sandbox_tests {

/// `worker` on this program's command line: serves as shadowlab's own command does, but for what a
/// child does.
int serve_hostile(int argc, char** argv);

}  // namespace shadowlab::sandbox_tests
