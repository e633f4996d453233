#include "gmsh_data.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <unordered_set>

namespace vp::reader::meshes
{

GmshData readGmshData(text::Cursor& at, GmshSection& section, bool of_nodes)
{
	GmshData data;
	data.of_nodes = of_nodes;
	for (std::size_t left = at.count(1); left > 0; --left)
	{
		at.line(); // the rest of the line before
		std::string_view text = at.peekLine();
		if (data.name.empty() && text.size() >= 2)
			data.name = text.substr(1, text.size() - 2);
		if (!at.atEnd())
			at.moveTo(at.place() + text.size());
	}
	const std::size_t reals = at.count(1);
	for (std::size_t i = 0; i < reals; ++i)
	{
		const double value = at.real();
		if (i == 0)
			data.time = value;
	}
	std::array<std::int64_t, 4> integers = {0, 1, 0, 0};
	const std::size_t given = at.count(1);
	for (std::size_t i = 0; i < given; ++i)
	{
		const std::int64_t value = at.integer();
		if (i < integers.size())
			integers[i] = value;
	}
	at.line();
	if (given < 3 || (integers[1] != 1 && integers[1] != 3 && integers[1] != 9))
		throw damaged("its data are no scalars, vectors or tensors");
	data.step = integers[0];
	data.components = static_cast<int>(integers[1]);
	data.partition = integers[3];
	const std::size_t count = section.checked(integers[2], 2 + 2 * static_cast<std::size_t>(data.components));
	for (std::size_t i = 0; i < count; ++i)
	{
		data.tags.push_back(section.integer());
		for (int c = 0; c < data.components; ++c)
			data.values.push_back(section.real());
	}
	return data;
}

namespace
{

// A step of a view, and the tags that it has, if pieces of it were compared.
struct ViewStep
{
	GmshData data;
	std::unordered_set<std::int64_t> tags;
};
using View = std::map<std::pair<double, std::int64_t>, ViewStep>; // by time and number
using ViewKey = std::tuple<std::string, bool, int>;               // name, of nodes, components

// Pieces have values of other nodes or elements. Several views of one name have values of the same ones.
bool isPieceOf(ViewStep& step, const GmshData& data)
{
	if (step.tags.empty())
		step.tags.insert(step.data.tags.begin(), step.data.tags.end());
	if (step.data.partition == data.partition &&
	    std::ranges::any_of(data.tags, [&](std::int64_t tag) { return step.tags.contains(tag); }))
		return false;
	step.tags.insert(data.tags.begin(), data.tags.end());
	return true;
}

// Adds a section to the first view of its name that lacks it.
void addTo(std::vector<View>& views, GmshData data)
{
	for (View& view : views)
	{
		const auto same = view.find({data.time, data.step});
		if (same == view.end())
		{
			view[{data.time, data.step}].data = std::move(data);
			return;
		}
		if (isPieceOf(same->second, data))
		{
			GmshData& whole = same->second.data;
			whole.tags.insert(whole.tags.end(), data.tags.begin(), data.tags.end());
			whole.values.insert(whole.values.end(), data.values.begin(), data.values.end());
			return;
		}
	}
	View view;
	view[{data.time, data.step}].data = std::move(data);
	views.push_back(std::move(view));
}

} // namespace

std::vector<double> gmshTimes(std::vector<GmshData>& all)
{
	const auto differs = [&](auto member)
	{ return std::ranges::any_of(all, [&](const GmshData& data) { return data.*member != all[0].*member; }); };
	if (!differs(&GmshData::time) && differs(&GmshData::step))
		for (GmshData& data : all)
			data.time = static_cast<double>(data.step);
	std::vector<double> times;
	for (const GmshData& data : all)
		times.push_back(data.time);
	return times;
}

std::vector<GmshView> gmshViewsAt(std::vector<GmshData> all, std::optional<double> time)
{
	std::vector<ViewKey> order;
	std::map<ViewKey, std::vector<View>> views;
	for (GmshData& data : all)
	{
		const ViewKey key(data.name, data.of_nodes, data.components);
		if (!views.contains(key))
			order.push_back(key);
		addTo(views[key], std::move(data));
	}
	std::vector<GmshView> chosen;
	std::map<std::pair<std::string, bool>, int> taken;
	for (const ViewKey& key : order)
		for (View& view : views[key])
		{
			auto at = view.begin();
			while (time && std::next(at) != view.end() && std::next(at)->first.first <= *time)
				++at;
			GmshView shown{std::move(at->second.data), false};
			shown.is_before = time && shown.data.time > *time;
			if (const int before = taken[{shown.data.name, shown.data.of_nodes}]++; before > 0)
				shown.data.name += fmt::format(" ({})", before + 1);
			chosen.push_back(std::move(shown));
		}
	return chosen;
}

} // namespace vp::reader::meshes
