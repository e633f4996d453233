#include "viewer/cutting/render_thread.h"
#include "write/slice_file.h"

namespace vp::app
{

void RenderThread::answer(Job& order)
{
	if (auto* picture = std::get_if<PictureJob>(&order))
		return picture->take(tried([&] { return this->picture(*picture); }));
	auto& slice = std::get<CutJob>(order);
	slice.done(tried([&] { return writeSlice(slice); }));
}

Result<render::Picture> RenderThread::picture(const PictureJob& order)
{
	if (Status followed = follow(order.wish); !followed)
		return followed.error();
	if (Result<double> cut = cutAsWished(); !cut)
		return cut.error();
	if (order.empty)
		return painter_->drawEmpty(cut_->slice, cut_->sheets);
	if (Status grown = growAsWished(order.wish); !grown)
		return grown.error();
	return painter_->draw(cut_->slice, cut_->sheets, grown_.contours);
}

Status RenderThread::writeSlice(const CutJob& order)
{
	if (Status followed = follow(order.wish); !followed)
		return followed;
	if (Result<double> cut = cutAsWished(); !cut)
		return cut.error();
	if (Status grown = growAsWished(order.wish); !grown)
		return grown;
	return write::writeSlice(session_->blocks(), session::exportedMeshes(cut_->sheets), order.file,
	                         session::contourPieces(grown_.contours));
}

} // namespace vp::app
