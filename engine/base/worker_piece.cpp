#include "base/worker_piece.h"

#include <atomic>
#include <new>
#include <string>
#include <utility>

namespace vp
{

namespace
{

void nameWorkerRow()
{
	static std::atomic<int> workers = 0;
	thread_local bool is_named = false;
	if (!std::exchange(is_named, true))
		nameThreadRow("worker " + std::to_string(++workers));
}

} // namespace

void WorkerPiece::begin(const TracedLoop& loop)
{
	if (openSection().depth > 0)
		return;
	nameWorkerRow();
	timeline_ = loop.timeline();
	// A loop in this part is traced too, and its other workers need the name.
	openSection() = {timeline_, loop.name(), 1};
	start_ = timeline_->now();
}

void WorkerPiece::end()
{
	const std::string_view name = openSection().name;
	openSection() = {};
	try
	{
		timeline_->addPiece(name, threadRow(), start_, timeline_->now());
	}
	catch (const std::bad_alloc&)
	{
		// As at the end of a section: a destructor calls this.
	}
}

} // namespace vp
