// SPDX-License-Identifier: BSD-3-Clause
// What a problem is called, and how much memory it takes.
#include "drivers/scene/scene_keys.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "mpm/basis/corners.hpp"
#include "mpm/mass/surface_rows.hpp"
#include "mpm/patch/methods.hpp"

namespace assay::drivers {

namespace {

constexpr double cell_bytes = 420, sector_bytes = 90;  ///< that averaging over a particle's domain takes (measured)
constexpr double hexahedron_bytes = 420;  ///< and over a box in space: corners, faces, forces on them (counted)
constexpr double spin_bytes = 120;        ///< that a spinning frame's force takes, its means included (counted)
constexpr double inertia_bytes =
    92;  ///< that giving particles their inertia takes where no two radii are equal (counted)

}  // namespace

std::string frame_text(const Frame& frame) {
  const Vector3& c = frame.velocity;
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (frame.angle != 0) add("turned by " + rounded_text(frame.angle, 4) + " rad");
  if (frame.spin != 0) add("spin " + rounded_text(frame.spin, 4) + " rad/s");
  if (c != Vector3::Zero()) {
    const std::string z = c.z() == 0 ? "" : ", " + rounded_text(c.z(), 4);
    add("velocity (" + rounded_text(c.x(), 4) + ", " + rounded_text(c.y(), 4) + z + ") m/s");
  }
  return text.empty() ? "the body's own" : text;
}

template <int Dim>
std::string ProblemIn<Dim>::motion_text() const {
  if (const auto* vortex = scene.motion.as<Vortex3d>()) {
    const std::string which = vortex->vortices.empty() ? in_plain_words(word_of(vortex->one.profile))
                                                       : std::to_string(vortex->vortices.size()) + " vortices";
    return "; " + which + "; amplitude " + rounded_text(vortex->amplitude.peak, 4);
  }
  if (is_vortex(scene.motion)) return "; amplitude " + rounded_text(scene.motion->amplitude()->peak, 4);
  std::string text = "; " + motion_type(scene);
  if (setup.traction) {
    text += ", traction by " + in_plain_words(word_of(setup.traction->algorithm)) + ", " +
            word_of(setup.traction->form) + " form";
  }
  return text;
}

template <int Dim>
std::string ProblemIn<Dim>::subject() const {
  const mpm::MethodNames names = mpm::names_of(setup.method);
  const mpm::Method& method = setup.method;
  std::string per_cell;
  for (std::size_t d = 0; d < Dim; ++d) per_cell += (d == 0 ? "" : "x") + std::to_string(scene.body.per_cell[d]);
  std::string way = names.basis + (method.is_total() ? ", total, " : ", ") + names.transfer + ", " + names.update;
  if (method.mass != mpm::Mass::lumped) way += ", " + names.mass;
  if (method.has_terms()) way += " " + std::to_string(method.terms);
  if (method.integrator != mpm::Integrator::symplectic_euler) way += ", " + word_of(method.integrator);
  for (const auto& effect : mpm::effects<Dim>()) {
    if (effect.in_title && effect.called_for(setup)) way += ", " + effect.in_title(setup.options);
  }
  return material->name() + "; " + way + "; h = " + scene.units.text(scene.grid->spacing, "m", 4) + "; " + per_cell +
         " a cell" + (scene.body.lattice == Body::Lattice::cartesian ? "" : ", " + word_of(scene.body.lattice)) +
         motion_text() + (scene.frame ? "; frame: " + frame_text(*scene.frame) : "") +
         (setup.uses_exact_solution() ? "; uses the exact solution" : "");
}

template <int Dim>
double ProblemIn<Dim>::estimated_bytes() const {
  double bytes = static_cast<double>(setup.grid.nodes()) * static_cast<double>(mpm::grid_bytes_per_node(setup));
  for (const auto& use : mpm::columns_of(mpm::compose(setup), setup)) {
    bytes += static_cast<double>(use.bytes) * static_cast<double>(setup.seeds.size());
  }
  // Which nodes have rows is known from the seeds.
  bytes -= static_cast<double>((setup.grid.nodes() - mpm::nodes_with_mass_rows(setup)) * mpm::mass_row_bytes(setup));
  const auto stepped = static_cast<double>(setup.seeds.size()), held = static_cast<double>(setup.seeds.held.size());
  constexpr double seed = Dim * sizeof(double), ring_point = 2 * sizeof(double) + sizeof(std::uint32_t);
  bytes += seed * (2 * stepped + held);  // the problem and its run have them
  // In the plane force field and error sampler; in space blocks of these are made as they are asked for.
  if (compared) bytes += stepped * (Dim == 2 ? 2 * ring_point + 4 * sizeof(double) : 2 * sizeof(double));
  if (setup.seeds.domains || setup.evaluation == mpm::Evaluation::domain_average) {
    bytes += stepped * (Dim == 3                                     ? hexahedron_bytes
                        : scene.body.lattice == Body::Lattice::polar ? sector_bytes
                                                                     : cell_bytes);
  }
  if (Dim == 2 && setup.frame && setup.frame->spin != 0) bytes += stepped * spin_bytes;
  if (Dim == 2 && setup.uses_exact_solution()) bytes += stepped * inertia_bytes;
  bytes += static_cast<double>(setup.seeds.corners.size() * sizeof(mpm::Corners<Dim>));
  if (scene.force.response == ForceChoice::Response::shadow) {  // states and stress at both ends of a step, and F
    bytes += scene.force.radii * sizeof(double) * (2.0 * static_cast<double>(material->state_size()) + 4 * 9);
  }
  constexpr double shown = Dim == 2 ? 9 : 14;  // of a particle in a picture's frame: doubles
  if (compared && scene.output.pictures) bytes += stepped * 2 * shown * sizeof(double);  // two frames
  return bytes;
}

template struct ProblemIn<2>;
template struct ProblemIn<3>;

}  // namespace assay::drivers
