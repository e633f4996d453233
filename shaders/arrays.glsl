// Arrays that a shader only reads (gpu::ShaderArray): texels, or storage buffers where VP_STORAGE says so.
//   VP_ARRAY(binding, name);    declares an array of four words each
//   VP_NUMBERS(binding, name);  of floats
//   VP_WORDS(name, i)           element i, uvec4
//   VP_NUMBER(name, i)          float i
//   VP_FOUR(name, i)            floats 4 i to 4 i + 3
#ifdef VP_STORAGE
#define VP_ARRAY(place, name) layout(binding = place, scalar) readonly buffer Array_##name { uvec4 name[]; }
#define VP_NUMBERS(place, name) layout(binding = place, scalar) readonly buffer Array_##name { float name[]; }
#define VP_WORDS(name, i) name[i]
#define VP_NUMBER(name, i) name[i]
#define VP_FOUR(name, i) vec4(name[4u * (i)], name[4u * (i) + 1u], name[4u * (i) + 2u], name[4u * (i) + 3u])
#else
#define VP_ARRAY(place, name) layout(binding = place) uniform usamplerBuffer name
#define VP_NUMBERS(place, name) layout(binding = place) uniform samplerBuffer name
#define VP_WORDS(name, i) texelFetch(name, int(i))
#define VP_NUMBER(name, i) texelFetch(name, int(i)).x
#define VP_FOUR(name, i) texelFetch(name, int(i))
#endif
