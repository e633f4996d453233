#include "api/border.h"
#include "api/states.h"
#include "view/settings.h"
#include "view/state_file.h"
#include "view/validate.h"

#include <vprobe/view.h>

namespace vprobe
{

namespace
{

vp::Vec3 vectorOf(const Vector3& v)
{
	return {v[0], v[1], v[2]};
}

} // namespace

View::View() : state_(std::make_unique<State>()) {}
View::View(const View& other) : state_(std::make_unique<State>(*other.state_)) {}
View::View(View&& other) noexcept = default;
View& View::operator=(const View& other)
{
	state_ = std::make_unique<State>(*other.state_);
	return *this;
}
View& View::operator=(View&& other) noexcept = default;
View::~View() = default;

View& View::shape(ProbeShape shape)
{
	state_->spec.probe.shape = static_cast<vp::view::ProbeShape>(shape);
	state_->spec.probe.own.reset();
	return *this;
}

View& View::origin(const Vector3& place)
{
	state_->spec.probe.origin = vectorOf(place);
	return *this;
}

View& View::normal(const Vector3& normal)
{
	state_->spec.probe.normal = vectorOf(normal);
	return *this;
}

View& View::up(const Vector3& up)
{
	state_->spec.probe.up = vectorOf(up);
	return *this;
}

View& View::window(double width, double height)
{
	state_->spec.probe.window = vp::probe::WindowSize{width, height};
	return *this;
}

View& View::vanes(int count)
{
	state_->spec.probe.vanes = count;
	return *this;
}

View& View::sheets(int count)
{
	state_->spec.probe.sheets = count;
	return *this;
}

View& View::offsets(std::span<const double> along_normal)
{
	state_->spec.probe.offsets.assign(along_normal.begin(), along_normal.end());
	return *this;
}

View& View::crinkle(bool whole_cells)
{
	state_->spec.probe.crinkle = whole_cells;
	return *this;
}

View& View::array(std::string_view name)
{
	state_->spec.probe.array = name;
	return *this;
}

View& View::component(int component)
{
	state_->spec.probe.component = component;
	return *this;
}

View& View::threshold(double lo, double hi)
{
	state_->spec.probe.threshold = vp::find::Threshold{lo, hi};
	return *this;
}

View& View::contour(std::span<const double> values)
{
	state_->spec.look.contour.values.assign(values.begin(), values.end());
	return *this;
}

View& View::size(std::uint32_t width, std::uint32_t height)
{
	state_->spec.look.size = {width, height};
	return *this;
}

View& View::colorMap(std::string_view name)
{
	state_->spec.look.colormap = name;
	return *this;
}

View& View::range(double lo, double hi)
{
	state_->spec.look.range = std::pair{lo, hi};
	return *this;
}

View& View::opacity(double share)
{
	state_->spec.look.opacity = share;
	return *this;
}

Status View::set(std::string_view key, std::string_view value)
{
	return guarded([&] { return publicStatus(vp::view::setByKey(state_->spec, key, std::string(value))); });
}

Status View::read(std::string_view state)
{
	return guarded([&] { return publicStatus(vp::view::readState(state_->spec, state, "state.json")); });
}

std::string View::json() const
{
	return vp::view::stateText(state_->spec, "state.json");
}

Status View::check() const
{
	return guarded([&] { return publicStatus(vp::view::validate(state_->spec)); });
}

} // namespace vprobe
