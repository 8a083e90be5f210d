#pragma once

#include "app/scene/reader_map.h"
#include "app/scene/scene.h"

/// @file
/// The blocks of a scene: what keys each has, and how they go together.

namespace app {

void read(MapReader& map, WaterScene& water);
void read(MapReader& map, SurfaceScene& surface);
void read(MapReader& map, FlatScene& flat);
void read(MapReader& map, HeightFieldScene& field);
void read(MapReader& map, WaveScene& wave);
void read(MapReader& map, SpectrumScene& spectrum);
void read(MapReader& map, GroundScene& ground);

void read(MapReader& map, MeshScene& mesh);
void read(MapReader& map, BoxScene& box);
void read(MapReader& map, SphereScene& sphere);
void read(MapReader& map, IcosphereScene& sphere);
void read(MapReader& map, EllipsoidScene& ellipsoid);
void read(MapReader& map, CylinderScene& cylinder);
/// The one shape among a body's keys.
void read_shape(MapReader& map, ShapeScene& shape);

void read(MapReader& map, HydroScene& hydro);
void read(MapReader& map, AddedMassScene& added_mass);
void read(MapReader& map, hydro::PressureDrag& drag);
void read(MapReader& map, BodyScene& body);
void read(MapReader& map, Eigen::Quaterniond& orientation);
void read(MapReader& map, AppliedLoadScene& load);
void read(MapReader& map, AppliedLoadScene::Sine& sine);
void read(MapReader& map, JointScene& joint);

void read(MapReader& map, RenderScene& render);
void read(MapReader& map, CameraScene& camera);
void read(MapReader& map, std::vector<CameraScene>& cameras);
/// Of `camera` or `cameras`: the bodies that they follow.
void check_followed_bodies(MapReader& map, const Scene& scene);

void read(MapReader& map, IntegratorScene& integrator);

/// The whole file.
void read(MapReader& map, Scene& scene);

}  // namespace app
