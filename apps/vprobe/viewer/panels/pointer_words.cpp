#include "viewer/panels/pointer_words.h"

#include "base/digits.h"
#include "interact/steps.h"
#include "picture/sheet_looks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::app
{

namespace
{

constexpr double kDigits = 1e-5; // smallest step that is shown, as a part of the data's size

// Returns a sheet's number in the cut, which has those sheets of the probe that are not hidden.
std::size_t sheetOfCut(const probe::Probe& probe, std::size_t sheet)
{
	const auto end = probe.sheets.begin() + static_cast<std::ptrdiff_t>(sheet);
	return static_cast<std::size_t>(
	    std::count_if(probe.sheets.begin(), end, [](const probe::Sheet& each) { return !each.wishes.hidden; }));
}

std::string place(const Vec3& at, const Box& bounds)
{
	const double step = kDigits * interact::sizeOf(bounds);
	const auto number = [&](double value)
	{ return fmt::format("{:.{}g}", std::abs(value) < 0.5 * step ? 0.0 : value, digitsFor(value, 100.0 * step, 5)); };
	return fmt::format("{}, {}, {}", number(at.x), number(at.y), number(at.z));
}

std::optional<Pointed> pointedInPane(const Desk& desk)
{
	const PresentedFrame& shown = *desk.document.shown();
	const ScenePart pane = paneOf(desk.hand.part(), desk.scale);
	if (!desk.document.parts.plane_pane || !shown.pane || !shown.lookups || !pane.holds(desk.hand.at()))
		return std::nullopt;
	const std::size_t sheet = shown.pane->sheet;
	const auto hit = interact::hitOf(probe::placed(shown.probe).sheets[sheet], sheet,
	                                 {shown.pane->camera, shown.pane->frame}, desk.hand.at() - pane.lo);
	if (!hit)
		return std::nullopt;
	auto found = shown.lookups->at(sheetOfCut(shown.probe, sheet), hit->content_uv);
	return found ? std::optional(Pointed{*hit, std::move(found)}) : std::nullopt;
}

} // namespace

std::optional<Pointed> pointedAt(const Desk& desk)
{
	const auto& shown = desk.document.shown();
	const auto view = desk.document.view();
	if (shown && !desk.hand.isBusy())
		if (auto in_pane = pointedInPane(desk))
			return in_pane;
	if (!shown || !view || !desk.hand.isInScene() || desk.hand.isBusy() || ImGui::GetIO().WantCaptureMouse)
		return std::nullopt;
	for (const interact::SheetHit& hit :
	     interact::pickSheets(shown->probe, *view, desk.hand.inScene(), desk.document.facts()->bounds))
	{
		if (!shown->lookups)
			return Pointed{hit, std::nullopt};
		// Where this sheet does not cut the grid, the user sees the sheet behind it.
		if (auto found = shown->lookups->at(sheetOfCut(shown->probe, hit.sheet), hit.content_uv))
			return Pointed{hit, std::move(found)};
	}
	return std::nullopt;
}

std::optional<session::PointedValue> valueOf(const Desk& desk, const Pointed& pointed)
{
	if (!pointed.found || pointed.found->array.empty() || !std::isfinite(pointed.found->value))
		return std::nullopt;
	return session::PointedValue{sheetOfCut(desk.document.shown()->probe, pointed.hit.sheet), pointed.found->value};
}

std::string valueWords(const Desk& desk, const Pointed& pointed)
{
	if (!pointed.found || pointed.found->array.empty())
		return {};
	const auto& shown = desk.document.shown();
	const bool own = shown->probe.sheets[pointed.hit.sheet].wishes.array.has_value();
	// The legend's title has the units.
	const std::string& title = own || !shown->values ? pointed.found->array : shown->values->title;
	return fmt::format("{} = {:.6g}", title, pointed.found->value);
}

std::string cellWords(const Pointed& pointed)
{
	if (!pointed.found)
		return {};
	return pointed.found->block.empty() ? fmt::format("cell {}", pointed.found->cell)
	                                    : fmt::format("cell {} of block {}", pointed.found->cell, pointed.found->block);
}

std::string pointerLine(const Desk& desk)
{
	const Box& bounds = desk.document.facts()->bounds;
	if (const auto pointed = pointedAt(desk))
	{
		std::string line = valueWords(desk, *pointed);
		const auto add = [&](const std::string& words)
		{
			if (!words.empty())
				line += (line.empty() ? "" : "   ") + words;
		};
		add(cellWords(*pointed));
		add(fmt::format("at {}", place(pointed->hit.content, bounds)));
		return line;
	}
	const probe::Frame& frame = desk.document.shown()->probe.frame;
	probe::Sheet standing;
	static_cast<probe::Frame&>(standing) = frame;
	return picture::caption(standing, bounds);
}

} // namespace vp::app
