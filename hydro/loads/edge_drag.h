#pragma once

#include <vector>

#include "hydro/loads/hull_lift.h"
#include "hydro/mesh/mesh.h"
#include "hydro/spatial.h"

/// @file
/// The drag of a body's sharp edges in motion to and fro.
///
/// At an edge of 90° the water that flows about it has the potential A r^(2/3) at the distance r,
/// and sheds a vortex in every stroke. By Graham's similarity of the vortex [G80] the power that it
/// takes is ρ A³ for a length of the edge, whatever the amplitude of the motion:
///
///     P = c ρ ∫ |A|³ dl,        F = −c ρ ∫ |A| A a dl,        A = a·u                          (1)
///
/// with the velocity u of the body relative to the water, of which A is a linear function. So the
/// load takes energy in any motion, is quadratic, and its matrix is symmetric. A follows from the
/// two sides i of the edge, the parts of the surface between sharp edges that meet there,
///
///     A = (√2/|n_1 − n_2|) (w_1^⅓/E_1 n_1·v(p_1) − w_2^⅓/E_2 n_2·v(p_2)),                   (2)
///     E = √(1 + 1.464 (w/l)^1.65)                                                           (3)
///
/// with their normals n_i, widths w_i and lengths l_i, and the points p_i halfway between the edge
/// and the middle of the side, measured across the edge. The exact A of plane flow about rectangles
/// with sides from 1:1 to 6:1, by conformal mapping: (2) is 2 to 13 % less for motion across the
/// long side, 2 to 9 % more along it, and 2 to 14 % less for turns about the middle
/// (edge_drag_test.cpp). By the ends of a side the flow is less than plane: E, of 1 for a strip and
/// ½π for a disc, is the complete elliptic integral in the potential of a flat ellipse [L32 §108],
/// as it is approximated for cracks.
///
/// c follows from measured rolling: with the exact A the formula of Ikeda and others [I93] for
/// barges with sharp bilges has c from 0.70 to 0.80 at breadths of 2 to 12 draughts. An edge that
/// turns the surface by less than 90° sheds less, and by less than 60° nothing. An edge that turns
/// it by more counts as one of 90°: for a plate Graham has P as KC^(−⅓), which a thin box meets at
/// a Keulegan–Carpenter number of 2.4.
///
/// [G80] Graham. The forces on sharp-edged cylinders in oscillatory flow at low Keulegan–Carpenter
///       numbers. J. Fluid Mech. 97 (1980) 331-346.
/// [L32] Lamb. Hydrodynamics, 6th edition (1932).
/// [I93] Ikeda, Fujiwara, Katayama. Roll damping of a sharp-cornered barge and roll control by a
///       new-type stabilizer. Proc. 3rd ISOPE (1993).

namespace hydro {

/// c of (1) [-].
inline constexpr double kEdgeDrag = 0.75;
/// Turns of the surface at which an edge begins to shed, and sheds in full [rad]. Smaller: the
/// edges of coarse round meshes shed.
inline constexpr double kLeastTurn = 1.0471975511965976, kFullTurn = 1.5707963267948966;

/// The sharp edges of a body. It is constant.
class EdgeDrag {
 public:
  /// @param mesh_B   Closed; its origin is the centre of mass.
  explicit EdgeDrag(const TriMesh& mesh_B);

  bool none() const { return edges_.empty(); }

  /// (1) over the part below the surface, in W, with its moment about the centre of mass.
  Wrench load(const BodyState& state, const HullWater& water) const;
  /// The derivative of (1) with respect to (v, ω) in W: symmetric, without positive eigenvalues.
  Matrix6d jacobian(const BodyState& state, const HullWater& water) const;

 private:
  struct Edge {
    Eigen::Vector3d from, to;  ///< In B [m].
    Vector6d a;                ///< ∛c a of (1), in B.
  };
  std::vector<Edge> edges_;
};

}  // namespace hydro
