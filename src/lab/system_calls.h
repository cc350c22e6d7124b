// Which calls to the system the process that draws a submission may make.
#pragma once

namespace shadowlab::lab {

/// From now on the calling thread and all that it starts may make no others: a call that drawing
/// could try in good faith fails, any other ends the process by SIGSYS. False where this kernel has
/// no such filters.
bool filter_system_calls();

}  // namespace shadowlab::lab
