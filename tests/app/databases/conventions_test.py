"""conventions_test.py PROGRAM: databases in foreign conventions give the numbers that were solved.

A tilted box without symmetry is solved by the program. Its numbers are written here, by numpy and
h5py, as other programs write them: about another point, with turned axes, another origin of the
waves' phase, other units and the other time convention. What the program makes of these files must
be what it has solved. Ends with 77, skipped, where there is no numpy or h5py.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import h5py
    import numpy as np
except ImportError:
    print("skipped: there is no numpy or h5py")
    sys.exit(77)

RHO, G = 1025.0, 9.81
SCENE = """
plimsoll: 1
duration: 1
gravity: 9.81
water: {{density: 1025, surface: {{waves: [{{amplitude: 0.1, wavelength: 30}}]}}}}
bodies:
  - {{name: box, box: {{size: [8, 4, 2], divisions: 3}}, mass: 32800, center_of_mass: [0.3, 0.2, 0.1],
     inertia: [5e4, 2e5, 2e5, 0, 0, 0], start: equilibrium{hydro}}}
"""
FREQUENCIES = "0.4,0.6,0.8,1,1.2,1.5,1.9,2.4,3,3.8"
MOTIONS = ["Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"]
# The file's frame: the centre of mass and the reference point in it, and the heading of its x axis.
CENTER = np.array([1.5, -0.7])
REFERENCE = np.array([0.9, 0.4, -0.6])


def cross(r):
    return np.array([[0, -r[2], r[1]], [r[2], 0, -r[0]], [-r[1], r[0], 0]])


def solid(turn):
    return np.kron(np.eye(2), turn)


class Truth:
    """What was solved, about the centre of mass: A (F x 6 x 6), X (F x 6 x headings), with units."""

    def __init__(self, body):
        rows = body["frequencies"]
        self.omega = np.array([row["omega"] for row in rows])
        self.beta = np.array(body["headings"])
        self.height = body["height"]
        self.volume = body["displaced_volume"]
        self.A = np.array([row["added_mass"] for row in rows])
        self.B = np.array([row["damping"] for row in rows])
        self.A_inf = np.array(body["infinite_added_mass"])
        self.FK, self.D = (
            np.array([np.array(row[f"{name}_real"]).T + 1j * np.array(row[f"{name}_imag"]).T
                      for row in rows]).reshape(len(rows), 6, len(self.beta))
            for name in ("froude_krylov", "diffraction"))


class Foreign:
    """The same in the file's frame."""

    def __init__(self, truth, heading_deg, phase_origin=(0, 0)):
        alpha = np.radians(heading_deg)
        c, s = np.cos(alpha), np.sin(alpha)
        to_file = solid(np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]))
        self.center = np.array([*CENTER, truth.height])
        # The velocity of the centre by that of the reference point.
        shift = np.eye(6)
        shift[:3, 3:] = -cross(self.center - REFERENCE)
        move = lambda M: shift.T @ to_file @ M @ to_file.T @ shift
        self.omega, self.volume = truth.omega, truth.volume
        self.A, self.B, self.A_inf = move(truth.A), move(truth.B), move(truth.A_inf)
        beta = np.mod(truth.beta - alpha, 2 * np.pi)
        order = np.argsort(beta)
        self.beta = beta[order]
        along = np.array([np.cos(beta), np.sin(beta)]).T @ (CENTER - np.array(phase_origin))
        k = truth.omega**2 / G
        phase = np.exp(1j * k[:, None, None] * along)
        loads = lambda X: ((shift.T @ to_file) @ X * phase)[:, :, order]
        self.FK, self.D = loads(truth.FK), loads(truth.D)
        self.X = self.FK + self.D


def write_capytaine(file, f, names=("",), alphabetical=False):
    """NetCDF-4 as xarray writes it; the second of two bodies is ten times the first."""
    motions = sorted(MOTIONS) if alphabetical else MOTIONS
    order = [MOTIONS.index(m) for m in motions]
    dofs = [name + ("__" if name else "") + m for name in names for m in motions]
    n = len(names)

    def spread(M):
        block = M[..., order, :][..., order]
        wide = np.zeros(M.shape[:-2] + (6 * n, 6 * n))
        for b in range(n):
            wide[..., 6 * b:6 * b + 6, 6 * b:6 * b + 6] = block * (1 if b == 0 else 10)
        return wide

    def loads(X):  # complex, omega, wave_direction, influenced_dof
        each = np.concatenate([X[:, order] * (1 if b == 0 else 10) for b in range(n)], axis=1)
        each = each.transpose(0, 2, 1)
        blank = np.full((1, *each.shape[1:]), np.nan)
        each = np.concatenate([blank, each])
        return np.array([each.real, each.imag])

    with h5py.File(file, "w") as out:
        def scale(name, data):
            out[name] = data
            out[name].make_scale(name)

        def array(name, data, dimensions):
            out[name] = data
            for i, dimension in enumerate(dimensions):
                out[name].dims[i].attach_scale(out[dimension])

        text = h5py.string_dtype()
        scale("omega", np.concatenate([[np.inf], f.omega]))
        scale("radiating_dof", np.array(dofs, dtype=text))
        scale("influenced_dof", np.array(dofs, dtype=text))
        scale("wave_direction", f.beta)
        scale("complex", np.array(["re", "im"], dtype=text))
        scale("body", np.array(names, dtype=text))
        scale("space_coordinate", np.array(["x", "y", "z"], dtype=text))
        out["rho"], out["g"], out["water_depth"] = RHO, G, np.inf
        both = ("omega", "radiating_dof", "influenced_dof")
        # The matrices are symmetric, so the order of the two dimensions does not matter.
        array("added_mass", spread(np.concatenate([[f.A_inf], f.A])), both)
        array("radiation_damping", spread(np.concatenate([[0 * f.A_inf], f.B])), both)
        waves = ("complex", "omega", "wave_direction", "influenced_dof")
        array("Froude_Krylov_force", loads(f.FK), waves)
        array("diffraction_force", loads(f.D), waves)
        array("rotation_center", np.tile(REFERENCE, (n, 1)), ("body", "space_coordinate"))
        array("center_of_mass", np.tile(f.center, (n, 1)), ("body", "space_coordinate"))
        array("disp_mass", RHO * f.volume * np.array([1, 10][:n]), ("body",))


def write_bemio(file, f, scaled, scattering=True, body=1, coupling=0):
    """For e^{+iωt}; the file's reference point is the centre of gravity. coupling: matrices of the
    other bodies' columns, over the body's own."""
    with h5py.File(file, "w") as out:
        p = "simulation_parameters/"
        out[p + "w"], out[p + "wave_dir"] = f.omega[:, None], np.degrees(f.beta)[:, None]
        out[p + "rho"], out[p + "g"], out[p + "scaled"] = [[RHO]], [[G]], [[float(scaled)]]
        out[p + "water_depth"] = "infinite"
        unit = 1 if scaled else RHO
        for b in range(1, body + 1):
            g = f"body{b}/hydro_coeffs/"
            factor = 1 if b == body else 7
            wide = lambda M: np.concatenate([coupling * M] * (b - 1) + [factor * M] +
                                            [coupling * M] * (body - b), axis=-1)
            out[g + "added_mass/all"] = wide(f.A / unit).transpose(1, 2, 0)
            out[g + "added_mass/inf_freq"] = wide(f.A_inf / unit)
            B = f.B if scaled else f.B / (RHO * f.omega[:, None, None])
            out[g + "radiation_damping/all"] = wide(B).transpose(1, 2, 0)
            for name, X in (("", f.X), ("scattering/", f.D), ("froude-krylov/", f.FK)):
                X = np.conj(X if scaled else X / (RHO * G)).transpose(1, 2, 0) * factor
                if name and not scattering:
                    X = X * np.nan
                out[g + f"excitation/{name}re"], out[g + f"excitation/{name}im"] = X.real, X.imag
            q = f"body{b}/properties/"
            out[q + "name"], out[q + "cg"] = np.bytes_(f"hull{b}"), REFERENCE[:, None]
            out[q + "disp_vol"] = [[f.volume]]


def write_wamit(stem, f, length, first=1):
    """For e^{+iωt}, by a length; the motions are numbered from `first`."""
    power = np.array([0, 0, 0, 1, 1, 1])
    unit = length ** (3 + power[:, None] + power[None, :])
    with open(f"{stem}.1", "w") as out:
        print(" WAMIT Numeric Output -- Filename  box.1", file=out)
        for period, A, B in [(0, f.A_inf, None), (-1, f.A[0], None)] + [
                (2 * np.pi / w, A, B / w) for w, A, B in zip(f.omega, f.A, f.B)]:
            for i in range(6):
                for j in range(6):
                    tail = "" if B is None else f" {B[i, j] / RHO / unit[i, j]:.13E}"
                    print(f" {period:.13E} {i + first} {j + first} {A[i, j] / RHO / unit[i, j]:.13E}"
                          + tail, file=out)
    with open(f"{stem}.3", "w") as out:
        for w, X in zip(f.omega, f.X):
            for h, beta in enumerate(f.beta):
                for i in range(6):
                    x = np.conj(X[i, h]) / (RHO * G * length ** (2 + power[i]))
                    print(f" {2 * np.pi / w:.13E} {np.degrees(beta):.10f} {i + first} {abs(x):.13E}"
                          f" {np.degrees(np.angle(x)):.9f} {x.real:.13E} {x.imag:.13E}", file=out)


def write_nemoh(folder, f, phase_origin):
    """Moduli and angles for e^{−iωt}, in SI units."""
    (folder / "Results").mkdir(parents=True)
    x, y, z = REFERENCE
    rows = "".join(f"2 {a} {x} {y} {z} ! about a point\n" for a in ("1 0 0", "0 1 0", "0 0 1"))
    six = "6 ! number\n1 1 0 0 0 0 0 ! x\n1 0 1 0 0 0 0 ! y\n1 0 0 1 0 0 0 ! z\n" + rows
    (folder / "Nemoh.cal").write_text(
        f"--- Environment ---\n{RHO} ! RHO\n{G} ! G\n0 ! DEPTH\n{phase_origin[0]} {phase_origin[1]} "
        f"! XEFF YEFF\n--- Bodies ---\n1 ! Number\n--- Body 1 ---\nmesh\\box.dat ! Name\n10 10 ! n\n"
        + six + six + "0 ! additional lines\n--- Load cases ---\n")
    def rows_of(tables):
        return "\n".join(" ".join(f"{n:.13E}" for n in row) for row in tables) + "\n"

    with open(folder / "Results/RadiationCoefficients.tec", "w") as out:
        out.write('VARIABLES="w (rad/s)"\n' +
                  "".join(f'"A 1 {i}" "B 1 {i}"\n' for i in range(1, 7)))
        for j in range(6):
            out.write(f'Zone t="Motion of body 1 in DoF {j + 1}",I={len(f.omega)},F=POINT\n')
            pairs = np.stack([f.A[:, :, j], f.B[:, :, j]], axis=-1).reshape(len(f.omega), 12)
            out.write(rows_of(np.column_stack([f.omega, pairs])))
    for name, X in (("ExcitationForce", f.X), ("DiffractionForce", f.D), ("FKForce", f.FK)):
        with open(folder / f"Results/{name}.tec", "w") as out:
            out.write('VARIABLES="w (rad/s)"\n' +
                      "".join(f'"abs(F 1 {i})" "angle(F 1 {i})"\n' for i in range(1, 7)))
            for h, beta in enumerate(f.beta):
                out.write(f'Zone t="{name} - beta = {np.degrees(beta):.12f} deg",F=POINT\n')
                pairs = np.stack([abs(X[:, :, h]), np.angle(X[:, :, h])], axis=-1)
                out.write(rows_of(np.column_stack([f.omega, pairs.reshape(len(f.omega), 12)])))


class Conventions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.kept.name)
        cls.truth = Truth(cls.numbers("", "--frequencies", FREQUENCIES))
        cls.turned = Foreign(cls.truth, 30)

    @classmethod
    def call(cls, hydro, *options):
        scene = cls.folder / "box.yaml"
        scene.write_text(SCENE.format(hydro=hydro and f", hydro: {{radiation: {hydro}}}"))
        return subprocess.run([program, "radiation", str(scene), "--json", "--no-store", *options],
                              capture_output=True, text=True)

    @classmethod
    def numbers(cls, hydro, *options):
        done = cls.call(hydro, *options)
        if "built without" in done.stderr:
            raise unittest.SkipTest("the program was built without HDF5")
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)["bodies"]["box"]

    def expect_truth(self, body, tolerance, loads=None, infinite=None):
        found, truth = Truth(body), self.truth
        np.testing.assert_allclose(found.omega, truth.omega, rtol=1e-12)
        self.assertEqual(len(found.beta), len(truth.beta))
        for name in ("A", "B", "A_inf", "FK", "D"):
            have, want = getattr(found, name), getattr(truth, name)
            bound = (loads if name in ("FK", "D") else infinite if name == "A_inf" else None)
            # Forces and moments are compared apart, as they differ in size.
            for rows in (slice(0, 3), slice(3, 6)):
                have_rows, want_rows = (M[rows] if M.ndim == 2 else M[:, rows] for M in (have, want))
                error = abs(have_rows - want_rows).max() / abs(want_rows).max()
                self.assertLess(error, bound or tolerance, f"{name}, rows {rows}")

    def test_capytaine_of_several_bodies_with_motions_in_any_order(self):
        write_capytaine(self.folder / "two.nc", self.turned, ("box", "tug"), alphabetical=True)
        body = self.numbers("{file: two.nc, body: box, heading_deg: 30}")
        self.expect_truth(body, 1e-9)
        self.assertIn("6 further motions are left out", body["notes"])
        write_capytaine(self.folder / "one.nc", self.turned)
        self.expect_truth(self.numbers("{file: one.nc, heading_deg: 30}"), 1e-9)

    def test_bemio_with_and_without_units(self):
        for scaled in (False, True):
            write_bemio(self.folder / "box.h5", self.turned, scaled, body=2)
            body = self.numbers("{file: box.h5, body: hull2, heading_deg: 30, "
                                f"center_of_mass: [1.5, -0.7, {self.truth.height}]}}")
            self.expect_truth(body, 1e-9)

    def test_excitation_alone_gives_the_diffraction_by_the_mesh(self):
        write_bemio(self.folder / "total.h5", self.turned, False, scattering=False)
        body = self.numbers("{file: total.h5, heading_deg: 30, "
                            f"center_of_mass: [1.5, -0.7, {self.truth.height}]}}")
        # The program that solved took the forces at the points of its patches.
        self.expect_truth(body, 1e-9, loads=3e-3)
        self.assertIn("Froude-Krylov forces: those on the mesh", body["notes"])

    def test_the_other_bodies_of_bemio_push_in_long_waves(self):
        hydro = ("{file: pair.h5, body: hull2, heading_deg: 30, "
                 f"center_of_mass: [1.5, -0.7, {self.truth.height}]}}")
        write_bemio(self.folder / "pair.h5", self.turned, False, scattering=False, body=2)
        self.expect_truth(self.numbers(hydro), 1e-9, loads=3e-3)
        # The excitation lacks what this coupling would add to it.
        write_bemio(self.folder / "pair.h5", self.turned, False, scattering=False, body=2,
                    coupling=30)
        self.assertIn("excitation in long waves at 0.6 rad/s", self.call(hydro).stderr)

    def test_wamit_with_a_length(self):
        write_wamit(self.folder / "box", self.turned, 2.5, first=7)
        body = self.numbers(
            "{file: box.1, body: 2, heading_deg: 30, length: 2.5, reference_point: [0.9, 0.4, -0.6], "
            f"center_of_mass: [1.5, -0.7, {self.truth.height}]}}")
        self.expect_truth(body, 1e-9, loads=3e-3)

    def test_nemoh_without_the_limit(self):
        write_nemoh(self.folder / "nemoh", Foreign(self.truth, 30, (2, 3)), (2, 3))
        body = self.numbers("{file: nemoh/Results/RadiationCoefficients.tec, heading_deg: 30, "
                            f"center_of_mass: [1.5, -0.7, {self.truth.height}]}}")
        # Ten frequencies give A∞ within some 3 %.
        self.expect_truth(body, 1e-9, infinite=0.05)
        self.assertIn("by Ogilvie's relation", " ".join(body["notes"]))

    def test_headings_between_ours_are_interpolated(self):
        write_capytaine(self.folder / "odd.nc", Foreign(self.truth, 33))
        body = self.numbers("{file: odd.nc, heading_deg: 33}")
        self.expect_truth(body, 1e-9, loads=2e-3)
        odd = Foreign(self.truth, 33)
        write_capytaine(self.folder / "even.nc", odd)
        self.assertGreater(
            abs(Truth(self.numbers("{file: even.nc, heading_deg: 30}")).D - self.truth.D).max(),
            0.01 * abs(self.truth.D).max())

    def test_the_other_time_convention_is_refused(self):
        wrong = Foreign(self.truth, 30)
        wrong.FK, wrong.D = wrong.FK.conj(), wrong.D.conj()
        write_capytaine(self.folder / "wrong.nc", wrong)
        done = self.call("{file: wrong.nc, heading_deg: 30}")
        self.assertEqual(done.returncode, 2)
        self.assertIn("bodies[0].hydro.radiation.file", done.stderr)
        self.assertIn("Froude-Krylov force at", done.stderr)
        # Where the file has the excitation alone, the push of its longest waves tells.
        write_bemio(self.folder / "wrong.h5", wrong, False, scattering=False)
        wrong.X = wrong.X.conj()
        write_bemio(self.folder / "wrong.h5", wrong, False, scattering=False)
        done = self.call("{file: wrong.h5, heading_deg: 30, "
                         f"center_of_mass: [1.5, -0.7, {self.truth.height}]}}")
        self.assertIn("excitation in long waves at 0.6 rad/s", done.stderr)

    def test_a_run_tells_its_file_and_the_checks(self):
        write_capytaine(self.folder / "run.nc", self.turned)
        scene = self.folder / "run.yaml"
        scene.write_text(SCENE.format(hydro=", hydro: {radiation: {file: run.nc, heading_deg: 30}}"))
        done = subprocess.run([program, "run", str(scene), "--set", "duration=0.2", "--out",
                               str(self.folder / "out")], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout + done.stderr, "box +run.nc +10 ")
        summary = json.loads((self.folder / "out/summary.json").read_text())
        told = summary["bodies"]["box"]["radiation"]
        self.assertEqual((told["source"], told["format"], told["notes"]), ("file", "Capytaine", []))
        self.assertEqual(pathlib.Path(told["file"]).name, "run.nc")
        for name in ("asymmetry of added mass", "least eigenvalue of damping",
                     "damping against Haskind's relation", "displaced volume against the mesh",
                     "Froude-Krylov force against the mesh"):
            self.assertLess(abs(told["checks"][name]), 0.01, name)

    def test_a_wrong_point_is_refused(self):
        write_capytaine(self.folder / "point.nc", self.turned)
        for wrong in ("heading_deg: 60", "heading_deg: 30, reference_point: [0, 0, 3]",
                      "heading_deg: 30, center_of_mass: [4, 0, 0]"):
            done = self.call(f"{{file: point.nc, {wrong}}}")
            self.assertEqual(done.returncode, 2, wrong)
            self.assertIn("reference_point, center_of_mass or heading_deg may be wrong",
                          done.stderr)

    def test_a_damaged_file_is_a_fault(self):
        write_capytaine(self.folder / "whole.nc", self.turned)
        self.numbers("{}".format("auto"), "--frequencies", "1", "--capytaine",
                     str(self.folder / "classic.nc"))
        write_bemio(self.folder / "whole.h5", self.turned, False)
        for name in ("whole.nc", "classic.nc", "whole.h5"):
            whole = (self.folder / name).read_bytes()
            for part in (0, 3, 40, 200, 1000, len(whole) // 2, len(whole) - 3000):
                cut = self.folder / f"cut{pathlib.Path(name).suffix}"
                cut.write_bytes(whole[:part])
                done = self.call(f"{{file: {cut.name}}}")
                self.assertEqual(done.returncode, 2, f"{name} cut at {part}: {done.stderr}")
                self.assertIn(cut.name, done.stderr)

    def test_a_wrong_entry_is_named(self):
        wrong = Foreign(self.truth, 30)
        wrong.A = wrong.A.copy()
        wrong.A[3, 1, 4] = np.nan
        write_capytaine(self.folder / "nan.nc", wrong)
        done = self.call("{file: nan.nc}")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, "nan.nc: added mass at 1 rad/s, row (2, column 5|5, column 2): "
                                      "expected a finite number")
        wrong = Foreign(self.truth, 30)
        wrong.B = wrong.B.copy()
        # A single frequency that contradicts itself is left out.
        wrong.B[2:, 0, 2] += 0.5 * abs(wrong.B[:, :3, :3]).max()
        write_bemio(self.folder / "odd.h5", wrong, False)
        self.assertIn("damping at 0.8 rad/s: found", self.call("{file: odd.h5}").stderr)
        with h5py.File(self.folder / "odd.h5", "a") as file:
            del file["body1/hydro_coeffs/added_mass/all"]
            file["body1/hydro_coeffs/added_mass/all"] = np.zeros((6, 6, 3))
        self.assertIn("added_mass/all has the shape 6 x 6 x 3, expected 6 x 6 x 10",
                      self.call("{file: odd.h5}").stderr)


if __name__ == "__main__":
    program = sys.argv.pop(1)
    unittest.main()
