#pragma once

#include <cstddef>
#include <optional>

/// @file
/// Rank of this process among those that mpirun, mpiexec or srun has started together.
///
/// It is read from the variables that these launchers set for each process: OMPI_COMM_WORLD_RANK
/// and …_SIZE (Open MPI), PMI_RANK and PMI_SIZE (MPICH, Intel MPI), SLURM_PROCID and
/// SLURM_STEP_NUM_TASKS (srun; SLURM_NTASKS is also set in a batch script, which runs once). Runs
/// of a sweep are independent and leave their results in a shared folder. The program therefore
/// passes no messages and links no MPI library: such a program works only with the MPI that it was
/// built with; a process that has called MPI_Init may not fork on some networks, and each run is a
/// process of its own; and MPI costs time (Open MPI 4.1: 1 ms of loading in each start of the
/// program, which takes 8 ms, and 0.3 s in MPI_Init).
///
/// Each rank does every size-th run. Rank 0 also writes the table and waits for the runs of the
/// others. If a rank dies, the launcher ends them all (srun: with --kill-on-bad-exit).

namespace app {

struct Rank {
  std::size_t number = 0;
  std::size_t size = 1;
};

/// Returns none if the process was not started by such a launcher.
std::optional<Rank> launched_rank();

}  // namespace app
