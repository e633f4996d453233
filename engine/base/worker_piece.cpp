#include "base/worker_piece.h"

#include <atomic>

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
	timeline_->addPiece(openSection().name, threadRow(), start_, timeline_->now());
	openSection() = {};
}

} // namespace vp
