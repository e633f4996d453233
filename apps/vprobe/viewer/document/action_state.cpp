#include "viewer/document/action_state.h"

#include "render/color/label_colors.h"

namespace vp::app
{

namespace
{

using interact::Action;

bool needsData(Action action)
{
	switch (action)
	{
	case Action::open:
	case Action::save_state:
	case Action::save_state_as:
	case Action::undo:
	case Action::redo:
	case Action::quit:
	case Action::cancel:
	case Action::dark_theme:
	case Action::handles:
	case Action::contour:
	case Action::plane_pane:
	case Action::panels:
	case Action::profile_overlay:
	case Action::full_screen:
	case Action::text_larger:
	case Action::text_smaller:
	case Action::find_command:
	case Action::menus:
	case Action::panel_keys:
	case Action::hints:
	case Action::help:
	case Action::magnifier:
		return false;
	default:
		return true;
	}
}

bool isProbe(const view::ProbeSpec& probe, view::ProbeShape shape)
{
	return probe.shape == shape && !view::replacesSheets(probe.surface);
}

} // namespace

bool isOn(const Document& document, Action action)
{
	const OpenParts& parts = document.parts;
	const view::LookSpec& look = document.state().look;
	const view::ProbeSpec& probe = document.state().probe;
	switch (action)
	{
	case Action::dark_theme:
		return document.settings.dark;
	case Action::handles:
		return parts.handles;
	case Action::contour:
		return parts.contour;
	case Action::plane_pane:
		return parts.plane_pane;
	case Action::panels:
		return parts.panels;
	case Action::panel_keys:
		return parts.panel_keys;
	case Action::profile_overlay:
		return parts.profile;
	case Action::full_screen:
		return parts.full_screen;
	case Action::magnifier:
		return parts.magnifier;
	case Action::find_command:
		return parts.command_search;
	case Action::hints:
		return document.settings.hint.has_value();
	case Action::help:
		return parts.help;
	case Action::play:
		return document.playback().isPlaying();
	case Action::loop:
		return document.playback().loops();
	case Action::there_and_back:
		return document.state().sweep.there_and_back;
	case Action::sheet_alone:
		return parts.own;
	case Action::lines:
		return look.lines > 0;
	case Action::bands:
		return look.bands > 0;
	case Action::mesh:
		return look.mesh;
	case Action::legend:
		return !look.no_legend;
	case Action::axes:
		return look.axes != view::AxesStyle::none;
	case Action::outline:
		return look.outline != render::Outline::none;
	case Action::range_of_slice:
		return !look.range && look.range_of == view::RangeOf::slice;
	case Action::preset_single:
		return isProbe(probe, view::ProbeShape::single);
	case Action::preset_trihedral:
		return isProbe(probe, view::ProbeShape::trihedral);
	case Action::preset_paddlewheel:
		return isProbe(probe, view::ProbeShape::paddlewheel);
	case Action::preset_stack:
		return isProbe(probe, view::ProbeShape::stack);
	default:
		return false;
	}
}

bool isPossible(const Document& document, Action action)
{
	switch (action)
	{
	case Action::undo:
		return document.history().canUndo();
	case Action::redo:
		return document.history().canRedo();
	case Action::cancel:
		return document.loader().isBusy() || document.playback().recording();
	case Action::save_color_map:
		return document.facts() && document.colorMapName() != render::kLabelsName;
	case Action::save_film:
		return document.playback().film() != nullptr;
	case Action::next_time:
	case Action::previous_time:
		return document.facts() && document.facts()->times.size() > 1;
	default:
		return !needsData(action) || document.facts().has_value();
	}
}

} // namespace vp::app
