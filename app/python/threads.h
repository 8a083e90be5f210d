#pragma once

#include <tbb/task_arena.h>

namespace python {

/// Returns the threads of all that computes on so many, for the whole process. The library that
/// gives them does not free all memory of an arena whose threads are busy elsewhere when it ends,
/// so none is made for each batch, scene or call.
/// @param threads   0 stands for all cores.
tbb::task_arena& shared_threads(int threads);

}  // namespace python
