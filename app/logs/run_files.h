#pragma once

/// @file
/// The names of the files in the folder of a run, and of those that a sweep adds. The names of
/// frames, sheets and videos, which depend on the camera, are in app/pictures/picture_files.h.

namespace app {

inline constexpr const char* kTrajectoryLog = "trajectory.csv";
inline constexpr const char* kForceLog = "forces.csv";
inline constexpr const char* kHdf5Log = "run.h5";
inline constexpr const char* kSummaryFile = "summary.json";
/// What a run saves of itself with --checkpoint, and the states that then wait to be drawn; both go
/// when it ends.
inline constexpr const char* kCheckpointFile = "checkpoint.bin";
inline constexpr const char* kShotFile = "checkpoint_shots.bin";
inline constexpr const char* kReportFile = "report.html";
/// The tolerances to which later runs are compared with this one.
inline constexpr const char* kTolerancesFile = "tolerances.yaml";

inline constexpr const char* kFramesFolder = "frames";
inline constexpr const char* kSheetFile = "sheet.png";

/// What a run of a sweep wrote to its standard streams.
inline constexpr const char* kMessagesFile = "messages.txt";
/// What a run of a sweep came to.
inline constexpr const char* kOutcomeFile = "outcome.json";

}  // namespace app
