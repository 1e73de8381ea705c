// SPDX-License-Identifier: BSD-3-Clause
// Keys of effects, told as a scene tells them.
#pragma once

#include <string>

#include "mpm/compose.hpp"

namespace assay::mpm {

class OneKey final : public Keys {
 public:
  OneKey(std::string name, KeyValue value) : name_(std::move(name)), value_(std::move(value)) {}
  bool is_met = false;

 protected:
  std::optional<KeyValue> meet(const KeyInfo& key, KeyType, const KeyValue&) override {
    if (key.name != name_) return std::nullopt;
    is_met = true;
    return value_;
  }

 private:
  std::string name_;
  KeyValue value_;
};

/// Whether some effect has the key.
inline bool tell(EffectOptions& options, const std::string& key, const KeyValue& value) {
  OneKey one(key, value);
  for (const auto& effect : effects<2>()) {
    if (effect.keys) effect.keys(options, one);
  }
  return one.is_met;
}

}  // namespace assay::mpm
