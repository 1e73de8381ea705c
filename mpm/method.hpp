// SPDX-License-Identifier: BSD-3-Clause
// The choices that make a particle method.
#pragma once

namespace assay::mpm {

enum class Basis { linear, ugimp, cpgimp, cpdi, bspline2, bspline3 };
enum class Transfer { pic, flip };
enum class Update { usf, usl, musl };
/// Of the body force: at the particle's reference position, or averaged over its reference domain.
enum class Evaluation { point, domain_average };

}  // namespace assay::mpm
