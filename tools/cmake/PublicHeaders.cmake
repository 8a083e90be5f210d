# What a user of the libraries includes. These headers are installed with those that they include.
set(public_headers
  # plimsoll::hydro
  hydro/added_mass/added_mass.h
  hydro/added_mass/constant_added_mass.h
  hydro/added_mass/deep_added_mass.h
  hydro/added_mass/wetted_added_mass.h
  hydro/loads/drag_calibration.h
  hydro/loads/loads.h
  hydro/mesh/mass_properties.h
  hydro/mesh/mesh_check.h
  hydro/mesh/primitives.h
  hydro/mesh/terrain.h
  hydro/statics/equilibrium.h
  hydro/wave_spectrum.h
  # plimsoll::engine
  engine/simulation.h
  # plimsoll::scene
  app/scene/reader.h
  app/scene/schema.h
  # plimsoll::assembly
  app/assembly/build.h
  app/assembly/mesh_io.h)
