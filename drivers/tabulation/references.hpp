// SPDX-License-Identifier: BSD-3-Clause
// What a tabulated response is compared with: whatever of the material does not come from the same equations.
#pragma once

#include <memory>
#include <string>

#include "drivers/result/result.hpp"
#include "harness/exact/response.hpp"

namespace assay::drivers {

/// Largest difference of the tabulated tau to the material's closed form of the path, relative to its largest
/// component, at 17 x 17 regular xi and t; none without one.
Figure difference_to_closed_form(const std::shared_ptr<const Material>& material, const Path& path,
                                 const Response& response, double end);

/// Largest difference between tau by the material's rate form and by its increments, relative to the largest
/// component, at 4 values of xi and 8 times; none without a rate
/// form, or where the material has kinks. Throws MaterialFailure.
Figure difference_of_forms(const Material& material, const Path& path, double end);

/// Both, as far as there are any.
ReferenceFigures references_of(const std::shared_ptr<const Material>& material, const Path& path,
                               const Response& response, double end);

/// One line each, or one that says that there is none.
std::string references_text(const ReferenceFigures& references, const std::string& path_name);

}  // namespace assay::drivers
