// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/body_faces.hpp"

#include <gtest/gtest.h>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_body_ends {
namespace {

Scene box_scene(const std::string& scene, const std::vector<std::string>& sets) {
  return read_scene(tree_folder() + "/configs/motions/" + scene + ".yaml", sets);
}

std::string refused_box(const std::string& scene, const std::vector<std::string>& sets) {
  return refusal_of([&] { assemble(box_scene(scene, sets), 1); });
}

TEST(BodyEnds, AreSymmetryPlanesAtWholeMetresAndAlongTheBar) {
  const auto whole = ends_of(box_scene("axis_aligned", {}));
  for (const auto& axis : whole) EXPECT_TRUE(axis.lower && axis.upper && !axis.periodic);
  const std::string part = "body={domain: box, lower: [0, -0.25], upper: [0.75, 1], per_cell: [2, 2]}";
  const auto of_box = ends_of(box_scene("axis_aligned", {part}));
  EXPECT_TRUE(of_box[0].lower && !of_box[0].upper && !of_box[1].lower && of_box[1].upper);
  const auto of_bar = ends_of(box_scene("bar_1d", {part}));
  EXPECT_TRUE(of_bar[0].lower && !of_bar[0].upper && of_bar[1].lower && of_bar[1].upper);
  const auto rigid = ends_of(box_scene("rigid", {"motion.spin=0", "body.periodic=x"}));
  EXPECT_TRUE(rigid[0].periodic && !rigid[1].any());
}

TEST(BodyEnds, AreRefusedWhereTheBodyCannotHaveThem) {
  const auto said = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  said(refused_box("axis_aligned", {"grid.spacing=0.3"}), "grid.spacing: body.upper = 1 is a symmetry plane");
  said(refused_box("axis_aligned", {"body.periodic=x"}), "body.periodic: the motion repeats after 2 m");
  said(refused_box("rigid", {"body.periodic=both"}), "body.periodic: a body that spins does not repeat");
  said(refused_box("axis_aligned", {"output.tractions=true"}), "output.tractions: compares tractions, and all faces");
  said(refused_box("axis_aligned", {"body.upper=[0.77, 0.77]"}), "body.upper: tractions act on the edges");
  EXPECT_EQ(refused_box("bar_1d", {"body.periodic=y"}), "accepted");
}

// Ends stay with the grid, and a frame takes the body away from them.
TEST(BodyEnds, AreNoneOfABodyThatAFrameMoves) {
  const auto in_space = [](const std::string& scene, std::vector<std::string> sets) {
    const std::string path = tree_folder() + "/configs/space/" + scene + ".yaml";
    return read_scene(path, sets);
  };
  const auto refused = [&](const std::string& scene, const std::vector<std::string>& sets) {
    return refusal_of([&] { assemble<3>(in_space(scene, sets), 1); });
  };
  for (const std::string& frame : {"{angle: 0.3}", "{spin: 0.3}", "{velocity: [1, 0]}"}) {
    const std::string set = "frame=" + frame;
    const ProblemIn<3> box = assemble<3>(in_space("axis_aligned", {set}), 1);
    for (const auto& axis : box.setup.ends) EXPECT_FALSE(axis.any()) << frame;
    EXPECT_TRUE(box.setup.traction) << frame;
    EXPECT_NE(refused("axis_aligned", {set, "body.upper=[2, 2, 2]", "body.periodic=all"})
                  .find("frame: moves the body against its periodic ends along x, which stay with the grid"),
              std::string::npos)
        << frame;
  }
  const std::string turned = "frame={angle: 0.3}", ends = refused("slab", {turned}),
                    planes = refused("slab", {turned, "body.periodic=none"});
  EXPECT_NE(ends.find("frame: moves the body against its periodic ends along z"), std::string::npos) << ends;
  EXPECT_NE(planes.find("frame: moves the body against its symmetry planes across z"), std::string::npos) << planes;
}

// Of a face that bears tractions, and where none does.
TEST(BodyEnds, TractionsActOnTheOtherFaces) {
  const Problem whole = assemble(box_scene("axis_aligned", {}), 1);
  EXPECT_FALSE(whole.setup.traction);
  const Problem part = assemble(box_scene("bar_1d", {"body.upper=[0.75, 0.25]"}), 1);
  ASSERT_TRUE(part.setup.traction);
  EXPECT_EQ(part.setup.seeds.surface.size(), 8u);  // edges of 1/32 m on a face of 1/4 m
  for (const auto& edge : part.setup.seeds.surface) EXPECT_EQ(edge.middle[0], 0.75);
}

}  // namespace
}  // namespace assay::drivers::test_body_ends
