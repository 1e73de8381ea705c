// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/patch/methods.hpp"

namespace assay::mpm {

std::vector<Method> all_methods() {
  std::vector<Method> methods;
  for (const Basis basis :
       {Basis::linear, Basis::ugimp, Basis::cpgimp, Basis::cpdi, Basis::bspline2, Basis::bspline3}) {
    for (const Transfer transfer : {Transfer::pic, Transfer::flip}) {
      for (const Update update : {Update::usf, Update::usl, Update::musl}) methods.push_back({basis, transfer, update});
    }
  }
  return methods;
}

const char* name_of(Basis basis) {
  constexpr const char* names[] = {"linear", "ugimp", "cpgimp", "cpdi", "bspline2", "bspline3"};
  return names[static_cast<int>(basis)];
}

MethodNames names_of(const Method& method) {
  const char* transfers[] = {"pic", "flip"};
  const char* updates[] = {"usf", "usl", "musl"};
  return {name_of(method.basis), "updated_lagrangian", transfers[static_cast<int>(method.transfer)],
          updates[static_cast<int>(method.update)], "lumped"};
}

std::string name_of(const Method& method) {
  const MethodNames names = names_of(method);
  return names.basis + "/" + names.transfer + "/" + names.update;
}

std::string exemption(const Method& method, const std::string& test) {
  const Basis basis = method.basis;
  if (test == "momentum.angular") {
    return method.transfer == Transfer::pic ? "a particle of PIC takes the grid's velocity and loses its own spin"
                                            : "with lumped mass the increments of FLIP have a moment of their own";
  }
  if (test.starts_with("rotation.")) {
    if (method.transfer == Transfer::pic) return "PIC smooths the velocity in every step, the more the shorter it is";
    if (basis == Basis::linear) return "the linear basis has a gradient that jumps where a particle changes its cell";
  }
  if (test == "stress.deformed" || test == "stress.graded" || test == "stress.jittered") {
    if (basis == Basis::linear) return "a particle of the linear basis counts whole for the cell that it is in";
    if (basis == Basis::ugimp) return "the boxes of uGIMP keep their size and shape, and leave gaps and overlap";
    if (basis == Basis::cpgimp) return "the boxes of cpGIMP keep to the axes, and leave gaps and overlap in shear";
    if (basis != Basis::cpdi)
      return "B-splines are sampled at the particles: points of unequal share are no quadrature";
    if (test == "stress.jittered") return "domains of CPDI that are moved one by one leave gaps and overlap";
  }
  return {};
}

}  // namespace assay::mpm
