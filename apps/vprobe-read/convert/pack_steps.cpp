#include "pack_steps.h"

#include "hdf5_output.h"

#include <array>
#include <cstdint>

namespace vp::reader::convert
{

void writePackSteps(hid_t root, const std::vector<double>& times, std::size_t partitions, bool has_polyhedra,
                    std::span<const StepsOfArray> arrays)
{
	const std::size_t count = times.size();
	const Handle steps = groupInOrder(root, "Steps");
	writeAttribute(steps, "NSteps", H5T_NATIVE_INT64, std::array{static_cast<std::int64_t>(count)});
	writeValues(steps, "Values", H5T_NATIVE_DOUBLE, {count}, times.data());
	const auto writeList = [count](hid_t group, const char* name, hsize_t first, hsize_t step)
	{
		std::vector<std::int64_t> list;
		for (hsize_t time = 0; time < count; ++time)
			list.push_back(static_cast<std::int64_t>(first + time * step));
		writeValues(group, name, H5T_NATIVE_INT64, {count}, list.data());
	};
	writeList(steps, "NumberOfParts", partitions, 0);
	for (const char* same : {"PartOffsets", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"})
		writeList(steps, same, 0, 0);
	if (has_polyhedra)
		for (const char* same : {"FaceConnectivityOffsets", "FaceOffsetsOffsets", "PolyhedronToFaceIdOffsets"})
			writeList(steps, same, 0, 0);
	const Handle of_points = groupInOrder(steps, "PointDataOffsets");
	const Handle of_cells = groupInOrder(steps, "CellDataOffsets");
	for (const StepsOfArray& array : arrays)
		writeList(array.on_points ? of_points : of_cells, array.name.c_str(), 0, array.rows);
}

} // namespace vp::reader::convert
