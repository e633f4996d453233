#include "corpus.h"

#include "format_samples.h"
#include "read/formats.h"
#include "sample_files.h"

#include <algorithm>
#include <set>

namespace fuzz
{

namespace
{

namespace fs = std::filesystem;

bool canBeOpened(const fs::path& file)
{
	return vp::read::formatOfEnding(file.filename().string()) != nullptr;
}

DataSet describe(const std::string& name, const fs::path& folder)
{
	DataSet set;
	set.name = name;
	set.folder = folder;
	for (const auto& entry : fs::recursive_directory_iterator(folder))
		if (const fs::path ending = entry.path().extension();
		    entry.is_directory() && (ending == ".zarr" || ending == ".n5"))
			set.inputs.push_back(fs::relative(entry.path(), folder));
		else if (entry.is_regular_file())
		{
			set.files.push_back(fs::relative(entry.path(), folder));
			set.bytes += entry.file_size();
		}
	std::sort(set.files.begin(), set.files.end());
	std::set<fs::path> endings;
	for (const fs::path& file : set.files)
		if (canBeOpened(file) && endings.insert(file.extension()).second)
			set.inputs.push_back(file);
	return set;
}

} // namespace

std::vector<DataSet> writeSamples(const fs::path& folder, bool with_large)
{
	std::vector<SampleFile> samples = sampleFiles();
	const std::vector<SampleFile> more = formatSamples();
	samples.insert(samples.end(), more.begin(), more.end());
	const std::vector<SampleFile> large = with_large ? largeSamples() : std::vector<SampleFile>();
	samples.insert(samples.end(), large.begin(), large.end());
	std::vector<DataSet> sets;
	for (const SampleFile& sample : samples)
	{
		const fs::path place = folder / sample.name;
		fs::create_directories(place);
		sample.write((place / sample.name).string());
		sets.push_back(describe(sample.name, place));
		sets.back().inputs = {sample.name};
	}
	return sets;
}

std::vector<DataSet> findRealSets(const fs::path& data, std::uint64_t most_bytes)
{
	std::vector<DataSet> sets;
	for (auto entry = fs::recursive_directory_iterator(data); entry != fs::recursive_directory_iterator(); ++entry)
		if (entry->is_directory() && entry.depth() == 1)
		{
			entry.disable_recursion_pending();
			DataSet set = describe(fs::relative(entry->path(), data).string(), entry->path());
			if (!set.inputs.empty() && set.bytes <= most_bytes)
				sets.push_back(std::move(set));
		}
	std::sort(sets.begin(), sets.end(), [](const DataSet& a, const DataSet& b) { return a.name < b.name; });
	return sets;
}

} // namespace fuzz
