#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The negative controls of CI: faults that are planted one at a time, each of which its stage must catch.

usage: plant.py --list       the faults, and the stage that must catch each
       plant.py --dry [NAME...]      whether each fault still fits the sources as they are; runs nothing
       plant.py --control [NAME...]  the stages concerned without a fault, which must all be good
       plant.py [NAME...]    plants these faults, or all, and runs the stages: hours

Works in a clone of HEAD in build/planted: what is not committed is not tried. What `dev` says of a fault stays in
build/plants/NAME.log. Exit status: 0 all are caught, 1 one is not or does not fit, 2 usage.
"""
import os
import re
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
CLONE, KEPT = ROOT / "build/planted", ROOT / "build/plants"
DEEP = {"watched", "mutants", "long", "cache", "bench", "foreign"}  # stages that a change does not run
# What a stage is made of: `sanitizers` links the tests of `build`, `fuzz` and `tidy` take what `sanitizers` builds.
# Stages that are not named here build what they need.
BEFORE = {"tests": ["build"], "sanitizers": ["build"], "fuzz": ["build", "sanitizers"], "tidy": ["build", "sanitizers"],
          "watched": ["build", "sanitizers"], "mutants": ["build"], "long": ["build"], "foreign": ["build"]}


class Plant(NamedTuple):
    """`old`, which the file has exactly once, becomes `new`. An empty `old`: `new` is appended, or is a new file."""
    name: str
    stage: str
    what: str
    file: str
    old: str
    new: str
    log: str  # what the log of the stage must have: another failure is not this fault
    why: str  # which check is to see it

    @property
    def depth(self):
        return "deep" if self.stage in DEEP else "run"

    @property
    def stages(self):
        return [*BEFORE.get(self.stage, []), self.stage]


def failed(suites):
    """A failed test of these suites, which may have parameters."""
    return rf"\[  FAILED  \] (\w+/)?({suites})\."


PLANTS = [
    # Faults of every kind: one for each stage.
    Plant("format", "format", "a line that clang-format would write otherwise", "harness/exact/polar.cpp",
          "const double omega = g.rate * p.h;  // (30)", "const double omega=g.rate*p.h;  // (30)",
          r"clang-format-violations", "clang-format reads every source"),
    Plant("warning", "build", "a variable that nobody uses", "harness/exact/polar.cpp",
          "const double omega = g.rate * p.h;  // (30)", "const double omega = g.rate * p.h, spare = omega;  // (30)",
          r"error: unused variable .spare", "in CI a warning of g++ is an error"),
    Plant("scene", "tests", "a misspelled key in a scene", "configs/motions/bar_1d.yaml",
          "transfer: aflip", "transfr: aflip", r"transfr",
          "the suites that read every scene, and Yaml.ShippedFilesAreValid, which takes the JSON Schema"),
    Plant("leak", "sanitizers", "a reader of tables that is never deleted", "drivers/format/csv.cpp",
          "CsvRows rows(CsvLines(text, file), required, optional);",
          "CsvRows& rows = *new CsvRows(CsvLines(text, file), required, optional);",
          r"LeakSanitizer: detected memory leaks", "the watched suites Csv and Npy read tables; no result is wrong"),
    Plant("out_of_bounds", "sanitizers", "one particle more than there are", "mpm/simulation.cpp",
          "for (std::size_t p = 0; p < s.particles; ++p) {", "for (std::size_t p = 0; p <= s.particles; ++p) {",
          r"AddressSanitizer: heap-buffer-overflow", "each watched test that makes a Simulation writes past a column"),
    Plant("fuzz", "fuzz", "zero passes where a number must be positive", "harness/numeric/range.cpp",
          "(lower_open ? value > lower : value >= lower)", "value >= lower", r"libFuzzer: |Sanitizer: ",
          "a density, a spacing or an end of 0 breaks a promise of tests/fuzz/composition.cpp"),
    Plant("tidy", "tidy", "a text that is copied at each call", "drivers/format/csv.cpp",
          "std::string csv_remedy(const std::string& text) {", "std::string csv_remedy(const std::string text) {",
          r"performance-unnecessary-value-param", ".clang-tidy has performance-*, and no compiler warns of this"),
    Plant("include", "alone", "a missing #include that no unit of a whole floor needs", "mpm/data/crew.cpp",
          "#include <deque>\n", "", r"deque.* (in namespace|is not a member|does not name|incomplete)",
          "crew.cpp changed, so it is compiled by itself; in its unit another source may bring <deque>"),
    Plant("link", "site", "a link to a page that is not there", "docs/development.md",
          "", "\nSee also [the page that is not there](no_such_page.md).\n", r"no_such_page",
          "a warning of sphinx is an error, and docs/site/check_links.py follows every link"),
    Plant("race", "races", "threads take their next piece of work without an atomic counter", "mpm/data/crew.hpp",
          "std::atomic<std::size_t> next{0};", "std::size_t next{0};", r"ThreadSanitizer: data race",
          "Crew, Blocks and Sweep share loops among threads; most runs of a race give the right result"),
    Plant("cost", "spine", "a damping that no scene asks for, of coefficient 0, at each particle", "mpm/simulation.cpp",
          "  begun_ = true;\n  last_dt_ = dt;\n",
          "  for (int d = 0; d < Dim; ++d) {\n    for (std::size_t p = 0; p < state_.particles; ++p)\n"
          "      state_.column(Column::velocity, d)[p] *= std::exp(-0.0 * state_.column(Column::mass)[p]);\n  }\n"
          "  begun_ = true;\n  last_dt_ = dt;\n",
          r"FAILED\s+composed: \+", "bench/compare_spine.py counts instructions of a step; every result is the same"),
    Plant("package", "package", "a package that does not say which libraries it needs", "cmake/package.cmake",
          "set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)", "set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS OFF)",
          r"error while loading shared libraries|try_package: FAILED", "only a bare system lacks these libraries"),
    Plant("rare_leak", "watched", "a leak where names are ordered", "drivers/text/natural_order.cpp",
          "const std::string n = number(a, i), m = number(b, k);",
          "const std::string &n = *new std::string(number(a, i)), &m = *new std::string(number(b, k));",
          r"LeakSanitizer: detected memory leaks", "NaturalOrder and JudgeOfRuns are not in tests/sanitized.cmake"),
    Plant("slow_mutant", "mutants", "a check that takes as long as the time of the scene", "drivers/scene/scene_check.cpp",
          "    check_title();\n    check_dimension();\n",
          "    check_title();\n    check_dimension();\n"
          "    for (volatile double t = 0; t < scene_.time.end;) t = t + 1e-6;\n",
          r"  took [\d.]+ s of CPU\n|exit status (-1|137|152)\n",
          "LongMutants bounds the processor time; 6 of 10,000 mutants end so late, and none of the 300 of `tests`"),
    Plant("not_installed", "long", "the header of the library is not installed", "cmake/install.cmake",
          "install(FILES drivers/library/assay.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})\n", "",
          r"Downstream\.InstalledPackage \.*\*\*\*Failed", "Downstream.InstalledPackage builds a client of it"),
    Plant("cache", "cache", "the compiler cache sees the path of the checkout", "dev",
          'export CCACHE_BASEDIR="$root" CCACHE_NOHASHDIR=1', "export CCACHE_NOHASHDIR=1",
          r"the second clone: .* (\d|[1-8]\d|9[0-4])\.\d % hits", "a second clone must find 95 % of its compilations"),
    Plant("bench", "bench", "a benchmark whose scene has a misspelled key", "bench/bench_exact.cpp",
          "material: {density: 1000, ", "material: {denstiy: 1000, ", r"denstiy", "nobody else runs the benchmarks"),
    Plant("foreign", "foreign", "a sign in the interpolation in time that others take",
          "drivers/templates/export/common/force_table.c.in",
          "w0 = -s * (s - 1) * (s - 2) / 6,", "w0 = s * (s - 1) * (s - 2) / 6,", r"NOT as expected: order",
          "foreign/export_csv, which needs a compiler and no package, loses its order; so does TableRoutines in `tests`"),

    # Wrong physics and wrong book-keeping that compile, run and crash nowhere: two or more on each floor.
    Plant("inertia_sign", "tests", "the sign of the printed (33): inertia along E_Theta", "harness/exact/polar.cpp",
          "R * g.acceleration * p.h - divergence.theta / density};",
          "-R * g.acceleration * p.h - divergence.theta / density};", failed("BodyForce|BodyForceField"),
          "BodyForce.BalancesMomentumAgainstABruteForceDivergence and .IsThePapersClosedFormWithItsErratum"),
    Plant("push_forward", "tests", "the Cauchy stress of points is turned the other way", "harness/exact/polar_places.cpp",
          "const Tensor sigma = r * cauchy_stress(tau, B) * r.transpose();",
          "const Tensor sigma = r.transpose() * cauchy_stress(tau, B) * r;", failed("Places|ExactFields"),
          "Places.AgreeWithTheMotionAndWithInstants: instants compute it in polar.cpp, by themselves"),
    Plant("umat_fence", "tests", "what a UMAT writes past its arrays is not told", "adapters/foreign/umat.cpp",
          'if (broken) throw PointFailure(overrun_words + ("the UMAT " + *broken));', "static_cast<void>(broken);",
          failed("PlaneStressUmat|RemoteHistories|Misbehaves"),
          "PlaneStressUmat of tests/adapters/foreign/test_plane_stress.cpp and RemoteHistories ask for 'writes past'"),
    Plant("vumat_order", "tests", "13 and 23 of a VUMAT's stress are exchanged", "adapters/foreign/vumat.cpp",
          "read_symmetric(a[block.stress[1]] + p, explicit_order, plain_shear, block.n)",
          "read_symmetric(a[block.stress[1]] + p, standard_order, plain_shear, block.n)",
          failed(r"\w*Vumat\w*|ForeignNeoHookean|GoodForeignModel|\w*Foreign\w*"),
          "GoodForeignModel and ForeignNeoHookean compare with built-in models in shears out of the plane"),
    Plant("spline", "tests", "a coefficient of the quadratic B-spline, wrong by 1e-4", "mpm/basis/basis_bspline.hpp",
          "value[1] = 0.75 - f * f;", "value[1] = 0.7501 - f * f;", failed("BsplineBasisTest|EveryBasisTest"),
          "EveryBasisTest: functions sum to one and reproduce linear fields"),
    Plant("apic_inertia", "tests", "APIC divides by twice the inertia of a particle's surroundings",
          "mpm/kernels/variants/to_particles.hpp",
          "B[c] = moments.B[c][k], D[c] = moments.D[c][k];", "B[c] = moments.B[c][k], D[c] = 2 * moments.D[c][k];",
          failed(r"Accounts|EveryPatchedMethod\w*|PatchTests\w*|EveryMethod|TransferPasses\w*|MethodsTable"),
          "the patch tests of APIC: a linear field of velocity is kept; Accounts: angular momentum is"),
    Plant("inch", "tests", "an inch of 25.4 cm", "drivers/text/units.cpp",
          '{"in", length, {254, 1e4}, true},', '{"in", length, {254, 1e3}, true},', failed(r"Units|SceneUnits"),
          "Units of tests/drivers/text/test_units.cpp has the inch in metres"),
    Plant("check_status", "tests", "`assay check` ends with 0 though the model fails", "drivers/check/check.cpp",
          "const int own = checked.passes() ? 0 : checked.error.empty() ? 1 : 2;",
          "const int own = checked.passes() ? 0 : checked.error.empty() ? 0 : 2;", failed(r"Check\w*"),
          "Check.AFailureLeavesAReplayThatFailsAgain and others ask for 1"),
    Plant("csv_column", "tests", "errors.csv has the largest velocity error in the column of the mean",
          "drivers/output/errors_csv.hpp", "return s.velocity.l2; }}", "return s.velocity.linf; }}", failed("ErrorsCsv"),
          "ErrorsCsv.has_one_column_a_field_and_norm compares each column"),
    Plant("junit_count", "tests", "JUnit files count failures as errors", "drivers/output/junit.cpp",
          'attribute("errors", count(JunitCase::Kind::error))', 'attribute("errors", count(JunitCase::Kind::failure))',
          failed(r"\w*J[Uu]nit\w*"), "Junit and RunJUnit compare the counts"),
]


def planted(plant, folder):
    """The text of the file with the fault; ValueError if it does not fit."""
    path = folder / plant.file
    if not plant.old:
        return (path.read_text(encoding="utf-8") if path.is_file() else "") + plant.new
    text = path.read_text(encoding="utf-8") if path.is_file() else ""
    if text.count(plant.old) != 1:
        raise ValueError(f"{plant.file} has {text.count(plant.old)} times, and must have once: {plant.old.strip()}")
    return text.replace(plant.old, plant.new)


def git(*words, at=CLONE):
    done = subprocess.run(["git", "-C", str(at), *words], capture_output=True, text=True, check=False, env=environment())
    if done.returncode != 0:
        sys.exit(f"plant.py: git {' '.join(words)}: {done.stderr.strip()}")
    return done.stdout.strip()


def environment(**more):
    # GIT_DIR and its like, as hooks have them, would lead to the wrong repository.
    return {name: value for name, value in os.environ.items() if not name.startswith("GIT_")} | more


def fresh_clone():
    """HEAD without a fault; the commit. What earlier plants built stays, so that each compiles only what it changes."""
    head = git("rev-parse", "HEAD", at=ROOT)
    if not (CLONE / ".git").exists():
        CLONE.parent.mkdir(exist_ok=True)
        git("clone", "-q", "--no-checkout", str(ROOT), str(CLONE), at=ROOT)
    git("fetch", "-q", "origin", "HEAD")
    git("checkout", "-q", "-f", "--detach", head)
    git("clean", "-q", "-fd", "-e", "build")
    return head


def run_dev(name, deep, stages, base):
    """Exit status and words of `dev`."""
    for old in (CLONE / "build/stages").glob("*"):
        old.unlink()  # the log of an earlier plant is no finding of this one
    (CLONE / "build/tidy.log").unlink(missing_ok=True)
    KEPT.mkdir(parents=True, exist_ok=True)
    log = KEPT / f"{name}.log"
    # The bare system of `package` is the same for all, and takes minutes to make.
    clean_root = os.environ.get("ASSAY_CLEAN_ROOT", str(ROOT / "build/clean_root"))
    with log.open("w", encoding="utf-8") as out:
        status = subprocess.run(["./dev", "test", "--deep" if deep else "--all", *stages], cwd=CLONE, stdout=out,
                                stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, check=False,
                                env=environment(CI="true", ASSAY_BASE=base, ASSAY_CLEAN_ROOT=clean_root)).returncode
    return status, log.read_text(encoding="utf-8", errors="replace")


def verdict(said, stage):
    found = re.search(rf"^dev: ---- {stage}: (\w+)$", said, re.MULTILINE)
    return found[1] if found else "did not run"


def log_of(stage):
    logs = [CLONE / f"build/stages/{stage}.log"] + [CLONE / "build/tidy.log"] * (stage == "tidy")  # it has its own
    return "".join(log.read_text(encoding="utf-8", errors="replace") for log in logs if log.is_file())


def try_plant(plant):
    """What is wrong; empty where the fault is caught."""
    base = fresh_clone()
    try:
        text = planted(plant, CLONE)
    except ValueError as misfit:
        return str(misfit)
    (CLONE / plant.file).write_text(text, encoding="utf-8")
    git("add", "-A")
    git("-c", "user.name=plant", "-c", "user.email=plant@localhost", "commit", "-q", "--no-verify", "-m", plant.what)
    status, said = run_dev(plant.name, plant.depth == "deep", plant.stages, base)
    if status != 1:
        return f"exit status {status}"
    if (found := verdict(said, plant.stage)) != "FAILED":
        return f"{plant.stage}: {found}"
    if not re.search(plant.log, log_of(plant.stage)):
        return f"{plant.stage} failed, but its log does not have /{plant.log}/"
    return ""


def try_all(plants):
    missed = 0
    for plant in plants:
        began = time.monotonic()
        wrong = try_plant(plant)
        missed += bool(wrong)
        minutes = (time.monotonic() - began) / 60
        print(f"{plant.name:14} {plant.stage:10} {minutes:6.1f} min  " +
              (f"NOT caught: {wrong}; see build/plants/{plant.name}.log" if wrong else "caught"), flush=True)
    print(f"{len(plants) - missed} of {len(plants)} are caught")
    return 1 if missed else 0


def control(plants):
    stages = sorted({stage for plant in plants for stage in plant.stages})
    status, said = run_dev("control", any(plant.depth == "deep" for plant in plants), stages, fresh_clone() + "^")
    for stage in stages:
        print(f"{stage:10} {verdict(said, stage)}")
    return 0 if status == 0 else 1


def dry(plants):
    misfits = 0
    for plant in plants:
        try:
            planted(plant, ROOT)
        except ValueError as misfit:
            misfits += 1
            print(f"{plant.name:14} {misfit}")
    print(f"{len(plants) - misfits} of {len(plants)} fit")
    return 1 if misfits else 0


def list_all(plants):
    for plant in plants:
        print(f"{plant.name:14} {plant.stage:10} {plant.depth:4}  {plant.what}; {plant.why}")
    return 0


def main(words):
    verbs = {"--list": list_all, "--dry": dry, "--control": control}
    verb = verbs.get(words[0] if words else "")
    names = words[1:] if verb else words
    known = {plant.name: plant for plant in PLANTS}
    unknown = [name for name in names if name not in known]
    if unknown:
        print(__doc__ if unknown[0].startswith("-") else f"plant.py: unknown: {' '.join(unknown)}; known: {' '.join(known)}",
              file=sys.stderr)
        return 2
    return (verb or try_all)([known[name] for name in names] or PLANTS)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
