// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "drivers/system/input_file.hpp"
#include "drivers/text/sha256.hpp"
#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scene_text.hpp"

namespace assay::drivers::test_scene_reader {
namespace {

std::string refused(const std::string& text, const std::vector<std::string>& sets = {}) {
  return refusal_of([&] { scene_from_text(text, "f.yaml", sets); });
}
std::string refused_extra(const std::string& extra) { return refused(scene_text(extra)); }
std::string refused_set(const std::string& setting) { return refused(scene_text(), {setting}); }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(SceneReader, ReadsEveryKeyOfTheVortex) {
  const Scene s = scene_from_text(
      "title: T\n"
      "motion: {type: vortex, inner: 0.5, outer: 1.5, period: 2, profile_power: 3, allow_unstable: true,\n"
      "         amplitude: {type: ramp, peak: -.25}}\n"
      "material: {adapter: neo_hookean, parameters: {E: 2e3, nu: 0.2}, density: 900}\n"
      "body: {domain: box, outside: free, lower: [-2, -3], upper: [4, 5], per_cell: [3, 4], lattice: cartesian}\n"
      "grid: {spacing: 0.25, lower: [-5, -6], upper: [7, 8]}\n"
      "method: {basis: ugimp, formulation: updated, transfer: pic, update: musl, mass: lumped, courant: 0.25}\n"
      "force: {response: closed_form, evaluation: point, tolerance: 1e-8}\n"
      "time: {end: 3, step: 1e-3}\n"
      "output: {errors: 7, particles: 0, pictures: false, report: false, accounts: false}\n"
      "limits: {memory_gib: 2, particle_steps: 1e6}\n"
      "expect: {outcome: unstable, error.l2_max: {below: .5}, steps: 3, t: {between: [1, 2]}, dt: {above: 0}}\n",
      "f.yaml");
  const Vortex& v = *s.motion.as<Vortex>();
  EXPECT_EQ(s.title, "T");
  EXPECT_EQ(v.inner, 0.5);
  EXPECT_EQ(v.outer, 1.5);
  EXPECT_EQ(v.profile_power, 3);
  EXPECT_EQ(v.amplitude.type, Amplitude::Type::ramp);
  EXPECT_EQ(v.amplitude.peak, -0.25);
  EXPECT_EQ(v.amplitude.period, 2);
  EXPECT_TRUE(s.allow_unstable);
  EXPECT_EQ(s.material.adapter, "neo_hookean");
  EXPECT_EQ(s.material.parameters, (std::map<std::string, double>{{"E", 2e3}, {"nu", 0.2}}));
  EXPECT_EQ(s.material.density, 900);
  EXPECT_EQ(s.body.domain, Body::Domain::box);
  EXPECT_EQ(s.body.outside, Body::Outside::free);
  EXPECT_EQ(s.body.lower, (std::array<double, 2>{-2, -3}));
  EXPECT_EQ(s.body.upper, (std::array<double, 2>{4, 5}));
  EXPECT_EQ(s.body.per_cell, (std::array<int, 2>{3, 4}));
  EXPECT_EQ(s.grid->spacing, 0.25);
  EXPECT_EQ(*s.grid->lower, (std::array<double, 2>{-5, -6}));
  EXPECT_EQ(*s.grid->upper, (std::array<double, 2>{7, 8}));
  EXPECT_EQ(s.method->basis, mpm::Basis::ugimp);
  EXPECT_EQ(s.method->transfer, mpm::Transfer::pic);
  EXPECT_EQ(s.method->update, mpm::Update::musl);
  EXPECT_EQ(s.method->courant, 0.25);
  EXPECT_EQ(s.force.response, ForceChoice::Response::closed_form);
  EXPECT_EQ(s.force.tolerance, 1e-8);
  EXPECT_EQ(s.time.end, 3);
  EXPECT_EQ(s.time.step, 1e-3);
  EXPECT_EQ(s.output.errors, 7);
  EXPECT_EQ(s.output.particles, 0);
  EXPECT_FALSE(s.output.pictures || s.output.report || s.output.accounts);
  EXPECT_EQ(s.limits.memory_gib, 2);
  EXPECT_EQ(s.limits.particle_steps, 1e6);
  ASSERT_EQ(s.expect.size(), 5u);
  EXPECT_EQ(s.expect[0].text, "unstable");
  EXPECT_EQ(s.expect[1].key, "error.l2_max");
  EXPECT_EQ(s.expect[1].op, Expectation::Operator::below);
  EXPECT_EQ(s.expect[1].number, 0.5);
  EXPECT_EQ(s.expect[2].op, Expectation::Operator::equals);
  EXPECT_EQ(s.expect[3].upper, 2);
  EXPECT_EQ(s.expect[4].op, Expectation::Operator::above);
}

TEST(SceneReader, FillsDefaults) {
  const Scene s = scene_from_text(scene_text(), "f.yaml");
  EXPECT_EQ(s.motion.as<Vortex>()->inner, 0.75);
  EXPECT_EQ(s.body.domain, Body::Domain::ring);
  EXPECT_EQ(s.body.outside, Body::Outside::free);
  EXPECT_FALSE(s.grid || s.method || s.time.step);
  EXPECT_EQ(scene_from_text(scene_text("body: {domain: square}"), "f").body.outside, Body::Outside::held);
  EXPECT_EQ(scene_from_text(scene_text(), "f", {"motion.period=3"}).time.end, 3) << "one period";
  const Scene h = scene_from_text(homogeneous_text(), "f.yaml");
  EXPECT_EQ(h.body.domain, Body::Domain::square);
  EXPECT_EQ(h.motion.as<Homogeneous>()->final(0, 1), 0.1);
}

TEST(SceneReader, KeepsPlacesAndTheHash) {
  const std::string text = scene_text("body: {domain: ring}\n");
  const Scene s = scene_from_text(text, "f.yaml");
  EXPECT_EQ(s.sha256, sha256_hex(text));
  EXPECT_EQ(s.file, "f.yaml");
  EXPECT_EQ(s.material.where.text(), "f.yaml:2:21");
  EXPECT_EQ(s.material.parameter_where.at("E").text(), "f.yaml:2:50");
  EXPECT_EQ(s.place("body").text(), "f.yaml:3:7");
}

TEST(SceneReader, EveryShippedSceneIsRead) {
  ASSERT_FALSE(all_configs().empty());
  for (const std::string& file : all_configs()) EXPECT_EQ(refusal_of([&] { read_scene(file); }), "accepted") << file;
}

TEST(SceneReader, RefusesUnknownKeysWithTheNearest) {
  EXPECT_EQ(
      refused_extra("grdi: {spacing: 1}\n"),
      "f.yaml:3:1: grdi: unknown key (nearest: grid); known: title, dimension, units, motion, frame, material, body, "
      "grid, method, force, traction, remedies, time, output, limits, expect");
  EXPECT_EQ(refused_extra("grid: {spacng: 1}\n"),
            "f.yaml:3:8: grid.spacng: unknown key (nearest: spacing); known: spacing, offset, lower, upper");
  EXPECT_TRUE(has(refused_set("motion.amplitude.pek=1"), "--set motion.amplitude.pek: unknown key (nearest: peak)"));
  EXPECT_TRUE(has(refused_extra("expect: {error.l2: {below: 1}}"), "expect.error.l2: unknown key (nearest: error.l2_"));
  EXPECT_TRUE(has(refused_extra("expect: {t: {belwo: 1}}"), "3:14: expect.t.belwo: unknown key (nearest: below)"));
}

TEST(SceneReader, RefusesWrongTypes) {
  EXPECT_EQ(refused_extra("grid: {spacing: abc}\n"), "f.yaml:3:17: grid.spacing: must be a number, found 'abc'");
  EXPECT_EQ(refused_extra("grid: {spacing: '0.1'}\n"),
            "f.yaml:3:17: grid.spacing: must be a number, found '0.1' in quotes, which make it a text: write 0.1");
  EXPECT_EQ(refused_extra("grid: 5\n"),
            "f.yaml:3:7: grid: must be a map of keys, found '5'; known: spacing, offset, lower, upper");
  EXPECT_EQ(refused_extra("grid:\n"),
            "f.yaml:3:1: grid: must be a map of keys, found nothing; known: spacing, offset, lower, upper");
  EXPECT_EQ(refused_extra("title: [a]\n"), "f.yaml:3:8: title: must be text, found a list");
  EXPECT_EQ(refused_extra("output: {pictures: yes}\n"),
            "f.yaml:3:20: output.pictures: must be true or false, found 'yes': write true");
  EXPECT_TRUE(has(refused_set("method.basis=[1]"), "--set method.basis: must be a word, found a list; known: linear"));
  EXPECT_TRUE(has(refused_set("body.per_cell=2"), "must be a list of 2 whole numbers, found '2'"));
  EXPECT_TRUE(has(refused_set("body.per_cell=[2]"), "must be a list of 2 whole numbers, found 1 in it"));
  EXPECT_TRUE(has(refused_set("body.per_cell=[2, 1.5]"), "body.per_cell[1]: must be a whole number, found '1.5'"));
  EXPECT_TRUE(has(refused_set("material.parameters=3"), "must be a map of keys"));
  EXPECT_TRUE(has(refused_set("material.parameters.E=soft"), "must be a number, found 'soft'"));
  EXPECT_TRUE(
      has(refused("[1, 2]\n"),
          "f.yaml:1:1: must be a map of keys, found a list: its keys stand without '-' and brackets; known: title"));
  EXPECT_TRUE(has(refused_extra("expect: {outcome: {below: 3}}"), "unknown key; known: equals"));
  EXPECT_TRUE(
      has(refused_extra("expect: {outcome: finished}"), "known: completed, unstable, material_failed, refused"));
  EXPECT_TRUE(has(refused_extra("expect: {steps: many}"), "expect.steps: must be a number, found 'many'"));
  EXPECT_TRUE(has(refused_extra("expect: {t: {below: 1, above: 0}}"), "exactly one operator"));
  EXPECT_TRUE(has(refused_extra("expect: {t: {}}"), "exactly one operator"));
  EXPECT_TRUE(has(refused_extra("expect: {t: {between: [2, 1]}}"), "the first must not exceed the second"));
}

TEST(SceneReader, RefusesNumbersOutOfRange) {
  for (const char* value : {"-0.05", "0", "-0", ".nan", ".inf", "-.inf", "1e999", "0x10", "\"1,5\"", "1.2.3"}) {
    EXPECT_TRUE(has(refused_set("grid.spacing=" + std::string(value)), "--set grid.spacing: must be ")) << value;
  }
  for (const char* value : {"[0, 2]", "[2, 17]", "[-1, 2]", "[2.5, 2]", "[1e99, 2]", "[.nan, 2]"}) {
    EXPECT_TRUE(has(refused_set("body.per_cell=" + std::string(value)), "--set body.per_cell[")) << value;
  }
  EXPECT_TRUE(has(refused_set("motion.profile_power=1"), "must be from 2 to 64, found '1'"));
  EXPECT_TRUE(has(refused_set("motion.inner=0"), "must be greater than 0"));
  EXPECT_TRUE(has(refused_set("motion.inner=1.25"), "--set motion.inner: must be less than motion.outer"));
  EXPECT_TRUE(has(refused_set("motion.period=0"), "greater than 0"));
  EXPECT_TRUE(has(refused_set("material.density=-1"), "greater than 0"));
  EXPECT_TRUE(has(refused_set("method.courant=0"), "must be greater than 0 and at most 1"));
  EXPECT_TRUE(has(refused_set("force.tolerance=1"), "from 1e-14 to 0.01"));
  EXPECT_TRUE(has(refused_set("time.step=2"), "--set time.step: must not exceed time.end"));
  EXPECT_TRUE(has(refused_set("output.errors=0"), "from 1 to"));
  EXPECT_TRUE(has(refused_set("limits.memory_gib=0"), "greater than 0"));
  EXPECT_EQ(refused_set("grid.spacing=.5"), "accepted");
  EXPECT_EQ(refused_set("output.errors=1e2"), "accepted");
}

TEST(SceneReader, RefusesWhatLaterVersionsMayKnow) {
  EXPECT_TRUE(has(refused_set("method.basis=bspline5"),
                  "unknown value 'bspline5' (nearest: bspline2); known: linear, ugimp, cpgimp, cpdi, cpdi2, bspline2, "
                  "bspline3, bspline4"));
  EXPECT_TRUE(has(refused_set("method.transfer=picflip"), "known: pic, flip, xpic, fmpm, apic, aflip"));
  EXPECT_TRUE(has(refused_set("force.evaluation=corner_average"), "known: point, domain_average"));
  EXPECT_TRUE(has(refused_set("motion.type=taylor_bar"), "known: vortex, homogeneous"));
  EXPECT_TRUE(has(refused_set("body.lattice=random"), "known: cartesian, polar, gauss, jittered"));
}

TEST(SceneReader, RefusesMethodsThatMakeNoSenseWithTheReason) {
  const auto refused_method = [](const std::string& method) {
    return refused(scene_text("grid: {spacing: .1}\n"), {"method=" + method});
  };
  EXPECT_TRUE(
      has(refused_method("{basis: cpgimp, formulation: total}"), "do not stretch in the reference configuration"));
  EXPECT_TRUE(has(refused_method("{transfer: fmpm, mass: series}"), "series of the mass matrix themselves"));
  EXPECT_TRUE(has(refused_method("{transfer: pic, mass: series}"), "is transfer: fmpm"));
  EXPECT_TRUE(has(refused_method("{basis: linear, transfer: apic, affine: moment}"), "set affine: gradient"));
  EXPECT_TRUE(has(refused_method("{transfer: apic, flip: 0.9}"), "blends flip or aflip"));
  EXPECT_TRUE(has(refused_method("{transfer: flip, terms: 3}"),
                  "method.terms: belongs to mass: series and to transfer: xpic or fmpm, but the method"));
  EXPECT_TRUE(has(refused_method("{transfer: flip, affine: moment}"),
                  "method.affine: belongs to transfer: apic and aflip, but transfer is flip"));
  EXPECT_TRUE(has(refused_method("{transfer: xpic, terms: 0}"), "from 1 to 100"));
  EXPECT_TRUE(has(refused_method("{integrator: symplectic_rkn4}"), "take formulation: total"));
  EXPECT_TRUE(has(refused_method("{formulation: total, transfer: aflip, integrator: symplectic_rkn4}"),
                  "method.transfer: symplectic_rkn4 has no place for the gradient"));
  EXPECT_TRUE(has(refused_method("{formulation: total, transfer: xpic, integrator: symplectic_rkn4}"), "take flip"));
  EXPECT_TRUE(has(refused_method("{formulation: total, flip: 0.9, integrator: symplectic_rkn4}"), "method.flip: "));
  EXPECT_TRUE(has(refused_method("{formulation: total, update: usf, integrator: symplectic_rkn4}"), "take usl"));
  EXPECT_TRUE(has(refused_method("{integrator: symplectic4}"), "known: symplectic_euler, leapfrog, symplectic_rkn4"));
  EXPECT_EQ(refused(scene_text("grid: {spacing: .1}\nmethod: {transfer: flip, integrator: symplectic_rkn4}\n"), {})
                .find("f.yaml:4:"),
            0u);
  for (const char* good :
       {"{basis: bspline2, formulation: total, transfer: aflip, mass: series, terms: 4}",
        "{formulation: total, mass: consistent, integrator: symplectic_rkn4}", "{transfer: flip, flip: 0.95}",
        "{transfer: xpic, terms: 5}", "{mass: consistent}", "{transfer: apic, affine: moment, integrator: leapfrog}"}) {
    EXPECT_EQ(refused_method(good), "accepted") << good;
  }
}

TEST(SceneReader, GivesInertiaToParticlesWhereThatMakesSense) {
  const auto refused_with = [](const std::string& method, const std::string& force) {
    return refused(scene_text("grid: {spacing: .1}\n"), {"method=" + method, "force=" + force});
  };
  EXPECT_TRUE(has(refused_with("{transfer: flip}", "{inertia: particles, response: none}"),
                  "needs a body force, but force.response is none"));
  EXPECT_TRUE(has(refused_with("{transfer: apic, affine: moment}", "{inertia: particles}"), "set affine: gradient"));
  EXPECT_TRUE(has(refused_with("{formulation: total, integrator: symplectic_rkn4}", "{inertia: particles}"),
                  "force.inertia: "));
  EXPECT_EQ(refused_with("{transfer: aflip}", "{inertia: particles}"), "accepted");
  EXPECT_EQ(scene_from_text(scene_text(), "f.yaml", {}).force.inertia, mpm::Inertia::grid);
}

TEST(SceneReader, AveragesByDefaultAndClipsTheRingThatItAveragesOver) {
  const auto body_of = [](const std::vector<std::string>& sets) {
    return scene_from_text(scene_text(), "f.yaml", sets).body;
  };
  EXPECT_EQ(scene_from_text(scene_text(), "f.yaml", {}).force.evaluation, ForceChoice::Evaluation::domain_average);
  EXPECT_EQ(body_of({}).cut, Body::Cut::clipped);
  EXPECT_EQ(body_of({"force.evaluation=point"}).cut, Body::Cut::whole);
  EXPECT_EQ(body_of({"body.cut=whole"}).cut, Body::Cut::whole);
  EXPECT_EQ(body_of({"force.evaluation=point", "body.cut=clipped"}).cut, Body::Cut::clipped);
  EXPECT_EQ(body_of({"body.lattice=polar"}).lattice, Body::Lattice::polar);
}

TEST(SceneReader, RefusesLatticesAndCutsThatABodyCannotHave) {
  EXPECT_EQ(refused_extra("body: {domain: square, lattice: polar}"),
            "f.yaml:3:33: body.lattice: a polar lattice fills a ring, and body.domain is square");
  EXPECT_EQ(refused_extra("body: {lattice: polar, cut: clipped}"),
            "f.yaml:3:29: body.cut: a polar lattice has no cell to cut: it follows the ring's edges");
  EXPECT_TRUE(has(refused_extra("body: {domain: box, cut: whole}"), "body.cut: does not belong to body.domain box"));
}

TEST(SceneReader, AGaussLatticeNeedsWholeCellsAndABasisWithoutDomains) {
  const auto gauss = [](const std::string& body, const std::string& rest) {
    return refused(scene_text("body: {lattice: gauss" + body + "}\ngrid: {spacing: 0.25}\n" + rest + "\n"));
  };
  const std::string square = ", domain: square", bspline = "method: {basis: bspline2}";
  EXPECT_EQ(gauss(square, bspline), "accepted");
  EXPECT_EQ(gauss(square + ", outside: free", bspline + "\nframe: {velocity: [1, 0]}"), "accepted");
  EXPECT_EQ(gauss("", bspline),
            "f.yaml:3:17: body.lattice: Gauss points integrate over whole cells of the grid, which a ring's edges cut: "
            "take a square or a box");
  EXPECT_TRUE(has(gauss(square + ", lower: [-1.4, -1.5], upper: [1.6, 1.5]", bspline),
                  "the body's corners [-1.4, -1.5] and [1.6, 1.5] are no multiples of grid.spacing, 0.25"));
  EXPECT_TRUE(has(gauss(square, bspline + "\nframe: {angle: 0.7}"), "frame.angle turns the body against these"));
  for (const std::string basis : {"ugimp", "cpgimp", "cpdi", "cpdi2"}) {
    EXPECT_EQ(gauss(square, "method: {basis: " + basis + "}"),
              "f.yaml:3:17: body.lattice: Gauss points are not the centres of domains that fill their cell, which " +
                  basis + " needs: take linear, bspline2, bspline3 or bspline4");
  }
}

TEST(SceneReader, JitterAndSeedAreOfAJitteredLattice) {
  const auto jittered = [](const std::string& body, const std::string& basis) {
    return refused(
        scene_text("body: {lattice: jittered" + body + "}\ngrid: {spacing: 0.1}\nmethod: {basis: " + basis + "}\n"));
  };
  EXPECT_EQ(jittered("", "ugimp"), "accepted");
  EXPECT_EQ(jittered(", domain: square, jitter: 0.5, seed: 7", "bspline2"), "accepted");
  EXPECT_EQ(
      jittered("", "cpdi"),
      "f.yaml:3:17: body.lattice: particles of cpdi share the edges of their domains, which would overlap and leave "
      "gaps: take another basis");
  EXPECT_TRUE(has(jittered(", jitter: 0.51", "linear"), "3:35: body.jitter: must be"));
  EXPECT_TRUE(has(jittered(", jitter: 0", "linear"), "3:35: body.jitter: must be"));
  EXPECT_TRUE(has(jittered(", seed: 1.5", "linear"), "3:33: body.seed: must be a whole number, found '1.5'"));
  EXPECT_EQ(refused_extra("body: {jitter: 0.1}"),
            "f.yaml:3:16: body.jitter: belongs to lattice: jittered, but body.lattice has another value");
  EXPECT_EQ(refused_extra("body: {lattice: polar, seed: 2}"),
            "f.yaml:3:30: body.seed: belongs to lattice: jittered, but body.lattice has another value");
}

TEST(SceneReader, RefusesWhatIsMissing) {
  EXPECT_EQ(refused("motion: {type: vortex}\n"), "f.yaml:1:1: material: required and not given");
  EXPECT_EQ(refused("title: x\n"), "f.yaml:1:1: motion: required and not given");
  EXPECT_EQ(refused("motion: {}\nmaterial: {}\n"), "f.yaml:1:9: motion.type: required and not given");
  EXPECT_EQ(refused_extra("grid: {lower: [0, 0]}"), "f.yaml:3:7: grid.spacing: required and not given");
  EXPECT_EQ(refused_extra("method: {basis: cpdi}"), "f.yaml:1:1: grid: required by method and not given");
  EXPECT_TRUE(has(refused("motion: {type: homogeneous}\nmaterial: {adapter: x}\n"), "motion.final: required"));
}

TEST(SceneReader, RefusesWhatDoesNotFitTogether) {
  EXPECT_TRUE(has(refused_extra("body: {lower: [0, 0]}"), "3:8: body.lower: does not belong to body.domain ring"));
  EXPECT_TRUE(has(refused_set("motion.final=[[1,0,0],[0,1,0],[0,0,1]]"), "does not belong to motion.type vortex"));
  EXPECT_TRUE(has(refused(homogeneous_text(), {"motion.inner=1"}),
                  "does not belong to motion.type homogeneous; known: type, "
                  "path, interpolation, time_unit, final, period, allow_unstable"));
  EXPECT_TRUE(has(refused(homogeneous_text("body: {domain: ring}")),
                  "a ring takes its radii from the motion, and homogeneous has none"));
  EXPECT_TRUE(has(refused_set("body={domain: ring, outside: held}"), "--set body.outside: a ring alone"));
  EXPECT_TRUE(
      has(refused_set("body={domain: square, lower: [-1, -1], upper: [1, 1]}"), "must contain the ring of the vortex"));
  EXPECT_TRUE(has(refused_set("body={domain: square, lower: [-2, -2], upper: [2, 3]}"), "a square has equal sides"));
  EXPECT_TRUE(has(refused_set("body={domain: box, lower: [-2, 2], upper: [2, -2]}"),
                  "body.lower: must be less than body.upper"));
  EXPECT_TRUE(has(refused_set("grid={spacing: .1, lower: [-2, -2]}"), "lower and upper only come together"));
  EXPECT_TRUE(has(refused_set("grid={spacing: .1, lower: [-1, -1], upper: [1, 1]}"), "particles would lie outside"));
  EXPECT_TRUE(has(refused(homogeneous_text(), {"motion.final=[[-1,0,0],[0,1,0],[0,0,1]]"}), "det F <= 0 on the way"));
  EXPECT_TRUE(
      has(refused(homogeneous_text("grid: {spacing: .1}\nmethod: {}"), {"motion.final=[[1,0,0],[0,1,0],[0,0,1.1]]"}),
          "plane strain"));
}

TEST(SceneReader, ReadsAFrameAndRefusesOneThatCannotBe) {
  const Scene s = scene_from_text(scene_text("frame: {angle: 0.7, spin: -1.3, velocity: [0.4, -0.2]}\n"), "f.yaml");
  EXPECT_EQ(s.frame->angle, 0.7);
  EXPECT_EQ(s.frame->spin, -1.3);
  EXPECT_EQ(s.frame->velocity, Vector3(0.4, -0.2, 0));
  EXPECT_FALSE(scene_from_text(scene_text(), "f.yaml").frame);
  EXPECT_FALSE(scene_from_text(scene_text("frame: {}\n"), "f.yaml").frame->moves());
  EXPECT_EQ(refused(homogeneous_text("frame: {angle: 1}\n")),
            "f.yaml:3:9: frame.angle: does not belong to motion.type homogeneous");
  EXPECT_EQ(refused(homogeneous_text("frame: {}\n")),
            "f.yaml:3:8: frame: serves the vortex, and motion.type is homogeneous");
  const std::string held = "body: {domain: square}\n";
  EXPECT_EQ(refused_extra(held + "frame: {angle: 1}\n"), "accepted");
  EXPECT_TRUE(has(refused_extra(held + "frame: {spin: 1}\n"), "f.yaml:4:15: frame.spin: moves the ring over the grid"));
  EXPECT_TRUE(has(refused_extra(held + "frame: {velocity: [0, 1]}\n"), "frame.velocity: moves the ring over the grid"));
  EXPECT_EQ(refused(scene_text(held + "frame: {spin: 1}\n"), {"body.outside=free"}), "accepted");
  EXPECT_TRUE(has(refused_extra("frame: {spin: 1}\nforce: {response: none}\n"), "frame.spin: needs the body force"));
  EXPECT_TRUE(has(refused_extra("frame: {angle: .nan}\n"), "frame.angle: must be a finite number"));
}

TEST(SceneReader, TheGridMustContainTheBodyOnAllItsWay) {
  const std::string grid = "grid: {spacing: .1, lower: [-1.3, -1.3], upper: [1.3, 1.3]}\n";
  EXPECT_EQ(refused_extra(grid + "frame: {angle: 1, spin: 3}\n"), "accepted") << "a ring stays itself";
  EXPECT_TRUE(has(refused_extra(grid + "frame: {velocity: [0.1, 0]}\n"), "must contain the body on all of its way"));
  EXPECT_EQ(refused(scene_text(grid + "frame: {velocity: [0.1, 0]}\n"), {"time.end=0.4"}), "accepted");
  const std::string square = "body: {domain: square, outside: free, lower: [-1.3, -1.3], upper: [1.3, 1.3]}\n";
  EXPECT_EQ(refused_extra(grid + square), "accepted");
  EXPECT_TRUE(has(refused_extra(grid + square + "frame: {angle: 0.1}\n"), "particles would lie outside"));
  EXPECT_TRUE(has(refused_extra(grid + square + "frame: {spin: 0.1}\n"), "particles would lie outside"));
}

TEST(SceneReader, PathsAreRelativeToTheSceneOrTheWorkingDirectory) {
  const auto adapter = [](const std::string& in_file, const std::vector<std::string>& sets) {
    return scene_from_text("motion: {type: vortex}\nmaterial: {adapter: " + in_file + "}\n", "/some/where/f.yaml", sets)
        .material.adapter;
  };
  EXPECT_EQ(adapter("name", {}), "name");
  EXPECT_EQ(adapter("lib.so", {}), "/some/where/lib.so");
  EXPECT_EQ(adapter("../lib.so:soft", {}), "/some/lib.so:soft");
  EXPECT_EQ(adapter("/abs/lib.so:soft", {}), "/abs/lib.so:soft");
  EXPECT_EQ(adapter("d/x.yaml", {}), "/some/where/d/x.yaml");
  const std::string here = std::filesystem::current_path().string();
  EXPECT_EQ(adapter("name", {"material.adapter=lib.so"}), here + "/lib.so");
  EXPECT_EQ(adapter("name", {"material={adapter: d/lib.so:x}"}), here + "/d/lib.so:x");
}

TEST(SceneReader, UnreadableFiles) {
  const std::string folder = testing::TempDir();
  EXPECT_EQ(refusal_of([&] { read_scene(folder); }), folder + ": is a folder, not a file");
  std::ofstream(folder + "nothing.yaml").close();
  EXPECT_EQ(refusal_of([&] { read_scene(folder + "nothing.yaml"); }), folder + "nothing.yaml: empty");
  EXPECT_TRUE(has(refusal_of([&] { read_scene(folder + "absent.yaml"); }), "cannot be read"));
}

// Whatever the text: a scene, or one line.
void digest(const std::string& text) {
  const std::string line = refused(text);
  ASSERT_FALSE(line.empty());
  ASSERT_EQ(line.find('\n'), std::string::npos) << line;
}

/// What two texts begin with alike is digested once.
void digest_truncations(const std::vector<std::string>& files) {
  std::set<std::string> texts;
  for (const std::string& file : files) texts.insert(read_bytes(file));
  std::string before;
  for (const std::string& text : texts) {
    const auto known = std::mismatch(text.begin(), text.end(), before.begin(), before.end()).first - text.begin();
    for (auto size = static_cast<std::size_t>(known); size < text.size(); ++size) digest(text.substr(0, size));
    before = text;
  }
}

/// Of one scene of each folder; FuzzCorpus cuts all of them at many places.
TEST(SceneReader, EveryTruncationEndsInASceneOrOneLine) {
  std::map<std::filesystem::path, std::string> of_folder;
  for (const std::string& file : all_configs()) of_folder.try_emplace(std::filesystem::path(file).parent_path(), file);
  std::vector<std::string> files;
  for (const auto& [folder, file] : of_folder) files.push_back(file);
  EXPECT_GE(files.size(), 8u);
  digest_truncations(files);
}

TEST(LongSceneReader, EveryTruncationOfEverySceneDoesToo) { digest_truncations(all_configs()); }

TEST(SceneReader, EveryMutationEndsInASceneOrOneLine) {
  const std::string text = scene_text("grid: {spacing: .1} # h\nexpect: {t: {below: 1}}\n");
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (int byte = 0; byte < 256; ++byte) {
      std::string changed = text;
      changed[i] = static_cast<char>(byte);
      digest(changed);
    }
  }
}

}  // namespace
}  // namespace assay::drivers::test_scene_reader
