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

// Handles the mouse in the scene. On a handle or a sheet, it moves, turns or sizes that. Elsewhere, and with the other
// buttons, it moves the camera. Positions are in the window.
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
	// within: no part of the user interface lies there.
	void press(Button button, bool within);
	void release(Button button);
	void wheel(double amount, bool within);
	void setKeys(const interact::Modifiers& keys) { keys_ = keys; }

	bool isBusy() const { return !std::holds_alternative<std::monostate>(grip_); }
	// These return what is under the pointer in the picture that is shown.
	const std::optional<interact::Handle>& handle() const { return handle_; }
	const std::optional<interact::SheetHit>& sheet() const { return sheet_; }
	glm::dvec2 at() const { return at_; }
	const ScenePart& part() const { return part_; }
	bool isInScene() const { return part_.holds(at_); }
	glm::dvec2 inScene() const { return at_ - part_.lo; } // position of the pointer, in pixels of the scene
	std::vector<interact::HandleShape> shapes() const;    // the shapes to draw, in world coordinates

private:
	struct CameraGrip
	{
		interact::View start;
		glm::dvec2 from;
		bool pans;
		Vec3 pivot;
	};
	struct LensGrip // a drag moves what the magnifier shows
	{
		probe::Probe start;
		interact::View view;
		std::size_t sheet;
		glm::dvec2 from; // place in the sheet
	};
	using DragState = std::variant<std::monostate, interact::Drag, CameraGrip, LensGrip>;

	void look();
	void drag();
	void noteLearned();
	void takeSheet();
	interact::Modifiers keysFor(const interact::Drag& drag) const;
	std::optional<interact::SheetHit> sheetAt(const glm::dvec2& pixel) const;

	Document& document_;
	ScenePart part_;
	double ui_scale_ = 1.0;
	glm::dvec2 at_{-1.0};
	interact::Modifiers keys_;
	DragState grip_;
	bool has_dragged_ = false; // since the button went down
	std::optional<Button> held_;
	std::optional<interact::Handle> handle_;
	std::optional<interact::SheetHit> sheet_;
};

} // namespace vp::app
