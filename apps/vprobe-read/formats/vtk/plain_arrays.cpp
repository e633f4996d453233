#include "plain_arrays.h"

#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/file_head.h"
#include "vprobe-read/convert/indexed_file.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/quick/plain_arrays.h"
#include "vtkhdf_pack.h"
#include "vtkhdf_steps.h"

#include <optional>

namespace vp::reader
{

namespace vtk
{

namespace
{

// Returns where the rows of an array begin at each time: the number of a row in its data set.
std::vector<std::uint64_t> firstRows(const hdf5::File& file, const std::string& root, const std::string& association,
                                     const std::string& name)
{
	std::vector<std::uint64_t> rows;
	const std::size_t steps = VtkHdfStep::timesOf(file, root).size();
	for (std::size_t number = 0; number < steps; ++number)
	{
		const VtkHdfStep step(file, root, number);
		const std::optional<std::uint64_t> own = step.arrayOffset(association, name);
		rows.push_back(own ? *own : step.entry(association + "Offsets").value_or(0));
	}
	return rows.empty() ? std::vector<std::uint64_t>{0} : rows;
}

} // namespace

std::vector<arrays::PlainArray> plainArraysOfHdf(const std::string& name_of_file)
{
	const std::string root = "/VTKHDF";
	const hdf5::File file(name_of_file);
	if (isVtkHdfPack(file, {.root = root, .own = "/vprobe"}))
		throw Refusal("is a pack, and needs no index: use it as it is");
	std::vector<arrays::PlainArray> plain;
	for (const std::string association : {"Point", "Cell"})
		for (const std::string& name : file.namesIn(root + "/" + association + "Data"))
		{
			const std::string path = root + "/" + association + "Data/" + name;
			const auto type = file.isSet(path) ? file.numberType(path) : std::nullopt;
			const auto begin = type ? file.plainOffset(path, *type) : std::nullopt;
			const std::vector<std::uint64_t> sides = begin ? file.sidesOf(path) : std::vector<std::uint64_t>();
			if (sides.empty() || sides.size() > 2)
				continue;
			const std::uint64_t components = sides.size() == 2 ? sides[1] : 1;
			arrays::PlainArray array{association == "Point", name, *type, components, {}};
			for (const std::uint64_t row : firstRows(file, root, association, name))
				array.offsets.push_back(*begin + row * components * grid::byteSize(*type));
			plain.push_back(std::move(array));
		}
	return plain;
}

} // namespace vtk

std::vector<arrays::PlainArray> convert::plainArraysOf(const std::string& file)
{
	const checks::FileHead head(file);
	if (head.isHdf5() && head.holds("VTKHDF"))
		return vtk::plainArraysOfHdf(file);
	if (head.starts("# vtk DataFile"))
		return vtk::plainArraysOfLegacy(MappedText(file).text());
	if (head.isXmlOfVtk())
		return quick::plainArrays(file).value_or(std::vector<arrays::PlainArray>());
	return {};
}

} // namespace vp::reader
