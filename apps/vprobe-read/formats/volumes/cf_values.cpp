#include "cf_values.h"

#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/is_one_of.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

namespace vp::reader::volumes
{

namespace
{

// Holds each whole number of 64 bits, and each double.
using Real = long double;
static_assert(std::numeric_limits<Real>::digits >= 64);

std::string nameOfVariable(const hdf5::NetcdfFile& file, int variable)
{
	std::array<char, NC_MAX_NAME + 1> name = {};
	hdf5::NetcdfFile::check(nc_inq_varname(file.id(), variable, name.data()));
	return name.data();
}

bool isUnsigned(const hdf5::NetcdfFile& file, int variable)
{
	return isOneOf(file.text(variable, "_Unsigned"), {"true", "True", "TRUE"});
}

// Some programs write numbers as texts. Nothing where other words are in it.
std::vector<Real> numbersInText(const std::string& text)
{
	std::vector<Real> numbers;
	for (const char* at = text.c_str(); *at != '\0';)
	{
		char* end = nullptr;
		numbers.push_back(std::strtod(at, &end));
		if (end == at)
			return {};
		at = end + std::strspn(end, " ,\t\n");
	}
	return numbers;
}

std::vector<Real> realsOf(const hdf5::NetcdfFile& file, int variable, const char* attribute)
{
	const auto [type, count] = file.attributeOf(variable, attribute);
	if (type == NC_CHAR || type == NC_STRING)
		return numbersInText(file.text(variable, attribute));
	const std::vector<double> doubles = file.numbers(variable, attribute);
	std::vector<Real> reals(doubles.begin(), doubles.end());
	if (type == NC_INT64 && reals.size() == count)
	{
		std::vector<long long> wide(count);
		hdf5::NetcdfFile::check(nc_get_att_longlong(file.id(), variable, attribute, wide.data()));
		reals.assign(wide.begin(), wide.end());
	}
	else if (type == NC_UINT64 && reals.size() == count)
	{
		std::vector<unsigned long long> wide(count);
		hdf5::NetcdfFile::check(nc_get_att_ulonglong(file.id(), variable, attribute, wide.data()));
		reals.assign(wide.begin(), wide.end());
	}
	return reals;
}

template <class Number>
bool canBe(Real real)
{
	if constexpr (std::is_floating_point_v<Number>)
		return true;
	else
		return real == std::floor(real) && real >= static_cast<Real>(std::numeric_limits<Number>::min()) &&
		       real <= static_cast<Real>(std::numeric_limits<Number>::max());
}

// Bytes have none: the NetCDF Users Guide leaves all their values to the writer.
template <class Number>
std::optional<Number> defaultFill()
{
	if constexpr (std::is_same_v<Number, float>)
		return NC_FILL_FLOAT;
	else if constexpr (std::is_same_v<Number, double>)
		return NC_FILL_DOUBLE;
	else if constexpr (sizeof(Number) == 1)
		return std::nullopt;
	else if constexpr (std::is_unsigned_v<Number>)
		return static_cast<Number>(sizeof(Number) == 8 ? NC_FILL_UINT64 : std::numeric_limits<Number>::max());
	else
		return static_cast<Number>(sizeof(Number) == 8 ? NC_FILL_INT64 : std::numeric_limits<Number>::min() + 1);
}

// Which stored values of a variable are missing.
template <class Number>
class Missing
{
public:
	Missing(const hdf5::NetcdfFile& file, int variable)
	    : turns_unsigned_(std::is_unsigned_v<Number> && isUnsigned(file, variable))
	{
		for (const char* attribute : {"_FillValue", "missing_value"})
			for (const Real mark : realsOf(file, variable, attribute))
				if (const Real real = turned(mark); canBe<Number>(real))
					marks_.push_back(static_cast<Number>(real));
		if (file.marksUnwritten() && file.attributeOf(variable, "_FillValue").first == NC_NAT)
			takeUnwritten(file, variable);
		takeRange(file, variable);
	}

	bool operator()(Number value) const
	{
		if (std::ranges::find(marks_, value) != marks_.end() || value < low_ || value > high_)
			return true;
		if constexpr (std::is_floating_point_v<Number>)
			return std::isnan(value);
		return false;
	}
	// Returns true if no value is missing, whatever it is.
	bool marksNone() const
	{
		using Limits = std::numeric_limits<Number>;
		return std::is_integral_v<Number> && marks_.empty() && low_ == Limits::lowest() && high_ == Limits::max() &&
		       std::isinf(meant_low_) && std::isinf(meant_high_);
	}
	// For packed values, once they are unpacked.
	bool isOutside(double unpacked) const { return unpacked < meant_low_ || unpacked > meant_high_; }

private:
	// Attributes of netCDF's classic format are as signed as the values.
	Real turned(Real real) const
	{
		return turns_unsigned_ && real < 0 ? real + std::ldexp(Real(1), std::numeric_limits<Number>::digits) : real;
	}
	// HDF5 and Zarr have a value for what nobody wrote; 0 is that of most programs, and mostly a value like others.
	void takeUnwritten(const hdf5::NetcdfFile& file, int variable)
	{
		if constexpr (std::is_unsigned_v<Number>)
		{
			if (const auto fill = defaultFill<std::make_signed_t<Number>>(); fill && turns_unsigned_)
				marks_.push_back(static_cast<Number>(*fill));
		}
		if (const auto fill = defaultFill<Number>(); fill && !turns_unsigned_)
			marks_.push_back(*fill);
		int has_none = 0;
		Number fill = 0;
		const bool is_plain = std::is_unsigned_v<Number> && !turns_unsigned_;
		const auto of_bytes = static_cast<Number>(is_plain ? NC_FILL_UBYTE : NC_FILL_BYTE);
		if (nc_inq_var_fill(file.id(), variable, &has_none, &fill) == NC_NOERR && has_none == 0 && fill != 0 &&
		    (sizeof(Number) > 1 || fill != of_bytes))
			marks_.push_back(fill);
	}
	void takeRange(const hdf5::NetcdfFile& file, int variable)
	{
		std::vector<Real> range = realsOf(file, variable, "valid_range");
		const std::vector<Real> low = realsOf(file, variable, "valid_min");
		const std::vector<Real> high = realsOf(file, variable, "valid_max");
		const bool has_both = range.size() == 2;
		if (has_both || low.size() == 1)
			takeBound(has_both ? range[0] : low[0], low_, meant_low_);
		if (has_both || high.size() == 1)
			takeBound(has_both ? range[1] : high[0], high_, meant_high_);
	}
	// Bounds are in packed units; one that no packed value can be is of the unpacked ones (NetCDF Users Guide).
	void takeBound(Real bound, Number& stored, double& meant) const
	{
		if (std::isnan(bound))
			return;
		if (const Real real = turned(bound); canBe<Number>(real))
			stored = static_cast<Number>(real);
		else
			meant = static_cast<double>(bound);
	}

	bool turns_unsigned_;
	std::vector<Number> marks_;
	Number low_ = std::is_floating_point_v<Number> ? -std::numeric_limits<Number>::infinity()
	                                               : std::numeric_limits<Number>::lowest();
	Number high_ =
	    std::is_floating_point_v<Number> ? std::numeric_limits<Number>::infinity() : std::numeric_limits<Number>::max();
	double meant_low_ = -std::numeric_limits<double>::infinity();
	double meant_high_ = std::numeric_limits<double>::infinity();
};

struct CfPacking
{
	double scale = 1.0, offset = 0.0;
	bool is_packed = false;
};

void takeFactor(const hdf5::NetcdfFile& file, int variable, const char* attribute, double& to, bool& is_packed)
{
	if (file.attributeOf(variable, attribute).first == NC_NAT)
		return;
	const std::vector<Real> factor = realsOf(file, variable, attribute);
	if (factor.size() != 1)
		throw Refusal(fmt::format("{} of {} is no number; mend it, for instance with ncatted", attribute,
		                          nameOfVariable(file, variable)));
	to = static_cast<double>(factor[0]);
	is_packed = true;
}

CfPacking packingOf(const hdf5::NetcdfFile& file, int variable)
{
	CfPacking packing;
	takeFactor(file, variable, "scale_factor", packing.scale, packing.is_packed);
	takeFactor(file, variable, "add_offset", packing.offset, packing.is_packed);
	return packing;
}

template <class Array, class Number>
vtkSmartPointer<vtkDataArray> meantAs(std::span<const Number> stored, const Missing<Number>& missing,
                                      const CfPacking& packing)
{
	using Meant = typename Array::ValueType;
	const auto array = vtkSmartPointer<Array>::New();
	array->SetNumberOfValues(static_cast<vtkIdType>(stored.size()));
	Meant* to = array->GetPointer(0);
	for (const Number value : stored)
	{
		const double meant = packing.is_packed ? static_cast<double>(value) * packing.scale + packing.offset
		                                       : static_cast<double>(value);
		*to++ = missing(value) || missing.isOutside(meant) ? std::numeric_limits<Meant>::quiet_NaN()
		                                                   : static_cast<Meant>(meant);
	}
	return array;
}

template <class Number>
vtkSmartPointer<vtkDataArray> meantOf(const Missing<Number>& missing, const CfPacking& packing,
                                      vtkSmartPointer<vtkDataArray> stored)
{
	const std::span<const Number> values(static_cast<const Number*>(stored->GetVoidPointer(0)),
	                                     static_cast<std::size_t>(stored->GetNumberOfValues()));
	const auto is_missing = [&](Number value)
	{ return missing(value) || missing.isOutside(static_cast<double>(value)); };
	if (!packing.is_packed && std::ranges::none_of(values, is_missing))
		return stored;
	// Floats hold all whole numbers of 16 bits.
	const bool is_short = std::is_same_v<Number, float> || (std::is_integral_v<Number> && sizeof(Number) <= 2);
	return is_short && !packing.is_packed ? meantAs<vtkFloatArray>(values, missing, packing)
	                                      : meantAs<vtkDoubleArray>(values, missing, packing);
}

} // namespace

int cfTypeOf(const hdf5::NetcdfFile& file, int variable)
{
	nc_type type = NC_NAT;
	hdf5::NetcdfFile::check(nc_inq_vartype(file.id(), variable, &type));
	const bool turned = isUnsigned(file, variable);
	switch (type)
	{
	case NC_BYTE:
		return turned ? VTK_UNSIGNED_CHAR : VTK_SIGNED_CHAR;
	case NC_UBYTE:
		return VTK_UNSIGNED_CHAR;
	case NC_SHORT:
		return turned ? VTK_UNSIGNED_SHORT : VTK_SHORT;
	case NC_USHORT:
		return VTK_UNSIGNED_SHORT;
	case NC_INT:
		return turned ? VTK_UNSIGNED_INT : VTK_INT;
	case NC_UINT:
		return VTK_UNSIGNED_INT;
	case NC_INT64:
		return turned ? VTK_UNSIGNED_LONG_LONG : VTK_LONG_LONG;
	case NC_UINT64:
		return VTK_UNSIGNED_LONG_LONG;
	case NC_FLOAT:
		return VTK_FLOAT;
	case NC_DOUBLE:
		return VTK_DOUBLE;
	default:
		return 0;
	}
}

namespace
{

// Calls act(NUMBER()) with a number of VTK's type.
template <class Act>
auto withNumber(int type, const Act& act)
{
	switch (type)
	{
	case VTK_SIGNED_CHAR:
		return act(static_cast<signed char>(0));
	case VTK_UNSIGNED_CHAR:
		return act(static_cast<unsigned char>(0));
	case VTK_SHORT:
		return act(short(0));
	case VTK_UNSIGNED_SHORT:
		return act(static_cast<unsigned short>(0));
	case VTK_INT:
		return act(0);
	case VTK_UNSIGNED_INT:
		return act(0u);
	case VTK_LONG_LONG:
		return act(0ll);
	case VTK_UNSIGNED_LONG_LONG:
		return act(0ull);
	case VTK_FLOAT:
		return act(0.0f);
	case VTK_DOUBLE:
		return act(0.0);
	default:
		throw damaged("a variable holds no numbers");
	}
}

} // namespace

CfMeaning cfMeaning(const hdf5::NetcdfFile& file, int variable)
{
	const auto meaning = [&]<class Number>(Number) -> CfMeaning
	{
		return [missing = Missing<Number>(file, variable), packing = packingOf(file, variable)](
		           vtkSmartPointer<vtkDataArray> stored) { return meantOf(missing, packing, std::move(stored)); };
	};
	return withNumber(cfTypeOf(file, variable), meaning);
}

std::optional<grid::NumberType> cfTypeMeant(const hdf5::NetcdfFile& file, int variable)
{
	const int type = cfTypeOf(file, variable);
	if (packingOf(file, variable).is_packed)
		return grid::NumberType::float64;
	const bool is_known = type == VTK_FLOAT || type == VTK_DOUBLE ||
	                      (type != 0 && withNumber(type, [&]<class Number>(Number)
	                                               { return Missing<Number>(file, variable).marksNone(); }));
	return is_known ? arrays::numberTypeOfVtk(type) : std::nullopt;
}

bool cfIsPlain(const hdf5::NetcdfFile& file, int variable)
{
	constexpr std::array kMarks = {"_FillValue", "missing_value", "valid_range", "valid_min",
	                               "valid_max",  "scale_factor",  "add_offset"};
	return !file.marksUnwritten() && std::ranges::all_of(kMarks, [&](const char* mark)
	                                                     { return file.attributeOf(variable, mark).first == NC_NAT; });
}

} // namespace vp::reader::volumes
