#include "quick_cells.h"

#include "base/ids.h"
#include "read/cell_types.h"
#include "vprobe-read/base/is_one_of.h"

#include <algorithm>
#include <array>
#include <mutex>

namespace vp::reader::quick
{

using grid::NumberType;

namespace
{

constexpr std::uint64_t kNarrowPoints = std::uint64_t(1) << 31;

const text::XmlElement& listOf(const Piece& piece, std::string_view name)
{
	const text::XmlElement* found = nullptr;
	for (const text::XmlElement& array : onlyChild(*piece.element, "Cells").children)
	{
		const std::string_view given = array.attribute("Name");
		if (!isOneOf(given, {"connectivity", "offsets", "types", "face_connectivity", "face_offsets",
		                     "polyhedron_to_faces", "polyhedron_offsets"}))
			throw arrays::NotQuick(); // faces of polyhedra as they were before VTK 9.4
		if (given == name)
		{
			if (found)
				throw arrays::NotQuick();
			found = &array;
		}
	}
	if (!found || ArrayKind(*found).components != 1)
		throw arrays::NotQuick();
	return *found;
}

// Calls work(begin, std::span<const T>) for the first numbers of an array, part by part. T is the file's type.
template <class Work>
void addIds(const File& file, const text::XmlElement& array, std::uint64_t count, Tasks& tasks, Work work)
{
	const NumberType type = ArrayKind(array).type;
	if (type != NumberType::int32 && type != NumberType::int64)
		throw arrays::NotQuick();
	const std::size_t id_bytes = byteSize(type);
	if (count > ~std::uint64_t(0) / id_bytes)
		throw arrays::NotQuick();
	const auto packed = file.open(array, count * id_bytes);
	const std::size_t part_bytes = packed->partBytes();
	if (part_bytes % id_bytes != 0)
		throw arrays::NotQuick();
	const std::uint64_t bytes = count * id_bytes;
	tasks.add((bytes + part_bytes - 1) / part_bytes,
	          [=](std::size_t part, arrays::Scratch& scratch)
	          {
		          const std::uint64_t begin = std::uint64_t(part) * part_bytes;
		          const std::span<const std::byte> given = packed->part(part, bytes - begin, scratch);
		          const auto use = [&](auto* ids) { work(begin / id_bytes, std::span(ids, given.size() / id_bytes)); };
		          if (type == NumberType::int32)
			          use(reinterpret_cast<const std::int32_t*>(given.data()));
		          else
			          use(reinterpret_cast<const std::int64_t*>(given.data()));
	          });
}

class CellReader
{
public:
	CellReader(const File& file, const std::vector<Piece>& pieces, arrays::Writer& writer, Tasks& tasks)
	    : file_(file), pieces_(pieces), writer_(writer), tasks_(tasks)
	{
		for (const Piece& piece : pieces)
		{
			points_ += piece.points;
			cells_ += piece.cells;
		}
		if (points_ >= kNarrowPoints || cells_ >= kMaxBlockIds)
			throw arrays::NotQuick();
	}

	Cells read()
	{
		readTypes();
		const bool are_alike = kinds_[types_[0]] == cells_;
		const auto size = static_cast<std::uint64_t>(read::slicedCellSize(types_[0]));
		std::vector<std::uint64_t> ids(pieces_.size());
		if (are_alike)
		{
			for (std::size_t p = 0; p < pieces_.size(); ++p)
				ids[p] = size * pieces_[p].cells;
			compareOffsets(size);
		}
		else
			readOffsets(ids);
		readIds(ids);
		return std::move(result_);
	}

private:
	void readTypes()
	{
		types_.resize(cells_);
		std::mutex mutex;
		std::uint64_t first = 0;
		const std::size_t at = writer_.reserve(cells_);
		for (const Piece& piece : pieces_)
		{
			const text::XmlElement& array = listOf(piece, "types");
			if (ArrayKind(array).type != NumberType::uint8)
				throw arrays::NotQuick();
			const auto packed = file_.open(array, piece.cells);
			const std::size_t part_bytes = packed->partBytes();
			tasks_.add((piece.cells + part_bytes - 1) / part_bytes,
			           [=, this, &mutex, cells = piece.cells](std::size_t part, arrays::Scratch& scratch)
			           {
				           const std::uint64_t begin = std::uint64_t(part) * part_bytes;
				           const auto given = packed->part(part, cells - begin, scratch);
				           auto* to = types_.data() + first + begin;
				           std::transform(given.begin(), given.end(), to,
				                          [](std::byte b) { return static_cast<std::uint8_t>(b); });
				           writer_.put(at + first + begin, to, given.size());
				           count({to, given.size()}, mutex);
			           });
			first += piece.cells;
		}
		tasks_.run();
		result_.lists["types"] = arrays::Writer::describe(NumberType::uint8, at, cells_);
		chooseKinds();
	}

	void count(std::span<const std::uint8_t> types, std::mutex& mutex)
	{
		std::array<std::size_t, 256> counts{};
		// Mostly, all types are the same.
		if (std::equal(types.begin() + 1, types.end(), types.begin()))
			counts[types[0]] = types.size();
		else
			for (const std::uint8_t type : types)
				++counts[type];
		const std::lock_guard lock(mutex);
		for (std::size_t type = 0; type < 256; ++type)
			kinds_[type] += counts[type];
	}

	// Counts the cells to slice, and flat ones.
	void chooseKinds()
	{
		std::size_t left = 0;
		for (std::size_t type = 0; type < 256; ++type)
		{
			const int dimension = read::cellDimension(static_cast<std::uint8_t>(type));
			const bool is_linear = read::slicedCellSize(static_cast<std::uint8_t>(type)) > 0;
			if (kinds_[type] == 0)
				continue;
			if (is_linear)
				left += kinds_[type];
			else if (dimension >= 0 && dimension < 3)
				result_.flat += kinds_[type];
			else
				throw arrays::NotQuick();
		}
		if (left == 0)
			throw arrays::NotQuick();
	}

	// Checks that the offsets belong to cells of one size, one after the other.
	void compareOffsets(std::uint64_t size)
	{
		for (const Piece& piece : pieces_)
			addIds(file_, listOf(piece, "offsets"), piece.cells, tasks_,
			       [size](std::uint64_t begin, auto offsets)
			       {
				       std::uint64_t wrong = 0;
				       std::uint64_t wanted = size * begin;
				       for (const auto offset : offsets)
					       wrong |= static_cast<std::uint64_t>(offset) ^ (wanted += size);
				       if (wrong)
					       throw arrays::NotQuick();
			       });
	}

	// Reads the offsets. Files store the ends of the cells' lists, for each piece separately.
	void readOffsets(std::vector<std::uint64_t>& ids)
	{
		std::vector<std::int64_t> offsets(cells_ + 1);
		std::uint64_t first = 0;
		for (const Piece& piece : pieces_)
		{
			addIds(file_, listOf(piece, "offsets"), piece.cells, tasks_,
			       [&offsets, first](std::uint64_t begin, auto ends)
			       { std::copy(ends.begin(), ends.end(), offsets.data() + first + begin + 1); });
			first += piece.cells;
		}
		tasks_.run();
		first = 0;
		std::int64_t behind = 0;
		for (std::size_t p = 0; p < pieces_.size(); ++p)
		{
			std::int64_t last = 0;
			for (std::uint64_t c = first; c < first + pieces_[p].cells; ++c)
			{
				const std::int64_t end = offsets[c + 1];
				const int wanted = read::slicedCellSize(types_[c]);
				// With this limit, the list of any further cell still fits into the type.
				if (end < last || end >= std::int64_t(1) << 60 || (wanted > 0 && end - last != wanted))
					throw arrays::NotQuick();
				last = end;
				offsets[c + 1] = behind + end;
			}
			ids[p] = static_cast<std::uint64_t>(last);
			behind += last;
			first += pieces_[p].cells;
		}
		result_.lists["offsets"] = arrays::writeInt64(writer_, std::span<const std::int64_t>(offsets));
	}

	void readIds(const std::vector<std::uint64_t>& ids)
	{
		std::uint64_t total = 0;
		for (const std::uint64_t piece : ids)
			total += piece;
		if (total >= std::uint64_t(1) << 60)
			throw arrays::NotQuick();
		const std::size_t at = writer_.reserve(total * sizeof(std::int32_t));
		std::uint64_t first = 0;
		std::int64_t first_point = 0;
		for (std::size_t p = 0; p < pieces_.size(); ++p)
		{
			addIds(file_, listOf(pieces_[p], "connectivity"), ids[p], tasks_,
			       [&writer = writer_, place = at + first * sizeof(std::int32_t), first_point](std::uint64_t begin,
			                                                                                   auto given)
			       {
				       thread_local std::vector<std::int32_t> narrow;
				       narrow.resize(given.size());
				       std::uint64_t high = 0;
				       std::int32_t* to = narrow.data();
				       for (std::size_t i = 0; i < given.size(); ++i)
				       {
					       // The id is unsigned, so that the sum cannot overflow.
					       const std::uint64_t id =
					           static_cast<std::uint64_t>(given[i]) + static_cast<std::uint64_t>(first_point);
					       high |= id;
					       to[i] = static_cast<std::int32_t>(id);
				       }
				       if (high >= kNarrowPoints)
					       throw arrays::NotQuick();
				       writer.put(place + begin * sizeof(std::int32_t), to, given.size() * sizeof(std::int32_t));
			       });
			first += ids[p];
			first_point += static_cast<std::int64_t>(pieces_[p].points);
		}
		result_.lists["connectivity"] = arrays::Writer::describe(NumberType::int32, at, total * sizeof(std::int32_t));
	}

	const File& file_;
	const std::vector<Piece>& pieces_;
	arrays::Writer& writer_;
	Tasks& tasks_;
	std::uint64_t points_ = 0;
	std::uint64_t cells_ = 0;
	std::vector<std::uint8_t> types_;
	std::array<std::size_t, 256> kinds_{};
	Cells result_;
};

} // namespace

Cells readCells(const File& file, const std::vector<Piece>& pieces, arrays::Writer& writer, Tasks& tasks)
{
	return CellReader(file, pieces, writer, tasks).read();
}

void copyArray(const File& file, const text::XmlElement& array, const ByteRange& range, arrays::Writer& writer,
               std::size_t at, Tasks& tasks)
{
	const std::uint64_t first = range.first;
	const std::uint64_t behind = first + range.count;
	const auto packed = file.open(array, range.all);
	const std::size_t part_bytes = packed->partBytes();
	const std::size_t first_part = first / part_bytes;
	tasks.add((behind + part_bytes - 1) / part_bytes - first_part,
	          [=, &writer](std::size_t part, arrays::Scratch& scratch)
	          {
		          const std::uint64_t begin = std::uint64_t(first_part + part) * part_bytes;
		          const std::uint64_t skipped = begin < first ? first - begin : 0;
		          const auto given = packed->part(first_part + part, behind - begin, scratch).subspan(skipped);
		          writer.put(at + (begin + skipped - first), given.data(), given.size());
	          });
}

} // namespace vp::reader::quick
