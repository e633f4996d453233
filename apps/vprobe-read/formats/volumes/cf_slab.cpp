// How parts of variables are read (cf_values.h).
#include "cf_values.h"
#include "vprobe-read/base/refusal.h"

#include <vtkDataArray.h>

namespace vp::reader::volumes
{

CfSlab CfSlab::of(const hdf5::NetcdfFile& file, int variable)
{
	CfSlab slab;
	for (const auto& [side, length] : file.dimensions(variable))
	{
		slab.starts.push_back(0);
		slab.counts.push_back(length);
	}
	return slab;
}

void CfSlab::fix(std::size_t dimension, std::size_t index)
{
	starts.at(dimension) = index;
	counts.at(dimension) = 1;
}

std::size_t CfSlab::count() const
{
	std::size_t count = 1;
	for (const std::size_t length : counts)
		if (__builtin_mul_overflow(count, length, &count) || count > std::size_t(1) << 36)
			throw damaged("it has more values than there can be");
	return count;
}

vtkSmartPointer<vtkDataArray> cfStored(const hdf5::NetcdfFile& file, int variable, const CfSlab& slab)
{
	const int type = cfTypeOf(file, variable);
	if (type == 0)
		throw damaged("a variable holds no numbers");
	auto stored = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
	stored->SetNumberOfTuples(static_cast<vtkIdType>(slab.count()));
	file.readSlab(variable, slab.starts, slab.counts, stored->GetVoidPointer(0));
	return stored;
}

vtkSmartPointer<vtkDataArray> cfArray(const hdf5::NetcdfFile& file, int variable, const CfSlab& slab)
{
	return cfMeaning(file, variable)(cfStored(file, variable, slab));
}

std::vector<double> cfNumbers(const hdf5::NetcdfFile& file, int variable, const CfSlab& slab)
{
	const vtkSmartPointer<vtkDataArray> array = cfArray(file, variable, slab);
	std::vector<double> numbers(static_cast<std::size_t>(array->GetNumberOfTuples()));
	for (std::size_t i = 0; i < numbers.size(); ++i)
		numbers[i] = array->GetTuple1(static_cast<vtkIdType>(i));
	return numbers;
}

std::vector<double> cfNumbers(const hdf5::NetcdfFile& file, int variable)
{
	return cfNumbers(file, variable, CfSlab::of(file, variable));
}

} // namespace vp::reader::volumes
