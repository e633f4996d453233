#include "shared_faces.h"

#include "base/ids.h"
#include "read/cell_types.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/cell_lists.h"
#include "vprobe-read/quick/quick_file.h"
#include "vprobe-read/text/text_cursor.h"

#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace vp::reader::vtk
{

using grid::NumberType;

namespace
{

// A face lies between two cells at the most, so that lists of faces which name one more often are not of a mesh.
constexpr std::size_t kMaxUsesOfFace = 16;

const text::XmlElement* childNamed(const text::XmlElement& parent, std::string_view name)
{
	const auto found = std::ranges::find(parent.children, name, &text::XmlElement::name);
	return found == parent.children.end() ? nullptr : &*found;
}

const text::XmlElement* listNamed(const text::XmlElement& piece, std::string_view name)
{
	const text::XmlElement* cells = childNamed(piece, "Cells");
	if (!cells)
		return nullptr;
	const auto found =
	    std::ranges::find_if(cells->children, [&](const text::XmlElement& e) { return e.attribute("Name") == name; });
	return found == cells->children.end() ? nullptr : &*found;
}

std::uint64_t countIn(const text::XmlElement& piece, std::string_view name)
{
	const std::int64_t count = text::Cursor(piece.attribute(name)).integer();
	if (count < 0)
		throw damaged("a piece of a negative size");
	return static_cast<std::uint64_t>(count);
}

// Reads the lists of one file.
class SharedFaceReader
{
public:
	explicit SharedFaceReader(const std::string& path)
	    : path_(path), mapped_(path), xml_(text::parseXml(mapped_.text()))
	{
	}

	std::vector<SharedFaces> pieces()
	{
		std::vector<SharedFaces> pieces;
		const text::XmlElement* data = xml_ ? childNamed(xml_->root, "UnstructuredGrid") : nullptr;
		if (!data)
			return pieces;
		for (const text::XmlElement& element : data->children)
			if (element.name == "Piece")
				pieces.push_back(pieceOf(element));
		return pieces;
	}

private:
	SharedFaces pieceOf(const text::XmlElement& element)
	{
		SharedFaces piece;
		piece.points = countIn(element, "NumberOfPoints");
		piece.cells = countIn(element, "NumberOfCells");
		const text::XmlElement* face_ends = listNamed(element, "polyhedron_offsets");
		const text::XmlElement* faces = listNamed(element, "polyhedron_to_faces");
		const text::XmlElement* corner_ends = listNamed(element, "face_offsets");
		const text::XmlElement* corners = listNamed(element, "face_connectivity");
		piece.has_lists = face_ends && faces && corner_ends && corners;
		if (!piece.has_lists)
			return piece;
		piece.face_ends = numbers(*face_ends, piece.cells);
		piece.faces = numbers(*faces, lastOf(piece.face_ends));
		std::int64_t count = 0;
		for (const std::int64_t face : piece.faces)
		{
			if (face < 0)
				throw damaged("a polyhedron with a face of a negative number");
			count = std::max(count, face + 1);
		}
		piece.corner_ends = numbers(*corner_ends, static_cast<std::uint64_t>(count));
		piece.corners = numbers(*corners, lastOf(piece.corner_ends));
		return piece;
	}

	static std::uint64_t lastOf(const std::vector<std::int64_t>& ends)
	{
		std::int64_t last = 0;
		for (const std::int64_t end : ends)
		{
			if (end < last)
				throw damaged("the offsets of its polyhedra do not rise");
			last = end;
		}
		return static_cast<std::uint64_t>(last);
	}

	// The first ones of a list, which may be longer.
	std::vector<std::int64_t> numbers(const text::XmlElement& array, std::uint64_t count)
	{
		if (array.attribute("format") == "ascii")
			return numbersOfText(array, count);
		try
		{
			if (!file_)
				file_.emplace(path_);
			const NumberType type = quick::ArrayKind(array).type;
			if (type == NumberType::int32 || type == NumberType::uint32)
				return numbersOf<std::int32_t>(array, count);
			if (type == NumberType::int64 || type == NumberType::uint64)
				return numbersOf<std::int64_t>(array, count);
		}
		catch (const arrays::NotQuick&)
		{
		}
		throw damaged(fmt::format("the list {} of its polyhedra cannot be read", array.attribute("Name")));
	}

	std::vector<std::int64_t> numbersOfText(const text::XmlElement& array, std::uint64_t count) const
	{
		std::string_view text = mapped_.text().substr(array.content_begin, array.content_end - array.content_begin);
		text = text.substr(0, text.find('<')); // keys stand behind the numbers
		text::Cursor at(text);
		at.checkedCount(static_cast<std::int64_t>(std::min<std::uint64_t>(count, kMaxBlockIds * 64ull)), 2);
		std::vector<std::int64_t> numbers(count);
		for (std::int64_t& number : numbers)
			number = at.integer();
		return numbers;
	}

	template <class T>
	std::vector<std::int64_t> numbersOf(const text::XmlElement& array, std::uint64_t count)
	{
		if (count > ~std::uint64_t(0) / sizeof(T))
			throw arrays::NotQuick();
		const std::uint64_t bytes = count * sizeof(T);
		const auto packed = file_->open(array, bytes); // which has so many
		if (packed->partBytes() % sizeof(T) != 0)
			throw arrays::NotQuick();
		std::vector<std::int64_t> numbers;
		numbers.reserve(count);
		arrays::Scratch scratch;
		for (std::uint64_t begin = 0; begin < bytes; begin += packed->partBytes())
		{
			const auto part = packed->part(begin / packed->partBytes(), bytes - begin, scratch);
			for (std::size_t at = 0; at + sizeof(T) <= part.size(); at += sizeof(T))
				numbers.push_back(numberAt<T>(part.data() + at));
		}
		if (numbers.size() != count)
			throw arrays::NotQuick();
		return numbers;
	}

	std::string path_;
	MappedText mapped_;
	std::optional<text::XmlFile> xml_;
	std::optional<quick::File> file_;
};

// The faces of all cells in VTK's form: per polyhedron their number, then each with its size and its points.
class FaceStream
{
public:
	explicit FaceStream(vtkUnstructuredGrid* grid) : grid_(grid) {}

	void add(const SharedFaces& piece)
	{
		if (piece.cells > static_cast<std::uint64_t>(grid_->GetNumberOfCells() - cell_))
			throw damaged("its polyhedra do not match its cells");
		refuseBadEnds(piece.face_ends, piece.faces.size());
		refuseBadEnds(piece.corner_ends, piece.corners.size());
		if (piece.has_lists && piece.face_ends.size() != piece.cells)
			throw damaged("its polyhedra do not match its cells");
		const std::size_t most =
		    stream_.size() + piece.cells +
		    kMaxUsesOfFace * (piece.corners.size() + piece.corner_ends.size() + piece.faces.size());
		for (std::uint64_t c = 0; c < piece.cells; ++c, ++cell_)
		{
			locations_.push_back(-1);
			if (grid_->GetCellType(cell_) != read::kPolyhedron)
				continue;
			locations_.back() = static_cast<vtkIdType>(stream_.size());
			if (piece.has_lists)
				addCell(piece, c, most);
			else
			{
				const auto faces = cells::polyhedronFaces(grid_, cell_);
				stream_.insert(stream_.end(), faces.begin(), faces.end());
			}
		}
		point_ += static_cast<vtkIdType>(piece.points);
	}

	void setFaces()
	{
		if (cell_ != grid_->GetNumberOfCells())
			throw damaged("its polyhedra do not match its cells");
		vtkNew<vtkIdTypeArray> locations, faces;
		const auto fill = [](vtkIdTypeArray* array, const std::vector<vtkIdType>& numbers)
		{
			array->SetNumberOfValues(static_cast<vtkIdType>(numbers.size()));
			std::ranges::copy(numbers, array->GetPointer(0));
		};
		fill(locations, locations_);
		fill(faces, stream_);
		grid_->SetCells(grid_->GetCellTypesArray(), grid_->GetCells(), locations, faces);
	}

private:
	static void refuseBadEnds(const std::vector<std::int64_t>& ends, std::size_t size)
	{
		std::int64_t last = 0;
		for (const std::int64_t end : ends)
			if (end < std::exchange(last, end) || static_cast<std::uint64_t>(end) > size)
				throw damaged("the offsets of its polyhedra do not rise to their end");
	}
	void addCell(const SharedFaces& piece, std::uint64_t cell, std::size_t most)
	{
		const auto begin = static_cast<std::size_t>(cell == 0 ? 0 : piece.face_ends[cell - 1]);
		const auto end = static_cast<std::size_t>(piece.face_ends[cell]);
		stream_.push_back(static_cast<vtkIdType>(end - begin));
		for (std::size_t f = begin; f < end; ++f)
		{
			const auto face = static_cast<std::size_t>(piece.faces[f]);
			if (face >= piece.corner_ends.size())
				throw damaged("a polyhedron has a face that is not there");
			const auto first = static_cast<std::size_t>(face == 0 ? 0 : piece.corner_ends[face - 1]);
			const auto behind = static_cast<std::size_t>(piece.corner_ends[face]);
			if (stream_.size() + (behind - first) > most)
				throw damaged("its polyhedra name the same faces over and over");
			stream_.push_back(static_cast<vtkIdType>(behind - first));
			for (std::size_t i = first; i < behind; ++i)
			{
				const std::int64_t corner = piece.corners[i];
				if (corner < 0 || static_cast<std::uint64_t>(corner) >= piece.points)
					throw damaged("a face of its polyhedra has a point that is not there");
				stream_.push_back(point_ + corner);
			}
		}
	}

	vtkUnstructuredGrid* grid_;
	std::vector<vtkIdType> stream_;
	std::vector<vtkIdType> locations_;
	vtkIdType cell_ = 0;
	vtkIdType point_ = 0;
};

} // namespace

void setSharedFaces(const std::vector<SharedFaces>& pieces, vtkUnstructuredGrid* grid)
{
	FaceStream stream(grid);
	for (const SharedFaces& piece : pieces)
		stream.add(piece);
	stream.setFaces();
}

void addSharedFaces(const std::vector<std::string>& files, vtkUnstructuredGrid* grid)
{
	const auto* types = grid->GetCellTypesArray();
	const auto is_polyhedron = [&](vtkIdType cell) { return grid->GetCellType(cell) == read::kPolyhedron; };
	vtkIdType first = 0;
	while (types && first < grid->GetNumberOfCells() && !is_polyhedron(first))
		++first;
	if (!types || first == grid->GetNumberOfCells())
		return;
	std::vector<SharedFaces> pieces;
	for (const std::string& file : files)
		std::ranges::move(SharedFaceReader(file).pieces(), std::back_inserter(pieces));
	if (std::ranges::any_of(pieces, &SharedFaces::has_lists))
		setSharedFaces(pieces, grid);
}

} // namespace vp::reader::vtk
