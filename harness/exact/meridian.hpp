// SPDX-License-Identifier: BSD-3-Clause
// DIV(T) of a body of revolution that turns by alpha = g(t) h(R, Z), from the baseline response of any material.
#pragma once

#include "harness/exact/response.hpp"
#include "harness/motion/kinds/vortex3d.hpp"

namespace assay {

/// What a material says of one xi and time. Nothing is stressed at rest, so that tau/xi is regular [Pa].
struct MeridianResponse {
  Tensor tau_by_xi = Tensor::Zero(), dtau_dxi = Tensor::Zero();
};

/// Near rest tau/xi is the mean of the slope, which no error is divided by: up to the first front, where there are any.
MeridianResponse meridian_response(const ResponseAtTime& response, double xi, double first_front);

/// The same of many, in their order.
std::vector<MeridianResponse> meridian_responses(const ResponseAtTime& response, std::span<const double> xi,
                                                 double first_front);

/// Along N, E_Theta, M, and so DIV(T) = Q (D_N N + D_Theta E_Theta + D_M M) [N/m^3]. With ' = (d/d xi)_t and k = Grad
/// h:
///   D_N     = tau11' xi_N + (tau11 - tau33) phi_M + (tau11 - tau22) c/R - beta tau21 c
///   D_Theta = tau21' xi_N + tau21 phi_M + (tau12 + tau21) c/R + beta tau11 c
///   D_M     = tau33' xi_M + (tau11 - tau33) phi_N + (tau22 - tau33) s/R + beta tau21 s
/// beta = g G; phi_M = H_MM/G, phi_N = H_NM/G of the Hessian of h; 2 xi_N = G c + R H_NN, 2 xi_M = -G s + R H_NM.
/// It is regular on the axis and where G = 0: with G = 2 xi/R, all that is divided by G or R is a part of tau/xi.
Vector3 divergence_piola(const MeridianPoint& p, double g, const MeridianResponse& response);

}  // namespace assay
