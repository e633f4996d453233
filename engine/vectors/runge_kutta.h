#pragma once

#include "base/vec.h"

#include <algorithm>
#include <cmath>

namespace vp::vectors
{

// A step of an embedded pair: two results of different order from the same stages. Their difference estimates the
// error.
struct RungeKuttaStep
{
	Vec3 move;     // move to the end of the step, by the higher order
	Vec3 error;    // error of the lower order there
	Vec3 velocity; // velocity at the end
};

// Dormand and Prince, "A family of embedded Runge-Kutta formulae" (1980): order 5 with 4. velocity_at(move, part) is
// asked at part of the step's time; the last stage is the first of the next step.
struct DormandPrince
{
	template <class VelocityAt>
	static RungeKuttaStep step(const Vec3& k1, double h, VelocityAt&& velocity_at)
	{
		const Vec3 k2 = velocity_at(h * (1.0 / 5.0) * k1, 1.0 / 5.0);
		const Vec3 k3 = velocity_at(h * (3.0 / 40.0 * k1 + 9.0 / 40.0 * k2), 3.0 / 10.0);
		const Vec3 k4 = velocity_at(h * (44.0 / 45.0 * k1 - 56.0 / 15.0 * k2 + 32.0 / 9.0 * k3), 4.0 / 5.0);
		const Vec3 k5 = velocity_at(
		    h * (19372.0 / 6561.0 * k1 - 25360.0 / 2187.0 * k2 + 64448.0 / 6561.0 * k3 - 212.0 / 729.0 * k4),
		    8.0 / 9.0);
		const Vec3 k6 = velocity_at(h * (9017.0 / 3168.0 * k1 - 355.0 / 33.0 * k2 + 46732.0 / 5247.0 * k3 +
		                                 49.0 / 176.0 * k4 - 5103.0 / 18656.0 * k5),
		                            1.0);
		RungeKuttaStep done;
		done.move = h * (35.0 / 384.0 * k1 + 500.0 / 1113.0 * k3 + 125.0 / 192.0 * k4 - 2187.0 / 6784.0 * k5 +
		                 11.0 / 84.0 * k6);
		done.velocity = velocity_at(done.move, 1.0);
		done.error = h * (71.0 / 57600.0 * k1 - 71.0 / 16695.0 * k3 + 71.0 / 1920.0 * k4 - 17253.0 / 339200.0 * k5 +
		                  22.0 / 525.0 * k6 - 1.0 / 40.0 * done.velocity);
		return done;
	}
};

// Bogacki and Shampine, "A 3(2) pair of Runge-Kutta formulas" (1989).
struct BogackiShampine
{
	template <class VelocityAt>
	static RungeKuttaStep step(const Vec3& k1, double h, VelocityAt&& velocity_at)
	{
		const Vec3 k2 = velocity_at(h * 0.5 * k1, 0.5);
		const Vec3 k3 = velocity_at(h * 0.75 * k2, 0.75);
		RungeKuttaStep done;
		done.move = h * (2.0 / 9.0 * k1 + 1.0 / 3.0 * k2 + 4.0 / 9.0 * k3);
		done.velocity = velocity_at(done.move, 1.0);
		done.error = h * (-5.0 / 72.0 * k1 + 1.0 / 12.0 * k2 + 1.0 / 9.0 * k3 - 1.0 / 8.0 * done.velocity);
		return done;
	}
};

// Chooses the pair for the next step. Inside a cell a field is mostly nearly straight, and steps are not longer than a
// cell, so the low order does it with half of the work. If the error demands shorter steps, the high order is used.
class PairChoice
{
public:
	bool low() const { return low_; }

	// Returns the factor for the next step, from the error of this one divided by the allowed error.
	double growth(double error) const
	{
		constexpr double kMax = 5.0;
		constexpr double kSafety = 0.9;
		constexpr double kSmall = 1e-5; // allows the most with either order: no power is taken
		if (error < kSmall)
			return kMax;
		return std::clamp(kSafety / (low_ ? std::cbrt(error) : std::pow(error, 0.2)), 0.2, kMax);
	}

	// After a step: how long the next may be, and how long it is wanted.
	void judge(double allowed, double wanted)
	{
		constexpr int kTriedAgain = 32; // the field may be gentler here
		if (low_ && allowed < 0.5 * wanted)
			*this = {false, 0};
		else if (!low_ && ++steps_ == kTriedAgain)
			*this = {true, 0};
	}

	PairChoice() = default;

private:
	PairChoice(bool low, int steps) : low_(low), steps_(steps) {}

	bool low_ = true;
	int steps_ = 0;
};

} // namespace vp::vectors
