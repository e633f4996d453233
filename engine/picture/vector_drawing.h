#pragma once

#include "picture/sheet_looks.h"
#include "render/scene/scene.h"
#include "vectors/trace_mesh.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::picture
{

// Draws the particles that start on the sheets of a session. The session outlives it.
class VectorDrawing
{
public:
	explicit VectorDrawing(const session::Session& session) : session_(&session) {}

	// Call this when the values of the arrays have changed.
	void forget() { kept_.reset(); }

	// Returns all paths as one surface, or nothing. scale: of the array that the sheets show.
	Result<std::optional<render::Surface>> surface(const cut::Cut& slice,
	                                               const std::vector<session::SheetStats>& sheets,
	                                               const std::optional<render::ValueScale>& scale, SheetLooks& looks);

private:
	using SharedTraces = std::vector<std::shared_ptr<const vectors::Traces>>;

	// The color of the particles: an array, or one color.
	struct Coloring
	{
		std::optional<grid::FieldChoice> field;
		render::Color color = render::kPlainColor;

		bool operator==(const Coloring&) const = default;
	};
	// Polygons of the last picture, and what they were made from.
	struct Kept
	{
		SharedTraces traces;
		Coloring coloring;
		std::optional<double> width;
		std::shared_ptr<const render::SurfacePolygons> polygons;
		bool has_nan = false;
	};

	Result<Coloring> coloringOf(const view::VectorLookSpec& look) const;
	std::vector<double> valuesOf(const Coloring& coloring, const vectors::Traces& traces) const;
	std::vector<double> turnsOf(const vectors::Traces& traces) const;
	void addTraces(const vectors::Traces& traces, const Vec3& normal, const Coloring& coloring, double width,
	               vectors::TraceMesh& made) const;
	Status make(Kept& kept, const cut::Cut& slice) const;

	const session::Session* session_;
	std::optional<Kept> kept_;
};

} // namespace vp::picture
