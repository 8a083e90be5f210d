#include "hydro/interior/pockets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "hydro/loads/clip.h"
#include "hydro/mesh/edge_table.h"

namespace hydro {
namespace {

/// A pocket that holds less than this part of the box around the mesh counts as the outside.
constexpr double kLeastPocket = 1e-3;

/// A pocket that holds less than this part of another one, where they meet, is a part of it.
constexpr double kLeastPart = 0.02;

/// Heights closer than this part of the height of the body are equal.
constexpr double kEqualHeight = 1e-9;

/// A face lower than this part of the height of the body is taken as level.
constexpr double kLevelFace = 1e-6;

/// Volume below a height x, a cubic polynomial; its derivative is the area of the section.
struct Cubic {
  std::array<double, 4> c = {};

  void add(const Cubic& other, double factor) {
    for (int i = 0; i < 4; ++i) c[i] += factor * other.c[i];
  }
  double volume(double x) const { return ((c[3] * x + c[2]) * x + c[1]) * x + c[0]; }
  double area(double x) const { return (3 * c[3] * x + 2 * c[2]) * x + c[1]; }
};

/// k (x − a)³ / 3
Cubic cube(double k, double a) { return {{-k * a * a * a / 3, k * a * a, -k * a, k / 3}}; }

/// Volume below a height of the column that stands on a face of the signed section `area`, given
/// the heights of its corners in ascending order and how many of them are below.
Cubic column(double area, const std::array<double, 3>& x, int below, double level_face) {
  const double mean = (x[0] + x[1] + x[2]) / 3;
  if (x[2] - x[0] < level_face) return {{-area * mean, area, 0, 0}};
  if (below == 1) {
    if (x[1] - x[0] < level_face) return {};
    return cube(area / ((x[1] - x[0]) * (x[2] - x[0])), x[0]);
  }
  Cubic sum{{-area * mean, area, 0, 0}};
  if (below == 2 && x[2] - x[1] >= level_face)
    sum.add(cube(area / ((x[2] - x[0]) * (x[2] - x[1])), x[2]), -1);
  return sum;
}

/// Disjoint sets of the numbers below n.
class Sets {
 public:
  int make() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int of(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Joins the set of `from` to that of `to`, whose name it takes.
  void join(int from, int to) { parent_[of(from)] = of(to); }
  int size() const { return static_cast<int>(parent_.size()); }

 private:
  std::vector<int> parent_;
};

/// A part of the surface below the height that the sweep has reached.
struct Part {
  Cubic below;
  std::vector<int> basins;  ///< Basins that may be pockets; empty if it has met the outside.
};

/// A candidate for a pocket: what runs down to one local minimum.
struct Basin {
  int lowest = 0;  ///< Vertex.
  double spill = std::numeric_limits<double>::infinity();
};

/// Visits the vertices from the lowest to the highest.
class Sweep {
 public:
  Sweep(const TriMesh& mesh, const Eigen::Vector3d& up);
  void run();

  /// Basin of each vertex, or kSea.
  int basin_of(int vertex) {
    const int basin = named_.of(label_[vertex]);
    return basin == sea_ ? kSea : basin;
  }
  const Basin& basin(int i) const { return basins_[i]; }
  double height(int vertex) const { return x_[vertex]; }
  double equal_height() const { return kEqualHeight * range_; }
  double least_volume() const { return least_volume_; }

 private:
  void visit(int vertex);
  void give(Part& part, int basin);
  void meet_inside(Part& a, int label_a, Part& b, int label_b, double x);
  void meet_outside(Part& part, double x);
  void meet(int vertex, int neighbour);
  void advance_face(int face, int part);
  int lowest_visited(int vertex) const;

  const TriMesh& mesh_;
  Eigen::VectorXd x_;                  ///< Heights of the vertices.
  Eigen::VectorXd area_;               ///< Signed sections of the faces.
  double range_ = 0;                   ///< Range of the heights.
  double least_volume_ = 0;            ///< Least volume of a pocket.
  std::vector<int> order_, place_;     ///< Vertices by height, and the inverse.
  std::vector<int> first_, faces_at_;  ///< Faces at each vertex.
  std::vector<int> below_;             ///< Corners of each face that have been visited.
  std::vector<int> part_of_;           ///< Name of a vertex in `sets_`.
  std::vector<int> label_;             ///< Basin of a vertex that has been visited.
  Sets sets_;
  std::vector<Part> parts_;
  Sets named_;  ///< Basins; joined ones are one.
  std::vector<Basin> basins_;
  int sea_ = 0;  ///< The basin that stands for the sea.
};

Sweep::Sweep(const TriMesh& mesh, const Eigen::Vector3d& up)
    : mesh_(mesh),
      x_(mesh.vertices.transpose() * up),
      area_(mesh.face_count()),
      order_(mesh.vertex_count()),
      place_(mesh.vertex_count()),
      first_(mesh.vertex_count() + 1, 0),
      faces_at_(3 * mesh.face_count()),
      below_(mesh.face_count(), 0),
      part_of_(mesh.vertex_count(), -1),
      label_(mesh.vertex_count(), kSea) {
  range_ = x_.maxCoeff() - x_.minCoeff();
  least_volume_ = kLeastPocket * bounding_box(mesh).volume();
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    area_[f] = area_vector(mesh, f).dot(up);
    for (int i = 0; i < 3; ++i) ++first_[mesh.faces(i, f) + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (int f = 0; f < mesh.face_count(); ++f)
    for (int i = 0; i < 3; ++i) faces_at_[next[mesh.faces(i, f)]++] = f;
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(),
            [this](int a, int b) { return x_[a] != x_[b] ? x_[a] < x_[b] : a < b; });
  for (int i = 0; i < mesh.vertex_count(); ++i) place_[order_[i]] = i;
  sea_ = named_.make();
  basins_.emplace_back();
}

int Sweep::lowest_visited(int vertex) const {
  int lowest = vertex;
  for (int k = first_[vertex]; k < first_[vertex + 1]; ++k)
    for (int i = 0; i < 3; ++i) {
      const int other = mesh_.faces(i, faces_at_[k]);
      if (place_[other] < place_[lowest]) lowest = other;
    }
  return lowest;
}

/// One more corner of the face is below: the face's column takes its next form.
void Sweep::advance_face(int face, int part) {
  std::array<int, 3> v = {mesh_.faces(0, face), mesh_.faces(1, face), mesh_.faces(2, face)};
  const auto order = [this](int& a, int& b) {
    if (place_[b] < place_[a]) std::swap(a, b);
  };
  order(v[0], v[1]);
  order(v[1], v[2]);
  order(v[0], v[1]);
  const std::array<double, 3> x = {x_[v[0]], x_[v[1]], x_[v[2]]};
  Cubic& below = parts_[part].below;
  const double level_face = kLevelFace * range_;
  if (below_[face] > 0) below.add(column(area_[face], x, below_[face], level_face), -1);
  below.add(column(area_[face], x, ++below_[face], level_face), 1);
}

/// Joins the basins of a part to another one.
void Sweep::give(Part& part, int basin) {
  for (const int i : part.basins) named_.join(i, basin);
  part.basins.clear();
}

/// Two parts meet, and the water on both sides joins: two pockets, or a pocket and what it
/// encloses.
void Sweep::meet_inside(Part& a, int label_a, Part& b, int label_b, double x) {
  const double volume_a = a.below.volume(x), volume_b = b.below.volume(x);
  const double least = std::max(least_volume_, kLeastPart * std::max(volume_a, volume_b));
  if (volume_a < std::min(least, volume_b)) return give(a, label_b);
  if (volume_b < least) return give(b, label_a);
  for (const Part* part : {&a, &b})
    for (const int i : part->basins) basins_[i].spill = std::min(basins_[i].spill, x);
}

/// A part meets the body that encloses it, or two bodies meet: its pockets overflow into the sea.
void Sweep::meet_outside(Part& part, double x) {
  if (part.below.area(x) <= 0 || part.below.volume(x) < least_volume_) return give(part, sea_);
  for (const int i : part.basins) basins_[i].spill = std::min(basins_[i].spill, x);
  part.basins.clear();
}

/// Joins the part of `neighbour` to that of `vertex`, where they meet.
void Sweep::meet(int vertex, int neighbour) {
  const int first = sets_.of(part_of_[vertex]), second = sets_.of(part_of_[neighbour]);
  const double x = x_[vertex];
  Part& a = parts_[first];
  Part& b = parts_[second];
  const bool begin =
      std::abs(a.below.volume(x)) < least_volume_ && std::abs(b.below.volume(x)) < least_volume_;
  if (begin || a.below.area(x) + b.below.area(x) > 0) {
    meet_inside(a, label_[vertex], b, label_[neighbour], x);
  } else {
    meet_outside(a, x);
    meet_outside(b, x);
  }
  a.basins.insert(a.basins.end(), b.basins.begin(), b.basins.end());
  a.below.add(b.below, 1);
  sets_.join(second, first);
}

void Sweep::visit(int vertex) {
  const int lowest = lowest_visited(vertex);
  if (lowest == vertex) {
    part_of_[vertex] = sets_.make();
    const int basin = named_.make();
    basins_.push_back({.lowest = vertex});
    parts_.push_back({.below = {}, .basins = {basin}});
    label_[vertex] = basin;
  } else {
    part_of_[vertex] = sets_.of(part_of_[lowest]);
    label_[vertex] = label_[lowest];
    for (int k = first_[vertex]; k < first_[vertex + 1]; ++k)
      for (int i = 0; i < 3; ++i) {
        const int other = mesh_.faces(i, faces_at_[k]);
        if (place_[other] >= place_[vertex]) continue;
        if (sets_.of(part_of_[other]) != sets_.of(part_of_[vertex])) meet(vertex, other);
      }
  }
  const int part = sets_.of(part_of_[vertex]);
  for (int k = first_[vertex]; k < first_[vertex + 1]; ++k) advance_face(faces_at_[k], part);
}

void Sweep::run() {
  for (const int vertex : order_) visit(vertex);
  const double top = x_.maxCoeff();
  for (int i = 0; i < sets_.size(); ++i) {
    if (sets_.of(i) != i) continue;
    const bool is_void = parts_[i].below.volume(top) >= least_volume_;
    for (const int basin : parts_[i].basins)
      if (!is_void) named_.join(basin, sea_);
  }
}

/// The basin of a face, or kSea: that of its lowest corner; of several at one height, the sea's.
int basin_of_face(Sweep& sweep, const Eigen::Vector3i& face) {
  int lowest = face[0];
  for (const int v : face)
    if (sweep.height(v) < sweep.height(lowest)) lowest = v;
  for (const int v : face)
    if (sweep.height(v) <= sweep.height(lowest) + sweep.equal_height() && sweep.basin_of(v) == kSea)
      return kSea;
  return sweep.basin_of(lowest);
}

/// Volume below a height of the columns that stand on faces [m^3].
double volume_over(const TriMesh& mesh, const std::vector<int>& faces, const Sweep& sweep,
                   const Eigen::Vector3d& up, double height) {
  double sum = 0;
  for (const int f : faces) {
    const auto v = mesh.faces.col(f);
    const Panel panel = {mesh.vertices.col(v[0]), mesh.vertices.col(v[1]), mesh.vertices.col(v[2])};
    Eigen::Vector3d depth;
    for (int i = 0; i < 3; ++i) depth[i] = height - sweep.height(v[i]);
    for (const PanelPart& part : positive_part(panel, depth))
      sum += area_vector(part.panel).dot(up) * part.value.sum() / 3;
  }
  return sum;
}

std::vector<SillEdge> find_sills(const TriMesh& mesh, const std::vector<int>& pocket_of_face) {
  std::vector<SillEdge> sills;
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  for (std::size_t i = 0; i < edges.size(); i = edge_end(edges, i))
    for (std::size_t j = i + 1, end = edge_end(edges, i); j < end; ++j) {
      const int a = pocket_of_face[edges[j - 1].face], b = pocket_of_face[edges[j].face];
      if (a == b) continue;
      const auto [low, high] = std::minmax(a, b);
      sills.push_back({.pocket = low == kSea ? high : low,
                       .other = low == kSea ? kSea : high,
                       .from = edges[j].low,
                       .to = edges[j].high});
    }
  std::stable_sort(sills.begin(), sills.end(), [](const SillEdge& a, const SillEdge& b) {
    return std::pair(a.pocket, a.other) < std::pair(b.pocket, b.other);
  });
  return sills;
}

}  // namespace

Pockets find_pockets(const TriMesh& mesh, const Eigen::Vector3d& up) {
  Pockets found;
  if (mesh.face_count() == 0) return found;
  Sweep sweep(mesh, up);
  sweep.run();
  std::map<int, std::vector<int>> faces_of;  // by the lowest vertex of the basin
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int basin = basin_of_face(sweep, mesh.faces.col(f));
    if (basin != kSea) faces_of[sweep.basin(basin).lowest].push_back(f);
  }
  const double top = (mesh.vertices.transpose() * up).maxCoeff();
  for (auto& [lowest, faces] : faces_of) {
    const double spill = sweep.basin(sweep.basin_of(lowest)).spill;
    const double capacity = volume_over(mesh, faces, sweep, up, std::min(spill, top));
    if (capacity < sweep.least_volume()) continue;
    found.pockets.push_back({.faces = std::move(faces),
                             .lowest = lowest,
                             .floor = sweep.height(lowest),
                             .spill = spill,
                             .capacity = capacity});
  }
  if (found.pockets.empty()) return found;
  found.pocket_of_face.assign(mesh.face_count(), kSea);
  for (std::size_t i = 0; i < found.pockets.size(); ++i)
    for (const int f : found.pockets[i].faces) found.pocket_of_face[f] = static_cast<int>(i);
  found.sills = find_sills(mesh, found.pocket_of_face);
  return found;
}

bool is_convex(const TriMesh& mesh) {
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  const double round_off = kEqualHeight * bounding_box(mesh).sizes().norm();
  for (std::size_t i = 0; i < edges.size(); i = edge_end(edges, i)) {
    if (edge_end(edges, i) != i + 2) return false;
    const Eigen::Vector3d normal = area_vector(mesh, edges[i].face).normalized();
    const Eigen::Vector3d on = mesh.vertices.col(edges[i].low);
    for (const int v : mesh.faces.col(edges[i + 1].face))
      if (normal.dot(mesh.vertices.col(v) - on) > round_off) return false;
  }
  return true;
}

}  // namespace hydro
