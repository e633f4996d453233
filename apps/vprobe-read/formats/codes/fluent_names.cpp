#include "fluent_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace vp::reader::codes
{

namespace
{

struct FluentName
{
	std::int64_t number;
	std::string_view name;
};

constexpr FluentName kFluentNames[] = {
    {1, "PRESSURE"},
    {2, "MOMENTUM"},
    {3, "TEMPERATURE"},
    {4, "ENTHALPY"},
    {5, "TKE"},
    {6, "TED"},
    {7, "SPECIES"},
    {8, "G"},
    {9, "WSWIRL"},
    {10, "DPMS_MASS"},
    {11, "DPMS_MOM"},
    {12, "DPMS_ENERGY"},
    {13, "DPMS_SPECIES"},
    {15, "BODY_FORCES"},
    {16, "FMEAN"},
    {17, "FVAR"},
    {18, "MASS_FLUX"},
    {22, "OLD_PRESSURE"},
    {33, "PDF_MW"},
    {42, "PREMIXC"},
    {50, "DO_I"},
    {53, "DO_IRRAD"},
    {59, "MACH"},
    {63, "SDR"},
    {67, "GRANULAR_TEMPERATURE"},
    {96, "WALL_DIST"},
    {101, "DENSITY"},
    {102, "MU_LAM"},
    {103, "MU_TURB"},
    {104, "CP"},
    {105, "KTC"},
    {108, "RSTRESS"},
    {111, "X_VELOCITY"},
    {112, "Y_VELOCITY"},
    {113, "Z_VELOCITY"},
    {115, "X_VELOCITY_M1"},
    {116, "Y_VELOCITY_M1"},
    {117, "Z_VELOCITY_M1"},
    {119, "TKE_M1"},
    {120, "TED_M1"},
    {122, "X_VELOCITY_M2"},
    {123, "Y_VELOCITY_M2"},
    {124, "Z_VELOCITY_M2"},
    {128, "RUU"},
    {129, "RVV"},
    {130, "RWW"},
    {131, "RUV"},
    {132, "RVW"},
    {133, "RUW"},
    {138, "ENTHALPY_M1"},
    {139, "ENTHALPY_M2"},
    {150, "VOF"},
    {192, "TOTAL_PRESSURE"},
    {193, "TOTAL_TEMPERATURE"},
    {400, "PRESSURE_MEAN"},
    {401, "PRESSURE_RMS"},
    {402, "X_VELOCITY_MEAN"},
    {403, "X_VELOCITY_RMS"},
    {404, "Y_VELOCITY_MEAN"},
    {405, "Y_VELOCITY_RMS"},
    {406, "Z_VELOCITY_MEAN"},
    {407, "Z_VELOCITY_RMS"},
    {408, "TEMPERATURE_MEAN"},
    {409, "TEMPERATURE_RMS"},
    {410, "VOF_MEAN"},
    {411, "VOF_RMS"},
    {412, "PRESSURE_M1"},
    {413, "PRESSURE_M2"},
};

// Rows of 50 names, one for each species.
constexpr FluentName kFluentSpecies[] = {{200, "Y"}, {250, "Y_M1"}, {300, "Y_M2"}, {350, "DR_SURF"}, {450, "DPMS_Y"}};

} // namespace

std::string fluentName(std::int64_t number)
{
	const auto known = std::ranges::find(kFluentNames, number, &FluentName::number);
	if (known != std::end(kFluentNames))
		return std::string(known->name);
	for (const FluentName& row : kFluentSpecies)
		if (number >= row.number && number < row.number + 50)
			return fmt::format("{}_{:02}", row.name, number - row.number);
	return fmt::format("field {}", number);
}

} // namespace vp::reader::codes
