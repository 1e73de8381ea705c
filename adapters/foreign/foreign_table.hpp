// SPDX-License-Identifier: BSD-3-Clause
// From a description of a foreign model to a table of the material ABI.
#pragma once

#include <stdexcept>
#include <string>

#include "adapters/foreign/foreign_model.hpp"

namespace assay::adapters {

/// A foreign model that cannot be bound: what() is one sentence, key() the key of its description to blame.
class ForeignError : public std::runtime_error {
 public:
  ForeignError(std::string key, const std::string& what, std::string known = {})
      : std::runtime_error(what), key_(std::move(key)), known_(std::move(known)) {}
  const std::string& key() const { return key_; }
  const std::string& known() const { return known_; }

 private:
  std::string key_, known_;
};

/// Loads the library into this process and binds its entry point; what metadata can tell is filled in. The table lives
/// as long as the process. Throws ForeignError, LibraryError.
const assay_material* foreign_table(const ForeignModel& model);

/// Variables of a point's state that the bridge keeps beside those of the model, before them.
std::size_t bridge_variables(const ForeignModel& model);

}  // namespace assay::adapters
