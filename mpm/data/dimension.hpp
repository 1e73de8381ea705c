// SPDX-License-Identifier: BSD-3-Clause
// The dimension that the sources of mpm are instantiated for. Each is compiled once for a dimension: for two into
// assay_mpm, for three into assay_mpm_3d, which property tests link and no scene asks for yet.
#pragma once

#ifndef ASSAY_DIMENSION
#define ASSAY_DIMENSION 2
#endif
