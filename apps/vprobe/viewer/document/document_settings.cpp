#include "view/settings.h"
#include "view/validate.h"
#include "viewer/document/document.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

Status Document::set(std::string_view key, const std::string& value)
{
	view::ViewSpec next = state();
	if (Status set = view::setByKey(next, key, value); !set)
		return set;
	next.look.size = state().look.size; // the window has its own
	view::InputSpec input = next.input;
	input.time = state().input.time;
	if (input != state().input || next.machine != state().machine)
		return Error{ErrorKind::usage, fmt::format("`{}` is said when data are opened; give it to vprobe view", key)};
	if (next.probe.surface != state().probe.surface && next.probe.own)
		for (probe::Sheet& sheet : next.probe.own->probe.sheets)
			sheet.form.reset();
	if (Status fits = view::validate(next); !fits)
		return fits;
	change(fmt::format("{} {}", key, value), [&](view::ViewSpec& spec) { spec = next; });
	return Nothing{};
}

void Document::learned(std::size_t hint)
{
	if (settings.hint != hint)
		return;
	settings.hint = hint + 1 < kHints ? std::optional(hint + 1) : std::nullopt;
}

} // namespace vp::app
