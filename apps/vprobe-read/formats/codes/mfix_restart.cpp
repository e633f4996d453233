// The order of records is that of MFIX's write_res0.f, as VTK's reader follows it too.
#include "mfix_restart.h"

#include "mfix_records.h"
#include "vprobe-read/text/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::codes
{

namespace
{

// Numbers of conditions that a file may speak of; MFIX itself allows 500 of each kind.
constexpr std::size_t kMaxMfixItems = 100000;

struct MfixCounts
{
	std::size_t initial = 5; // conditions
	std::size_t boundary = 5;
	std::size_t constants = 5;
	std::size_t surfaces = 5;
	std::size_t files = 9;
	static constexpr std::size_t kUser = 5;
};

class MfixParser
{
public:
	explicit MfixParser(std::string_view bytes) : records_(bytes) {}

	MfixRestart parse()
	{
		readVersion();
		readSizes();
		readSpecies();
		for (std::size_t axis = 0; axis < 3; ++axis)
			mfix_.widths[axis] = records_.numbers<double>(mfix_.cells[axis]);
		readNames();
		skipInitialConditions();
		skipBoundaryConditions();
		mfix_.flags = records_.numbers<std::int32_t>(mfix_.cellCount());
		skipSurfaces();
		skipFiles();
		skipRest();
		readCounts();
		return std::move(mfix_);
	}

private:
	bool since(double version) const { return mfix_.version > version - 1e-6; }
	void skipDoubles(std::size_t count, std::size_t times) { records_.skipNumbers<double>(count, times); }
	std::size_t wholeAt(std::string_view record, std::size_t place)
	{
		const auto number = MfixRecords::numberAt<std::int32_t>(record, place);
		if (number < 0 || static_cast<std::size_t>(number) > kMaxMfixItems)
			throw damaged(fmt::format("a count of {}", number));
		return static_cast<std::size_t>(number);
	}
	std::size_t speciesOfSolids() const
	{
		std::size_t sum = 0;
		for (std::size_t phase = 1; phase < mfix_.species.size(); ++phase)
			sum += mfix_.species[phase];
		return sum;
	}

	void readVersion()
	{
		const std::string_view head = records_.record(); // "RES = 01.6"
		text::Cursor at(head);
		at.word();
		at.word();
		const std::string_view word = at.word(); // which zeros may follow
		mfix_.version = text::Cursor(word.substr(0, word.find_first_not_of(".0123456789"))).real();
		if (!(mfix_.version >= 1.0 && mfix_.version < 3.0))
			throw Refusal(fmt::format("a restart file of MFIX of version {}, which is not read", mfix_.version));
		records_.skip(2); // what it is called, and when it was written
	}

	void readSizes()
	{
		const std::string_view record = records_.record();
		std::size_t place = 9 * 4; // the first and the last cells that are none of the ghosts
		for (std::size_t& count : mfix_.cells)
		{
			count = wholeAt(record, place);
			place += 4;
		}
		place += 2 * 4; // products of these
		mfix_.phases = wholeAt(record, place);
		place += 4;
		const auto next = [&](std::size_t& count, double from)
		{
			if (!since(from))
				return;
			count = wholeAt(record, place);
			place += 4;
		};
		next(counts_.initial, 1.01);
		next(counts_.boundary, 1.01);
		next(counts_.constants, 1.04);
		next(counts_.surfaces, 1.05);
		if (since(1.03)) // behind the step of time
			mfix_.start = MfixRecords::numberAt<double>(record, place + 8);
		if (!std::isfinite(mfix_.start) || mfix_.phases > 100)
			throw damaged("its sizes cannot be");
		for (const std::size_t count : mfix_.cells)
			if (count < 3)
				throw Refusal("nothing to slice: a case of MFIX of fewer than three dimensions");
	}

	void readSpecies()
	{
		mfix_.species.assign(mfix_.phases + 1, 1);
		if (!since(1.05))
			return;
		skipDoubles(counts_.constants, 1);
		records_.skip(counts_.constants); // their names
		for (std::size_t i = 0; const std::int32_t count : records_.numbers<std::int32_t>(mfix_.phases + 1))
		{
			if (count < 0 || count > 1000)
				throw damaged(fmt::format("a phase of {} species", count));
			mfix_.species[i++] = static_cast<std::size_t>(count);
		}
	}

	void readNames()
	{
		const std::string_view record = records_.record(); // 60 for the run, 60 about it
		const auto word = [&](std::size_t place)
		{
			std::string text(record.substr(place, 16));
			std::erase_if(text, [](unsigned char c) { return c <= ' '; });
			return text;
		};
		mfix_.length_units = word(120) == "SI" ? "m" : word(120) == "CGS" ? "cm" : "";
		const std::string coordinates = word(152);
		mfix_.is_cylindrical = coordinates == "CYLINDRICAL";
		if (coordinates != "CARTESIAN" && coordinates != "CYLINDRICAL")
			throw damaged(fmt::format("coordinates called \"{}\"", coordinates));
		if (since(1.04))
		{
			skipDoubles(mfix_.species[0], 1); // weights of molecules
			records_.skip(mfix_.phases);
		}
		records_.skip(); // sizes of particles
	}

	void skipInitialConditions()
	{
		const std::size_t count = counts_.initial;
		skipDoubles(count, 6);
		records_.skipNumbers<std::int32_t>(count, 6);
		skipDoubles(count, 3 + (since(1.15) ? 0 : 2) + (since(1.04) ? mfix_.species[0] : 0) + 3);
		skipDoubles(count, mfix_.phases * (4 + (since(1.15) ? 1 : 0)) + (since(1.04) ? speciesOfSolids() : 0));
	}

	void skipBoundaryConditions()
	{
		const std::size_t count = counts_.boundary;
		skipDoubles(count, 6);
		records_.skipNumbers<std::int32_t>(count, 6);
		skipDoubles(count, 3 + (since(1.15) ? 0 : 2) + (since(1.04) ? mfix_.species[0] : 0) + 7);
		const std::size_t of_phase = 3 + (since(1.04) ? 1 + (since(1.15) ? 1 : 0) : 0) + 2;
		skipDoubles(count, mfix_.phases * of_phase + (since(1.04) ? speciesOfSolids() : 0));
		records_.skip(since(1.01) ? count : 10); // their kinds
	}

	void skipSurfaces()
	{
		if (!since(1.04))
			return;
		const std::size_t count = counts_.surfaces;
		skipDoubles(count, 6);
		records_.skipNumbers<std::int32_t>(count, 6);
		skipDoubles(count, 2 + (since(1.07) ? mfix_.phases : 0));
		records_.skip(count); // their kinds
	}

	void skipFiles()
	{
		if (since(1.08))
			records_.skip();
		if (!since(1.09))
			return;
		records_.skip();
		if (since(1.5))
			counts_.files = wholeAt(records_.record(), 0);
		records_.skip(counts_.files + mfix_.phases + 1);
		skipDoubles(MfixCounts::kUser, 7);
		records_.skip(MfixCounts::kUser);
		skipDoubles(counts_.initial, 2);
		records_.skip(counts_.initial);
		skipDoubles(counts_.boundary, 6);
	}

	void skipRest()
	{
		records_.skip((since(1.1) ? 1 : 0) + (since(1.11) ? 1 : 0) + (since(1.12) ? 2 : 0));
		if (since(1.12))
			skipDoubles(counts_.boundary, 4 + 4 * mfix_.phases);
		records_.skip((since(1.13) ? 1 : 0) + (since(1.14) ? 1 : 0) + (since(1.15) ? 1 : 0));
		if (since(1.15))
			skipDoubles(counts_.initial, 2 + 2 * mfix_.phases);
		if (since(1.2))
			records_.skip();
	}

	void readCounts()
	{
		if (since(1.3))
		{
			const std::string_view record = records_.record(); // a count, a limit, how many phases follow
			mfix_.scalars = wholeAt(record, 0);
			records_.skipNumbers<std::int32_t>(wholeAt(record, 12));
		}
		if (since(1.5))
			mfix_.reactions = wholeAt(records_.record(), 0);
		if (since(1.6))
			mfix_.has_turbulence = MfixRecords::numberAt<std::int32_t>(records_.record(), 0) != 0;
	}

	MfixRecords records_;
	MfixRestart mfix_{};
	MfixCounts counts_;
};

} // namespace

MfixRestart parseMfixRestart(std::string_view bytes)
{
	return MfixParser(bytes).parse();
}

} // namespace vp::reader::codes
