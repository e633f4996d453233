#include "picture/facing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vp::picture::test
{

namespace
{

const Vec3 kX{1.0, 0.0, 0.0};
const Vec3 kY{0.0, 1.0, 0.0};
const Vec3 kZ{0.0, 0.0, 1.0};

probe::Sheet seen(const Vec3& normal, const char* orientation = "")
{
	return facingSheet(probe::makeSheet({1.0, 2.0, 3.0}, normal), grid::parseOrientation(orientation), false);
}

// Looks at a plane from `eye` with these directions to the right and up.
void expectView(const probe::Sheet& sheet, const Vec3& right, const Vec3& up, const Vec3& eye)
{
	EXPECT_LT(glm::length(sheet.xAxis() - right), 1e-12) << sheet.xAxis().x << sheet.xAxis().y << sheet.xAxis().z;
	EXPECT_LT(glm::length(sheet.up - up), 1e-12) << sheet.up.x << sheet.up.y << sheet.up.z;
	EXPECT_LT(glm::length(sheet.normal - eye), 1e-12) << sheet.normal.x << sheet.normal.y << sheet.normal.z;
	EXPECT_EQ(sheet.origin, Vec3(1.0, 2.0, 3.0));
}

using Sides = std::array<std::string, 4>; // left, right, lower, upper rim

Sides sides(const Vec3& normal, const char* orientation)
{
	return sidesOf(seen(normal, orientation), *grid::parseOrientation(orientation).patient);
}

} // namespace

TEST(Facing, EngineersDrawTheAxesThisWay)
{
	expectView(seen(kX), kY, kZ, kX);
	expectView(seen(kY), kX, kZ, -kY);
	expectView(seen(kZ), kX, kY, kZ);
	expectView(seen(-kX), -kY, kZ, -kX);
	expectView(seen(-kY), -kX, kZ, kY);
	expectView(seen(-kZ), -kX, kY, -kZ);
}

TEST(Facing, RowsOfARasterRunDown)
{
	expectView(seen(kZ, "rows-down"), kX, -kY, -kZ);
	expectView(seen(kY, "rows-down"), kX, -kZ, kY);
	expectView(seen(kX, "rows-down"), kZ, -kY, kX);
}

// Axial from the feet, coronal from the front, sagittal from the left, whatever the coordinates are.
TEST(Facing, RadiologistsSeeAPatientThisWay)
{
	expectView(seen(kZ, "LPS"), kX, -kY, -kZ);
	expectView(seen(kZ, "RAS"), -kX, kY, -kZ);
	for (const char* coordinates : {"LPS", "RAS", "LAS", "RPI"})
	{
		EXPECT_EQ(sides(kZ, coordinates), (Sides{"R", "L", "P", "A"})) << coordinates;
		EXPECT_EQ(sides(kY, coordinates), (Sides{"R", "L", "F", "H"})) << coordinates;
		EXPECT_EQ(sides(kX, coordinates), (Sides{"A", "P", "F", "H"})) << coordinates;
		// From the opposite side.
		EXPECT_EQ(sides(-kZ, coordinates), (Sides{"L", "R", "P", "A"})) << coordinates;
	}
	// The axes may be in any order: here x runs to the front, y to the head and z to the left.
	EXPECT_EQ(sides(kZ, "ASL"), (Sides{"A", "P", "F", "H"}));
	// An oblique plane has the sides of the nearest axes.
	EXPECT_EQ(sides(glm::normalize(Vec3{0.1, -0.2, 1.0}), "LPS"), (Sides{"R", "L", "P", "A"}));
	EXPECT_EQ(sides(glm::normalize(Vec3{0.1, -0.2, -1.0}), "LPS"), (Sides{"L", "R", "P", "A"})); // as -z
}

// A plane that leans by 20 degrees is seen from the same side as the one it is nearest to, with the same side up.
TEST(Facing, APatientsObliquePlanesLookLikeTheNearest)
{
	const double c = std::cos(20.0 * 3.14159265358979323846 / 180.0);
	const double s = std::sqrt(1.0 - c * c);
	// Axial, leaning to the back in LPS and to the front in RAS: from the feet, the patient's left to the right.
	expectView(seen({0.0, s, c}, "LPS"), kX, {0.0, -c, s}, {0.0, -s, -c});
	expectView(seen({0.0, s, c}, "RAS"), -kX, {0.0, c, -s}, {0.0, -s, -c});
	expectView(seen({0.0, -s, -c}, "RAS"), kX, {0.0, c, -s}, {0.0, s, c}); // as -z: from the head
	// Coronal, leaning to the head: from the front.
	expectView(seen({0.0, c, s}, "RAS"), -kX, {0.0, -s, c}, {0.0, c, s});
	// Sagittal, leaning to the front: from the left, the back to the right.
	expectView(seen({c, s, 0.0}, "RAS"), {s, -c, 0.0}, kZ, {-c, -s, 0.0});
	// Far from each of them, from the side of the normal.
	const Vec3 corner = glm::normalize(Vec3{1.0, 1.0, 1.0});
	EXPECT_LT(glm::length(seen(corner, "RAS").normal - corner), 1e-12);
	// Where nothing tells of a patient, too.
	EXPECT_LT(glm::length(seen({0.0, s, -c}).normal - Vec3{0.0, s, -c}), 1e-12);
}

TEST(Orientation, IsThatOfAllBlocks)
{
	grid::BlockSet blocks;
	EXPECT_FALSE(orientationOf(blocks).isGiven());
	blocks.blocks.resize(2);
	blocks.blocks[0].imaging = {.orientation = "RAS", .gray = true};
	blocks.blocks[1].imaging = {.orientation = "RAS", .labels = true};
	EXPECT_EQ(orientationOf(blocks), grid::parseOrientation("RAS"));
	blocks.blocks[1].imaging.orientation = "LPS";
	EXPECT_FALSE(orientationOf(blocks).isGiven());
}

TEST(Facing, LeftHandedCoordinatesAreMirroredAsTheyAre)
{
	// In LAS the frame of axes is left-handed, so the eye is at the head's side of the coordinates.
	expectView(seen(kZ, "LAS"), kX, kY, kZ);
}

TEST(Facing, OtherPlanesHaveZUp)
{
	const Vec3 normal = glm::normalize(Vec3{0.3, 0.5, 0.8});
	const probe::Sheet sheet = seen(normal);
	EXPECT_LT(glm::length(sheet.normal - normal), 1e-12);
	EXPECT_NEAR(sheet.xAxis().z, 0.0, 1e-12);
	EXPECT_NEAR(sheet.up.z, std::hypot(normal.x, normal.y), 1e-12);
	EXPECT_GT(seen(glm::normalize(Vec3{0.001, 0.0, 1.0})).up.y, 0.99); // where the projection of z is too short
	EXPECT_LT(seen(normal, "rows-down").up.y, 0.0);
}

TEST(Facing, AGivenUpWins)
{
	const probe::Sheet sheet = probe::makeSheet({1.0, 2.0, 3.0}, kY, kX);
	expectView(facingSheet(sheet, {}, true), -kZ, kX, -kY);
	const probe::Sheet oblique = probe::makeSheet({1.0, 2.0, 3.0}, {1.0, 1.0, 1.0}, kX);
	const probe::Sheet kept = facingSheet(oblique, {}, true);
	EXPECT_LT(glm::length(kept.up - oblique.up), 1e-12);
	EXPECT_LT(glm::length(kept.normal - oblique.normal), 1e-12);
}

TEST(Facing, AWindowIsTheFrame)
{
	// The sheet's own axes of a plane normal to x are (up x normal, up) = (-z, y), so its left side is high in the
	// picture.
	probe::Sheet sheet = probe::makeSheet({1.0, 2.0, 3.0}, kX);
	sheet.window = probe::Window{-1.0, 2.0, -3.0, 4.0};
	const probe::Sheet shown = facingSheet(sheet, {}, false);
	expectView(shown, kY, kZ, kX);
	ASSERT_TRUE(shown.window);
	EXPECT_EQ(*shown.window, (probe::Window{-3.0, 4.0, -2.0, 1.0}));

	// A window that lies askew turns by quarters only.
	sheet = probe::makeSheet({1.0, 2.0, 3.0}, kZ, {-0.2, 1.0, 0.0});
	sheet.window = probe::Window{-1.0, 2.0, -3.0, 4.0};
	EXPECT_LT(glm::length(facingSheet(sheet, {}, false).up - sheet.up), 1e-12);
	EXPECT_EQ(*facingSheet(sheet, {}, false).window, *sheet.window);
}

TEST(Orientation, Texts)
{
	EXPECT_TRUE(grid::parseOrientation("rows-down").first_row_is_top);
	EXPECT_FALSE(grid::parseOrientation("").isGiven());
	for (const char* none : {"LPX", "LLS", "LP", "LRS", "lps"})
		EXPECT_FALSE(grid::parseOrientation(none).isGiven()) << none;
	EXPECT_EQ(grid::parseOrientation("RAI"), grid::parseOrientation("RAF"));
}

} // namespace vp::picture::test
