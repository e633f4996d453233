#include "surface/implicit_surface.h"
#include "surface/quadric.h"

#include <gtest/gtest.h>

#include <random>

namespace vp::test
{

TEST(ImplicitSurface, TellsWhatIsWrong)
{
	for (const auto& [text, says] :
	     {std::pair{"sphere", "a radius"}, std::pair{"sphere:", "a radius"}, std::pair{"sphere:-1", "above 0"},
	      std::pair{"sphere:1,2", "a radius"}, std::pair{"cylinder:0", "above 0"}, std::pair{"cone:90", "90 degrees"},
	      std::pair{"cone:nan", "opening angle"}, std::pair{"ellipsoid:1,2", "three half axes"},
	      std::pair{"ellipsoid:1,-2,3", "above 0"}, std::pair{"quadric:1,2", "ten numbers"},
	      std::pair{"quadric:0,0,0,0,0,0,0,0,0,3", "constant"}, std::pair{"iso:", "a value"},
	      std::pair{"iso:inf", "a value"}})
	{
		const Result<surface::ImplicitSurface> form = surface::ImplicitSurface::parse(text);
		ASSERT_FALSE(form) << text;
		EXPECT_EQ(form.error().kind, ErrorKind::usage);
		EXPECT_NE(form.error().message.find(says), std::string::npos) << text << ": " << form.error().message;
	}
}

TEST(ImplicitSurface, KeepsItsText)
{
	const surface::ImplicitSurface form = surface::ImplicitSurface::parse("ellipsoid:1,2.5,3e-1").value();
	EXPECT_EQ(form.text(), "ellipsoid:1,2.5,3e-1");
	EXPECT_EQ(form, surface::ImplicitSurface::parse(form.text()).value());
	EXPECT_EQ(surface::ImplicitSurface::parse("iso:-0.25").value().isoValue()->value, -0.25);
}

TEST(Quadric, CrossesEdgesAtItsRoot)
{
	std::mt19937 random(5);
	std::uniform_real_distribution<double> number(-1.0, 1.0);
	const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
	int crossed = 0;
	for (int i = 0; i < 2000; ++i)
	{
		surface::Quadric::Coefficients coefficients;
		for (double& c : coefficients)
			c = number(random);
		const surface::Quadric quadric(coefficients);
		const Vec3 a = vector();
		const Vec3 b = vector();
		const double height_a = quadric.height(a);
		const double height_b = quadric.height(b);
		if ((height_a >= 0.0) == (height_b >= 0.0))
			continue;
		++crossed;
		const double t = quadric.crossing(a, b, height_a, height_b);
		ASSERT_TRUE(t >= 0.0 && t <= 1.0);
		EXPECT_NEAR(quadric.height(a + t * (b - a)), 0.0, 1e-13);
	}
	EXPECT_GT(crossed, 300);
}

TEST(Quadric, MeetsEveryBoxThatItPassesThrough)
{
	std::mt19937 random(6);
	std::uniform_real_distribution<double> number(-1.0, 1.0);
	const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
	int missed = 0;
	for (int i = 0; i < 2000; ++i)
	{
		surface::Quadric::Coefficients coefficients;
		for (double& c : coefficients)
			c = number(random);
		const surface::Quadric quadric(coefficients);
		Box box;
		box.include(vector());
		box.include(box.lo + 0.2 * glm::abs(vector()));
		bool positive = false;
		bool negative = false;
		for (int s = 0; s < 64; ++s)
		{
			const Vec3 share = 0.5 + 0.5 * vector();
			(quadric.height(box.lo + share * box.size()) >= 0.0 ? positive : negative) = true;
		}
		if (positive && negative)
		{
			EXPECT_TRUE(quadric.meets(box));
		}
		missed += !quadric.meets(box);
	}
	EXPECT_GT(missed, 500); // it does tell
}

TEST(Quadric, IsTheSameWhereverItIsPlaced)
{
	std::mt19937 random(7);
	std::uniform_real_distribution<double> number(-1.0, 1.0);
	const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
	const surface::Quadric quadric({1, 0.5, -2, 0.3, -0.7, 0.2, 0.1, -0.4, 0.6, -0.3});
	for (int i = 0; i < 200; ++i)
	{
		surface::Axes axes;
		axes.origin = 3.0 * vector();
		axes.z = glm::normalize(vector());
		axes.x = glm::normalize(glm::cross(vector(), axes.z));
		axes.y = glm::cross(axes.z, axes.x);
		const Vec3 q = vector();
		const Vec3 p = axes.origin + q.x * axes.x + q.y * axes.y + q.z * axes.z;
		const surface::Quadric placed = quadric.placed(axes);
		EXPECT_NEAR(placed.height(p), quadric.height(q), 1e-13);
		const Vec3 gradient = quadric.gradient(q);
		EXPECT_LT(glm::length(placed.gradient(p) - (gradient.x * axes.x + gradient.y * axes.y + gradient.z * axes.z)),
		          1e-12);
	}
}

} // namespace vp::test
