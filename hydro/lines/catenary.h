#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

/// @file
/// Tensions of a mooring line at rest: the elastic catenary, quasi-static.
///
/// A line of the unstretched length L, the weight w per length in water and the stiffness EA hangs
/// between an anchor and a fairlead. It has no bending stiffness and stretches linearly; current,
/// inertia and drag do not act on it. With H and V the horizontal and vertical tension at the
/// fairlead, V_a = V − wL, T = √(H² + V²), T_a = √(H² + V_a²) and S = T + T_a, a line that touches
/// nothing spans [Ir81]
///
///     x = (2H/w) artanh(wL/S) + HL/EA,     z = L (V + V_a) (1/S + 1/(2EA))                  (1)
///
/// This is the familiar (H/w)(asinh V/H − asinh V_a/H) and (T − T_a)/w, written so that nothing
/// cancels for light and taut lines. On a flat bottom, where V < wL, the length L_B = L − V/w
/// rests; the rest is (1) with V_a = 0, and friction C_B w per length takes tension off the
/// resting part until nothing is left of it, at the distance m from the touchdown point [Jo07]:
///
///     x = L_B + (H m − ½ C_B w m²)/EA + x_1(H, V, V/w),    m = min(L_B, H/(C_B w))           (2)
///     z = z_1(H, V, V/w)
///
/// For every x > 0 and z there is one (H, V). Newton's method finds it in log H and V; where it
/// does not converge, bisection does: at constant z, x grows with H, and at constant H, z with V.
///
/// Frame    The vertical plane of the line: the anchor at (0, 0), x from the anchor to the
///          fairlead, z up.
/// Errors   std::invalid_argument if an argument is not finite or out of the range that is given.
///
/// [Ir81] Irvine, Cable Structures, MIT Press 1981, chapter 1.
/// [Jo07] Jonkman, Dynamics Modeling and Loads Analysis of an Offshore Floating Wind Turbine,
///        NREL/TP-500-41958, 2007, section 2.4.2.

namespace hydro {

/// A uniform line.
struct CatenaryLine {
  double length = 0;     ///< Unstretched, > 0 [m].
  double weight = 0;     ///< Per unstretched length, in water, >= 0 [N/m].
  double stiffness = 0;  ///< EA, > 0 [N].
  double friction = 0;   ///< Coefficient of friction C_B of the bottom, >= 0 [-].
};

/// The tensions of a line and their change as the fairlead moves.
struct CatenarySolution {
  /// The properties of the line.
  enum class Form {
    slack,      ///< On a bottom it hangs vertically and H = 0; without weight it has no tension.
    on_bottom,  ///< A part of it rests on the bottom.
    suspended,  ///< It touches nothing, and is at least as long as the distance of its ends.
    taut        ///< It touches nothing, and is stretched to a greater distance than its length.
  };

  double horizontal = 0;         ///< Pull on the fairlead towards the anchor, >= 0 [N].
  double vertical = 0;           ///< Pull on the fairlead, downwards positive [N].
  double anchor_horizontal = 0;  ///< Pull on the anchor towards the fairlead, >= 0 [N].
  double anchor_vertical = 0;    ///< Pull on the anchor, upwards positive: V_a [N].
  double resting = 0;            ///< Unstretched length on the bottom, L_B [m].

  /// ∂(H, V)/∂(x, z) [N/m], symmetric and positive semi-definite. Without friction it is the exact
  /// derivative; with it the symmetric part of that, as friction is not conservative. Where the
  /// fairlead meets the bottom V grows as √z: the derivative has no bound there, and at z = 0
  /// itself its vertical part is given as zero.
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();

  Form form = Form::slack;  ///< Shape of the line.

  /// At the fairlead [N].
  double tension() const { return Eigen::Vector2d(horizontal, vertical).norm(); }
};

/// Solves (1) or (2) to round-off.
///
/// The error of the tensions is that of x and z in double precision times the stiffness. The
/// solution is continuous in x and z, also where its form changes.
///
/// @param x       Horizontal span, >= 0 [m].
/// @param z       Height of the fairlead above the anchor [m], of any sign. With a bottom, a
/// fairlead
///                below it has the tensions of one on it.
/// @param bottom  Whether the anchor lies on a flat bottom that carries the line.
/// @param start   (H, V) near the solution, which saves time and changes nothing else; values that
///                are of no use are ignored.
CatenarySolution solve_catenary(const CatenaryLine& line, double x, double z, bool bottom,
                                const std::optional<Eigen::Vector2d>& start = {});

/// Points of the line from the anchor (0, 0) to the fairlead (x, z), for pictures, at equal
/// distances of the unstretched line.
///
/// The resting part of a slack line is drawn straight, though it is longer; so is a slack line
/// without weight.
///
/// @param solution  Solution for the same line, x and z.
/// @param count     >= 2.
std::vector<Eigen::Vector2d> catenary_shape(const CatenaryLine& line,
                                            const CatenarySolution& solution, double x, double z,
                                            int count);

}  // namespace hydro
