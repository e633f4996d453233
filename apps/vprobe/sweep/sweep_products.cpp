#include "sweep/sweep_products.h"

#include "base/frame_scope.h"
#include "ranks/write/joined_tables.h"
#include "team.h"

#include <utility>

namespace vp::app
{

Result<std::unique_ptr<SweepProducts>> SweepProducts::create(session::Session& session,
                                                             std::optional<picture::Painter> painter, Frames frames,
                                                             const std::string& series)
{
	std::unique_ptr<SweepProducts> products(new SweepProducts(session, std::move(painter), std::move(frames)));
	if (series.empty())
		return products;
	products->interrupt_ = std::make_unique<DeferredInterrupt>();
	if (isFirst())
	{
		Result<write::SliceSeries> made = write::SliceSeries::create(series);
		if (!made)
			return made.error();
		products->series_.emplace(std::move(*made));
	}
	return products;
}

Status SweepProducts::add(int frame, std::optional<double> time, const session::Frame& cut)
{
	if (interrupt_ && interrupt_->came())
		return Error{ErrorKind::cancelled, "interrupted; nothing is written"};
	if (interrupt_)
	{
		const TimedSection section(session_.timeline(), "write");
		FrameScope::comesTo(FrameScope::Stop::file, session_.timeline());
		const write::SliceTable table =
		    ranks::tabulate(session_.ranks(), cut.slice.blocksOf(session_.blocks()),
		                    session::exportedMeshes(cut.sheets), session::contourPieces(cut.contours));
		if (Status written = series_ ? series_->add(frame, time, table) : Nothing{}; !written)
			return written;
	}
	return painter_ ? draw(frame, cut) : Nothing{};
}

Status SweepProducts::draw(int frame, const session::Frame& cut)
{
	if (frame == 0 && frames_.wantsExposure())
	{
		Result<render::Picture> empty = painter_->drawEmpty(cut.slice, cut.sheets);
		if (!empty)
			return empty.error();
		frames_.beginExposure(std::move(*empty));
	}
	Result<render::Picture> picture = painter_->draw(cut.slice, cut.sheets, cut.contours);
	if (!picture)
		return picture.error();
	if (writer_)
	{
		const TimedSection section(session_.timeline(), "await writer");
		writer_->give([this, frame, picture = std::move(*picture)] { write(frame, picture); });
	}
	else
		write(frame, *picture);
	return write_failed_ ? finish() : Nothing{};
}

void SweepProducts::write(int frame, const render::Picture& picture)
{
	if (write_failed_)
		return;
	const FrameScope scope(frame, FrameScope::Stop::file);
	const TimedSection section(session_.timeline(), "write");
	FrameScope::comesTo(FrameScope::Stop::file, session_.timeline());
	written_ = frames_.add(frame, picture);
	write_failed_ = !written_;
}

Status SweepProducts::finish()
{
	if (writer_)
		writer_->finish();
	return written_;
}

Status SweepProducts::commit()
{
	if (Status all = finish(); !all)
		return all;
	if (Status written = frames_.commit(); !written)
		return written;
	return series_ ? series_->commit() : Nothing{};
}

} // namespace vp::app
