#pragma once

#include "interact/drag.h"
#include "interact/pick.h"
#include "viewer/document/document.h"

#include <glm/vec2.hpp>

#include <optional>
#include <variant>

namespace vp::app
{

// The part of the window that shows the scene, in pixels.
struct ScenePart
{
	glm::dvec2 lo{0.0};
	glm::dvec2 size{0.0};

	bool holds(const glm::dvec2& at) const
	{
		return at.x >= lo.x && at.y >= lo.y && at.x < lo.x + size.x && at.y < lo.y + size.y;
	}
};

enum class Button
{
	left,
	right,
	middle
};

// What the mouse does in the scene. On a handle, or on a sheet: it is moved, turned or sized. Elsewhere, and with the
// other buttons: the camera. Positions are the window's.
class PointerController
{
public:
	explicit PointerController(Document& document) : document_(document) {}

	void place(const ScenePart& part, double ui_scale)
	{
		part_ = part;
		ui_scale_ = ui_scale;
	}

	void moveTo(const glm::dvec2& at);
	// within: nothing of the user interface lies there.
	void press(Button button, bool within);
	void release(Button button);
	void wheel(double amount, bool within);
	void setKeys(const interact::Modifiers& keys) { keys_ = keys; }

	bool isBusy() const { return !std::holds_alternative<std::monostate>(grip_); }
	// What is under the pointer, by the picture that is shown.
	const std::optional<interact::Handle>& handle() const { return handle_; }
	const std::optional<interact::SheetHit>& sheet() const { return sheet_; }
	glm::dvec2 at() const { return at_; }
	const ScenePart& part() const { return part_; }
	bool isInScene() const { return part_.holds(at_); }
	glm::dvec2 inScene() const { return at_ - part_.lo; } // the pointer, in the scene's pixels
	std::vector<interact::HandleShape> shapes() const;    // as they are to be drawn, in the world

private:
	struct CameraGrip
	{
		interact::View start;
		glm::dvec2 from;
		bool pans;
		Vec3 pivot;
	};
	struct LensGrip // what the magnifier shows is moved
	{
		probe::Probe start;
		interact::View view;
		std::size_t sheet;
		glm::dvec2 from; // in the sheet
	};
	using DragState = std::variant<std::monostate, interact::Drag, CameraGrip, LensGrip>;

	void look();
	void drag();
	void takeSheet();
	interact::Modifiers keysFor(const interact::Drag& drag) const;
	std::optional<interact::SheetHit> sheetAt(const glm::dvec2& pixel) const;

	Document& document_;
	ScenePart part_;
	double ui_scale_ = 1.0;
	glm::dvec2 at_{-1.0};
	interact::Modifiers keys_;
	DragState grip_;
	std::optional<Button> held_;
	std::optional<interact::Handle> handle_;
	std::optional<interact::SheetHit> sheet_;
};

} // namespace vp::app
