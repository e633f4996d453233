#include "arrays.h"

#include "work.h"

#include <array>

namespace binding
{

namespace
{

using vprobe::NumberType;

constexpr std::array kNames{"int8",   "uint8", "int16",  "uint16",  "int32",
                            "uint32", "int64", "uint64", "float32", "float64"};

[[noreturn]] void refuse(const std::string& what, const std::string& why)
{
	raise({vprobe::ErrorKind::input, what + ": " + why});
}

NumberType typeOf(const py::array& array, const std::string& what)
{
	const py::dtype type = array.dtype();
	const char byte_order = type.byteorder();
	const auto words = py::str(static_cast<const py::object&>(type)).cast<std::string>();
	if (byte_order == '>')
		refuse(what, words + " has another byte order than this machine; use copy=True, or array.astype()");
	const bool is_float = type.kind() == 'f' && type.itemsize() >= 4 && type.itemsize() <= 8;
	const bool is_integer = type.kind() == 'i' || type.kind() == 'u';
	if (!is_float && !is_integer)
		refuse(what, words + " is no type that can be used; convert it with array.astype('float32') or another of "
		                     "float32, float64, and integers of 8 to 64 bits");
	if (is_float)
		return type.itemsize() == 4 ? NumberType::float32 : NumberType::float64;
	const int size = type.itemsize() == 1 ? 0 : type.itemsize() == 2 ? 1 : type.itemsize() == 4 ? 2 : 3;
	return static_cast<NumberType>(2 * size + (type.kind() == 'u' ? 1 : 0));
}

// Keeps a Python object alive. The library may let go of it in any thread.
std::shared_ptr<const void> ownerOf(const py::object& object)
{
	return {object.inc_ref().ptr(), [](const void* kept)
	        {
		        if (!Py_IsInitialized())
			        return;
		        const py::gil_scoped_acquire locked;
		        Py_DECREF(static_cast<PyObject*>(const_cast<void*>(kept)));
	        }};
}

} // namespace

vprobe::Numbers numbersOf(const py::handle& handle, const std::string& what)
{
	if (!py::isinstance<py::array>(handle))
		refuse(what, "is no numpy array");
	const auto array = py::reinterpret_borrow<py::array>(handle);
	const NumberType type = typeOf(array, what);
	if ((array.flags() & py::array::c_style) == 0)
		refuse(what, "its values do not lie side by side; use copy=True, or numpy.ascontiguousarray()");
	return {array.data(), static_cast<std::size_t>(array.size()), type, ownerOf(array)};
}

py::dtype dtypeOf(NumberType type)
{
	return py::dtype(std::string(kNames[static_cast<std::size_t>(type)]));
}

py::array viewOf(NumberType type, py::array::ShapeContainer shape, const void* data, const py::handle& owner)
{
	py::array view(dtypeOf(type), std::move(shape), {}, data, owner);
	py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
	return view;
}

} // namespace binding
