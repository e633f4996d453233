#include "vprobe-read/arrays/packed_parts.h"

#include "cf_parts.h"
#include "tiff_volume.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/netcdf_size.h"
#include "vprobe-read/hdf5/hdf5_chunk_reader.h"
#include "vprobe-read/hdf5/hdf5_filters.h"
#include "vprobe-read/hdf5/hdf5_parts.h"
#include "zarr_array.h"
#include "zarr_file.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <mutex>
#include <sstream>
#include <vector>

namespace vp::reader
{

namespace
{

arrays::UnpackPart fromChunks(const std::string& name, const std::string& filters)
{
	const auto file = std::make_shared<const MappedText>(name);
	return [file, steps = hdf5::Filters(filters)](const arrays::PackedPart& part, std::span<std::byte> to)
	{
		if (part.offset > file->text().size() || part.bytes > file->text().size() - part.offset)
			throw damaged("a part lies outside of it");
		const auto packed = std::as_bytes(std::span(file->text().substr(part.offset, part.bytes)));
		steps.unpack(packed, static_cast<std::uint32_t>(part.left_out_filters), to);
	};
}

std::string restOf(std::istream& words)
{
	std::string rest;
	std::getline(words >> std::ws, rest, '\0');
	return rest;
}

arrays::UnpackPart fromVariable(std::unique_ptr<hdf5::NetcdfFile> file, const std::string& words)
{
	const auto parts = std::make_shared<const volumes::CfParts>(std::move(file), words);
	return [parts](const arrays::PackedPart& part, std::span<std::byte> to) { parts->read(part.offset, to); };
}

arrays::UnpackPart fromNetcdf(const std::string& file, std::istream& words)
{
	checks::refuseShortNetcdf(file);
	hdf5::refuseMissingParts(file);
	return fromVariable(std::make_unique<hdf5::NetcdfFile>(file), restOf(words));
}

// file: the array's JSON, or the folder that it is in.
arrays::UnpackPart fromZarr(const std::filesystem::path& file, std::istream& words)
{
	const std::filesystem::path folder = std::filesystem::is_directory(file) ? file : file.parent_path();
	const std::string rest = restOf(words);
	if (constexpr std::string_view by_conventions = "cf "; rest.starts_with(by_conventions))
		return fromVariable(
		    std::make_unique<volumes::ZarrFile>(volumes::ZarrGroup::of(folder.string()), folder.string()),
		    rest.substr(by_conventions.size()));
	std::istringstream indices(rest);
	const auto about = volumes::zarrArrayJson(folder);
	if (!about)
		throw Refusal("its array is not there any more");
	const auto array = std::make_shared<volumes::ZarrArray>(folder, folder.filename().string(), *about);
	std::vector<std::size_t> front;
	std::string word;
	for (std::vector<std::size_t> order; indices >> word;)
		if (std::size_t index = 0; word == "turned")
		{
			while (order.size() < array->shape().size() && indices >> index)
				order.push_back(index);
			array->turn(order);
		}
		else
			front.push_back(std::strtoull(word.c_str(), nullptr, 10));
	return [array, front](const arrays::PackedPart& part, std::span<std::byte> to)
	{ array->readPart(front, part.offset, to); };
}

// libtiff reads a file by one thread at a time, so each thread has it open.
class OpenTiffs
{
public:
	OpenTiffs(std::string file, std::uint32_t time) : file_(std::move(file)), time_(time) {}

	template <class Use>
	void use(const Use& use)
	{
		std::unique_ptr<volumes::TiffVolume> volume;
		{
			const std::lock_guard lock(mutex_);
			if (!idle_.empty())
			{
				volume = std::move(idle_.back());
				idle_.pop_back();
			}
		}
		if (!volume)
		{
			volume = std::make_unique<volumes::TiffVolume>(file_);
			volume->choose(time_);
		}
		use(*volume);
		const std::lock_guard lock(mutex_);
		idle_.push_back(std::move(volume));
	}

private:
	std::string file_;
	std::uint32_t time_;
	std::mutex mutex_;
	std::vector<std::unique_ptr<volumes::TiffVolume>> idle_;
};

arrays::UnpackPart fromTiff(const std::string& file, std::istream& indices)
{
	std::uint32_t channel = 0, time = 0;
	indices >> channel >> time;
	const auto files = std::make_shared<OpenTiffs>(file, time);
	return [files, channel](const arrays::PackedPart& part, std::span<std::byte> to)
	{ files->use([&](volumes::TiffVolume& volume) { volume.readPart(channel, part.offset, to); }); };
}

// words: how many indices, these, and the path of the data set, which may have blanks.
arrays::UnpackPart fromHdf5(const std::string& file, std::istream& words)
{
	std::size_t count = 0;
	words >> count;
	std::vector<std::uint64_t> front;
	for (std::uint64_t index = 0; front.size() < count && words >> index;)
		front.push_back(index);
	words.get();
	std::string path;
	std::getline(words, path, '\0');
	const auto chunks = std::make_shared<const hdf5::ChunkReader>(file, path, std::move(front));
	return [chunks](const arrays::PackedPart& part, std::span<std::byte> to) { chunks->read(part.offset, to); };
}

} // namespace

arrays::UnpackPart arrays::unpackerOf(const std::string& file, const std::string& how)
{
	std::istringstream words(how);
	std::string reader;
	words >> reader;
	return reader == "zarr"     ? fromZarr(file, words)
	       : reader == "tiff"   ? fromTiff(file, words)
	       : reader == "hdf5"   ? fromHdf5(file, words)
	       : reader == "netcdf" ? fromNetcdf(file, words)
	                            : fromChunks(file, how);
}

} // namespace vp::reader
