#include "read/geometry.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <vector>

namespace vp::read
{

namespace
{

constexpr std::size_t kChunkBytes = 1 << 20;

// Multiplies and folds eight bytes at a time, four in step.
class Mixer
{
public:
	void add(std::uint64_t word)
	{
		std::uint64_t& lane = lanes_[next_++ & 3];
		lane = mixed(lane, word);
	}
	void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
	void add(const Vec3& v)
	{
		for (int axis = 0; axis < 3; ++axis)
			add(v[axis]);
	}
	// Chunks on all cores, then what they came to.
	template <class T>
	void add(const T* numbers, std::size_t count)
	{
		add(std::uint64_t(count));
		const std::span<const std::byte> bytes = std::as_bytes(std::span(numbers, count));
		std::vector<std::uint64_t> values((bytes.size() + kChunkBytes - 1) / kChunkBytes);
		tracedFor(std::size_t(0), values.size(),
		          [&](std::size_t chunk)
		          {
			          const auto rest = bytes.subspan(chunk * kChunkBytes);
			          values[chunk] = valueOf(rest.first(std::min(rest.size(), kChunkBytes)));
		          });
		for (const std::uint64_t value : values)
			add(value);
	}
	template <class T>
	void add(const Array<T>& array)
	{
		add(array.data(), array.size());
	}
	void add(const grid::Points& points)
	{
		if (points.isDouble())
			add(points.doubles(), 3 * points.size());
		else
			add(points.floats(), 3 * points.size());
	}
	std::uint64_t value()
	{
		for (const std::uint64_t lane : lanes_)
			lanes_[0] = std::rotl(lanes_[0] ^ lane, 31) * 0x94D049BB133111EBull;
		return lanes_[0] ? lanes_[0] : 1;
	}

private:
	static std::uint64_t mixed(std::uint64_t lane, std::uint64_t word)
	{
		return std::rotl((lane ^ word) * 0x9E3779B97F4A7C15ull, 29) * 0xBF58476D1CE4E5B9ull;
	}
	static std::uint64_t valueOf(std::span<const std::byte> bytes)
	{
		Mixer mixer;
		std::array<std::uint64_t, 4> words;
		for (; bytes.size() >= sizeof words; bytes = bytes.subspan(sizeof words))
		{
			std::memcpy(words.data(), bytes.data(), sizeof words);
			for (int lane = 0; lane < 4; ++lane)
				mixer.lanes_[lane] = mixed(mixer.lanes_[lane], words[lane]);
		}
		words = {};
		std::copy(bytes.begin(), bytes.end(), std::as_writable_bytes(std::span(words)).begin());
		for (const std::uint64_t word : words)
			mixer.add(word);
		return mixer.value();
	}

	std::uint64_t lanes_[4] = {1, 2, 3, 4};
	std::size_t next_ = 0;
};

void addMesh(Mixer& mixer, const CellMesh& mesh)
{
	mixer.add(mesh.points);
	mixer.add(mesh.cells.types);
	mesh.cells.connectivity.as([&](auto ids) { mixer.add(ids.data(), ids.size()); });
	for (const Array<std::int64_t>* array :
	     {&mesh.cells.offsets, &mesh.cells.face_offsets, &mesh.cells.face_stream, &mesh.cells.source_cells})
		mixer.add(*array);
	mixer.add(std::uint64_t(mesh.cells.source_points));
}

void addMesh(Mixer& mixer, const grid::CurvilinearGrid& grid)
{
	mixer.add(grid.coordinates());
}

// Few numbers: the places of the points along each axis.
template <class LatticeGrid>
void addMesh(Mixer& mixer, const LatticeGrid& grid)
{
	const auto points = grid.points();
	for (int axis = 0; axis < 3; ++axis)
		for (std::uint32_t i = 0; i < points[axis]; ++i)
		{
			std::array<std::uint32_t, 3> at{0, 0, 0};
			at[static_cast<std::size_t>(axis)] = i;
			mixer.add(grid.point(grid.pointId(at[0], at[1], at[2])));
		}
}

} // namespace

std::uint64_t geometryOf(const CheckedBlock& block)
{
	Mixer mixer;
	mixer.add(std::uint64_t(block.mesh.index()));
	std::visit(
	    [&](const auto& mesh)
	    {
		    if constexpr (!std::is_same_v<std::decay_t<decltype(mesh)>, CellMesh>)
			    for (const std::uint32_t points : mesh.points())
				    mixer.add(std::uint64_t(points));
		    addMesh(mixer, mesh);
	    },
	    block.mesh);
	return mixer.value();
}

} // namespace vp::read
