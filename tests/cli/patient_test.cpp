// Pictures of a patient: what is where, and which letters tell it.

#include "png_pixels.h"
#include "program.h"

#include <array>
#include <cstring>
#include <vector>

namespace cli
{

namespace
{

constexpr int kSide = 9;

// A NIfTI file of 9 x 9 x 9 voxels of 1 mm, stored from the patient's right to the left. Its coordinates, 0 to 8, run
// to the right, the front and the head (RAS). The voxels of the left, front and upper corner have 1, the others 0.
std::string cornerOfAPatient()
{
	std::string bytes(352, '\0');
	const auto put = [&](std::size_t at, auto... values)
	{ ((std::memcpy(&bytes[at], &values, sizeof values), at += sizeof values), ...); };
	const auto shorts = [](int value) { return static_cast<std::int16_t>(value); };
	put(0, std::int32_t(348));
	put(40, shorts(3), shorts(kSide), shorts(kSide), shorts(kSide), shorts(1), shorts(1), shorts(1), shorts(1));
	put(70, shorts(16), shorts(32)); // float
	put(76, 1.0f, 1.0f, 1.0f, 1.0f);
	put(108, 352.0f, 1.0f); // where the voxels begin, and the slope of their values
	bytes[123] = 2;         // mm
	put(254, shorts(1));    // the three rows below are coordinates of the scanner
	put(280, -1.0f, 0.0f, 0.0f, 8.0f);
	put(296, 0.0f, 1.0f, 0.0f, 0.0f);
	put(312, 0.0f, 0.0f, 1.0f, 0.0f);
	std::memcpy(&bytes[344], "n+1", 4);
	for (int k = 0; k < kSide; ++k)
		for (int j = 0; j < kSide; ++j)
			for (int i = 0; i < kSide; ++i)
			{
				const float value = i >= 6 && j >= 6 && k >= 6 ? 1.0f : 0.0f;
				bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
			}
	return bytes;
}

class Patient : public Program
{
protected:
	// Returns where the corner is seen, from the middle of the plane, in parts of the picture: x to the right, y up.
	std::array<double, 2> cornerSeen(const Arguments& plane) const
	{
		const Arguments bare{"--classify",  "cpu",     "--colormap", "viridis",        "--no-legend", "--no-inset",
		                     "--no-footer", "--title", "",           "--size",         "300x300",     "--range",
		                     "0",           "1",       "-o",         path("plane.png")};
		const Outcome drawn = run(Arguments{"slice", path("patient.nii")} + plane + bare, noDevice());
		EXPECT_TRUE(isQuiet(drawn)) << drawn.err;
		const Pixels pixels = readPixels(path("plane.png"));
		std::array<double, 3> corner{}; // sums of x and y, and the number of pixels
		std::array<double, 3> rest{};
		for (std::size_t p = 0; 4 * p < pixels.rgba.size(); ++p)
		{
			const unsigned char* rgb = &pixels.rgba[4 * p];
			const bool is_yellow = rgb[0] > 200 && rgb[1] > 190 && rgb[2] < 90;
			const bool is_violet = rgb[0] < 90 && rgb[1] < 40 && rgb[2] > 60;
			if (!is_yellow && !is_violet)
				continue;
			auto& sums = is_yellow ? corner : rest;
			sums[0] += static_cast<double>(p % pixels.width);
			sums[1] += static_cast<double>(p / pixels.width);
			++sums[2];
		}
		EXPECT_GT(corner[2], 200.0);
		EXPECT_GT(rest[2], 5.0 * corner[2]);
		return {(corner[0] / corner[2] - rest[0] / rest[2]) / pixels.width,
		        -(corner[1] / corner[2] - rest[1] / rest[2]) / pixels.height};
	}

	void SetUp() override { write("patient.nii", cornerOfAPatient()); }
};

class PatientInSpace : public Drawing
{
};

} // namespace

// By the radiological convention the reader looks at an axial plane from the feet, at a coronal one from the front, and
// at a sagittal one from the left. Planes that lean by some 15 degrees look the same way.
TEST_F(Patient, IsSeenByTheConventionThoughThePlaneLeans)
{
	constexpr double kFar = 0.12;
	for (const Arguments& axial : {Arguments{"--normal", "z", "--origin", "4", "4", "7"},
	                               Arguments{"--normal", "0", "0.26", "0.97", "--origin", "4", "6", "7"}})
	{
		const auto [right, up] = cornerSeen(axial);
		EXPECT_GT(right, kFar); // the patient's left is to the right
		EXPECT_GT(up, kFar);    // the front is up
	}
	for (const Arguments& coronal : {Arguments{"--normal", "y", "--origin", "4", "7", "4"},
	                                 Arguments{"--normal", "0.1", "0.97", "-0.2", "--origin", "4", "7", "6"}})
	{
		const auto [right, up] = cornerSeen(coronal);
		EXPECT_GT(right, kFar);
		EXPECT_GT(up, kFar); // the head is up
	}
	for (const Arguments& sagittal : {Arguments{"--normal", "x", "--origin", "1", "4", "4"},
	                                  Arguments{"--normal", "0.96", "0.2", "-0.15", "--origin", "1", "6", "6"}})
	{
		const auto [right, up] = cornerSeen(sagittal);
		EXPECT_LT(right, -kFar); // the front is to the left
		EXPECT_GT(up, kFar);
	}
	// A normal that runs the other way looks from the other side: here from the head.
	const auto [right, up] = cornerSeen({"--normal", "0", "-0.26", "-0.97", "--origin", "4", "6", "7"});
	EXPECT_LT(right, -kFar);
	EXPECT_GT(up, kFar);
}

// The same picture, but for the letters in its lower left corner.
TEST_F(PatientInSpace, HasLettersAtTheAxes)
{
	const auto drawn = [&](const std::string& space)
	{
		std::string text = "NRRD0004\ntype: float\ndimension: 3\nsizes: 3 3 3\nencoding: ascii\n" + space +
		                   "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n\n";
		for (int i = 0; i < 27; ++i)
			text += std::to_string(i) + "\n";
		write("a.nrrd", text);
		EXPECT_TRUE(isQuiet(run({"render", path("a.nrrd"), "--size", "320x240", "--samples", "1", "--colormap",
		                         "viridis", "--range", "0", "26", "-o", path("a.png")})));
		return readPixels(path("a.png"));
	};
	const Pixels plain = drawn("space dimension: 3\n");
	const Pixels lps = drawn("space: left-posterior-superior\n");
	const Pixels ras = drawn("space: right-anterior-superior\n");
	const auto apart = [&](const Pixels& a, const Pixels& b)
	{
		std::size_t pixels = 0;
		for (const auto& region : regionsApart(a, b))
			for (const std::size_t pixel : region)
			{
				EXPECT_LT(pixel % 320, 75u);
				EXPECT_GT(pixel / 320, 165u);
				++pixels;
			}
		return pixels;
	};
	EXPECT_GT(apart(plain, lps), 60u); // x, y, z and L, P, H
	EXPECT_GT(apart(plain, ras), 60u); // R, A, H
	EXPECT_GT(apart(lps, ras), 20u);
	EXPECT_LT(apart(lps, ras), apart(plain, lps)); // H is in both
}

} // namespace cli
