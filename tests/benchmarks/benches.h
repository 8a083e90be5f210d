#pragma once

/// @file
/// The groups of benchmarks; each function registers those of one file.

namespace bench {

void register_hydro();
void register_step();
void register_hollow();
void register_added_mass();
void register_wetted_added_mass();
void register_machines();
void register_rigs();
void register_mesh();
void register_frame();
void register_run();
void register_fleet();

}  // namespace bench
