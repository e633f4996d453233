#include "profile/counted_planes.h"

#include <functional>

namespace vp::app
{

namespace
{

// Measures up to 12 planes, for a tenth of a second. begin() and end() are called for each.
Status forSomePlanes(SweptProbe& swept, const std::function<void()>& begin, const std::function<void()>& end)
{
	constexpr std::size_t kCountedPlanes = 12;
	constexpr double kLongestMs = 100.0;
	const Timeline& timeline = *swept.session().timeline();
	const double start = timeline.now();
	const std::size_t step = (swept.planes() + kCountedPlanes - 1) / kCountedPlanes;
	for (std::size_t plane = 0; plane < swept.planes() && timeline.now() < start + kLongestMs; plane += step)
	{
		begin();
		if (Status measured = swept.measure(plane); !measured)
			return measured;
		end();
	}
	return Nothing{};
}

} // namespace

Status countUse(SweptProbe& swept, StageWork& work)
{
	SectionMeter meter;
	work.setWhyNoCounters(meter.whyNoCounters());
	return forSomePlanes(
	    swept, [&] { meter.take(); }, [&] { work.addUse(meter.take()); });
}

Status countTouched(SweptProbe& swept, StageWork& work)
{
	return forSomePlanes(
	    swept, [] {}, [&] { work.addTouched(swept.session().blocks(), swept.made(), swept.pixels()); });
}

Status countShaders(SweptProbe& swept, DeviceWork& work)
{
	gpu::countInvocations(true);
	Status counted = forSomePlanes(
	    swept, [] { gpu::takeInvocations(); }, [&] { work.add(gpu::takeInvocations()); });
	gpu::countInvocations(false);
	return counted;
}

} // namespace vp::app
