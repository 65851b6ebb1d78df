// The walls of a WallList in registers.

/// Nearer than this to a wall's line (metres) no bearing of its ends is trusted.
constexpr float kNear = 1e-3F;

/// Ends of walls, seen from where rays begin, metres. Lanes beyond the last wall hold no numbers.
struct Ends {
  Floats ax, ay, bx, by;
  Floats area;      ///< Positive where b is to the left of a, seen from there.
  Floats length;    ///< Up to sqrt(2) times as much.
  FloatMask along;  ///< Set where rays begin so near the wall's line that they all may meet it.
};

/// Of the register that begins with the wall `k` of the list.
HWY_INLINE Ends ends_of(const WallList& walls, std::size_t k, Vec2 origin) {
  const Floats x0 = filled(static_cast<float>(origin.x - walls.centre.x));
  const Floats y0 = filled(static_cast<float>(origin.y - walls.centre.y));
  const auto error = static_cast<float>(walls.error);
  const Floats ax = load(walls.ends + k) - x0;
  const Floats ay = load(walls.ends + walls.stride + k) - y0;
  const Floats bx = load(walls.ends + 2 * walls.stride + k) - x0;
  const Floats by = load(walls.ends + 3 * walls.stride + k) - y0;
  const Floats area = ax * by - ay * bx;
  // There the tolerances of rays are wide angles: the area by the length.
  const Floats length = hn::Abs(ax - bx) + hn::Abs(ay - by);
  const Floats size = (hn::Abs(ax) + hn::Abs(ay)) * (hn::Abs(bx) + hn::Abs(by));
  const Floats little = filled(kNear + 2 * error) * length + filled(1e-5F) * size;
  return {ax, ay, bx, by, area, length, hn::Abs(area) <= little};
}
