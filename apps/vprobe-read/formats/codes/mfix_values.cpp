// After MFIX's write_spx1.f: a head of three records, then for each time a record and the variables.
#include "mfix_values.h"

#include "mfix_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vp::reader::codes
{

namespace
{

struct MfixFile
{
	std::size_t parts = 0;
	std::vector<MfixVariable> variables;

	void add(std::string name, std::size_t components = 1)
	{
		MfixVariable& variable = variables.emplace_back(MfixVariable{std::move(name), {}});
		for (std::size_t c = 0; c < components; ++c)
			variable.parts.push_back(parts++);
	}
};

// Lists the variables in case.SP1 to case.SPB. Their names are those that ParaView shows.
std::vector<MfixFile> mfixFiles(const MfixRestart& mesh)
{
	std::vector<MfixFile> files(11);
	files[0].add("EP_g");
	files[1].add("P_g");
	files[1].add("P_star");
	files[2].add("Gas Velocity", 3);
	files[5].add("T_g");
	for (std::size_t m = 1; m <= mesh.phases; ++m)
	{
		files[3].add(fmt::format("Solids_Velocity_{}", m), 3);
		files[4].add(fmt::format("ROP_s_{}", m));
		files[7].add(fmt::format("Theta_m_{}", m));
	}
	// Until version 1.15, of two phases whether there were so many or not.
	const bool has_two = mesh.version < 1.15 + 1e-6;
	for (std::size_t m = 1; m <= (has_two ? 2 : mesh.phases); ++m)
		files[5].add(fmt::format("T_s_{}{}", m, m > mesh.phases ? "_not_used" : ""));
	for (std::size_t s = 1; s <= mesh.species[0]; ++s)
		files[6].add(fmt::format("X_g_{}", s));
	for (std::size_t m = 1; m <= mesh.phases; ++m)
		for (std::size_t s = 1; s <= mesh.species[m]; ++s)
			files[6].add(fmt::format("X_s_{}_{}", m, s));
	for (std::size_t s = 1; s <= mesh.scalars; ++s)
		files[8].add(fmt::format("Scalar_{}", s));
	for (std::size_t r = 1; r <= mesh.reactions; ++r)
		files[9].add(fmt::format("RRates_{}", r));
	if (mesh.has_turbulence)
	{
		files[10].add("k_turb_g");
		files[10].add("e_turb_g");
	}
	return files;
}

} // namespace

MfixValues::MfixValues(const std::string& path, std::size_t parts, std::vector<MfixVariable> variables,
                       const MfixRestart& mesh)
    : file_(path), parts_(parts), cells_(mesh.cellCount()),
      records_((cells_ * sizeof(float) + MfixRecords::kBytes - 1) / MfixRecords::kBytes),
      variables_(std::move(variables))
{
	const std::string_view head = MfixRecords(file_.text(), 2).record();
	const auto next = MfixRecords::numberAt<std::int32_t>(head, 0); // record to write, from 1
	const auto of_time = MfixRecords::numberAt<std::int32_t>(head, 4);
	if (next < 4 || of_time < 1 || static_cast<std::size_t>(of_time) != parts_ * records_ + 1 ||
	    file_.text().size() / MfixRecords::kBytes < static_cast<std::size_t>(next) - 1)
		throw damaged(fmt::format("{} has {} records, {} for each time", path, next - 1, of_time));
	const auto count = static_cast<std::size_t>((next - 4) / of_time);
	for (std::size_t t = 0; t < count; ++t)
	{
		const std::string_view record = MfixRecords(file_.text(), 3 + t * static_cast<std::size_t>(of_time)).record();
		times_.push_back(MfixRecords::numberAt<float>(record, 0));
		if (!std::isfinite(times_.back()))
			throw damaged(fmt::format("{} has a time that is no number", path));
	}
}

std::size_t MfixValues::stepAt(double time) const
{
	std::size_t best = 0;
	for (std::size_t step = 1; step < times_.size(); ++step)
	{
		const bool is_after = times_[step] > time;
		if (times_[best] > time ? !is_after || times_[step] <= times_[best] : !is_after && times_[step] >= times_[best])
			best = step;
	}
	return best;
}

std::vector<float> MfixValues::values(std::size_t part, std::size_t step) const
{
	const std::size_t at = 3 + step * (parts_ * records_ + 1) + 1 + part * records_;
	return MfixRecords(file_.text(), at).numbers<float>(cells_);
}

std::deque<MfixValues> mfixValuesBeside(const std::string& restart, const MfixRestart& mesh,
                                        std::vector<std::string>& empty)
{
	std::deque<MfixValues> values;
	std::vector<MfixFile> files = mfixFiles(mesh);
	for (std::size_t f = 0; f < files.size(); ++f)
	{
		const std::filesystem::path path =
		    std::filesystem::path(restart).replace_extension(std::string(".SP") + "123456789AB"[f]);
		std::error_code ignored;
		if (files[f].parts == 0 || !std::filesystem::is_regular_file(path, ignored))
			continue;
		values.emplace_back(path.string(), files[f].parts, std::move(files[f].variables), mesh);
		if (values.back().times().empty())
		{
			values.pop_back();
			empty.push_back(path.extension().string());
		}
	}
	return values;
}

} // namespace vp::reader::codes
