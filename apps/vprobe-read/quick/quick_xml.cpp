#include "quick_xml.h"

#include "base/ids.h"
#include "quick_cells.h"
#include "quick_file.h"
#include "quick_lattice.h"
#include "tasks.h"
#include "vprobe-read/arrays/stored_place.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/is_one_of.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace vp::reader::quick
{

using grid::NumberType;
using nlohmann::json;

namespace
{

class QuickReader
{
public:
	QuickReader(const std::string& path, const ArrayWish& wish, int threads, arrays::Writer& arrays,
	            arrays::Writer& cells, const std::optional<CellLayers>& layers, std::uint64_t stays_above)
	    : path_(path), file_(path), wish_(wish), tasks_(threads), arrays_(arrays), cells_(cells), layers_(layers),
	      stays_above_(layers ? ~std::uint64_t(0) : stays_above)
	{
	}

	Block read()
	{
		const text::XmlElement& data = file_.data();
		for (const text::XmlElement& child : data.children)
			if (child.name == "FieldData")
				readTime(child);
			else if (child.name != "Piece")
				throw arrays::NotQuick();
		if (file_.type() == "UnstructuredGrid")
			readUnstructured(data);
		else
			readLattice(data);
		addArrays("point", "PointData");
		addArrays("cell", "CellData");
		tasks_.run();
		block_.block["arrays"] = std::move(described_);
		for (json& left_out : left_out_)
			block_.block["arrays"].push_back(std::move(left_out));
		return std::move(block_);
	}

private:
	static void allowAttributes(const text::XmlElement& element, std::initializer_list<std::string_view> allowed)
	{
		for (const auto& [key, value] : element.attributes)
			if (std::find(allowed.begin(), allowed.end(), key) == allowed.end())
				throw arrays::NotQuick(); // times among them
	}
	static void allowChildren(const text::XmlElement& element, std::initializer_list<std::string_view> allowed)
	{
		std::set<std::string_view> seen;
		for (const text::XmlElement& child : element.children)
			if (std::find(allowed.begin(), allowed.end(), child.name) == allowed.end() ||
			    !seen.insert(child.name).second)
				throw arrays::NotQuick();
	}

	// Reads the time, which is all that VTK's readers take from field data.
	void readTime(const text::XmlElement& field_data)
	{
		for (const text::XmlElement& array : field_data.children)
		{
			const std::string_view name = array.attribute("Name");
			if (!name.starts_with("TimeValue"))
				continue;
			const ArrayKind kind(array);
			if (name != "TimeValue" || array.attribute("NumberOfTuples") != "1" || kind.type != NumberType::float64 ||
			    kind.components != 1 || !block_.times.empty())
				throw arrays::NotQuick();
			double time = 0.0;
			if (array.attribute("format") == "ascii")
				time = numbersIn<double, 1>(array.text)[0];
			else
			{
				arrays::Scratch scratch;
				const auto packed = file_.open(array, sizeof time);
				time = numberAt<double>(packed->part(0, sizeof time, scratch).data());
			}
			block_.times.push_back(time);
		}
	}

	void readUnstructured(const text::XmlElement& data)
	{
		allowAttributes(data, {});
		for (const text::XmlElement& piece : data.children)
		{
			if (piece.name != "Piece")
				continue;
			allowAttributes(piece, {"NumberOfPoints", "NumberOfCells"});
			allowChildren(piece, {"PointData", "CellData", "Points", "Cells"});
			pieces_.push_back({&piece, numbersIn<std::uint64_t, 1>(piece.attribute("NumberOfPoints"))[0],
			                   numbersIn<std::uint64_t, 1>(piece.attribute("NumberOfCells"))[0]});
			// Such sums stay far from overflow.
			if (pieces_.back().points == 0 || pieces_.back().points >= kMaxBlockIds || pieces_.back().cells == 0 ||
			    pieces_.back().cells >= kMaxBlockIds)
				throw arrays::NotQuick();
		}
		if (pieces_.empty())
			throw arrays::NotQuick();
		Cells cells = readCells(file_, pieces_, cells_, tasks_);
		block_.flat = cells.flat;
		block_.block = {{"kind", "unstructured"}, {"coordinates", copyPoints(cells_)}};
		block_.block["cells"] = std::move(cells.lists);
	}

	void readLattice(const text::XmlElement& data)
	{
		allowAttributes(data, {"WholeExtent", "Origin", "Spacing", "Direction"});
		const text::XmlElement& piece = onlyChild(data, "Piece");
		allowAttributes(piece, {"Extent"});
		allowChildren(piece, {"PointData", "CellData", "Points", "Coordinates"});
		const auto extent = numbersIn<std::int32_t, 6>(data.attribute("WholeExtent"));
		std::array<std::uint64_t, 3> points = latticePoints(data, piece);
		const CellLayers layers = layers_.value_or(CellLayers{0, points[2] - 1});
		if (layers.end >= points[2])
			throw arrays::NotQuick();
		first_plane_ = layers.begin;
		const std::uint64_t planes = points[2];
		points[2] = layers.count() + 1;
		const std::uint64_t plane = points[0] * points[1];
		const std::uint64_t layer = (points[0] - 1) * (points[1] - 1);
		pieces_ = {{&piece, plane * points[2], layer * layers.count(), plane * layers.begin, layer * layers.begin,
		            plane * planes, layer * (planes - 1)}};
		if (isOneOf(file_.type(), {"ImageData", "RectilinearGrid"}))
			lattice_ = points;
		if (file_.type() == "ImageData")
			describeImage(data, extent, points);
		else if (file_.type() == "RectilinearGrid")
			readAxes(piece, points);
		else if (file_.type() == "StructuredGrid")
			block_.block = {{"kind", "curvilinear"}, {"points", points}, {"coordinates", copyPoints(arrays_)}};
		else
			throw arrays::NotQuick();
	}

	void describeImage(const text::XmlElement& data, const std::array<std::int32_t, 6>& extent,
	                   const std::array<std::uint64_t, 3>& points)
	{
		const auto spacing = numbersIn<double, 3>(data.attribute("Spacing"));
		auto origin = numbersIn<double, 3>(data.attribute("Origin"));
		if (data.has("Direction") &&
		    numbersIn<double, 9>(data.attribute("Direction")) != std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1})
			throw arrays::NotQuick();
		for (std::size_t axis = 0; axis < 3; ++axis)
		{
			if (!std::isfinite(spacing[axis]) || !std::isfinite(origin[axis]))
				throw arrays::NotQuick();
			origin[axis] += extent[2 * axis] * spacing[axis];
		}
		block_.block = {{"kind", "image"}, {"points", points}, {"origin", origin}, {"spacing", spacing}};
		if (layers_)
			describeSlab(origin, spacing, points);
	}

	// Describes a slab as a rectilinear grid, so that its points have the places that they have in the whole image.
	void describeSlab(const std::array<double, 3>& origin, const std::array<double, 3>& spacing,
	                  const std::array<std::uint64_t, 3>& points)
	{
		json axes = json::array();
		for (std::size_t axis = 0; axis < 3; ++axis)
		{
			std::vector<double> places;
			for (std::uint64_t i = 0; i < points[axis]; ++i)
				places.push_back(origin[axis] +
				                 static_cast<std::uint32_t>(i + (axis == 2 ? first_plane_ : 0)) * spacing[axis]);
			axes.push_back(arrays_.write(NumberType::float64, places.data(), places.size() * sizeof(double)));
		}
		block_.block = {{"kind", "rectilinear"}, {"axes", std::move(axes)}};
	}

	// Reads the axes at once, since they are short.
	void readAxes(const text::XmlElement& piece, const std::array<std::uint64_t, 3>& points)
	{
		const text::XmlElement& coordinates = onlyChild(piece, "Coordinates");
		if (coordinates.children.size() != 3)
			throw arrays::NotQuick();
		json axes = json::array();
		for (std::size_t axis = 0; axis < 3; ++axis)
		{
			const text::XmlElement& array = coordinates.children[axis];
			const ArrayKind kind(array);
			if (kind.components != 1)
				throw arrays::NotQuick();
			const std::uint64_t first = axis == 2 ? first_plane_ : 0;
			const std::uint64_t all = axis == 2 ? pieces_[0].all_points / (points[0] * points[1]) : points[axis];
			if (kind.type == NumberType::float32)
				axes.push_back(copyAxis<float>(array, first, points[axis], all));
			else if (kind.type == NumberType::float64)
				axes.push_back(copyAxis<double>(array, first, points[axis], all));
			else
				throw arrays::NotQuick();
		}
		block_.block = {{"kind", "rectilinear"}, {"axes", std::move(axes)}};
	}

	template <class T>
	json copyAxis(const text::XmlElement& array, std::uint64_t first, std::uint64_t count, std::uint64_t all)
	{
		const std::uint64_t bytes = (first + count) * sizeof(T);
		const auto packed = file_.open(array, all * sizeof(T));
		if (packed->partBytes() % sizeof(T) != 0)
			throw arrays::NotQuick();
		arrays::Scratch scratch;
		arrays_.begin();
		for (std::uint64_t begin = 0; begin < bytes; begin += packed->partBytes())
		{
			const auto part = packed->part(begin / packed->partBytes(), bytes - begin, scratch);
			const std::span<const T> given(reinterpret_cast<const T*>(part.data()), part.size() / sizeof(T));
			const std::uint64_t left_out = first - std::min(first, begin / sizeof(T));
			const auto wanted = given.subspan(std::min<std::uint64_t>(left_out, given.size()));
			const std::vector<double> numbers(wanted.begin(), wanted.end());
			arrays_.append(numbers.data(), numbers.size() * sizeof(double));
		}
		return arrays_.end(NumberType::float64);
	}

	json copyPoints(arrays::Writer& writer)
	{
		std::vector<const text::XmlElement*> arrays;
		for (const Piece& piece : pieces_)
		{
			const text::XmlElement& points = onlyChild(*piece.element, "Points");
			if (points.children.size() != 1)
				throw arrays::NotQuick();
			arrays.push_back(&points.children[0]);
		}
		const ArrayKind kind(*arrays[0]);
		if (kind.components != 3 || (kind.type != NumberType::float32 && kind.type != NumberType::float64))
			throw arrays::NotQuick();
		return copyPieces(arrays, kind, &Piece::points, writer);
	}

	json copyPieces(const std::vector<const text::XmlElement*>& arrays, const ArrayKind& kind,
	                std::uint64_t Piece::*tuples, arrays::Writer& writer)
	{
		std::uint64_t total = 0;
		for (const Piece& piece : pieces_)
			total += piece.*tuples * kind.tupleBytes();
		const std::size_t at = writer.reserve(total);
		std::uint64_t first = 0;
		for (std::size_t p = 0; p < pieces_.size(); ++p)
		{
			if (ArrayKind(*arrays[p]) != kind)
				throw arrays::NotQuick();
			const std::uint64_t bytes = pieces_[p].*tuples * kind.tupleBytes();
			const bool is_point = tuples == &Piece::points;
			const auto before = is_point ? pieces_[p].first_point : pieces_[p].first_cell;
			const auto all = is_point ? pieces_[p].all_points : pieces_[p].all_cells;
			copyArray(file_, *arrays[p], {before * kind.tupleBytes(), bytes, all * kind.tupleBytes()}, writer,
			          at + first, tasks_);
			first += bytes;
		}
		return arrays::Writer::describe(kind.type, at, total);
	}

	// Returns the description of an array of a lattice that stays in the file, or null.
	json inFile(const text::XmlElement& array, const ArrayKind& kind, bool is_point)
	{
		if (lattice_[0] == 0)
			return {};
		std::array<std::uint64_t, 3> items = lattice_;
		for (std::uint64_t& count : items)
			count -= is_point ? 0 : 1;
		const std::uint64_t bytes = items[0] * items[1] * items[2] * kind.tupleBytes();
		const std::optional<std::uint64_t> begin =
		    bytes > stays_above_ ? file_.open(array, bytes)->placeInFile() : std::nullopt;
		if (!begin)
			return {};
		const arrays::StoredPlace place = arrays::storedRows(path_, *begin, items, kind.tupleBytes(), false);
		return {{"type", grid::numberTypeName(kind.type)}, {"stored", arrays::describeStored(place, arrays_)}};
	}

	static const std::vector<text::XmlElement>& arraysOf(const Piece& piece, std::string_view element)
	{
		static const std::vector<text::XmlElement> none;
		for (const text::XmlElement& child : piece.element->children)
			if (child.name == element)
				return child.children;
		return none;
	}

	// Takes the units. Ranges in the file are ignored, because they are computed anew.
	static std::string unitsOf(const text::XmlElement& array)
	{
		std::string units;
		for (const text::XmlElement& key : array.children)
		{
			const std::string_view name = key.attribute("name");
			if (key.name != "InformationKey" ||
			    !isOneOf(name, {"L2_NORM_RANGE", "L2_NORM_FINITE_RANGE", "UNITS_LABEL"}))
				throw arrays::NotQuick();
			if (name != "UNITS_LABEL")
				continue;
			units = key.text;
			const auto is_space = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
			if (key.attribute("location") != "vtkDataArray" || units.empty() || is_space(units.front()) ||
			    is_space(units.back()) || units.size() > 1000)
				throw arrays::NotQuick();
		}
		return units;
	}

	void addArrays(const char* association, std::string_view element)
	{
		const auto tuples = association[0] == 'p' ? &Piece::points : &Piece::cells;
		const std::vector<text::XmlElement>& first = arraysOf(pieces_[0], element);
		for (const Piece& piece : pieces_)
			if (arraysOf(piece, element).size() != first.size())
				throw arrays::NotQuick();
		std::set<std::string_view> names;
		for (std::size_t i = 0; i < first.size(); ++i)
		{
			const std::string name(first[i].attribute("Name"));
			// Files with ghost marks are left to VTK.
			if (!first[i].has("Name") || isOneOf(name, {"", "vtkGhostType", "vtkGhostLevels"}) ||
			    !names.insert(first[i].attribute("Name")).second)
				throw arrays::NotQuick();
			std::vector<const text::XmlElement*> arrays;
			for (const Piece& piece : pieces_)
			{
				arrays.push_back(&arraysOf(piece, element)[i]);
				if (arrays.back()->attribute("Name") != name)
					throw arrays::NotQuick();
			}
			const ArrayKind kind(first[i]);
			const bool is_shown = !has_shown_;
			has_shown_ = true;
			const bool wanted = wish_.wants(association, name, is_shown);
			json described;
			if (!wanted)
				described = {{"type", grid::numberTypeName(kind.type)}, {"left_out", true}};
			else if (described = inFile(first[i], kind, association[0] == 'p'); described.is_null())
				described = copyPieces(arrays, kind, tuples, arrays_);
			described["name"] = name;
			described["association"] = association;
			described["components"] = kind.components;
			if (const std::string units = unitsOf(first[i]); !units.empty())
				described["units"] = units;
			(wanted ? described_ : left_out_).push_back(std::move(described));
		}
	}

	const std::string path_;
	File file_;
	const ArrayWish& wish_;
	Tasks tasks_;
	arrays::Writer& arrays_;
	arrays::Writer& cells_;
	std::optional<CellLayers> layers_;
	std::uint64_t stays_above_;
	std::array<std::uint64_t, 3> lattice_{0, 0, 0}; // points of one with straight axes
	std::uint64_t first_plane_ = 0;
	std::vector<Piece> pieces_;
	Block block_;
	json described_ = json::array();
	json left_out_ = json::array();
	bool has_shown_ = false;
};

} // namespace

std::optional<Block> readQuickly(const std::string& file, const ArrayWish& wish, int threads, arrays::Writer& arrays,
                                 arrays::Writer& cells, const std::optional<CellLayers>& layers,
                                 std::uint64_t stays_above)
{
	const std::size_t arrays_mark = arrays.mark();
	const std::size_t cells_mark = cells.mark();
	try
	{
		return QuickReader(file, wish, threads, arrays, cells, layers, stays_above).read();
	}
	catch (const arrays::NotQuick&)
	{
		arrays.rewind(arrays_mark);
		cells.rewind(cells_mark);
		return std::nullopt;
	}
}

} // namespace vp::reader::quick
