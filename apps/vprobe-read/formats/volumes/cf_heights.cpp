#include "cf_heights.h"

#include "cf_grid.h"
#include "cf_values.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"
#include "wrf_file.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>
#include <sstream>

namespace vp::reader::volumes
{

namespace
{

constexpr std::string_view kHybridHeight = "atmosphere_hybrid_height_coordinate";

bool isKnownFormula(std::string_view name)
{
	return isOneOf(name, {"ocean_sigma_coordinate", "ocean_s_coordinate", "ocean_s_coordinate_g1",
	                      "ocean_s_coordinate_g2", kHybridHeight});
}

// "s: s_rho C: Cs_r eta: zeta" names the variable of each term.
std::map<std::string, std::string> termsIn(const std::string& text)
{
	std::map<std::string, std::string> terms;
	std::istringstream words(text);
	for (std::string term, name; words >> term >> name;)
		if (term.ends_with(':'))
			terms[term.substr(0, term.size() - 1)] = name;
	return terms;
}

// A term of a formula: one number, one for each layer, or one for each column.
class CfTerm
{
public:
	CfTerm(const hdf5::NetcdfFile& file, const CfVolumes& volumes, std::size_t step, const std::string& name)
	{
		const int variable = file.variable(name.c_str());
		if (variable < 0)
			throw Refusal(
			    fmt::format("its heights need {}, which is not in the file; add it, for instance with ncks -A", name));
		std::size_t layers = 0, columns = 0, others = 0;
		for (const auto& [side, length] : file.dimensions(variable))
			if (side == volumes.axes[2].name)
				++layers;
			else if (side == volumes.axes[0].name || side == volumes.axes[1].name)
				++columns;
			else if (length > 1 && !(volumes.time && side == volumes.time->name))
				++others;
		if (others == 0 && layers == 0 && columns == 2)
			values_ = cfPlane(file, volumes, variable, step, 1);
		else if (others == 0 && columns == 0)
			values_ = cfNumbers(file, variable, slabAt(file, volumes, variable, step));
		is_of_columns_ = columns == 2;
		const std::size_t wanted = is_of_columns_ ? volumes.axes[0].length * volumes.axes[1].length
		                           : layers == 1  ? volumes.axes[2].length
		                                          : 1;
		if (values_.size() != wanted)
			throw Refusal(fmt::format("its heights need {}, which lies on other dimensions", name));
	}

	double at(std::size_t layer, std::size_t column) const
	{
		return values_[values_.size() == 1 ? 0 : is_of_columns_ ? column : layer];
	}

private:
	static CfSlab slabAt(const hdf5::NetcdfFile& file, const CfVolumes& volumes, int variable, std::size_t step)
	{
		CfSlab slab = CfSlab::of(file, variable);
		const auto sides = file.dimensions(variable);
		for (std::size_t i = 0; i < sides.size(); ++i)
			if (volumes.time && sides[i].first == volumes.time->name && sides[i].second > 0)
				slab.fix(i, std::min(step, sides[i].second - 1));
		return slab;
	}

	std::vector<double> values_;
	bool is_of_columns_ = false;
};

// Stretching of the first kind of s-coordinates, by two parameters.
double stretched(double s, double a, double b)
{
	return a == 0.0 ? s
	                : (1.0 - b) * std::sinh(a * s) / std::sinh(a) +
	                      b * (std::tanh(a * (s + 0.5)) / (2.0 * std::tanh(0.5 * a)) - 0.5);
}

using Term = std::function<double(const char*)>;

double heightOf(std::string_view formula, const Term& term)
{
	if (formula == kHybridHeight)
		return term("a") + term("b") * term("orog");
	const double eta = term("eta"), depth = term("depth");
	if (formula == "ocean_sigma_coordinate")
		return eta + term("sigma") * (depth + eta);
	const double s = term("s"), depth_c = term("depth_c");
	if (formula == "ocean_s_coordinate")
		return eta * (1.0 + s) + depth_c * s + (depth - depth_c) * stretched(s, term("a"), term("b"));
	if (formula == "ocean_s_coordinate_g1")
	{
		const double shape = depth_c * s + (depth - depth_c) * term("C");
		return shape + eta * (1.0 + shape / depth);
	}
	return eta + (eta + depth) * (depth_c * s + depth * term("C")) / (depth_c + depth);
}

std::string formulaOf(const hdf5::NetcdfFile& file, const CfVolumes& volumes)
{
	const int variable = volumes.axes[2].coordinate;
	return variable < 0 || file.text(variable, "formula_terms").empty() ? "" : file.text(variable, "standard_name");
}

} // namespace

std::optional<CfHeights> cfHeights(const hdf5::NetcdfFile& file, const CfVolumes& volumes, std::size_t step)
{
	if (auto heights = wrfHeights(file, volumes, step))
		return CfHeights{std::move(*heights), "m"};
	const std::string formula = formulaOf(file, volumes);
	if (!isKnownFormula(formula))
		return std::nullopt;
	const std::map<std::string, std::string> names = termsIn(file.text(volumes.axes[2].coordinate, "formula_terms"));
	std::map<std::string, CfTerm, std::less<>> terms;
	for (const auto& [term, name] : names)
		terms.emplace(term, CfTerm(file, volumes, step, name));
	CfHeights heights;
	const char* in_meters = formula == kHybridHeight ? "a" : "depth";
	if (const auto named = names.find(in_meters); named != names.end())
		heights.units = file.text(file.variable(named->second.c_str()), "units");
	const std::size_t columns = volumes.axes[0].length * volumes.axes[1].length;
	for (std::size_t layer = 0; layer < volumes.axes[2].length; ++layer)
		for (std::size_t column = 0; column < columns; ++column)
			heights.places.push_back(
			    heightOf(formula,
			             [&](const char* name)
			             {
				             const auto term = terms.find(name);
				             if (term == terms.end())
					             throw Refusal(fmt::format("the formula_terms of its heights lack {}:", name));
				             return term->second.at(layer, column);
			             }));
	return heights;
}

std::string unknownFormula(const hdf5::NetcdfFile& file, const CfVolumes& volumes)
{
	const std::string formula = formulaOf(file, volumes);
	return isKnownFormula(formula) ? std::string() : formula;
}

} // namespace vp::reader::volumes
