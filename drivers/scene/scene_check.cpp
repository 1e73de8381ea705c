// SPDX-License-Identifier: BSD-3-Clause
// Keys of a scene that do not go together.
#include "drivers/scene/scene_reader.hpp"

#include <cmath>
#include <span>

#include "drivers/format/yaml_values.hpp"
#include "drivers/scene/body_box.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "mpm/compose.hpp"
#include "mpm/patch/methods.hpp"

namespace assay::drivers {

namespace {

bool is_node(double x, double h) {
  constexpr double rounding = 1e-9;  // of a cell, as the lattices count it
  return std::abs(x / h - std::round(x / h)) <= rounding;
}

class SceneCheck {
 public:
  SceneCheck(const Scene& scene, const KeyPlace& where)
      : scene_(scene), where_(where), ring_(ring_of(scene.motion)), is_free_(scene.force.response == no_force) {}

  void all() const {
    check_title();
    check_dimension();
    MotionUse use{scene_.time.end, scene_.method.has_value(), [&](const std::string& key) { return given(key); },
                  scene_.dimension};
    if (!scene_.units.is_si())
      use.in_units = [&](double value, std::string_view unit, int digits) {
        return digits > 0 ? scene_.units.text(value, unit, digits) : scene_.units.text(value, unit);
      };
    if (const auto found = scene_.motion->fault(use)) refuse_if(true, found->key, found->what);
    const auto direction = scene_.material.direction.value_or(std::array{1.0, 0.0, 0.0});
    refuse_if(direction[0] == 0 && direction[1] == 0 && direction[2] == 0, "material.direction", "must not be zero");
    check_body();
    check_lattice();
    refuse_if(scene_.method && !scene_.grid, "grid", "required by method and not given");
    if (scene_.frame) check_frame(*scene_.frame);
    if (scene_.body.initial_velocity) check_initial_velocity();
    if (const std::string fault = fault_of_initial_stress(scene_); !fault.empty())
      refuse_if(true, "material.initial_stress", fault);
    if (scene_.grid) check_grid(*scene_.grid);
    if (scene_.method) check_method(*scene_.method);
    if (scene_.force.inertia == mpm::Inertia::particles) check_inertia();
    refuse_if(scene_.output.tractions && is_free_, "output.tractions",
              "compares tractions, and with force.response: none no forces act");
    check_time();
  }

 private:
  static constexpr auto no_force = ForceChoice::Response::none;

  bool given(const std::string& key) const { return scene_.places.contains(key); }

  void refuse_if(bool fault, const std::string& key, const std::string& what) const {
    if (fault) throw InputError(where_(key), key, what);
  }

  /// In the units of the scene.
  std::string length(double x) const { return number_text(scene_.units.scale("m").from_si(x)) + unit("m"); }
  std::string lengths(std::span<const double> p) const {
    const Scale scale = scene_.units.scale("m");
    return flow_list(mapped(p, [&](double x) { return number_text(scale.from_si(x)); })) + unit("m");
  }
  std::string lengths(const PerAxis<double>& p) const { return lengths(std::span(&p[0], p.size())); }
  std::string duration(double t) const { return number_text(scene_.units.scale("s").from_si(t)) + unit("s"); }
  /// Behind a number; a scene in SI has none there.
  std::string unit(const char* si) const { return scene_.units.is_si() ? "" : " " + scene_.units.name(si); }

  void check_title() const {
    for (const char* none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
      refuse_if(scene_.title.find(none) != std::string::npos, "title",
                std::string("holds U+FFF") + (none[2] == '\xBE' ? "E" : "F") + ", which is no character: delete it");
    }
    refuse_if(one_line(scene_.title, scene_.title.size()) != scene_.title, "title",
              "must be one line of text, found '" + shown(scene_.title, 200) + "'");
  }

  bool in_space() const { return scene_.dimension == 3; }

  void check_dimension() const {
    refuse_if(!in_space() && scene_.motion->only_in_space(), "dimension",
              "must be 3 for motion.type " + motion_type(scene_) + ", which has no plane version");
  }

  std::size_t axes() const { return in_space() ? 3 : 2; }

  void check_corners(const PerAxis<double>& lower, const PerAxis<double>& upper, const std::string& section) const {
    bool ordered = true;
    for (std::size_t d = 0; d < axes(); ++d) ordered = ordered && lower[d] < upper[d];
    refuse_if(!ordered, section + ".lower",
              "must be less than " + section + ".upper, found " + lengths(lower) + " and " + lengths(upper));
  }

  /// In space there are boxes, and the bodies of vortices.
  void check_body_in_space() const {
    const Body& body = scene_.body;
    const auto* vortex = scene_.motion.as<Vortex3d>();
    refuse_if(body.domain == Body::Domain::ring || body.domain == Body::Domain::square, "body.domain",
              domain_name(body.domain) + (vortex ? " lies in the plane, and dimension is 3: take box or vortex"
                                                 : " lies in the plane, and dimension is 3: take box"));
    refuse_if(body.domain == Body::Domain::vortex && !vortex, "body.domain",
              "vortex is the body of motion.type vortex3d, and motion.type is " + motion_type(scene_));
    refuse_if(body.domain == Body::Domain::vortex && body.outside == Body::Outside::held, "body.outside",
              "a vortex alone has nothing outside it that could be held; its surface is free");
    refuse_if(body.lattice == Body::Lattice::polar, "body.lattice", "a polar lattice fills a ring in the plane");
    refuse_if(ring_ && !is_vortex(scene_.motion) && scene_.method, "dimension",
              "must be 2 for motion.type " + motion_type(scene_) + " with a method: its ring has no lattice in space");
    for (std::size_t d = 0; d < 3; ++d) {
      const bool may = scene_.motion->may_repeat() || (d == 2 && scene_.motion->is_plane());
      refuse_if(body.is_periodic(d) && !may, "body.periodic",
                motion_type(scene_) + " does not repeat along " + std::string(1, "xyz"[d]));
    }
    if (body.domain == Body::Domain::vortex) return;
    check_corners(body.lower, body.upper, "body");
    if (!vortex && !ring_) return;
    Scene alone = scene_;
    alone.body.domain = Body::Domain::vortex;
    BoxOf<3> around{{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL, HUGE_VAL}};
    if (vortex) around = body_box<3>(alone);
    for (std::size_t d = 0; d < 3; ++d) {
      if (!vortex && d == 2) continue;
      const double lower = vortex ? around.lower[d] : -ring_->outer, upper = vortex ? around.upper[d] : ring_->outer;
      const double rounding = 1e-12 * (upper - lower);
      refuse_if(!(body.lower[d] <= lower + rounding && body.upper[d] >= upper - rounding), "body.domain",
                "must contain the vortex, which reaches from " + length(lower) + " to " + length(upper) + " along " +
                    std::string(1, "XYZ"[d]) + ", and reaches from " + lengths(body.lower) + " to " +
                    lengths(body.upper));
    }
  }

  void check_body() const {
    if (in_space() && scene_.method) return check_body_in_space();
    const Body& body = scene_.body;
    const bool polar = body.lattice == Body::Lattice::polar;
    if (body.domain == Body::Domain::vortex) {
      refuse_if(!in_space(), "body.domain", "vortex is a body in space, and dimension is 2");
      return;
    }
    const auto periodic = static_cast<int>(body.periodic), both = static_cast<int>(Body::Periodic::both);
    refuse_if(periodic > both && !in_space(), "body.periodic", "z is an axis of space, and dimension is 2");
    if (body.domain == Body::Domain::ring) {
      refuse_if(!ring_, "body.domain",
                "a ring takes its radii from the motion, and " + motion_type(scene_) + " has none");
      refuse_if(body.outside == Body::Outside::held, "body.outside",
                "a ring alone has nothing outside it that could be held; its faces are free");
      refuse_if(polar && given("body.cut"), "body.cut",
                "a polar lattice has no cell to cut: it follows the ring's edges");
      return;
    }
    refuse_if(ring_ && !is_vortex(scene_.motion), "body.domain",
              "a twisting ring is a ring: nothing is known of the motion outside it");
    refuse_if(polar, "body.lattice", "a polar lattice fills a ring, and body.domain is " + domain_name(body.domain));
    check_corners(body.lower, body.upper, "body");
    const double width = body.upper[0] - body.lower[0], height = body.upper[1] - body.lower[1];
    refuse_if(body.domain == Body::Domain::square && std::abs(width - height) > 1e-12 * width, "body.upper",
              "a square has equal sides, found " + length(width) + " and " + length(height));
    for (std::size_t i = 0; ring_ && i < 2; ++i) {
      refuse_if(!(body.lower[i] <= -ring_->outer && body.upper[i] >= ring_->outer), "body.domain",
                "must contain the ring of the vortex (outer " + length(ring_->outer) + "), reaches from " +
                    lengths(body.lower) + " to " + lengths(body.upper));
    }
  }

  void check_lattice() const {
    const Body::Lattice lattice = scene_.body.lattice;
    const bool jittered = lattice == Body::Lattice::jittered;
    for (const char* key : {"body.jitter", "body.seed"})
      refuse_if(given(key) && !jittered, key, "belongs to lattice: jittered, but body.lattice has another value");
    if (lattice == Body::Lattice::gauss) check_gauss_lattice();
    if (!jittered || !scene_.method) return;
    refuse_if(mpm::traits_of<2>(scene_.method->basis).convects, "body.lattice",
              "particles of " + mpm::names_of(*scene_.method).basis +
                  " share the edges of their domains, which would overlap and leave gaps: take another basis");
  }

  void check_gauss_lattice() const {
    const std::string points = "Gauss points integrate over whole cells of the grid, ";
    const Body& body = scene_.body;
    refuse_if(body.domain == Body::Domain::ring, "body.lattice",
              points + "which a ring's edges cut: take a square or a box");
    refuse_if(body.domain == Body::Domain::vortex, "body.lattice",
              points + "which the vortex's surface cuts: take a box");
    refuse_if(scene_.frame && scene_.frame->angle != 0, "body.lattice",
              points + "and frame.angle turns the body against these");
    for (std::size_t d = 0; scene_.grid && d < body.lower.size(); ++d) {
      const double h = scene_.grid->spacing;
      refuse_if(scene_.grid->offset[d] != 0, "grid.offset", points + "and the offset cuts these");
      refuse_if(!is_node(body.lower[d], h) || !is_node(body.upper[d], h), "body.lattice",
                points + "and the body's corners " + lengths(body.lower) + " and " + lengths(body.upper) +
                    " are no multiples of grid.spacing, " + length(h));
    }
    if (!scene_.method) return;
    refuse_if(!mpm::traits_of<2>(scene_.method->basis).at_points, "body.lattice",
              "Gauss points are not the centres of domains that fill their cell, which " +
                  mpm::names_of(*scene_.method).basis + " needs: take " +
                  mpm::bases_that(&mpm::BasisTraits::at_points, "or"));
  }

  void check_initial_velocity() const {
    const std::string key = "body.initial_velocity";
    refuse_if(in_space(), key, "is plane so far, and dimension is 3");
    refuse_if(!is_free_, key, "is for a free body, but the body force drives this body: set force.response: none");
    refuse_if(scene_.frame.has_value(), key, "cannot be combined with frame: both set the initial velocity");
    refuse_if(scene_.body.outside == Body::Outside::held, key,
              "would move the particles that body.outside: held fixes");
  }

  void check_method(const Method& method) const {
    refuse_if(given("method.terms") && !method.has_terms(), "method.terms",
              "belongs to mass: series and to transfer: xpic or fmpm, but the method has none of these");
    refuse_if(given("method.affine") && !method.is_affine(), "method.affine",
              "belongs to transfer: apic and aflip, but transfer is " + mpm::names_of(method).transfer);
    if (const auto found = mpm::contradiction(method)) refuse_if(true, found->key, found->reason);
    if (const auto found = mpm::contradiction<2>(method, scene_.effects)) refuse_if(true, found->key, found->reason);
  }

  void check_grid(const GridChoice& grid) const {
    refuse_if(!grid.lower != !grid.upper, grid.lower ? "grid.lower" : "grid.upper",
              "lower and upper only come together");
    if (!grid.lower) return;
    check_corners(*grid.lower, *grid.upper, "grid");
    in_space() ? check_holds(grid, swept_box<3>(scene_)) : check_holds(grid, swept_box<2>(scene_));
  }

  void check_holds(const GridChoice& grid, const auto& body) const {
    const std::string way = scene_.frame && scene_.frame->moves() ? " on all of its way" : "";
    for (std::size_t i = 0; i < axes(); ++i) {
      const bool below = (*grid.lower)[i] > body.lower[i];
      refuse_if(below || !((*grid.upper)[i] >= body.upper[i]), below ? "grid.lower" : "grid.upper",
                "the grid must contain the body" + way + ", which reaches " +
                    lengths(std::span<const double>(below ? body.lower : body.upper)) +
                    ": particles would lie outside");
    }
  }

  void check_frame(const Frame& frame) const {
    refuse_if(frame.axis == Vector3::Zero(), "frame.axis", "must not be zero");
    refuse_if(!in_space() && frame.unit_axis() != Vector3::UnitZ(), "frame.axis",
              "must be [0, 0, 1] in the plane: another axis needs dimension: 3");
    refuse_if(!in_space() && frame.velocity.z() != 0, "frame.velocity",
              "has two numbers in the plane: a third needs dimension: 3");
    refuse_if(!in_space() && !is_vortex(scene_.motion), "frame",
              "serves the vortex, and motion.type is " + motion_type(scene_));
    refuse_if((!in_space() || scene_.method) && frame.moves() && scene_.body.outside == Body::Outside::held,
              frame.spin != 0 ? "frame.spin" : "frame.velocity",
              in_space()
                  ? "moves the vortex over the grid, whose nodes around it are held: take body.outside: free or a "
                    "vortex alone"
                  : "moves the ring over the grid, whose nodes around it are held: take body.outside: free or a "
                    "ring alone");
    refuse_if(frame.spin != 0 && is_free_, "frame.spin",
              "needs the body force, of which Coriolis' and the centrifugal one are parts");
  }

  void check_inertia() const {
    const std::string key = "force.inertia";
    refuse_if(is_free_, key, "needs a body force, but force.response is none");
    if (!scene_.method) return;
    refuse_if(scene_.method->is_affine() && scene_.method->affine == mpm::Affine::moment, key,
              "`particles` gives the particles the gradient of the acceleration too, but with affine: moment they "
              "carry a moment: set affine: gradient");
    refuse_if(scene_.method->has_stages(), key,
              "particles cannot be combined with symplectic_rkn4, which accelerates the particles in stages of its "
              "own: set grid");
  }

  void check_time() const {
    const TimeChoice& time = scene_.time;
    const auto fixed = time.fixed_step();
    if (!fixed) return;
    refuse_if(time.control == TimeChoice::Control::current, "time.control",
              std::string("current takes steps by method.courant, and ") + fixed->key + " fixes them");
    const auto* box = scene_.motion.as<AxisAligned>();
    const bool known_end = !box || box->given_speed || given("time.end");
    refuse_if(known_end && fixed->dt > time.end, fixed->key, "must not exceed time.end, found " + duration(fixed->dt));
  }

  const Scene& scene_;
  const KeyPlace& where_;
  const std::optional<Annulus> ring_;
  const bool is_free_;  ///< no body force acts
};

}  // namespace

void check_scene(const Scene& scene, const KeyPlace& where) { SceneCheck(scene, where).all(); }

}  // namespace assay::drivers
