#pragma once

#include "app/scene/reader_map.h"
#include "app/scene/scene.h"

/// @file
/// Readers of a scene's blocks: their keys and the constraints between them.

namespace scene {

void read(MapReader& map, Water& water);
/// Reads `current`: a velocity, uniform everywhere, or a table over depth.
void read_current(MapReader& map, Water& water);
void read(MapReader& map, Flat& flat);
void read(MapReader& map, HeightField& field);
void read(MapReader& map, SimulatedWater& simulated);
void read(MapReader& map, Wave& wave);
void read(MapReader& map, Spectrum& spectrum);
void read(MapReader& map, Elevation& elevation);
void read(MapReader& map, hydro::Air& air);
void read(MapReader& map, Ground& ground);

void read(MapReader& map, Mesh& mesh);
void read(MapReader& map, Box& box);
void read(MapReader& map, Sphere& sphere);
void read(MapReader& map, Icosphere& sphere);
void read(MapReader& map, Ellipsoid& ellipsoid);
void read(MapReader& map, Cylinder& cylinder);
void read(MapReader& map, PlacedShape& placed);
/// Reads the one shape among a body's keys.
void read_shape(MapReader& map, Shape& shape);

void read(MapReader& map, Hydro& hydro);
void read(MapReader& map, AddedMass& added_mass);
void read(MapReader& map, Heel& heel);
void read(MapReader& map, Radiation& radiation);
void read(MapReader& map, Resistance& resistance);
void read(MapReader& map, hydro::PressureDrag& drag);
void read(MapReader& map, Body& body);
void read(MapReader& map, Eigen::Quaterniond& orientation);
void read(MapReader& map, AppliedLoad& load);
void read(MapReader& map, AppliedLoad::Sine& sine);
/// Reads `interior`, `air`, `interior_water`, `openings` and `pumps`.
void read_interior(MapReader& map, Body& body);
void read(MapReader& map, InteriorWater& water);
void read(MapReader& map, Opening& opening);
void read(MapReader& map, Pump& pump);
void read(MapReader& map, Joint& joint);
/// Reads `bodies`: the names of two bodies, or of a body and `world`.
void read_pair(MapReader& map, std::array<std::string, 2>& bodies);

/// Reads `friction` and `restitution` of a surface.
void read_surface(MapReader& map, double& friction, double& restitution);
void read(MapReader& map, Contact& contact);
void read(MapReader& map, BedSuction& suction);
/// Checks that contacts are given for pairs that can touch, once for each.
void check_contacts(MapReader& map, const Scene& scene);
/// Reads a direction and gives it unit length; without the key it keeps its value. @return true if
/// it is present and valid
bool read_direction(MapReader& map, const std::string& key, Eigen::Vector3d& axis);
/// Reads what acts along the coordinate of a joint. @param type   None: it is not known.
void read_drive(MapReader& map, std::optional<Joint::Type> type, JointDrive& drive);

void read(MapReader& map, Spring& spring);
void read(MapReader& map, Rope& rope);
void read(MapReader& map, Mooring& mooring);
void read(MapReader& map, LineDrag& drag);
void read(MapReader& map, MoorDyn& moordyn);
void read(MapReader& map, Propeller& propeller);
void read(MapReader& map, hydro::WageningenB& screw);
void read(MapReader& map, hydro::OpenWaterTable& table);
void read(MapReader& map, hydro::FourQuadrantTable& table);
void read(MapReader& map, Rudder& rudder);
void read(MapReader& map, Sail& sail);
void read(MapReader& map, hydro::Foil::Table& table);
void read(MapReader& map, Control& control);
void read(MapReader& map, PidControl& pid);
void read(MapReader& map, RelayControl& relay);
/// Reads `file`, `column` and `interpolation` into `file`. @return true if there is a file
bool read_command_file(MapReader& map, CommandFile& file);
/// Reads a formula in the time; a number is one, too. @return true if it is present and valid
bool read_formula(MapReader& map, const std::string& key, std::string& formula, bool required);
/// Checks what lines, machines and controls need from other blocks.
void check_rig(MapReader& map, const Scene& scene);
/// Adds a fault for each name that is used twice. `list` is the path of the list.
void check_unique(MapReader& map, const std::string& list, const std::vector<std::string>& names);
/// Checks that names are all different. @param entries   Path of each entry, and its name.
void check_unique(MapReader& map, const std::vector<std::pair<std::string, std::string>>& entries);

void read(MapReader& map, Render& render);
void read(MapReader& map, Camera& camera);
/// Reads `cameras`: a list of them, or a map by their names.
void read_cameras(MapReader& map, std::vector<Camera>& cameras);
/// Checks that the bodies of `camera` or `cameras` exist.
void check_followed_bodies(MapReader& map, const Scene& scene);

void read(MapReader& map, Integrator& integrator);

void read(MapReader& map, Probe& probe);
/// Checks what the probes need from other blocks: their bodies, and water that is deep enough.
void check_probes(MapReader& map, const Scene& scene);

/// Reads the whole file.
void read(MapReader& map, Scene& scene);

}  // namespace scene
