// SPDX-License-Identifier: BSD-3-Clause
// Descriptions of foreign models at random, and whether two are the same.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "drivers/material/material_description.hpp"

namespace assay::drivers {

/// YAML of descriptions that hold every key or not, in every form that a key may have.
class RandomDescription {
 public:
  explicit RandomDescription(unsigned seed) : random_(seed) {}

  std::string yaml() {
    interface_ = any(std::vector<std::string>{"umat", "vumat", "mfront"});
    std::string text = "library: " + any(texts_) + "\ninterface: " + interface_ + "\n";
    const auto maybe = [&](const std::string& key, const std::string& value) {
      if (chance()) text += key + ": " + value + "\n";
    };
    maybe("name", any(texts_));
    maybe("symbol", any(texts_));
    maybe("properties", properties());
    maybe("state", state());
    const bool of_abaqus = interface_ != "mfront";
    if (of_abaqus) maybe("kinematics", any({"objective", "abaqus"}));
    if (interface_ == "umat") maybe("axes", any({"fixed", "corotational"}));
    maybe("fields", any({"{}", "{T: 1}", "{\"a b\": -2.5, \"1\": 0}"}));
    if (of_abaqus) maybe("step", any({"1", "2"}));
    if (of_abaqus) maybe("npt", any({"1", "8"}));
    if (interface_ == "umat" && chance()) {
      text += any({"noel: 1\n", "noel: 100000\n", "elements: one\n", "elements: each\n"});
    }
    if (of_abaqus) maybe("strain", any({"small", "finite"}));
    maybe("symmetry", any({"isotropic", "cylindrically_orthotropic", "anisotropic", "orthotropic", "cubic"}));
    maybe("flags", any({"[]", "[non_smooth]", "[thread_safe, rate_dependent]", "[non_smooth, non_smooth]"}));
    if (of_abaqus) maybe("components", any({"4", "[6]", "[4, 6]", "[6, 4]"}));
    maybe("units", any({"{}", "{stress: MPa}", "{length: in, time: h}", "{stress: ksi, time: us, length: mm}"}));
    maybe("temperature", number());
    if (of_abaqus) maybe("characteristic_length", any({"1", "0.3333333333333333", "1e-300"}));
    if (of_abaqus) maybe("material_name", any(texts_));
    maybe("density", any({"1000", "0.1", "7.85e3"}));
    maybe("time_limit", any({"20", "0.5"}));
    maybe("memory_limit", any({"4", "0.25"}));
    return text;
  }

 private:
  bool chance() { return random_() % 2 == 0; }
  std::string any(const std::vector<std::string>& list) { return list[random_() % list.size()]; }
  std::string number() { return any({"0", "-0.0", "1", "-2.5", "1e-320", "1.7976931348623157e308", "0.1", "293.15"}); }

  std::string properties() {
    if (chance()) return any({"[]", "[1, 2.5, -3]", "[E, nu]", "[1, E, 2]", "[\"1\", two]"});
    std::string map;
    for (std::size_t k = random_() % 5; k > 0; --k) {
      map += (map.empty() ? "" : ", ") + key(k) + ": " +
             any({"~", number(), "{}", "{value: " + number() + "}", "{unit: MPa, doc: " + any(texts_) + "}",
                  "{value: 1, lower: " + any({"-2.5", "-0.0", "1e-320", "0.1", "1"}) +
                      ", upper: " + any({"1", "293.15", "1.7976931348623157e308"}) + "}"});
    }
    return "{" + map + "}";
  }

  std::string state() {
    if (chance()) return any({"0", "3", "[]", "[a, \"1\", c]"});
    std::string map;
    for (std::size_t k = random_() % 5; k > 0; --k) {
      map += (map.empty() ? "" : ", ") + key(k) + ": " +
             any({"scalar", "vector", "symmetric_tensor", "strain", "tensor", "mandel", "{initial: " + number() + "}",
                  "{}", "{kind: tensor, count: 3}", "{kind: strain, initial: " + number() + "}",
                  "{kind: vector, initial: [1, " + number() + ", 3], unit: " + any(texts_) + "}"});
    }
    return "{" + map + "}";
  }

  /// A key that no other has: a number, and what is hard to write.
  std::string key(std::size_t k) {
    return "\"" + any({"E", "a b", "x: y", "[1]", "true ", "1.5", "\u00e9", "#c", "- d", "q'", "~", "\\\"", "\\\\"}) +
           std::to_string(k) + "\"";
  }

  std::mt19937 random_;
  std::string interface_;
  std::vector<std::string> texts_{"plain", "\"\"", "\"1.5\"", "\"a: b # c\"", "'it''s'", "\"\u00fc\\\"\\\\\"",
                                  "lib.so"};
};

inline bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

inline void expect_same(const adapters::ForeignModel& a, const adapters::ForeignModel& b) {
  EXPECT_EQ(a.interface, b.interface);
  EXPECT_EQ(a.symbol, b.symbol);
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.properties.size(), b.properties.size());
  for (std::size_t k = 0; k < a.properties.size(); ++k) {
    const adapters::ForeignProperty &p = a.properties[k], &q = b.properties[k];
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(p.unit + "|" + p.doc, q.unit + "|" + q.doc);
    EXPECT_TRUE(same(p.value, q.value) && p.lower == q.lower && p.upper == q.upper) << p.name;
  }
  ASSERT_EQ(a.state.size(), b.state.size());
  for (std::size_t k = 0; k < a.state.size(); ++k) {
    const adapters::ForeignVariable &v = a.state[k], &w = b.state[k];
    EXPECT_EQ(v.name + "|" + v.unit + "|" + v.doc, w.name + "|" + w.unit + "|" + w.doc);
    EXPECT_EQ(v.kind, w.kind);
    EXPECT_EQ(v.initial, w.initial);
    EXPECT_EQ(v.kind_is_said, w.kind_is_said) << v.name;
  }
  EXPECT_EQ(a.kinematics, b.kinematics);
  EXPECT_EQ(a.axes, b.axes);
  EXPECT_EQ(a.step, b.step);
  ASSERT_EQ(a.fields.size(), b.fields.size());
  for (std::size_t k = 0; k < a.fields.size(); ++k) {
    EXPECT_EQ(a.fields[k].name, b.fields[k].name);
    EXPECT_EQ(a.fields[k].value, b.fields[k].value);
  }
  EXPECT_EQ(a.element, b.element);
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.each_its_element, b.each_its_element);
  EXPECT_EQ(a.finite_strain, b.finite_strain);
  EXPECT_EQ(a.strain_is_said, b.strain_is_said);
  EXPECT_EQ(a.components, b.components);
  EXPECT_EQ(a.components_are_said, b.components_are_said);
  EXPECT_EQ(a.symmetry, b.symmetry);
  EXPECT_EQ(a.symmetry_is_said, b.symmetry_is_said);
  EXPECT_EQ(a.material_class, b.material_class);
  EXPECT_EQ(a.flags, b.flags);
  EXPECT_EQ(a.flags_are_said, b.flags_are_said);
  EXPECT_TRUE(a.units.stress == b.units.stress && a.units.time == b.units.time && a.units.length == b.units.length);
  EXPECT_EQ(a.temperature, b.temperature);
  EXPECT_EQ(a.temperature_is_said, b.temperature_is_said);
  EXPECT_EQ(a.characteristic_length, b.characteristic_length);
  EXPECT_EQ(a.density, b.density);
  EXPECT_EQ(a.material_name, b.material_name);
}

inline void expect_same(const MaterialDescription& a, const MaterialDescription& b) {
  EXPECT_EQ(a.library, b.library);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.parameters, b.parameters);
  EXPECT_EQ(a.density, b.density);
  EXPECT_EQ(a.limits.seconds, b.limits.seconds);
  EXPECT_EQ(a.limits.gigabytes, b.limits.gigabytes);
  ASSERT_EQ(a.foreign.has_value(), b.foreign.has_value());
  if (a.foreign) expect_same(*a.foreign, *b.foreign);
}

}  // namespace assay::drivers
