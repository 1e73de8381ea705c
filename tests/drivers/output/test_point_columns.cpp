// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/point_columns.hpp"

#include <gtest/gtest.h>

#include "drivers/system/input_error.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers::test_point_columns {
namespace {

std::string names(const std::string& asked, bool three = false, const PointsGiven& given = {}) {
  return joined(mapped(wanted_columns(asked, three, given).columns, &PointColumn::name));
}

std::string fields(const std::string& asked, bool three = false, const PointsGiven& given = {}) {
  return joined(mapped(wanted_columns(asked, three, given).fields,
                       [](const PointField& field) { return field.name + std::to_string(field.columns.size()); }));
}

std::string refusal(const std::string& asked, bool three = false, const PointsGiven& given = {}) {
  try {
    return names(asked, three, given);
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(PointColumns, AllInTheirOrder) {
  EXPECT_EQ(names(""),
            "X, Y, t, x, y, vx, vy, ax, ay, F11, F12, F21, F22, F33, P11, P12, P21, P22, P33, s11, s12, s22, "
            "s33, bx, by");
  EXPECT_EQ(fields(""), "X2, t1, x2, v2, a2, F9, P9, sigma6, b2");
  PointsGiven given;
  given.normals = given.boxes = true;
  EXPECT_EQ(names("", true, given).substr(names("", true, given).find("bx")), "bx, by, bz, V, mx, my, mz, tx, ty, tz");
  EXPECT_EQ(fields("", false, given), "X2, t1, x2, v2, a2, F9, P9, sigma6, b2, V1, m1, traction2");
}

TEST(PointColumns, NamesAndWordsForAllComponents) {
  EXPECT_EQ(names("by,x,bx"), "by, x, bx");
  EXPECT_EQ(fields("by,x,bx"), "by1, x1, bx1");
  EXPECT_EQ(names(" b , position,t"), "bx, by, x, y, t");
  EXPECT_EQ(fields("b,position,t"), "b2, x2, t1");
  EXPECT_EQ(names("sigma"), names("s"));
  EXPECT_EQ(names("s", true), "s11, s22, s33, s12, s13, s23");
  EXPECT_EQ(names("reference,x", true), "X, Y, Z, x");
  PointsGiven given;
  given.normals = true;
  EXPECT_EQ(names("traction", false, given), "tx, ty");
}

/// A tensor of the plane has zeros where it has no column.
TEST(PointColumns, FieldsKnowTheirComponents) {
  const PointColumns plane = wanted_columns("F,s", false, {});
  EXPECT_EQ(plane.fields[0].columns, (std::vector<int>{0, 1, -1, 2, 3, -1, -1, -1, 4}));
  EXPECT_EQ(plane.fields[1].columns, (std::vector<int>{5, 7, 8, 6, -1, -1}));
  EXPECT_EQ(wanted_columns("s", true, {}).fields[0].columns, (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

TEST(PointColumns, RefusesInOneLine) {
  EXPECT_TRUE(refusal("bx,bq").starts_with("--columns: unknown column 'bq' (nearest: b")) << refusal("bx,bq");
  EXPECT_TRUE(refusal("positon").starts_with("--columns: unknown column 'positon' (nearest: position)"));
  EXPECT_EQ(refusal("bx,b"), "--columns: column 'bx' twice");
  EXPECT_EQ(refusal("bx,,by"), "--columns: an empty name: names have a comma between them");
  EXPECT_EQ(refusal("bz"), "--columns: column 'bz' is there in three dimensions alone");
  EXPECT_EQ(refusal("F13"), "--columns: column 'F13' is there in three dimensions alone");
  for (const char* name : {"tx", "traction"})
    EXPECT_EQ(refusal(name),
              std::string("--columns: column '") + name + "' comes with the columns NX,NY of the points");
  for (const char* name : {"V", "m", "mz"})
    EXPECT_EQ(refusal(name),
              std::string("--columns: column '") + name + "' comes with the columns HX,HY of the points");
}

}  // namespace
}  // namespace assay::drivers::test_point_columns
