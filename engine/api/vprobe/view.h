#pragma once

#include <vprobe/result.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace vprobe
{

using Vector3 = std::array<double, 3>;

/// The built-in probes: sheets that move as one. Use read() for a probe of your own.
enum class ProbeShape : std::uint8_t
{
	single,      // one sheet
	trihedral,   // three at right angles
	paddlewheel, // vanes about the up axis
	stack        // parallel sheets
};

/// All settings of a cut and its picture: where the probe stands, what it shows, how it looks, how it is swept. A View
/// is a value: copies are independent. Settings that are not set have the defaults of the program's options.
///
/// The functions accept any value. check() reports impossible values, and so does every function that takes a View.
/// Every setting has a key: the name of its option, with _ for -; `vprobe manual --schema` describes all of them. Use
/// set() for settings without a function here. A View is not thread safe, but several threads may read one.
class VPROBE_API View
{
public:
	View();
	View(const View& other);
	View(View&& other) noexcept;
	View& operator=(const View& other);
	View& operator=(View&& other) noexcept;
	~View();

	// Where the probe stands.
	View& shape(ProbeShape shape);
	View& origin(const Vector3& place);                  // place of the hot spot; default: the center of the bounds
	View& normal(const Vector3& normal);                 // not zero; default: z
	View& up(const Vector3& up);                         // not zero, made perpendicular to the normal; default: y
	View& window(double width, double height);           // along the sheets' x and y; default: the whole slice
	View& vanes(int count);                              // number of vanes of a paddlewheel, 1 to 64
	View& sheets(int count);                             // number of sheets of a stack, 1 to 64
	View& offsets(std::span<const double> along_normal); // places of a stack's sheets
	View& crinkle(bool whole_cells);                     // shows the cut cells whole

	// The values that it shows.
	View& array(std::string_view name);            // "[point:|cell:]NAME"; default: the first
	View& component(int component);                // from 0; -1 is the magnitude, the default
	View& threshold(double lo, double hi);         // the search ends at cells with values outside
	View& contour(std::span<const double> values); // surfaces that grow from the sheets

	// How the picture looks.
	View& size(std::uint32_t width, std::uint32_t height); // size of the picture in pixels
	View& colorMap(std::string_view name);
	View& range(double lo, double hi); // values at the two ends of the color map
	View& opacity(double share);       // 0 to 1

	/// Sets any setting by its key, with a value as on a command line: set("surface", "sphere:1.5"), set("camera",
	/// "30,20"). Several numbers are separated by blanks. A usage error names the key and the values that it takes.
	Status set(std::string_view key, std::string_view value);
	/// Takes the settings in a state. The others stay. An input error names the place in the document.
	Status read(std::string_view state);
	/// Returns a state file, which the program's --state takes too. It leaves out settings of the machine.
	std::string json() const;

	/// Returns a usage error if settings are impossible or do not go together.
	Status check() const;

	struct State;

private:
	friend struct DatasetState;
	friend class Cut;

	std::unique_ptr<State> state_;
};

} // namespace vprobe
