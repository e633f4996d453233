#include "interact/nudge.h"
#include "interact/placing.h"
#include "view/words.h"
#include "viewer/document/document.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr double kTurnDegrees = 5.0;
constexpr double kWindowFactor = 1.1;

} // namespace

bool Document::performOnProbe(Action action)
{
	const probe::Probe now = probe();
	if (!facts_ || now.sheets.empty())
		return false;
	const std::string words(interact::wordsOf(action));
	const auto set = [&](const probe::Probe& next) { return setProbe(words, next), true; };
	const auto push = [&](double steps, bool fine)
	{ return set(interact::pushed(now, sheet_, steps, facts_->bounds, fine)); };
	const auto turn = [&](const Vec3& axis, double degrees)
	{ return set(interact::turned(now, std::nullopt, axis, degrees)); };
	const auto face = [&](const Vec3& normal) { return set(interact::withNormal(now, std::nullopt, normal)); };
	const auto scale = [&](double factor)
	{ return set(interact::withWindowScaled(now, sheet_, factor, facts_->bounds)); };
	switch (action)
	{
	case Action::push_forward:
		return push(1.0, false);
	case Action::push_back:
		return push(-1.0, false);
	case Action::push_forward_fine:
		return push(1.0, true);
	case Action::push_back_fine:
		return push(-1.0, true);
	case Action::turn_x_plus:
		return turn(now.frame.xAxis(), kTurnDegrees);
	case Action::turn_x_minus:
		return turn(now.frame.xAxis(), -kTurnDegrees);
	case Action::turn_up_plus:
		return turn(now.frame.up, kTurnDegrees);
	case Action::turn_up_minus:
		return turn(now.frame.up, -kTurnDegrees);
	case Action::turn_normal_plus:
		return turn(now.frame.normal, kTurnDegrees);
	case Action::turn_normal_minus:
		return turn(now.frame.normal, -kTurnDegrees);
	case Action::window_bigger:
		return scale(kWindowFactor);
	case Action::window_smaller:
		return scale(1.0 / kWindowFactor);
	case Action::normal_x:
		return face({1.0, 0.0, 0.0});
	case Action::normal_y:
		return face({0.0, 1.0, 0.0});
	case Action::normal_z:
		return face({0.0, 0.0, 1.0});
	case Action::normal_to_camera:
		return !shown_ || set(interact::withNormalToCamera(now, std::nullopt, shown_->camera));
	case Action::snap_normal:
		return set(interact::withNormalSnapped(now, std::nullopt));
	case Action::reset_place:
		return set(interact::resetPlace(now, facts_->bounds));
	case Action::reset_magnifier:
		return set(interact::withoutMagnifier(now, sheet_));
	default:
		return false;
	}
}

void Document::setPreset(view::ProbeShape shape)
{
	change(fmt::format("Probe: {}", view::text(shape)),
	       [&](view::ViewSpec& state)
	       {
		       state.probe.shape = shape;
		       state.probe.own.reset();
		       if (view::replacesSheets(state.probe.surface))
			       state.probe.surface = {};
		       state.probe.vanes.reset();
		       state.probe.offsets.clear();
		       state.probe.sheets.reset();
		       state.probe.corners.reset();
	       });
	sheet_ = 0;
}

void Document::setSurface(const std::string& text)
{
	const Result<view::SurfaceSpec> surface =
	    text.empty() ? Result<view::SurfaceSpec>(view::SurfaceSpec()) : view::parseSurface(text);
	if (!surface)
		return notify(fmt::format("`surface` {}: {}", text, surface.error().message), true);
	change("Surface",
	       [&](view::ViewSpec& state)
	       {
		       state.probe.surface = *surface;
		       if (state.probe.own)
			       for (probe::Sheet& sheet : state.probe.own->probe.sheets)
				       sheet.form.reset();
	       });
}

bool Document::performOnSheets(Action action)
{
	probe::Probe next = probe();
	const std::string words(interact::wordsOf(action));
	const auto done = [&] { return setProbe(words, next), true; };
	switch (action)
	{
	case Action::preset_single:
		return setPreset(view::ProbeShape::single), true;
	case Action::preset_trihedral:
		return setPreset(view::ProbeShape::trihedral), true;
	case Action::preset_paddlewheel:
		return setPreset(view::ProbeShape::paddlewheel), true;
	case Action::preset_stack:
		return setPreset(view::ProbeShape::stack), true;
	case Action::next_sheet:
		return chooseSheet(sheet_ + 1), true;
	case Action::previous_sheet:
		return chooseSheet(sheet_ + std::max<std::size_t>(next.sheets.size(), 1) - 1), true;
	default:
		break;
	}
	if (next.sheets.empty())
		return false;
	probe::Sheet& sheet = next.sheets[std::min(sheet_, next.sheets.size() - 1)];
	switch (action)
	{
	case Action::hide_sheet:
		sheet.wishes.hidden = !sheet.wishes.hidden;
		return done();
	case Action::show_all_sheets:
		for (probe::Sheet& each : next.sheets)
			each.wishes.hidden = false;
		return done();
	case Action::add_sheet:
	{
		if (next.sheets.size() >= probe::kMaxSheets)
			return notify(fmt::format("A probe has at most {} sheets", probe::kMaxSheets), true), true;
		// The new sheet is perpendicular to the chosen one and passes through the same place, so it shows what the
		// chosen one cannot show.
		probe::Sheet added = sheet;
		static_cast<probe::Frame&>(added) = probe::turned(sheet, sheet.origin, sheet.up, 90.0);
		added.wishes.hidden = false;
		next.sheets.push_back(added);
		setProbe(words, next);
		chooseSheet(next.sheets.size() - 1);
		return true;
	}
	case Action::remove_sheet:
		if (next.sheets.size() == 1)
			return notify("The last sheet stays: hide it, or choose another probe", true), true;
		next.sheets.erase(next.sheets.begin() + static_cast<std::ptrdiff_t>(std::min(sheet_, next.sheets.size() - 1)));
		setProbe(words, next);
		chooseSheet(std::min(sheet_, next.sheets.size() - 1));
		return true;
	default:
		return false;
	}
}

} // namespace vp::app
