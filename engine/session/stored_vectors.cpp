#include "session/stored_vectors.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::session
{

namespace
{

// Moves the array out of the fields. If it is not there, returns a field without components, as vectors::vectorsOf()
// does.
grid::Field pick(std::vector<grid::Field>& fields, const grid::FieldChoice& array)
{
	for (grid::Field& field : fields)
		if (field.name == array.name && field.association == array.association)
			return std::move(field);
	grid::Field none;
	none.components = 0;
	return none;
}

} // namespace

Result<vectors::StoredVectors> storedVectors(const Session& session, const grid::FieldChoice& array)
{
	const view::ViewSpec& spec = session.spec();
	const std::string input = spec.input.files.front();
	if (session.blocks().times.size() < 2)
		return Error{ErrorKind::input,
		             fmt::format("{}: has no several times for `path_lines`; leave the setting out", input)};
	vectors::StoredVectors stored{session.blocks().times, {}};
	stored.times.erase(std::unique(stored.times.begin(), stored.times.end()), stored.times.end()); // equal ones once
	stored.load = [spec, input, array, inputs = session.inputs(), times = stored.times, &blocks = session.blocks(),
	               timeline = session.timeline()](std::size_t index) -> Result<std::vector<grid::Field>>
	{
		const read::TimeChoice time{read::TimeChoice::Kind::value, times[index]};
		Result<std::optional<read::BlockFields>> read =
		    read::readFields(inputs, readOptions(spec, time), blocks, timeline);
		if (!read)
			return read.error();
		if (!*read)
			return Error{ErrorKind::input, fmt::format("{}: its grid moves with time, and `path_lines` needs one that "
			                                           "stays; leave the setting out",
			                                           input)};
		std::vector<grid::Field> fields;
		for (std::vector<grid::Field>& of_block : **read)
			fields.push_back(pick(of_block, array));
		return fields;
	};
	return stored;
}

} // namespace vp::session
