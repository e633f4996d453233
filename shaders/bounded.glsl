// Arithmetic in float with a bound on the error of each value: running error analysis (Higham, Accuracy and Stability of
// Numerical Algorithms, 2002, section 3.3). `error` bounds |value - v|, where v is what the CPU computes in double from
// exact operands. What Vulkan promises of its operations ("Precision and Operation of SPIR-V Instructions") is taken as
// it stands: sums, products and quotients may be rounded either way, and numbers below 2^-126 may become 0.
//
// Where no bound is known (a pole, what is not defined, very large numbers) `unknown` is set, and stays so.

struct Bounded
{
	float value;
	float error;
};

bool unknown = false;

// An operation's rounding, relative: 2^-23 here, 2^-53 or little more on the CPU, and what the bounds' own rounding
// takes away from them.
const float kRounding = 1.25e-7;
const float kTiny = 1e-37; // below it numbers may become 0
// Nothing larger is computed with: no product overflows, and no NaN arises that a driver may treat as it likes.
const float kLargest = 1e18;

// Rounded once.
Bounded rounded(float value, float error)
{
	unknown = unknown || abs(value) > kLargest || error > kLargest;
	return Bounded(value, error + (kRounding * abs(value) + kTiny));
}

// Rounded not at all.
Bounded exactly(float value, float error)
{
	return Bounded(value, error);
}

// 1 instead of what must not be so small; the result is unknown then.
float atLeast(float least, float value)
{
	unknown = unknown || value < least;
	return max(value, least);
}

// Above the largest the result is unknown.
float atMost(float largest, float value)
{
	unknown = unknown || value > largest;
	return min(value, largest);
}

Bounded sumOf(Bounded a, Bounded b)
{
	precise float value = a.value + b.value;
	return rounded(value, a.error + b.error);
}

Bounded negativeOf(Bounded a)
{
	return exactly(-a.value, a.error);
}

Bounded differenceOf(Bounded a, Bounded b)
{
	return sumOf(a, negativeOf(b));
}

Bounded productOf(Bounded a, Bounded b)
{
	precise float value = a.value * b.value;
	return rounded(value, abs(a.value) * b.error + a.error * (abs(b.value) + b.error));
}

// Vulkan: 2.5 ulps where the divisor is neither tiny nor huge.
Bounded quotientOf(Bounded a, Bounded b)
{
	const float least = atLeast(1e-17, abs(b.value) - b.error);
	precise float value = a.value / b.value;
	return rounded(value, (a.error + abs(value) * b.error) / least + 4.0 * kRounding * abs(value));
}

Bounded squareOf(Bounded a)
{
	precise float value = a.value * a.value;
	return rounded(value, a.error * (2.0 * abs(a.value) + a.error));
}

Bounded powerOf(Bounded a, int exponent)
{
	Bounded power = exactly(1.0, 0.0);
	Bounded base = a;
	for (int left = abs(exponent); left > 0; left >>= 1)
	{
		if ((left & 1) != 0)
			power = productOf(power, base);
		if (left > 1)
			base = squareOf(base);
	}
	return exponent < 0 ? quotientOf(exactly(1.0, 0.0), power) : power;
}

Bounded absOf(Bounded a)
{
	return exactly(abs(a.value), a.error);
}

Bounded minOf(Bounded a, Bounded b)
{
	return exactly(min(a.value, b.value), max(a.error, b.error));
}

Bounded maxOf(Bounded a, Bounded b)
{
	return exactly(max(a.value, b.value), max(a.error, b.error));
}

// Vulkan: 1 / inversesqrt(), 2 and 2.5 ulps. |sqrt(a) - sqrt(b)| = |a - b| / (sqrt(a) + sqrt(b)).
Bounded sqrtOf(Bounded a)
{
	const float least = atLeast(1e-30, a.value - a.error);
	precise float value = sqrt(max(a.value, least));
	return rounded(value, 1.001 * a.error / value + 6.0 * kRounding * value);
}

// Vulkan: 3 + 2 |a| ulps. Below -80 it is less than 2e-35.
Bounded expOf(Bounded a)
{
	const float from = max(atMost(41.0, a.value), -80.0); // e^41 < kLargest
	const float error = atMost(0.5, a.error); // e^t - 1 <= 1.3 t
	precise float value = exp(from);
	return rounded(value, value * (1.3 * error + (4.0 + 2.0 * abs(from)) * kRounding) + 4e-35);
}

// Vulkan: 3 ulps, or 2^-21 between 0.5 and 2.
float logError(float value)
{
	return 4.0 * kRounding * abs(value) + 5e-7;
}

Bounded logOf(Bounded a)
{
	const float least = atLeast(1e-17, a.value - a.error);
	precise float value = log(max(a.value, least));
	return rounded(value, a.error / least + logError(value));
}

Bounded log2Of(Bounded a)
{
	const float least = atLeast(1e-17, a.value - a.error);
	precise float value = log2(max(a.value, least));
	return rounded(value, 1.4427 * a.error / least + logError(value));
}

Bounded log10Of(Bounded a)
{
	return productOf(logOf(a), Bounded(0.43429448, 2e-8));
}

Bounded powOf(Bounded a, Bounded b)
{
	return expOf(productOf(b, logOf(a)));
}

// By exp2 and log2: l = log2 |a| is wrong by logError(l), a third of it by its rounding too, and 2^(l / 3) by 3 + 2 |l / 3|
// ulps besides.
Bounded cbrtOf(Bounded a)
{
	const float size = abs(a.value);
	const float least = atLeast(1e-17, size - a.error);
	precise float third = log2(max(size, least)) / 3.0;
	precise float root = exp2(third);
	const float relative = logError(3.0 * third) / 3.0 + 4.0 * kRounding * abs(third);
	const float own = root * (relative + (4.0 + 2.0 * abs(third)) * kRounding);
	return rounded(a.value < 0.0 ? -root : root, 1.01 * (root + own) * a.error / (3.0 * least) + own);
}

Bounded hypotOf(Bounded a, Bounded b)
{
	return sqrtOf(sumOf(squareOf(a), squareOf(b)));
}

// The sine of a + quarters pi / 2. Vulkan promises 2^-11 and no more, so this is our own: pi / 2 is taken off in three
// parts, the first of which are short enough for exact products (Cody and Waite 1980), and the polynomials are those of
// Cephes' sinf and cosf (Moshier 1989). Reduction and polynomial are wrong by some 6e-7 at most.
const float kSineError = 2e-6;
const float kLargestAngle = 1000.0;

float sineAt(float a, int quarters)
{
	precise float turns = roundEven(a * 0.63661977);
	precise float first = a - turns * 1.5703125;
	precise float second = first - turns * 4.837512969970703125e-4;
	precise float r = second - turns * 7.54978995489188e-8;
	precise float s = r * r;
	precise float sine = r + ((-1.9515295891e-4 * s + 8.3321608736e-3) * s - 1.6666654611e-1) * (s * r);
	precise float cosine =
		((2.443315711809948e-5 * s - 1.388731625493765e-3) * s + 4.166664568298827e-2) * (s * s) + (1.0 - 0.5 * s);
	const int quarter = int(turns) + quarters;
	const float size = (quarter & 1) != 0 ? cosine : sine;
	return (quarter & 2) != 0 ? -size : size;
}

float angleOf(Bounded a)
{
	const float size = atMost(kLargestAngle, abs(a.value));
	return clamp(a.value, -size, size);
}

Bounded sinOf(Bounded a)
{
	return rounded(sineAt(angleOf(a), 0), a.error + kSineError);
}

Bounded cosOf(Bounded a)
{
	return rounded(sineAt(angleOf(a), 1), a.error + kSineError);
}

// The slope is 1 / cos^2, and the cosine changes by no more than the angle.
Bounded tanOf(Bounded a)
{
	const float angle = angleOf(a);
	const float cosine = sineAt(angle, 1);
	const float least = atLeast(1e-3, abs(cosine) - kSineError - a.error);
	precise float value = sineAt(angle, 0) / cosine;
	return rounded(value, a.error / (least * least) + (1.0 + abs(value)) * kSineError / least +
	                          4.0 * kRounding * abs(value));
}

// The angle whose tangent is small / large, 0 <= small <= large. Vulkan promises 4096 ulps and no more, so this is our own
// too: Cephes' atanf (Moshier 1989), with (t - 1) / (t + 1) taken from pi / 4 where t is large. Its error, that of t and
// that of a sum with multiples of pi / 2 are some 1e-6 at most; of a root of 1 - a^2 as many again.
const float kArcError = 4e-6;

float arcOf(float small, float large)
{
	precise float t = small / large;
	const bool steep = t > 0.41421356;
	precise float mirrored = (t - 1.0) / (t + 1.0);
	const float r = steep ? mirrored : t;
	precise float s = r * r;
	precise float series = ((8.05374449538e-2 * s - 1.38776856032e-1) * s + 1.99777106478e-1) * s - 3.33329491539e-1;
	precise float arc = series * s * r + r;
	return steep ? 0.78539816 + arc : arc;
}

// The angle of (x, y), as atan(y, x); not both are 0.
float angleTo(float y, float x)
{
	const bool upright = abs(y) > abs(x);
	const float arc = arcOf(upright ? abs(x) : abs(y), upright ? abs(y) : abs(x));
	const float from_axis = upright ? 1.57079633 - arc : arc;
	const float angle = x < 0.0 ? 3.14159265 - from_axis : from_axis;
	return y < 0.0 ? -angle : angle;
}

Bounded atanOf(Bounded a)
{
	return rounded(angleTo(a.value, 1.0), a.error + kArcError);
}

// The slopes are at most 1 / r. The angle jumps where y = 0 and x < 0.
Bounded atan2Of(Bounded y, Bounded x)
{
	const float error = y.error + x.error;
	const float size = max(abs(y.value), abs(x.value));
	const float least = atLeast(1e-9, size - error);
	unknown = unknown || (x.value <= x.error && abs(y.value) <= y.error);
	return rounded(size > 0.0 ? angleTo(y.value, x.value) : 0.0, error / least + kArcError);
}

// Up to 0.99, where the slope is below 7.1.
Bounded asinOf(Bounded a)
{
	const float size = atMost(0.99, abs(a.value) + a.error);
	const float sine = clamp(a.value, -size, size);
	precise float cosine = sqrt((1.0 - sine) * (1.0 + sine));
	return rounded(angleTo(sine, cosine), 7.2 * a.error + kArcError);
}

Bounded acosOf(Bounded a)
{
	return differenceOf(Bounded(1.57079633, 1e-7), asinOf(a));
}

Bounded halfOf(Bounded a)
{
	return exactly(0.5 * a.value, 0.5 * a.error + kTiny);
}

Bounded sinhOf(Bounded a)
{
	return halfOf(differenceOf(expOf(a), expOf(negativeOf(a))));
}

Bounded coshOf(Bounded a)
{
	return halfOf(sumOf(expOf(a), expOf(negativeOf(a))));
}

// 1 - 2 / (e^2a + 1), which beyond 10 differs from 1 by less than 5e-9.
Bounded tanhOf(Bounded a)
{
	const Bounded inner = exactly(2.0 * clamp(a.value, -10.0, 10.0), 2.0 * atMost(0.24, a.error));
	const Bounded one = exactly(1.0, 0.0);
	const Bounded two = exactly(2.0, 0.0);
	const Bounded value = differenceOf(one, quotientOf(two, sumOf(expOf(inner), one)));
	return exactly(value.value, value.error + 5e-9);
}
