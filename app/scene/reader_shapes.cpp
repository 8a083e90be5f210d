#include <utility>

#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

// Counts are bounded so that a typing error does not fill the memory: each of these limits gives
// some ten million triangles.
const NumberRule kDivisions = between(1, 1000);
const NumberRule kSlices = between(3, 2000);
const NumberRule kSphereStacks = between(2, 2000);
const NumberRule kCylinderStacks = between(1, 2000);
const NumberRule kSubdivisions = between(0, 9);

/// Reads the single shapes; the caller checks that there is one.
template <class Holder>
void read_single(MapReader& map, Holder& shape) {
  map.alternative<Mesh>("mesh", shape);
  map.alternative<Box>("box", shape);
  map.alternative<Sphere>("sphere", shape);
  map.alternative<Icosphere>("icosphere", shape);
  map.alternative<Ellipsoid>("ellipsoid", shape);
  map.alternative<Cylinder>("cylinder", shape);
}

}  // namespace

void read_shape(MapReader& map, Shape& shape) {
  map.exactly_one_of({"mesh", "box", "sphere", "icosphere", "ellipsoid", "cylinder", "shapes"});
  read_single(map, shape);
  Shapes shapes;
  map.blocks("shapes", shapes.parts, {}, 1);
  if (!map.has("shapes")) return;
  if (shapes.parts.empty()) map.fault("shapes", "expected one shape at least");
  shape = std::move(shapes);
}

void read(MapReader& map, PlacedShape& placed) {
  map.exactly_one_of({"mesh", "box", "sphere", "icosphere", "ellipsoid", "cylinder"});
  read_single(map, placed.shape);
  map.optional("position", placed.position, number("m"));
  map.block("orientation", placed.orientation);
}

void read(MapReader& map, Mesh& mesh) {
  map.required("file", mesh.file, FileRule{});
  map.optional("up", mesh.up, ChoiceRule<UpAxis>{up_axes()});
  map.optional("unit", mesh.unit, ChoiceRule<double>{length_units()});
  map.optional("scale", mesh.scale, positive());
  map.optional("weld", mesh.mending.weld, positive("m"));
  map.optional("cap", mesh.mending.cap, TruthRule{});
  map.optional("mirror", mesh.mending.mirror, ChoiceRule<int>{mirror_axes()});
  map.optional("unite", mesh.mending.unite, TruthRule{});
  map.optional("thickness", mesh.mending.thickness, positive("m"));
}

void read(MapReader& map, Box& box) {
  map.required("size", box.size, positive("m"));
  map.optional("divisions", box.divisions, kDivisions);
}

void read(MapReader& map, Sphere& sphere) {
  map.required("radius", sphere.radius, positive("m"));
  map.optional("slices", sphere.slices, kSlices);
  map.optional("stacks", sphere.stacks, kSphereStacks);
}

void read(MapReader& map, Icosphere& sphere) {
  map.required("radius", sphere.radius, positive("m"));
  map.optional("subdivisions", sphere.subdivisions, kSubdivisions);
}

void read(MapReader& map, Ellipsoid& ellipsoid) {
  map.required("semi_axes", ellipsoid.semi_axes, positive("m"));
  map.optional("slices", ellipsoid.slices, kSlices);
  map.optional("stacks", ellipsoid.stacks, kSphereStacks);
}

void read(MapReader& map, Cylinder& cylinder) {
  map.required("radius", cylinder.radius, positive("m"));
  map.required("height", cylinder.height, positive("m"));
  map.optional("slices", cylinder.slices, kSlices);
  map.optional("stacks", cylinder.stacks, kCylinderStacks);
}

}  // namespace scene
