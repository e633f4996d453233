#pragma once

#include "vectors/field_walker.h"
#include "vectors/particle.h"
#include "vectors/runge_kutta.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace vp::vectors
{

// A span of the time since launch, at whose ends the two times' vectors hold. Steady: all of time.
struct TimeSpan
{
	double begin = 0.0; // may lie before the launch
	double end = HUGE_VAL;

	double between(double time) const { return end == HUGE_VAL ? 0.0 : (time - begin) / (end - begin); }
};

// Moves one particle within one block. Substeps are as long as the error allows, in the coordinates of the cell, and no
// longer than a cell: so nothing is stepped over. A step whose end is outside is shortened until it ends on the face.
template <grid::Grid G>
class Follower
{
public:
	Follower(const CellLoader<G>& loader, const Motion& motion, const TimeSpan& span, Particle& particle)
	    : loader_(loader), walker_(loader, loader.onCells()), stays_(loader.onCells()), motion_(motion), span_(span),
	      p_(particle)
	{
	}

	// Until it ends, until the span does, or until it stands on a face that leads out of the block: then that. In
	// pieces of a lattice also until it is in another piece, where it has a stand, or until a cell is missing.
	std::optional<Exit> follow()
	{
		if (!loader_.hasElsewhere())
			return followOn();
		before_ = p_;
		try
		{
			return followOn();
		}
		catch (const MissingCell& missing)
		{
			static_cast<ParticleState&>(p_) = before_;
			p_.missing = missing.cell;
			return std::nullopt;
		}
	}

private:
	std::optional<Exit> followOn()
	{
		const CellId first = loader_.numberOf({p_.block, p_.cell});
		if (p_.stand)
			walker_.resume(first, *p_.stand);
		else
			enter(first);
		p_.stand.reset();
		if (p_.points == 0)
			p_.record();
		for (;;)
		{
			if (loader_.isFar(walker_.cell()))
			{
				p_.stand = walker_.stand();
				return std::nullopt;
			}
			if (!finite(p_.vector))
				p_.stop(TraceEnd::no_vector);
			while (!p_.end && p_.time >= motion_.due(p_.points))
				arrive();
			if (p_.end || p_.time >= span_.end)
				return std::nullopt;
			if (loader_.hasElsewhere())
			{
				before_ = p_;
				before_.stand = walker_.stand();
			}
			if (const std::optional<Exit> exit = move(std::min(motion_.due(p_.points), span_.end)))
				return exit;
		}
	}

	static constexpr double kReach = 1.0; // cells a substep: two might step over a third
	// Cells: so short a substep is taken whatever its error, at a kink of the field.
	static constexpr double kMin = 1e-3;
	// In a million such steps nothing would move by a millionth of a cell.
	static constexpr double kStands = 1e-12;
	static constexpr std::size_t kMaxSubsteps = 20'000; // a step
	static constexpr std::size_t kMaxIdle = 32; // faces crossed at one place: about a corner there are some twenty

	static bool finite(const Vec3& v) { return std::isfinite(v.x + v.y + v.z); }
	static double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

	void arrive()
	{
		// A step of no length, as the last of a whole number of them, leaves no second point.
		if (p_.last_time < p_.time)
			p_.record();
		p_.substeps = 0;
		if (p_.time >= motion_.total())
			p_.end = TraceEnd::steps;
	}

	struct Tried
	{
		double h;
		Vec3 place;
		Vec3 velocity;
		Vec3 vector; // whole
		double error;
		Sample sample;
	};

	Tried attempt(double h)
	{
		walker_.restore(start_);
		Tried tried{h, {}, {}, {}, 0.0, {}};
		const auto velocityAt = [&](const Vec3& way, double part)
		{
			tried.sample = walker_.at(p_.place + way, span_.between(p_.time + part * h));
			return p_.sense * motion_.moving(tried.sample.vector);
		};
		const RungeKuttaStep step = p_.pair.low() ? BogackiShampine::step(velocity_, h, velocityAt)
		                                          : DormandPrince::step(velocity_, h, velocityAt);
		tried.place = p_.place + step.move;
		tried.velocity = step.velocity;
		tried.vector = tried.sample.vector;
		tried.error = largest(locate::applied(inverse_, step.error)) / motion_.tolerance;
		return tried;
	}

	// One substep, to `until` at most.
	std::optional<Exit> move(double until)
	{
		const double left = until - p_.time;
		velocity_ = p_.sense * motion_.moving(p_.vector);
		inverse_ = walker_.measureCell();
		start_ = walker_.cursor();
		const double rate = largest(locate::applied(inverse_, velocity_));
		if (motion_.steady && !(rate * motion_.dt > kStands))
			return stop(TraceEnd::zero_vector);
		if (++p_.substeps > kMaxSubsteps)
			return stop(TraceEnd::gave_up);
		const double wanted = std::min(left, kReach / rate);
		double most = std::min(p_.substep, wanted);
		if (most < left && left < 2.0 * most)
			most = 0.5 * left; // two of a length in place of a long one and a crumb
		for (double h = most;;)
		{
			const Tried tried = attempt(h);
			const bool short_enough = h * rate <= kMin;
			if (!finite(tried.place + tried.velocity))
			{
				if (short_enough)
					return stop(TraceEnd::no_vector);
				h *= 0.25;
				continue;
			}
			const double factor = p_.pair.growth(tried.error);
			p_.pair.judge(h * factor, wanted);
			if (tried.error > 1.0 && !short_enough)
			{
				h *= factor;
				continue;
			}
			p_.substep = h < most || factor < 1.0 ? h * factor : std::max(p_.substep, h * factor);
			if (tried.sample.outside)
				return leave(tried);
			accept(tried, h == left ? until : p_.time + h);
			return std::nullopt;
		}
	}

	std::optional<Exit> stop(TraceEnd why)
	{
		p_.stop(why);
		return std::nullopt;
	}

	void accept(const Tried& tried, double time)
	{
		p_.place = tried.place;
		p_.time = time;
		p_.vector = tried.vector;
		take(walker_.cell());
		p_.idle = 0;
	}

	// Where a step ended outside.
	struct Beyond
	{
		double h;
		double depth; // behind the face, negative
		CellId cell;
		int face;
	};
	Beyond beyond(const Tried& tried) const { return {tried.h, tried.sample.depth, walker_.cell(), tried.sample.face}; }

	std::optional<Exit> leave(const Tried& tried)
	{
		walker_.beExact(true);
		const std::optional<Exit> exit = shorten(tried);
		walker_.beExact(false);
		return exit;
	}

	// A step that ends beyond a face, until it ends on it. The depth behind the face is followed by secants
	// where it is known, else the step is halved.
	std::optional<Exit> shorten(const Tried& tried)
	{
		constexpr int kMaxTries = 60;
		constexpr double kOnFace = 1e-9; // cells
		constexpr double kNothing = 1e-14;
		Beyond out = beyond(tried);
		Tried in = tried;
		in.h = 0.0;
		walker_.restore(start_);
		in.sample = walker_.at(p_.place, span_.between(p_.time));
		std::optional<double> depth = depthBehind(out);
		for (int i = 0; i < kMaxTries && !(depth && *depth <= kOnFace) && out.h - in.h > kNothing * tried.h; ++i)
		{
			// Every so often halved, since secants may keep to one side.
			const bool secant = depth && out.depth < 0.0 && i % 4 != 3;
			const double part = secant ? *depth / (*depth - out.depth) : 0.5;
			const Tried next = attempt(in.h + part * (out.h - in.h));
			if (next.sample.outside)
			{
				const Beyond nearer = beyond(next);
				if (nearer.cell != out.cell || nearer.face != out.face)
					depth.reset();
				out = nearer;
			}
			else
			{
				in = next;
				depth = depthBehind(out);
			}
		}
		// To and fro across a face, as vectors that run against each other have it, is no way.
		constexpr double kWay = 1e-6; // cells
		return standOn(out, in, in.h * largest(locate::applied(inverse_, velocity_)) > kWay);
	}

	// The last place asked for.
	std::optional<double> depthBehind(const Beyond& out) const
	{
		return walker_.cell() == out.cell ? walker_.depthBehind(out.face) : std::nullopt;
	}

	std::optional<Exit> standOn(const Beyond& out, const Tried& in, bool moved)
	{
		if (in.h > 0.0)
		{
			p_.place = in.place;
			p_.time += in.h;
			p_.vector = in.vector;
		}
		take(out.cell);
		p_.idle = moved ? 1 : p_.idle + 1;
		if (p_.idle > kMaxIdle)
			return stop(TraceEnd::zero_vector); // vectors on both sides of a face run against each other
		enter(out.cell);
		if (stays_)
			if (const CellId next = walker_.across(out.face); next != kNoCell)
			{
				enter(next);
				return std::nullopt;
			}
		take(out.cell); // whose face it is, though on an edge others may hold the place
		const Vec3 velocity = p_.sense * motion_.moving(p_.vector);
		const int face = kIsLattice<G> ? sourceFace(loader_.axes(), out.face) : out.face;
		return Exit{face, largest(locate::applied(walker_.measureCell(), velocity))};
	}

	void take(CellId cell)
	{
		const mesh::BlockCell id = loader_.idOf(cell);
		p_.block = id.block;
		p_.cell = id.cell;
	}

	// Takes a cell, or the one beside it that holds the particle's place.
	void enter(CellId cell)
	{
		walker_.startIn(cell);
		p_.vector = walker_.at(p_.place, span_.between(p_.time)).vector;
		take(walker_.cell());
	}

	const CellLoader<G>& loader_;
	FieldWalker<G> walker_;
	bool stays_;
	const Motion& motion_;
	const TimeSpan& span_;
	Particle& p_;
	ParticleState before_; // the present substep
	// These belong to the present substep.
	Vec3 velocity_{0.0};
	std::array<Vec3, 3> inverse_{};
	typename FieldWalker<G>::Cursor start_{};
};

} // namespace vp::vectors
