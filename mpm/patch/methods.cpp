// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/patch/methods.hpp"

namespace assay::mpm {

namespace {

std::string why_angular_momentum_changes(const Method& method) {
  if (method.is_total())
    return "forces in the reference configuration have a moment about the current positions, because the grid "
           "reproduces X and not x";
  if (method.keeps_velocity()) return "the velocity increments of FLIP have a moment of their own";
  if (!method.is_affine()) return "a particle that takes over the grid's velocity loses its angular momentum";
  if (method.affine == Affine::gradient) return "the velocity gradient conserves the moment of affine motions only";
  return std::string(traits_of<2>(method.basis).why_not_angular_momentum);
}

}  // namespace

std::vector<Method> all_methods() {
  std::vector<Method> methods;
  const auto add = [&](const Method& method) {
    if (!contradiction(method)) methods.push_back(method);
  };
  for (const Formulation formulation : {Formulation::updated, Formulation::total}) {
    for (std::size_t k = 0; k < names_of(Basis{}).size(); ++k) {
      const auto basis = static_cast<Basis>(k);
      const auto add_last = [&](Transfer transfer, Mass mass = Mass::lumped, Affine affine = Affine::gradient) {
        add({basis, transfer, Update::usl, formulation, mass, affine});
      };
      for (const Transfer transfer : {Transfer::pic, Transfer::flip}) {
        for (const Update update : {Update::usf, Update::usl, Update::musl})
          add({basis, transfer, update, formulation});
      }
      for (const Transfer transfer : {Transfer::xpic, Transfer::fmpm, Transfer::apic, Transfer::aflip})
        add_last(transfer);
      for (const Transfer transfer : {Transfer::apic, Transfer::aflip})
        add_last(transfer, Mass::lumped, Affine::moment);
      for (const Transfer transfer : {Transfer::flip, Transfer::aflip}) add_last(transfer, Mass::series);
      // Its matrix is that of the basis: one of each kind tells.
      const bool total = formulation == Formulation::total;
      if (basis == (total ? Basis::bspline2 : Basis::cpdi)) add_last(Transfer::flip, Mass::consistent);
      // Stages with the matrix of nodes, and by way of the particles.
      for (const Mass mass : {Mass::lumped, Mass::series}) {
        if (basis == Basis::bspline2 || (basis == Basis::cpdi && mass == Mass::lumped))
          add({basis, Transfer::flip, Update::usl, formulation, mass, Affine::gradient, Integrator::symplectic_rkn4});
      }
    }
  }
  return methods;
}

const char* word_of(auto value) { return names_of(value)[static_cast<std::size_t>(value)]; }

MethodNames names_of(const Method& method) {
  return {word_of(method.basis), word_of(method.formulation), word_of(method.transfer), word_of(method.update),
          word_of(method.mass)};
}

std::string name_of(const Method& method) {
  const MethodNames names = names_of(method);
  std::string name = names.basis + "/" + names.transfer;
  if (method.transfer == Transfer::xpic || method.transfer == Transfer::fmpm) name += std::to_string(method.terms);
  if (method.is_affine() && method.affine == Affine::moment) name += "_moment";
  if (method.flip != 1) name += "_blend";
  name += "/" + names.update;
  if (method.mass == Mass::series) name += "/series" + std::to_string(method.terms);
  if (method.mass == Mass::consistent) name += "/consistent";
  if (method.has_stages()) name += "/symplectic_rkn4";
  return method.is_total() ? name + "/total" : name;
}

std::string exemption(const Method& method, const std::string& test) {
  const BasisTraits basis = traits_of<2>(method.basis);
  if (test == "momentum.angular" || test == "tilted.angular") return why_angular_momentum_changes(method);
  if (test.starts_with("rotation.")) {
    if (method.transfer == Transfer::pic)
      return "PIC smooths the velocity in every step, so shorter steps give more smoothing";
    return std::string(basis.why_not_rotation);
  }
  if (test == "stress.deformed" && method.is_total()) return {};  // the lattice as it was seeded
  if (test == "stress.deformed" || test == "stress.graded" || test == "stress.jittered") {
    const bool fits = test == "stress.jittered" && basis.why_not_deformed.empty();
    return std::string(fits ? basis.why_not_jittered : basis.why_not_deformed);
  }
  if (test.starts_with("surface.")) {
    const bool fits = test == "surface.free" && !basis.keeps_domains();  // the body is a lattice on the grid's cells
    return std::string(fits || method.is_total() ? basis.why_not_surface : basis.why_not_deformed);
  }
  return {};
}

}  // namespace assay::mpm
