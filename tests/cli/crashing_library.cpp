// Preloaded, it stands in for any other library: libcrashing_library.so crashes where a flat picture begins.
extern "C" __attribute__((visibility("default"))) void* cairo_image_surface_create(int, int, int)
{
	volatile int* nowhere = nullptr;
	*nowhere = 1;
	return nullptr;
}
