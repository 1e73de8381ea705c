// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/setup/method.hpp"

#include "mpm/setup/with_basis.hpp"

namespace assay::mpm {

template <int Dim>
BasisTraits traits_of(Basis basis) {
  return with_basis<Dim>(basis, [basis](auto tag) {
    using B = typename decltype(tag)::type;
    BasisTraits traits = B::traits;
    if (traits.name.empty()) traits.name = names_of(basis)[static_cast<std::size_t>(basis)];
    traits.at_points = B::domain_components == 0 && !traits.moves_corners;
    traits.domain_components = B::domain_components, traits.bytes = B::bytes, traits.nodes_across = B::nodes_across;
    return traits;
  });
}

template BasisTraits traits_of<2>(Basis);
template BasisTraits traits_of<3>(Basis);

std::string bases_in_words() {
  std::string list;
  for (std::size_t k = 0; k < names_of(Basis{}).size(); ++k) {
    list.append(k == 0 ? "" : ", ").append(traits_of<2>(static_cast<Basis>(k)).name);
  }
  return list;
}

std::string bases_that(bool BasisTraits::*trait, const std::string& and_or) {
  std::string list, last;
  for (std::size_t k = 0; k < names_of(Basis{}).size(); ++k) {
    if (!(traits_of<2>(static_cast<Basis>(k)).*trait)) continue;
    list += last.empty() ? "" : list.empty() ? last : ", " + last;
    last = names_of(Basis{})[k];
  }
  return list.empty() ? last : list + " " + and_or + " " + last;
}

namespace {

std::optional<Contradiction> first_true(std::initializer_list<std::pair<bool, Contradiction>> all) {
  for (const auto& [is_true, found] : all) {
    if (is_true) return found;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Contradiction> contradiction(const Method& m) {
  const BasisTraits basis = traits_of<2>(m.basis);
  const bool has_moment = m.is_affine() && m.affine == Affine::moment;
  const bool stages = m.has_stages();  // a symplectic step of them wants x' = A v, v' = B(x, t) and nothing else
  return first_true(
      {{m.is_total() && !basis.why_not_total.empty(), {"method.basis", std::string(basis.why_not_total)}},
       {m.mass != Mass::lumped && (m.transfer == Transfer::xpic || m.transfer == Transfer::fmpm),
        {"method.mass", "xpic and fmpm are series of the mass matrix themselves: take lumped"}},
       {m.mass == Mass::series && m.transfer == Transfer::pic,
        {"method.mass", "pic with a series of the mass matrix is transfer: fmpm"}},
       {has_moment && !basis.why_no_second_moment.empty(), {"method.affine", std::string(basis.why_no_second_moment)}},
       {m.flip != 1 && !m.keeps_velocity(),
        {"method.flip", "blends flip or aflip with the grid's velocity, and transfer is neither"}},
       {stages && !m.is_total(),
        {"method.integrator",
         "symplectic_rkn4 needs weights that do not move with the particles: take formulation: total"}},
       {stages && m.transfer == Transfer::aflip,
        {"method.transfer",
         "symplectic_rkn4 has no place for the gradient that aflip carries from step to step: take flip"}},
       {stages && m.transfer != Transfer::flip,
        {"method.transfer",
         "only flip leaves the energy alone, and symplectic_rkn4 transfers back and forth: take flip"}},
       {stages && m.flip != 1,
        {"method.flip", "a share of the grid's velocity takes energy, which symplectic_rkn4 keeps: take 1"}},
       {stages && m.update != Update::usl,
        {"method.update", "symplectic_rkn4 moves F together with the positions: take usl"}}});
}

}  // namespace assay::mpm
