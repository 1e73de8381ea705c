# SPDX-License-Identifier: BSD-3-Clause
"""What all blind cases share: the lines of the codes that are changed, the methods, and how a scene is written."""
RING = ["body={domain: ring, lattice: polar, per_cell: [2, 2]}"]
# Where the codes have what is changed: FEniCSx, the box in FEniCSx, and the quadrilaterals.
FX_FORCE = "return force(t)[row]"
FX_INNER = "- inner / (DENSITY * volume)"
FX_BEGIN = "    frames = [(0.0, X.copy(), v)]"
FX_END = "        sys.exit(f\"{folder}: the nodes of the mesh are not those of seeds.csv\")\n"
FX_ASSAY = FX_END + "    import assay\n    known = assay.Problem('scene.yaml')\n"
FX_SMALL = [("strain = (F.T * F - ufl.Identity(F.ufl_shape[0])) / 2", "strain = (F.T + F) / 2 - ufl.Identity(2)")]
BOX_BEGIN = "frames = [(0.0, X.copy(), v.copy())]"
Q_B = 'b = points(t, "b")[:, :2]'
Q_BEGIN = "frames = [(0.0, x.copy(), v.copy())]"
Q_LOADS = '    """Forces on the nodes but for those of the stress."""\n'
Q_T = "T = surface.tractions(t, N)[:, :2]"
Q_P = "P = stress(F, dt, memory)"
BACK = ("\n    place = points(t, 'x')[:, :2] @ [1, 1j]\n"
        "    turn = (X @ [1, 1j]) / place * abs(place) / np.hypot(*X.T)\n"
        "    b = b @ [1, 1j] {} turn\n    b = np.stack([b.real, b.imag], 1)")

GOOD = ("{basis: bspline2, formulation: total, transfer: aflip, mass: series, terms: 4, integrator: leapfrog,"
        " courant: 0.4}")
CPDI = "{basis: cpdi2, transfer: aflip, mass: series, terms: 2, integrator: leapfrog, courant: 0.4}"
PIC = "{basis: bspline2, formulation: total, transfer: pic, courant: 0.4}"
FLIP = "{basis: linear, formulation: total, transfer: flip, courant: 0.4}"
XPIC = "{basis: ugimp, formulation: total, transfer: xpic, terms: 3, courant: 0.4}"
APIC = "{basis: ugimp, formulation: total, transfer: apic, courant: 0.4}"


def text_of(name, motions, materials):
    """The text of scene `motion_material`."""
    motion, material = name.split("_")
    way, (kind, low, high), end = motions[motion]
    body = f"body: {{domain: square, lower: [{low}, {low}], upper: [{high}, {high}]" + (
        ", outside: free}\n" if way.startswith("{type: vortex") else "}\n") if kind == "box" else ""
    return f"motion: {way}\nmaterial: {materials[material]}\n{body}time: {{end: {end!r}}}\n"
