#include "viewer/cutting/render_thread.h"
#include "write/slice_file.h"

namespace vp::app
{

void RenderThread::answer(Job& order)
{
	at_ = &finest_;
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
		return at_->painter->drawEmpty(at_->cut->slice, at_->cut->sheets);
	if (Status grown = growAsWished(order.wish); !grown)
		return grown.error();
	return at_->painter->draw(at_->cut->slice, at_->cut->sheets, at_->grown.contours);
}

Status RenderThread::writeSlice(const CutJob& order)
{
	if (Status followed = follow(order.wish); !followed)
		return followed;
	if (Result<double> cut = cutAsWished(); !cut)
		return cut.error();
	if (Status grown = growAsWished(order.wish); !grown)
		return grown;
	return write::writeSlice(at_->session->blocks(), session::exportedMeshes(at_->cut->sheets), order.file,
	                         session::contourPieces(at_->grown.contours));
}

} // namespace vp::app
