#include "cut/request.h"

namespace vp::cut
{

find::PlanRequest planRequestOf(const CutRequest& request)
{
	return {.sheets = request.probe.sheets,
	        .surface = request.surface ? &*request.surface : nullptr,
	        .has_threshold = request.threshold.has_value(),
	        .seed_mode = request.seeds.mode,
	        .finder = request.finder,
	        .strategy = request.strategy};
}

} // namespace vp::cut
