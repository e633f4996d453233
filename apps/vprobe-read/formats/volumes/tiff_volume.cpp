#include "tiff_volume.h"

#include "read/protocol.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace vp::reader::volumes
{

namespace fs = std::filesystem;

namespace
{

// A file that was renamed, and whose XML has no UUID, names only itself by its old name.
void findRenamed(TiffLayout& layout, const std::string& file)
{
	const auto names_itself = [](const TiffRun& run) { return run.file == 0; };
	std::error_code error;
	if (layout.files.size() != 2 || std::any_of(layout.runs.begin(), layout.runs.end(), names_itself) ||
	    fs::exists(fs::path(file).parent_path() / layout.files[1], error))
		return;
	for (TiffRun& run : layout.runs)
		run.file = 0;
}

// The pages like the first one that is no preview, by their numbers.
std::vector<std::uint64_t> alikePages(const TiffPages& pages)
{
	std::uint64_t first = 0;
	while (first + 1 < pages.count() && pages.isPreview(first))
		++first;
	std::vector<std::uint64_t> alike;
	for (std::uint64_t page = first; page < pages.count(); ++page)
		if (pages.kind(page) == pages.kind(first) && (!pages.isPreview(page) || page == first))
			alike.push_back(page);
	return alike;
}

// OME's description may lie in another file.
std::string descriptionOf(const std::string& file, TiffPages& pages)
{
	std::string description = pages.description();
	const std::string name = omeMetadataFile(description);
	if (name.empty())
		return description;
	const std::string path = (fs::path(file).parent_path() / name).string();
	std::error_code error;
	if (!fs::is_regular_file(path, error))
		throw Refusal(fmt::format("its description is in {}, which cannot be opened; keep the files together", path));
	const MappedText mapped(path);
	const std::string_view text = mapped.text();
	return text.starts_with("II") || text.starts_with("MM") ? TiffPages(path).description() : std::string(text);
}

} // namespace

TiffPages& TiffFiles::open(std::uint32_t file)
{
	if (file == current_)
		return *pages_;
	const std::string path = file == 0 ? first_ : (fs::path(first_).parent_path() / names_[file]).string();
	std::error_code error;
	if (!fs::is_regular_file(path, error))
		throw Refusal(
		    fmt::format("some of its planes are in {}, which cannot be opened; keep the files together", path));
	pages_.reset();
	current_ = std::numeric_limits<std::uint32_t>::max();
	pages_.emplace(path);
	current_ = file;
	return *pages_;
}

TiffVolume::TiffVolume(const std::string& file) : file_(file), files_(file, layout_.files)
{
	TiffPages& pages = files_.open(0);
	alike_ = alikePages(pages);
	const TiffPageKind kind = pages.kind(alike_.front());
	kind.type();
	if (kind.width == 0 || kind.height == 0)
		throw damaged("its pages have no pixels");
	layout_ = tiffLayout({fs::path(file).filename().string(), descriptionOf(file, pages), alike_.size(), kind.samples,
	                      pages.resolution(), pages.resolutionUnit()});
	findRenamed(layout_, file);
}

std::vector<std::string> TiffVolume::leftOut()
{
	std::vector<std::string> lines;
	if (layout_.counts_previews)
		return lines;
	if (const std::uint64_t others = files_.open(0).count() - alike_.size(); others > 0)
		lines.push_back(fmt::format("{} pages unlike the first one, or previews, are left out", others));
	if (alike_.size() > layout_.planes())
		lines.push_back(
		    fmt::format("{} pages more than its description asks for are left out", alike_.size() - layout_.planes()));
	return lines;
}

// Finds the page of every plane.
void TiffVolume::mapPlanes()
{
	planes_.resize(layout_.planes());
	for (const TiffRun& run : layout_.runs)
	{
		const std::uint64_t there = planes_.size() - run.plane;
		std::uint64_t count = run.count.value_or(there);
		if (!run.count)
		{
			const std::uint64_t pages = files_.open(run.file).count();
			count = std::min(there, pages - std::min(pages, run.page));
		}
		if (count > there)
			throw damaged("its description maps more pages than it has planes");
		for (std::uint64_t i = 0; i < count; ++i)
			planes_[run.plane + i] = {run.file, run.page + i};
	}
}

void TiffVolume::choose(std::uint32_t time)
{
	if (time >= layout_.times)
		throw damaged(fmt::format("it has {} times where {} is asked for", layout_.times, time));
	time_ = time;
	mapPlanes();
	if (layout_.counts_previews)
	{
		const Plane first = planes_[layout_.planeOf(0, 0, time)];
		TiffPages& pages = files_.open(first.file);
		const std::uint64_t page = first.page < pages.count() ? first.page : 0;
		kind_ = pages.kind(page);
		if (kind_.width == 0 || kind_.height == 0)
			throw damaged("its pages have no pixels");
		pages.refuseImpossible(page);
		return;
	}
	TiffPages& pages = files_.open(0);
	kind_ = pages.kind(alike_.front());
	pages.refuseImpossible(alike_.front());
	reads_behind_ = alike_.size() == 1 && layout_.planes() > 1 && alike_.front() == 0 && pages.isPlain(0);
	if (!reads_behind_ && layout_.planes() > alike_.size())
		throw damaged(
		    fmt::format("it has {} pages where its description asks for {}", alike_.size(), layout_.planes()));
}

arrays::ValueLayout TiffVolume::values() const
{
	return {{kind_.width, kind_.height, layout_.slices}, kind_.samples, kind_.type()};
}

// Returns the page of a plane, in its file.
TiffVolume::Plane TiffVolume::planeOf(std::uint32_t channel, std::uint32_t slice)
{
	if (channel >= layout_.channels || slice >= layout_.slices)
		throw damaged("it has fewer planes than are asked for");
	Plane at = planes_[layout_.planeOf(channel, slice, time_)];
	if (at.page == Plane().page)
		throw damaged(
		    fmt::format("its description gives no page of slice {}, channel {}, time {}", slice, channel, time_));
	const TiffPages& pages = files_.open(at.file);
	if (at.page >= (layout_.counts_previews ? pages.count() : alike_.size()))
		throw damaged(fmt::format("it has {} pages where its description asks for page {}", pages.count(), at.page));
	if (!layout_.counts_previews)
		at.page = alike_[at.page];
	if (pages.kind(at.page) != kind_)
		throw damaged(fmt::format("page {} has another size or type than the first one", at.page));
	return at;
}

void TiffVolume::readPlane(std::uint32_t channel, std::uint32_t slice, char* to)
{
	if (reads_behind_)
		return files_.open(0).readBehindFirst(layout_.planeOf(channel, slice, time_), to);
	const Plane at = planeOf(channel, slice);
	files_.open(at.file).read(at.page, to);
}

// Returns where in the file the values of each slice begin, if they lie there as they are, each slice in one piece.
std::optional<std::vector<std::uint64_t>> TiffVolume::plainPlanes(std::uint32_t channel)
{
	std::vector<std::uint64_t> begins;
	TiffPages& pages = files_.open(0);
	if (reads_behind_)
	{
		const auto first = pages.plainBegin(0);
		for (std::uint32_t slice = 0; first && slice < layout_.slices; ++slice)
			begins.push_back(*first + layout_.planeOf(channel, slice, time_) * kind_.bytes());
		return first ? std::optional(begins) : std::nullopt;
	}
	for (std::uint32_t slice = 0; slice < layout_.slices; ++slice)
	{
		const Plane at = planeOf(channel, slice);
		const auto begin = at.file == 0 ? files_.open(0).plainBegin(at.page) : std::nullopt;
		if (!begin)
			return std::nullopt;
		begins.push_back(*begin);
	}
	return begins;
}

std::optional<arrays::StoredPlace> TiffVolume::storedPlace(std::uint32_t channel)
{
	const std::uint64_t item_bytes = byteSize(kind_.type()) * kind_.samples;
	if (const auto begins = plainPlanes(channel))
		return arrays::storedLayers(file_, *begins, {kind_.width, kind_.height, begins->size()}, item_bytes,
		                            files_.open(0).isSwapped());
	const Plane first = planeOf(channel, 0);
	const std::array<std::uint32_t, 2> block = files_.open(first.file).blockSize(first.page);
	if (std::uint64_t(block[0]) * block[1] > read::kMaxPartBytes / item_bytes)
		return std::nullopt;
	arrays::StoredPlace place{.file = file_};
	place.part = {block[0], block[1], 1};
	place.reader = fmt::format("tiff {} {}", channel, time_);
	return place;
}

void TiffVolume::readPart(std::uint32_t channel, std::uint64_t number, std::span<std::byte> to)
{
	const Plane first = planeOf(channel, 0);
	const std::array<std::uint32_t, 2> block = files_.open(first.file).blockSize(first.page);
	const std::uint64_t across = (kind_.width + block[0] - 1) / block[0];
	const std::uint64_t in_page = across * ((kind_.height + block[1] - 1) / block[1]);
	const std::uint64_t pixel = kind_.bytes() / kind_.width / kind_.height;
	if (number / in_page >= layout_.slices || to.size() != block[0] * std::uint64_t(block[1]) * pixel)
		throw damaged("it has other parts than are asked for");
	const Plane at = planeOf(channel, static_cast<std::uint32_t>(number / in_page));
	TiffPages& pages = files_.open(at.file);
	if (pages.blockSize(at.page) != block)
		throw damaged(fmt::format("page {} has strips or tiles of another size than the first one", at.page));
	const std::uint64_t in_row = number % in_page;
	pages.readBlock(at.page, in_row % across, in_row / across, reinterpret_cast<char*>(to.data()));
}

} // namespace vp::reader::volumes
