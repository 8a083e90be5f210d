#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/body.h"
#include "hydro/radiation/radiation_data.h"

/// @file
/// Databases of linear radiation and diffraction that other programs write.

namespace databases {

/// Data of one body in a file, in SI units, for water of density 1 and a time factor e^{−iωt},
/// but in the file's own frame: z up from the still water, and the motions and moments about the
/// file's reference point.
struct Database {
  std::string format;  ///< The program's name.
  std::string body;    ///< Name or number of the body.
  /// All files that were read, the one that was asked for first.
  std::vector<std::filesystem::path> files;
  // As in hydro::RadiationData, but neither symmetric nor checked.
  std::vector<double> frequencies;
  std::vector<hydro::Matrix6d> added_mass;
  std::vector<hydro::Matrix6d> damping;
  std::optional<hydro::Matrix6d> infinite_added_mass;
  /// Added mass by which surge, sway and heave of all other bodies at once act on this one; one a
  /// frequency, empty where the file has no others or does not tell it.
  std::vector<Eigen::Matrix<double, 6, 3>> neighbours;
  /// Directions in which waves travel, from the file's x axis, in the file's order [rad].
  std::vector<double> headings;
  // Loads of waves: one a frequency, a column for each heading; empty where the file has none. The
  // phase is that of a wave with its crest over `phase_origin`.
  std::vector<hydro::Loads6cd> excitation;  ///< X_FK + X_D.
  std::vector<hydro::Loads6cd> froude_krylov;
  std::vector<hydro::Loads6cd> diffraction;
  Eigen::Vector2d phase_origin = Eigen::Vector2d::Zero();  ///< [m]
  std::optional<Eigen::Vector3d> reference_point;          ///< [m]
  std::optional<Eigen::Vector3d> center_of_mass;           ///< [m]
  std::optional<double> gravity;                           ///< [m/s^2]
  std::optional<double> depth;            ///< Depth of the water [m]; may be infinite.
  std::optional<double> volume;           ///< Displaced [m^3].
  std::optional<double> waterplane_area;  ///< [m^2]
  std::vector<std::string> notes;         ///< Data left out or assumed.
};

/// Reads a database.
/// - `.nc`: Capytaine's dataset, its complex numbers separated.
/// - `.h5`: a file of BEMIO, for WEC-Sim and HydroChrono.
/// - `.1`: WAMIT's, with the files .3 and .hst beside it where they exist.
/// - `.tec`: Nemoh's RadiationCoefficients.tec with the forces beside it, and its Nemoh.cal there
/// or
///   in the folder above.
/// @throws InputError for a file that cannot be read, lacks the body, or has an entry that is no
///     finite number, named by its frequency, row and column
Database read_database(const scene::RadiationFile& source, double gravity);

/// @name The readers, by format
/// @{
Database read_capytaine(const scene::RadiationFile& source);
Database read_bemio(const scene::RadiationFile& source);
/// @param gravity   Where the file does not tell it [m/s^2].
Database read_wamit(const scene::RadiationFile& source, double gravity);
Database read_nemoh(const scene::RadiationFile& source);
/// @}

/// Puts the frequencies in order, moves the matrix at an infinite one to `infinite_added_mass` and
/// drops those that are 0.
/// @throws InputError for a frequency that is given twice or negative, if fewer than two remain, or
///     for an entry that is not finite
void settle(Database& database);

/// Leaves out the frequencies that are not kept. @param kept   One for each.
void keep_frequencies(const std::vector<bool>& kept, Database& database);

/// Leaves out the frequencies outside a range [rad/s]. @return how many are left
std::size_t limit_frequencies(double least, double greatest, Database& database);

/// Returns the index of the body that `body` names or counts from 1; of the only one if it is
/// empty.
/// @param names   All of the file's bodies; empty names where it has none.
std::size_t index_of_body(const scene::RadiationFile& source,
                          const std::vector<std::string>& names);

/// Refuses a database by its file. @throws InputError always
[[noreturn]] void refuse(const Database& database, const std::string& message);

inline constexpr const char* kMotions[] = {"Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"};

}  // namespace databases
