// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene_reader.hpp"

#include <cmath>
#include <utility>

#include "drivers/scene/body_box.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/text/number_format.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "mpm/patch/methods.hpp"

namespace assay::drivers {

namespace {

std::string text(const std::array<double, 2>& p) { return "[" + number_text(p[0]) + ", " + number_text(p[1]) + "]"; }

void check_corners(const std::array<double, 2>& lower, const std::array<double, 2>& upper, const std::string& section,
                   const KeyPlace& where) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (lower[i] < upper[i]) continue;
    refuse_at(where, section + ".lower",
              "must be less than " + section + ".upper, found " + text(lower) + " and " + text(upper));
  }
}

bool is_node(double x, double h) {
  constexpr double rounding = 1e-9;  // of a cell, as the lattices count it
  return std::abs(x / h - std::round(x / h)) <= rounding;
}

void check_gauss_lattice(const Scene& scene, const KeyPlace& where) {
  const std::string points = "Gauss points integrate over whole cells of the grid, ";
  const Body& body = scene.body;
  if (body.domain == Body::Domain::ring) {
    refuse_at(where, "body.lattice", points + "which a ring's edges cut: take a square or a box");
  }
  if (scene.frame && scene.frame->angle != 0) {
    refuse_at(where, "body.lattice", points + "and frame.angle turns the body against these");
  }
  for (std::size_t d = 0; scene.grid && d < 2; ++d) {
    const double h = scene.grid->spacing;
    if (scene.grid->offset[d] != 0) refuse_at(where, "grid.offset", points + "and the offset cuts these");
    if (is_node(body.lower[d], h) && is_node(body.upper[d], h)) continue;
    refuse_at(where, "body.lattice",
              points + "and the body's corners " + text(body.lower) + " and " + text(body.upper) +
                  " are no multiples of grid.spacing, " + number_text(h));
  }
  using enum mpm::Basis;
  if (!scene.method) return;
  const auto basis = scene.method->basis;
  const std::string name = mpm::names_of(*scene.method).basis;
  if (basis != linear && !mpm::is_spline(basis)) {
    refuse_at(where, "body.lattice",
              "Gauss points are not the centres of domains that fill their cell, which " + name +
                  " needs: take linear, bspline2, bspline3 or bspline4");
  }
}

void check_jittered_lattice(const Scene& scene, const KeyPlace& where) {
  if (!scene.method) return;
  const auto basis = scene.method->basis;
  if (basis != mpm::Basis::cpdi && basis != mpm::Basis::cpdi2) return;
  refuse_at(where, "body.lattice",
            "particles of " + mpm::names_of(*scene.method).basis +
                " share the edges of their domains, which would overlap and leave gaps: take another basis");
}

void check_lattice(const Scene& scene, const KeyPlace& where) {
  const bool jittered = scene.body.lattice == Body::Lattice::jittered;
  for (const char* key : {"body.jitter", "body.seed"}) {
    if (scene.places.contains(key) && !jittered)
      refuse_at(where, key, "belongs to lattice: jittered, but body.lattice has another value");
  }
  if (jittered) check_jittered_lattice(scene, where);
  if (scene.body.lattice == Body::Lattice::gauss) check_gauss_lattice(scene, where);
}

void check_body(const Scene& scene, const KeyPlace& where) {
  const Body& body = scene.body;
  if (body.domain == Body::Domain::ring) {
    if (!ring_of(scene.motion)) {
      refuse_at(where, "body.domain",
                "a ring takes its radii from the motion, and " + motion_type(scene) + " has none");
    }
    if (body.outside == Body::Outside::held) {
      refuse_at(where, "body.outside", "a ring alone has nothing outside it that could be held; its faces are free");
    }
    if (body.lattice == Body::Lattice::polar && scene.places.contains("body.cut")) {
      refuse_at(where, "body.cut", "a polar lattice has no cell to cut: it follows the ring's edges");
    }
    return;
  }
  const auto ring = ring_of(scene.motion);
  if (ring && !is_vortex(scene.motion)) {
    refuse_at(where, "body.domain", "a twisting ring is a ring: nothing is known of the motion outside it");
  }
  if (body.lattice == Body::Lattice::polar) {
    refuse_at(where, "body.lattice", "a polar lattice fills a ring, and body.domain is " + domain_name(body.domain));
  }
  check_corners(body.lower, body.upper, "body", where);
  const double width = body.upper[0] - body.lower[0], height = body.upper[1] - body.lower[1];
  if (body.domain == Body::Domain::square && std::abs(width - height) > 1e-12 * width) {
    refuse_at(where, "body.upper",
              "a square has equal sides, found " + number_text(width) + " and " + number_text(height));
  }
  for (std::size_t i = 0; ring && i < 2; ++i) {
    if (body.lower[i] <= -ring->outer && body.upper[i] >= ring->outer) continue;
    refuse_at(where, "body.domain",
              "must contain the ring of the vortex (outer " + number_text(ring->outer) + "), reaches from " +
                  text(body.lower) + " to " + text(body.upper));
  }
}

void check_initial_velocity(const Scene& scene, const KeyPlace& where) {
  const std::string key = "body.initial_velocity";
  if (scene.force.response != ForceChoice::Response::none) {
    refuse_at(where, key, "is for a free body, but the body force drives this body: set force.response: none");
  }
  if (scene.frame) refuse_at(where, key, "cannot be combined with frame: both set the initial velocity");
  if (scene.body.outside == Body::Outside::held) {
    refuse_at(where, key, "would move the particles that body.outside: held fixes");
  }
}

void check_method(const Scene& scene, const KeyPlace& where) {
  const Method& method = *scene.method;
  if (scene.places.contains("method.terms") && !method.has_terms()) {
    refuse_at(where, "method.terms",
              "belongs to mass: series and to transfer: xpic or fmpm, but the method has none of these");
  }
  if (scene.places.contains("method.affine") && !method.is_affine()) {
    refuse_at(where, "method.affine",
              "belongs to transfer: apic and aflip, but transfer is " + mpm::names_of(method).transfer);
  }
  if (const auto found = mpm::contradiction(method)) refuse_at(where, found->key, found->reason);
  if (const auto found = mpm::contradiction(method, scene.remedies)) refuse_at(where, found->key, found->reason);
}

void check_grid(const Scene& scene, const KeyPlace& where) {
  const GridChoice& grid = *scene.grid;
  if (!grid.lower != !grid.upper) {
    const std::string given = grid.lower ? "grid.lower" : "grid.upper";
    refuse_at(where, given, "lower and upper only come together");
  }
  if (!grid.lower) return;
  check_corners(*grid.lower, *grid.upper, "grid", where);
  const Box body = swept_box(scene);
  for (std::size_t i = 0; i < 2; ++i) {
    const bool below = (*grid.lower)[i] > body.lower[i];
    if (!below && (*grid.upper)[i] >= body.upper[i]) continue;
    const std::string way = scene.frame && scene.frame->moves() ? " on all of its way" : "";
    refuse_at(where, below ? "grid.lower" : "grid.upper",
              "the grid must contain the body" + way + ", which reaches " + text(below ? body.lower : body.upper) +
                  ": particles would lie outside");
  }
}

void check_frame(const Scene& scene, const KeyPlace& where) {
  if (!is_vortex(scene.motion)) {
    refuse_at(where, "frame", "serves the vortex, and motion.type is " + motion_type(scene));
  }
  const Frame& frame = *scene.frame;
  if (frame.moves() && scene.body.outside == Body::Outside::held) {
    refuse_at(where, frame.spin != 0 ? "frame.spin" : "frame.velocity",
              "moves the ring over the grid, whose nodes around it are held: take body.outside: free or a ring alone");
  }
  if (frame.spin != 0 && scene.force.response == ForceChoice::Response::none) {
    refuse_at(where, "frame.spin", "needs the body force, of which Coriolis' and the centrifugal one are parts");
  }
}

void check_inertia(const Scene& scene, const KeyPlace& where) {
  const std::string key = "force.inertia";
  if (scene.force.response == ForceChoice::Response::none) {
    refuse_at(where, key, "needs a body force, but force.response is none");
  }
  if (!scene.method) return;
  if (scene.method->is_affine() && scene.method->affine == mpm::Affine::moment) {
    refuse_at(
        where, key,
        "`particles` gives the particles the gradient of the acceleration too, but with affine: moment they carry a "
        "moment: set affine: gradient");
  }
  if (scene.method->has_stages()) {
    refuse_at(where, key,
              "particles cannot be combined with symplectic_rkn4, which accelerates the particles in stages of its "
              "own: set grid");
  }
}

}  // namespace

void refuse_at(const KeyPlace& where, const std::string& key, const std::string& what) {
  throw InputError(where(key), key, what);
}

void check_scene(const Scene& scene, const KeyPlace& where) {
  for (const char* none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
    if (scene.title.find(none) == std::string::npos) continue;
    refuse_at(where, "title",
              std::string("holds U+FFF") + (none[2] == '\xBE' ? "E" : "F") + ", which is no character: delete it");
  }
  if (one_line(scene.title, scene.title.size()) != scene.title) {
    refuse_at(where, "title", "must be one line of text, found '" + shown(scene.title, 200) + "'");
  }
  const MotionUse use{scene.time.end, scene.method.has_value(),
                      [&](const std::string& key) { return scene.places.contains(key); }};
  if (const auto found = scene.motion->fault(use)) refuse_at(where, found->key, found->what);
  const auto& direction = scene.material.direction;
  if (direction && (*direction)[0] == 0 && (*direction)[1] == 0 && (*direction)[2] == 0) {
    refuse_at(where, "material.direction", "must not be zero");
  }
  check_body(scene, where);
  check_lattice(scene, where);
  if (scene.method && !scene.grid) refuse_at(where, "grid", "required by method and not given");
  if (scene.frame) check_frame(scene, where);
  if (scene.body.initial_velocity) check_initial_velocity(scene, where);
  if (scene.grid) check_grid(scene, where);
  if (scene.method) check_method(scene, where);
  if (scene.force.inertia == mpm::Inertia::particles) check_inertia(scene, where);
  if (scene.output.tractions && scene.force.response == ForceChoice::Response::none) {
    refuse_at(where, "output.tractions", "compares tractions, and with force.response: none no forces act");
  }
  const auto* box = scene.motion.as<AxisAligned>();
  if (scene.time.step && scene.time.control == TimeChoice::Control::current) {
    refuse_at(where, "time.control", "current takes steps by method.courant, and time.step fixes them");
  }
  const bool known_end = !box || box->given_speed || scene.places.contains("time.end");
  if (known_end && scene.time.step && *scene.time.step > scene.time.end) {
    refuse_at(where, "time.step", "must not exceed time.end, found " + number_text(*scene.time.step));
  }
}

}  // namespace assay::drivers
