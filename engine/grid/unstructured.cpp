#include "grid/unstructured.h"

namespace vp::grid
{

int UnstructuredGrid::faceCount(CellId c) const
{
	if (!isPolyhedron(c))
		return topology(shape(c)).faces;
	if (list_)
		return static_cast<int>(list_->faceCount(c));
	const std::uint32_t number = record(c)[0];
	return static_cast<int>(polyhedron_faces_[number + 1] - polyhedron_faces_[number]);
}

void UnstructuredGrid::cellFaces(CellId c, CellFaces& faces) const
{
	faces.clear();
	if (!isPolyhedron(c))
		return shapeFaces(shape(c), cellPoints(c), faces);
	if (list_)
	{
		std::vector<PointId> ids;
		return list_->forEachFace(c,
		                          [&](std::span<const std::int64_t> face)
		                          {
			                          ids.assign(face.begin(), face.end());
			                          faces.add(ids);
		                          });
	}
	const std::uint32_t number = record(c)[0];
	for (std::uint32_t f = polyhedron_faces_[number]; f < polyhedron_faces_[number + 1]; ++f)
		faces.add({face_points_.data() + face_points_start_[f], face_points_start_[f + 1] - face_points_start_[f]});
}

std::size_t UnstructuredGrid::geometryBytes() const
{
	return points_.bytes() + (list_ ? list_->bytes() : 0) +
	       4 * (cell_count_ * std::size_t(width_) + polyhedron_faces_.capacity() + face_points_start_.capacity() +
	            face_points_.capacity());
}

std::size_t UnstructuredGrid::adjacencyBytes() const
{
	std::size_t sum = 4 * (cell_count_ * std::size_t(face_width_) + polyhedron_neighbors_.capacity() +
	                       source_points_.capacity() + source_cells_.capacity());
	for (const std::vector<CellId>& cells : several_)
		sum += sizeof(cells) + 4 * cells.capacity();
	return sum;
}

} // namespace vp::grid
