#include "report/explain.h"
#include "view/validate.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace vp::app
{

namespace
{

// Calls visit(sheet, block, plan).
template <class Visit>
void forEachBlockPlan(const find::CutPlan& plan, Visit&& visit)
{
	for (std::size_t s = 0; s < plan.sheets.size(); ++s)
		for (std::size_t b = 0; b < plan.sheets[s].size(); ++b)
			visit(s, b, plan.sheets[s][b]);
}

} // namespace

Result<ExitCode> explain(const view::ViewSpec& spec, const session::OpenOptions& how)
{
	if (Status known = view::refuseGenerations(spec.probe, spec.look.color_by); !known)
		return known.error();
	Result<std::unique_ptr<session::Session>> opened = session::openSession(spec, how);
	if (!opened)
		return opened.error();
	session::Session& session = **opened;
	const Result<find::CutPlan> plan = planOf(session);
	if (!plan)
		return plan.error();
	const std::vector<grid::Block>& blocks = session.blocks.blocks;
	std::size_t width = 5;
	for (const grid::Block& block : blocks)
		width = std::max(width, block.name.size());
	fmt::print("{:>5}  {:<{}}  {:<11}  {:<10}  {}\n", "sheet", "block", width, "strategy", "classifier", "reason");
	forEachBlockPlan(*plan,
	                 [&](std::size_t s, std::size_t b, const find::BlockPlan& way)
	                 {
		                 fmt::print("{:>5}  {:<{}}  {:<11}  {:<10}  {}\n", s, blocks[b].name, width,
		                            nameOf(way.strategy), nameOf(way.classifier), way.reason());
	                 });
	return ExitCode::done;
}

nlohmann::json planJson(const session::Session& session)
{
	nlohmann::json list = nlohmann::json::array();
	if (const Result<find::CutPlan> plan = planOf(session))
		forEachBlockPlan(*plan,
		                 [&](std::size_t s, std::size_t b, const find::BlockPlan& way)
		                 {
			                 list.push_back({{"block", b},
			                                 {"sheet", s},
			                                 {"strategy", nameOf(way.strategy)},
			                                 {"classifier", nameOf(way.classifier)},
			                                 {"reason", way.reason()}});
		                 });
	return list;
}

} // namespace vp::app
