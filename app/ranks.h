#pragma once

#include <cstddef>
#include <optional>

/// @file
/// The place of this process among those that mpirun, mpiexec or srun has started together.
///
/// It is read from the variables that these launchers set for each process: OMPI_COMM_WORLD_RANK
/// and …_SIZE (Open MPI), PMI_RANK and PMI_SIZE (MPICH, Intel MPI), SLURM_PROCID and
/// SLURM_STEP_NUM_TASKS (srun; SLURM_NTASKS is also set in a batch script, which runs once). The
/// runs of a sweep need nothing of each other, and what they leave lies in a folder that all see,
/// so no message is passed and no MPI library is linked: every start of the program would load some
/// twenty libraries more, and a program would fit the one MPI that it was built with.
///
/// Each rank does every size-th run. Rank 0 also writes the table and waits for the others' runs; a
/// rank that dies is the launcher's affair, which ends them all (srun: with --kill-on-bad-exit).

namespace app {

struct Rank {
  std::size_t number = 0;
  std::size_t size = 1;
};

/// None where the process was not started with others.
std::optional<Rank> launched_rank();

}  // namespace app
