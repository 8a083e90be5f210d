#pragma once

#include <cstddef>
#include <optional>

/// @file
/// The place of this process among those that mpirun, mpiexec or srun has started together.
///
/// It is read from the variables that these launchers set for each process: OMPI_COMM_WORLD_RANK
/// and …_SIZE (Open MPI), PMI_RANK and PMI_SIZE (MPICH, Intel MPI), SLURM_PROCID and
/// SLURM_STEP_NUM_TASKS (srun; SLURM_NTASKS is also set in a batch script, which runs once). The
/// runs of a sweep need nothing of each other, and what they leave lies in a folder that all see.
/// So no message is passed and no MPI library is linked, for three reasons: a program fits only the
/// MPI that it was built with; a process that has called MPI_Init may not fork where the network
/// writes to its memory, and each run is a process of its own; and it costs time (Open MPI 4.1: 1
/// ms to load with every start of the program, which takes 8 ms, and 0.3 s in MPI_Init).
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
