#pragma once

/// @file
/// File names in the folder of a run, including those that a sweep adds. The names of frames,
/// sheets and videos, which depend on the camera, are in app/pictures/picture_files.h, those of
/// tables in app/logs/rig_log.h.

namespace app {

inline constexpr const char* kTrajectoryLog = "trajectory.csv";
inline constexpr const char* kForceLog = "forces.csv";
inline constexpr const char* kInteriorLog = "interior.csv";
inline constexpr const char* kHdf5Log = "run.h5";
inline constexpr const char* kSummaryFile = "summary.json";
/// Checkpoint of a run with --checkpoint, and its states to be drawn; both are removed when it
/// ends.
inline constexpr const char* kCheckpointFile = "checkpoint.bin";
inline constexpr const char* kShotFile = "checkpoint_shots.bin";
inline constexpr const char* kReportFile = "report.html";
/// Tolerances for comparisons of later runs with this one.
inline constexpr const char* kTolerancesFile = "tolerances.yaml";

inline constexpr const char* kFramesFolder = "frames";
inline constexpr const char* kSheetFile = "sheet.png";

/// Output of a run of a sweep to its standard streams.
inline constexpr const char* kMessagesFile = "messages.txt";
/// Result of a run of a sweep.
inline constexpr const char* kOutcomeFile = "outcome.json";

}  // namespace app
