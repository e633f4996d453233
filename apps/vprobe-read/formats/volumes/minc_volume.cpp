// After "MINC 2.0 file format" and the "MINC Programmer's Guide" (McConnell Brain Imaging Centre).
#include "minc_volume.h"

#include "vprobe-read/base/refusal.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/hdf5/netcdf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace vp::reader::volumes
{

namespace
{

// Along which axis of space one goes whose file does not say it.
std::array<double, 3> usualDirection(const std::string& name)
{
	return {name == "xspace" ? 1.0 : 0.0, name == "yspace" ? 1.0 : 0.0, name == "zspace" ? 1.0 : 0.0};
}

void setDirection(MincAxis& axis, const std::vector<double>& cosines)
{
	axis.direction = usualDirection(axis.name);
	if (cosines.size() == 3)
		std::copy(cosines.begin(), cosines.end(), axis.direction.begin());
}

// Version 1 stores bytes and words without their sign.
void takeSign(MincVolume& volume, nc_type type, const std::string& sign)
{
	const bool is_signed = sign.empty() ? type != NC_BYTE : !sign.starts_with("unsigned");
	const double range = type == NC_BYTE ? 256.0 : type == NC_SHORT ? 65536.0 : 4294967296.0;
	if (!is_signed && !volume.is_float)
		for (double& value : volume.values)
			value += value < 0.0 ? range : 0.0;
	if (is_signed && type == NC_BYTE)
		for (double& value : volume.values)
			value -= value > 127.0 ? range : 0.0;
	if (volume.valid[0] == volume.valid[1])
		volume.valid = {is_signed ? -range / 2.0 : 0.0, (is_signed ? range / 2.0 : range) - 1.0};
}

} // namespace

MincVolume readMinc1(const std::string& name)
{
	const hdf5::NetcdfFile file(name);
	const int image = file.variable("image");
	if (image < 0)
		throw damaged("it has no image");
	MincVolume volume;
	for (const auto& [axis_name, count] : file.dimensions(image))
	{
		const int variable = file.variable(axis_name.c_str());
		MincAxis axis;
		axis.name = axis_name;
		axis.count = count;
		const auto first = [&](const char* attribute, double otherwise)
		{
			const std::vector<double> numbers = file.numbers(variable, attribute);
			return numbers.empty() ? otherwise : numbers[0];
		};
		axis.start = first("start", 0.0);
		axis.step = first("step", 1.0);
		axis.units = file.text(variable, "units");
		setDirection(axis, file.numbers(variable, "direction_cosines"));
		volume.axes.push_back(axis);
	}
	nc_type type = NC_NAT;
	hdf5::NetcdfFile::check(nc_inq_vartype(file.id(), image, &type));
	volume.is_float = type == NC_FLOAT || type == NC_DOUBLE;
	volume.values = file.values(image);
	if (volume.is_float) // what nobody wrote
		std::replace(volume.values.begin(), volume.values.end(), NC_FILL_DOUBLE,
		             std::numeric_limits<double>::quiet_NaN());
	if (const std::vector<double> range = file.numbers(image, "valid_range"); range.size() == 2)
		volume.valid = {range[0], range[1]};
	takeSign(volume, type, file.text(image, "signtype"));
	for (const auto& [variable, values] :
	     {std::pair{"image-min", &volume.least}, std::pair{"image-max", &volume.greatest}})
		if (const int id = file.variable(variable); id >= 0)
			*values = file.values(id);
	return volume;
}

MincVolume readMinc2(const std::string& name)
{
	const hdf5::File file(name);
	const std::string root = "/minc-2.0/";
	const std::string image = root + "image/0/image";
	const std::vector<std::uint64_t> sides = file.sidesOf(image);
	std::string order = file.textOr(image, "dimorder");
	MincVolume volume;
	for (const std::uint64_t side : sides)
	{
		MincAxis axis;
		axis.name = order.substr(0, order.find(','));
		axis.count = side;
		order.erase(0, std::min(order.find(','), order.size()));
		order.erase(0, 1);
		const std::string dimension = root + "dimensions/" + axis.name;
		axis.start = file.realOr(dimension, "start", 0.0);
		axis.step = file.realOr(dimension, "step", 1.0);
		axis.units = file.textOr(dimension, "units");
		setDirection(axis, file.realsOr(dimension, "direction_cosines"));
		volume.axes.push_back(axis);
	}
	volume.values = file.reals(image);
	volume.is_float = file.isFloat(image);
	const std::vector<double> range = file.realsOr(image, "valid_range");
	volume.valid = range.size() == 2 ? std::array{range[0], range[1]} : file.limitsOfType(image);
	for (const auto& [variable, values] :
	     {std::pair{"image-min", &volume.least}, std::pair{"image-max", &volume.greatest}})
		if (const std::string path = root + "image/0/" + variable; file.has(path))
			*values = file.reals(path);
	return volume;
}

} // namespace vp::reader::volumes
