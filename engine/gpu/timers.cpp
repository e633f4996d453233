#include "gpu/timers.h"

#include "base/frame_scope.h"
#include "base/timeline.h"
#include "gpu/invocations.h"
#include "gpu/vk_check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <utility>

namespace vp::gpu
{

namespace
{
// The parts of Invocations, in the order of the bits.
constexpr VkQueryPipelineStatisticFlags kCounted = VK_QUERY_PIPELINE_STATISTIC_INPUT_ASSEMBLY_VERTICES_BIT |
                                                   VK_QUERY_PIPELINE_STATISTIC_FRAGMENT_SHADER_INVOCATIONS_BIT |
                                                   VK_QUERY_PIPELINE_STATISTIC_COMPUTE_SHADER_INVOCATIONS_BIT;

std::uint64_t steadyNow()
{
	return static_cast<std::uint64_t>(
	    std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
	        .count());
}
} // namespace

Timers::Timers(Device& device, const char* row) : device_(&device), row_(addRow(row)) {}

Timers::Timers(Timers&& other) noexcept
    : device_(other.device_), row_(other.row_), pools_(std::exchange(other.pools_, {})),
      statistics_(std::exchange(other.statistics_, {})), sections_(std::exchange(other.sections_, {}))
{
}

Timers::~Timers()
{
	for (const auto* pools : {&pools_, &statistics_})
		for (const VkQueryPool pool : *pools)
			device_->retire([pool](VkDevice device) { vkDestroyQueryPool(device, pool, nullptr); });
}

void Timers::makePool(std::vector<VkQueryPool>& pools, std::size_t section, const VkQueryPoolCreateInfo& info)
{
	while (pools.size() <= section / kPoolSections)
	{
		pools.reserve(pools.size() + 1);
		VkQueryPool pool = VK_NULL_HANDLE;
		// A timer is not worth a failed slice: without memory for it nothing is measured.
		if (vkCreateQueryPool(device_->handle(), &info, nullptr, &pool) == VK_SUCCESS)
		{
			vkResetQueryPool(device_->handle(), pool, 0, info.queryCount);
			device_->setName(VK_OBJECT_TYPE_QUERY_POOL, pool, "timers");
		}
		pools.push_back(pool);
	}
}

std::size_t Timers::begin(VkCommandBuffer commands, const char* name)
{
	device_->beginLabel(commands, name);
	const std::size_t section = sections_.size();
	Section made{name, steadyNow()};
	sections_.reserve(std::bit_ceil(section + 1)); // without memory there is no section that lacks its pools
	VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
	if (device_->timestampBits())
	{
		info.queryType = VK_QUERY_TYPE_TIMESTAMP;
		info.queryCount = 2 * kPoolSections;
		makePool(pools_, section, info);
		if (const VkQueryPool pool = pools_[section / kPoolSections])
			vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool, 2 * (section % kPoolSections));
	}
	if (countsInvocations() && device_->features().pipelineStatisticsQuery)
	{
		info.queryType = VK_QUERY_TYPE_PIPELINE_STATISTICS;
		info.queryCount = kPoolSections;
		info.pipelineStatistics = kCounted;
		makePool(statistics_, section, info);
		if (const VkQueryPool pool = statistics_[section / kPoolSections])
		{
			vkCmdBeginQuery(commands, pool, section % kPoolSections, 0);
			made.is_counted = true;
		}
	}
	sections_.push_back(made);
	return section;
}

void Timers::end(VkCommandBuffer commands, std::size_t section)
{
	if (sections_[section].is_counted)
		vkCmdEndQuery(commands, statistics_[section / kPoolSections], section % kPoolSections);
	if (device_->timestampBits())
		if (const VkQueryPool pool = pools_[section / kPoolSections])
			vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool,
			                     2 * (section % kPoolSections) + 1);
	device_->endLabel(commands);
}

void Timers::collect(Timeline& timeline)
{
	collectTimes(timeline);
	collectInvocations();
	forget();
}

void Timers::collectTimes(Timeline& timeline)
{
	const std::uint32_t bits = device_->timestampBits();
	const std::uint64_t mask = bits >= 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << bits) - 1;
	const double tick_ns = device_->limits().timestampPeriod;

	// Both clocks at one moment; a section's distance from it in ticks gives its place on the steady clock.
	std::uint64_t anchor_ticks = 0;
	std::uint64_t anchor_ns = 0;
	bool anchored = bits && device_->calibrate(anchor_ticks, anchor_ns);
	const double timeline_now = timeline.now();
	const double steady_now = static_cast<double>(steadyNow());
	const auto toTimeline = [&](double steady_ns) { return timeline_now + (steady_ns - steady_now) * 1e-6; };

	std::array<std::uint64_t, 4 * kPoolSections> results; // per query: ticks, availability
	for (std::size_t first = 0; bits && first < sections_.size(); first += kPoolSections)
	{
		const std::size_t count = std::min<std::size_t>(kPoolSections, sections_.size() - first);
		const VkQueryPool pool = pools_[first / kPoolSections];
		if (!pool)
			continue;
		const VkResult got = vkGetQueryPoolResults(
		    device_->handle(), pool, 0, static_cast<std::uint32_t>(2 * count), count * 4 * sizeof(std::uint64_t),
		    results.data(), 2 * sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WITH_AVAILABILITY_BIT);
		if (got < 0)
			continue; // a lost device is told by the next submission
		for (std::size_t i = 0; i < count; ++i)
		{
			const std::uint64_t begin = results[4 * i] & mask;
			const std::uint64_t end = results[4 * i + 2] & mask;
			if (!results[4 * i + 1] || !results[4 * i + 3])
				continue;
			const Section& section = sections_[first + i];
			if (!anchored)
			{
				// The first section cannot have begun before it was recorded, and mostly begins soon after.
				anchor_ticks = begin;
				anchor_ns = section.recorded_ns;
				anchored = true;
			}
			const auto ticks = static_cast<double>(static_cast<std::int64_t>(begin - anchor_ticks));
			timeline.add({.name = section.name,
			              .track = Timeline::Track::gpu,
			              .start_ms = toTimeline(static_cast<double>(anchor_ns) + ticks * tick_ns),
			              .duration_ms = static_cast<double>((end - begin) & mask) * tick_ns * 1e-6,
			              .row = row_,
			              .frame = FrameScope::frame()});
		}
	}
}

void Timers::collectInvocations()
{
	struct Counted
	{
		Invocations invocations; // in the order of the bits of kCounted
		std::uint64_t is_available;
	};
	static_assert(sizeof(Counted) == 4 * sizeof(std::uint64_t));
	for (std::size_t s = 0; s < sections_.size(); ++s)
	{
		Counted counted{};
		if (sections_[s].is_counted &&
		    vkGetQueryPoolResults(device_->handle(), statistics_[s / kPoolSections], s % kPoolSections, 1,
		                          sizeof(counted), &counted, sizeof(counted),
		                          VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WITH_AVAILABILITY_BIT) >= 0 &&
		    counted.is_available)
			addInvocations(sections_[s].name, counted.invocations);
	}
}

void Timers::forget()
{
	const auto reset = [&](const std::vector<VkQueryPool>& pools, std::uint32_t queries)
	{
		for (const VkQueryPool pool : pools)
			if (pool)
				vkResetQueryPool(device_->handle(), pool, 0, queries);
	};
	reset(pools_, 2 * kPoolSections);
	reset(statistics_, kPoolSections);
	sections_.clear();
}

} // namespace vp::gpu
