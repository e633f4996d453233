#include "probe/probe.h"

namespace vp::probe
{

Probe placed(const Probe& probe)
{
	Probe world{probe.sheets, {}, probe.name};
	for (Sheet& sheet : world.sheets)
		static_cast<Frame&>(sheet) = placed(sheet, probe.frame);
	return world;
}

} // namespace vp::probe
