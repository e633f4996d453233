// Preloaded, it stands in for any other library: libcrashing_library.so crashes where a PNG file begins.
extern "C" __attribute__((visibility("default"))) void* png_create_write_struct(const char*, void*, void*, void*)
{
	volatile int* nowhere = nullptr;
	*nowhere = 1;
	return nullptr;
}
