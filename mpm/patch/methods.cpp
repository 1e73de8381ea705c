// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/patch/methods.hpp"

namespace assay::mpm {

namespace {

/// What both formulations take besides pic and flip in all updates.
void add_choices(const Method& plain, std::vector<Method>& methods) {
  const auto add = [&](Transfer transfer, Mass mass = Mass::lumped, Affine affine = Affine::gradient) {
    Method method = plain;
    method.transfer = transfer;
    method.mass = mass;
    method.affine = affine;
    if (!contradiction(method)) methods.push_back(method);
  };
  for (const Transfer transfer : {Transfer::xpic, Transfer::fmpm, Transfer::apic, Transfer::aflip}) add(transfer);
  for (const Transfer transfer : {Transfer::apic, Transfer::aflip}) add(transfer, Mass::lumped, Affine::moment);
  for (const Transfer transfer : {Transfer::flip, Transfer::aflip}) add(transfer, Mass::series);
  // Its matrix is that of the basis: one of each kind tells.
  if (plain.basis == (plain.is_total() ? Basis::bspline2 : Basis::cpdi)) add(Transfer::flip, Mass::consistent);
  // The matrix of nodes, and by way of the particles.
  if (!plain.is_total() || (plain.basis != Basis::bspline2 && plain.basis != Basis::cpdi)) return;
  for (const Mass mass : {Mass::lumped, Mass::series}) {
    if (plain.basis == Basis::cpdi && mass != Mass::lumped) continue;
    Method method = plain;
    method.mass = mass;
    method.integrator = Integrator::symplectic_rkn4;
    methods.push_back(method);
  }
}

std::string why_angular_momentum_changes(const Method& method) {
  if (method.is_total())
    return "forces in the reference configuration have a moment about the current positions, because the grid "
           "reproduces X and not x";
  if (method.keeps_velocity()) return "the velocity increments of FLIP have a moment of their own";
  if (!method.is_affine()) return "a particle that takes over the grid's velocity loses its angular momentum";
  if (method.affine == Affine::gradient) return "the velocity gradient conserves the moment of affine motions only";
  return method.basis == Basis::cpdi2 ? "the centre of a quadrilateral moves slightly differently from its particle"
                                      : "";
}

/// Of a body that is no longer the lattice that it was.
std::string why_domains_do_not_fit(Basis basis) {
  if (basis == Basis::linear) return "with the linear basis, a particle contributes only to the cell that it is in";
  if (basis == Basis::ugimp) return "the domains of uGIMP keep their size and shape, so they overlap and leave gaps";
  if (basis == Basis::cpgimp)
    return "the domains of cpGIMP stay aligned with the axes, so they overlap and leave gaps in shear";
  return is_spline(basis) ? "B-splines are evaluated at the particles, which are no accurate quadrature points if "
                            "their volumes differ"
                          : "";
}

/// `fits`: the body is a lattice on the grid's cells as it is now.
std::string why_surface_is_unbalanced(const Method& method, bool fits) {
  if (!method.is_total() && (!fits || method.basis == Basis::ugimp)) return why_domains_do_not_fit(method.basis);
  if (method.basis == Basis::bspline3 || method.basis == Basis::bspline4)
    return "two points a cell do not integrate cubic and quartic B-splines exactly, and this shows at a face, which "
           "cuts the splines off";
  return {};
}

}  // namespace

std::vector<Method> all_methods() {
  std::vector<Method> methods;
  for (const Formulation formulation : {Formulation::updated, Formulation::total}) {
    for (std::size_t k = 0; k < names_of(Basis{}).size(); ++k) {
      const auto basis = static_cast<Basis>(k);
      for (const Transfer transfer : {Transfer::pic, Transfer::flip}) {
        for (const Update update : {Update::usf, Update::usl, Update::musl}) {
          Method method{basis, transfer, update};
          method.formulation = formulation;
          if (!contradiction(method)) methods.push_back(method);
        }
      }
      Method plain{basis};
      plain.formulation = formulation;
      add_choices(plain, methods);
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
  const Basis basis = method.basis;
  if (test == "momentum.angular") return why_angular_momentum_changes(method);
  if (test.starts_with("rotation.")) {
    if (method.transfer == Transfer::pic)
      return "PIC smooths the velocity in every step, so shorter steps give more smoothing";
    if (basis == Basis::linear)
      return "the gradient of the linear basis jumps when a particle crosses into another cell";
  }
  if (test == "stress.deformed" && method.is_total()) return {};  // the lattice as it was seeded
  if (test == "stress.deformed" || test == "stress.graded" || test == "stress.jittered") {
    if (test == "stress.jittered" && basis == Basis::cpdi)
      return "domains of CPDI that are moved independently overlap and leave gaps";
    return why_domains_do_not_fit(basis);
  }
  if (test.starts_with("surface.")) return why_surface_is_unbalanced(method, test == "surface.free");
  return {};
}

}  // namespace assay::mpm
