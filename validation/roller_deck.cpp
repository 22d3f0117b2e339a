/// A pipe pulled over a level deck and an arc of equally spaced rollers.
#include <fmt/core.h>

#include <cmath>

#include "base/constants.h"
#include "groups.h"
#include "rod.h"

namespace overbend::validation {
namespace {

constexpr int kBefore = 12;   ///< Rollers before and after the tangent point; more do not change the results.
constexpr int kInside = 8;    ///< A roller of the arc far from both its ends.
constexpr int kPerSpan = 16;  ///< Elements.

struct Steel {
  double D, wall, E;
  double area() const { return 0.25 * kPi * (D * D - std::pow(D - 2.0 * wall, 2)); }
  double EA() const { return E * area(); }
  double EI() const { return E * kPi / 64.0 * (std::pow(D, 4) - std::pow(D - 2.0 * wall, 4)); }
};

/// Pipe and rollers: radius `R` of the arc, spacing `L`, tension `T` at the deck's end, weight `w`.
struct Deck {
  Steel steel;
  double R, L, T, w;
  bool two_sided;  ///< A second roller above each, so that none opens.

  int after() const { return R < 1e3 ? 10 : 16; }  ///< Rollers of the arc; a tight one must not turn under itself.
  double u() const { return L * std::sqrt(T / steel.EI()); }
};

/// Point of the pipe's axis at arc length `s` from the tangent point: level before it, a circle behind it.
Vec3 axis_point(double R, double s) {
  return s <= 0.0 ? Vec3(s, 0.0, 0.0) : Vec3(R * std::sin(s / R), 0.0, -2.0 * R * std::pow(std::sin(0.5 * s / R), 2));
}

PlacedRoller roller_at(const Vec3& axis_point, const Vec3& normal, double pipe_radius, double stiffness) {
  PlacedRoller roller;
  roller.radius = 0.01;
  roller.center = axis_point - (roller.radius + pipe_radius) * normal;
  roller.axis = Vec3::UnitY();
  roller.normal = normal;
  roller.half_face = 1.0;
  roller.stiffness = stiffness;
  return roller;
}

/// The pipe on its rollers. Roller 0 is the tangent roller, see roller().
class DeckPipe {
 public:
  explicit DeckPipe(const Deck& deck)
      : deck_(deck),
        rod_({deck.steel.EA(), deck.steel.EI(), deck.w, kRadius},
             equal_lengths((kBefore + deck.after()) * deck.L, (kBefore + deck.after()) * kPerSpan), Vec3::Zero(),
             Vec3::UnitX()) {
    lay_on_curve();
    place_rollers();
    const int last = rod_.nodes() - 1;
    rod_.hold_in_plane();
    rod_.hold(0, kRz);
    rod_.hold(last, kRx);
    rod_.hold(last, kRz);
    rod_.dead[kRx] = -deck.T;
    rod_.settle();
  }

  /// Hogging moment at a roller [N m].
  double moment(int roller) const { return rod_.moment_at_roller(index(roller)).y(); }
  /// Midway between a roller and the next.
  double moment_behind(int roller) const { return rod_.moment_at((kBefore + roller) * kPerSpan + kPerSpan / 2).y(); }
  /// Upwards [N].
  double reaction(int roller) const {
    const std::size_t i = index(roller);
    return rod_.roller_force(i) - (deck_.two_sided ? rod_.roller_force(i + 1) : 0.0);
  }
  /// Curvature of the arc gives m = 1.
  double m(double moment) const { return moment * deck_.R / deck_.steel.EI(); }

 private:
  static constexpr double kRadius = 0.01;  ///< Small, so that rolling on the face shifts no contact.

  std::size_t index(int roller) const {
    return static_cast<std::size_t>(kBefore - 1 + roller) * (deck_.two_sided ? 2 : 1);
  }
  void lay_on_curve() {
    for (int node = 0; node < rod_.nodes(); ++node) {
      const double s = rod_.s(node) - kBefore * deck_.L;
      Eigen::Map<Vec3>(rod_.state.q.data() + 6 * node) = axis_point(deck_.R, s);
      const double angle = std::max(s, 0.0) / deck_.R;
      Eigen::Map<Vec3>(rod_.state.q.data() + 6 * node + 3) = Vec3(std::cos(angle), 0.0, -std::sin(angle));
    }
  }
  void place_rollers() {
    constexpr double kPinch =
        1e-6;  ///< Rollers press this deep at the start: pairs stay in contact, single ones begin so [m].
    for (int i = 1 - kBefore; i < deck_.after(); ++i) {
      const Vec3 point = axis_point(deck_.R, i * deck_.L);
      const double angle = std::max(i, 0) * deck_.L / deck_.R;
      const Vec3 normal(std::sin(angle), 0.0, std::cos(angle));
      if (!deck_.two_sided) {
        rod_.rollers.push_back(roller_at(point + kPinch * normal, normal, kRadius, 1e8));
        continue;
      }
      rod_.rollers.push_back(roller_at(point + kPinch * normal, normal, kRadius, 1e11));
      rod_.rollers.push_back(roller_at(point - kPinch * normal, -normal, kRadius, 1e11));
    }
  }

  Deck deck_;
  Rod rod_;
};

/// The infinite deck and arc of small slope: beta m(i-1) + 4 alpha m(i) + beta m(i+1) = 6 c(i).
struct DeckTheory {
  double alpha = 1.0, beta = 1.0, u;

  explicit DeckTheory(double u_) : u(u_) {
    if (u > 1e-3) {
      alpha = 3.0 * (u / std::tanh(u) - 1.0) / (u * u);
      beta = 6.0 * (1.0 - u / std::sinh(u)) / (u * u);
    }
  }
  /// Moment of the weight at an interior roller, in w L2: a span clamped by symmetry.
  double weight_moment() const { return u > 1e-3 ? (0.5 * u / std::tanh(0.5 * u) - 1.0) / (u * u) : 1.0 / 12.0; }
  double on_arc() const { return 3.0 / (2.0 * alpha + beta); }
  double midspan() const { return u > 1e-3 ? 0.5 * u / std::sinh(0.5 * u) : 1.0; }
  /// At roller `i` from the tangent roller 0: half the arc's value there, and exponential decay either way.
  double moment_at(int i) const {
    const double ratio = 2.0 * alpha / beta;
    const double decay = -ratio + std::sqrt(ratio * ratio - 1.0);
    const double part = 0.5 * on_arc() * std::pow(decay, std::abs(i));
    return i < 0 ? part : on_arc() - part;
  }
  static double step(int i) { return i < 0 ? 0.0 : i == 0 ? 0.5 : 1.0; }
};

constexpr Steel kSixteen{0.4064, 0.021, 207e9};
constexpr Steel kTwenty{0.508, 0.021, 207e9};
constexpr double kGentle =
    1e4;  ///< Radius at which the slope stays below 0.015, so that small-slope theory is exact to 1e-4 [m].
constexpr double kTonne = 1e3 * kGravity;

std::string roller_name(int i) {
  return i < 0 ? fmt::format("SR{}", i) : fmt::format("SR{}", i + 1);
}

Table moments(const std::string& name, const Deck& deck) {
  Table table{"Moments and reactions, " + name,
              fmt::format("Two-sided rollers, no weight, u = L sqrt(T/EI) = {:.4f}. m = M R/EI; SR1 is the tangent "
                          "roller. Reactions in EI/(R L).",
                          deck.u()),
              {}};
  const DeckPipe pipe(deck);
  const DeckTheory theory(deck.u());
  const std::string basis = "small-slope theory; slopes up to 0.015 leave 2e-4";
  const auto add = [&](const std::string& where, const std::string& what, double ours, double reference) {
    table.rows.push_back({name + ", " + where, what, "", ours, reference, 1e-3, basis});
  };
  for (const int i : {-1, 0, 1, 2, 3}) {
    add(roller_name(i), "m", pipe.m(pipe.moment(i)), theory.moment_at(i));
  }
  add("inside the arc", "m at a roller", pipe.m(pipe.moment(kInside)), theory.on_arc());
  add("inside the arc", "m at midspan", pipe.m(pipe.moment_behind(kInside)), theory.midspan());
  const double unit = deck.steel.EI() / (deck.R * deck.L);
  for (const int i : {-1, 0, 1, kInside}) {
    const double bent = 2.0 * theory.moment_at(i) - theory.moment_at(i - 1) - theory.moment_at(i + 1);
    add(i == kInside ? "inside the arc" : roller_name(i), "reaction", pipe.reaction(i) / unit,
        bent + DeckTheory::step(i) * deck.u() * deck.u());
  }
  return table;
}

Table with_weight() {
  Table table{"With weight", "200 kg/m on two-sided rollers; R = 10 km.", {}};
  for (const double tonnes : {1.0, 120.0}) {
    const Deck deck{kSixteen, kGentle, 9.0, tonnes * kTonne, 200.0 * kGravity, true};
    const DeckPipe pipe(deck);
    const DeckTheory theory(deck.u());
    const double reference =
        deck.steel.EI() / deck.R * theory.on_arc() + deck.w * deck.L * deck.L * theory.weight_moment();
    table.rows.push_back({fmt::format("T = {:g} t", tonnes), "moment at a roller inside the arc", "kN m",
                          1e-3 * pipe.moment(kInside), 1e-3 * reference, 1e-6 * reference,
                          "small-slope theory, w L2/12 for small u; 0.1 %"});
    const double reaction = deck.w * deck.L + deck.T * deck.L / deck.R;
    table.rows.push_back({fmt::format("T = {:g} t", tonnes), "reaction inside the arc", "kN",
                          1e-3 * pipe.reaction(kInside), 1e-3 * reaction, 1e-6 * reaction, "w L + T L/R; 0.1 %"});
  }
  return table;
}

/// Largest strain of the outer fibre at the second roller of the arc [%].
double strain_at_second(const Deck& deck) {
  const DeckPipe pipe(deck);
  return 100.0 * (0.5 * deck.steel.D * pipe.moment(1) / deck.steel.EI() + deck.T / deck.steel.EA());
}

Table strain() {
  const Steel steel{0.4064, 0.021, 210e9};
  const Deck bare{steel, 85.0, 9.0, 120.0 * kTonne, 0.0, true};
  const Deck heavy{steel, 85.0, 9.0, 120.0 * kTonne, 200.0 * kGravity, true};
  Deck pushed = heavy;
  pushed.two_sided = false;
  return {"Strain over a stinger of 85 m",
          fmt::format("406.4 x 21 mm, E 210 GPa, rollers 9 m apart at the pipe's axis, 120 t; strain due to bending "
                      "and tension at SR2. In the references the rollers act in both directions: on rollers without "
                      "tension the pipe lifts off SR-1, and our strain is {:.3f} %.",
                      strain_at_second(pushed)),
          {{"no weight, two-sided rollers", "strain", "%", strain_at_second(bare), 0.3132, 0.005 * 0.3132,
            "small-slope theory; the arc's slopes of up to 1 rad are not small: 0.5 %"},
           {"200 kg/m", "strain", "%", strain_at_second(heavy), 0.3161, 0.005 * 0.3161,
            "beam elements of another program; 0.5 %"},
           {"200 kg/m", "strain", "%", strain_at_second(heavy), 0.3159, 0.005 * 0.3159,
            "small-slope theory with w L2/12; 0.5 %"}}};
}

}  // namespace

Group roller_deck() {
  return {"Over equally spaced rollers",
          "three-moment equations of the tensioned beam",
          "A pipe under tension over a horizontal deck followed by an arc: at the tangent roller SR1 the pipe has half "
          "the curvature of the arc, at the next roller more than that of the arc. Theory: three-moment equations of "
          "the tensioned beam with "
          "alpha = 3(u coth u - 1)/u2 and\nbeta = 6(1 - u/sinh u)/u2.",
          {moments("no tension", {kSixteen, kGentle, 9.0, 0.0, 0.0, true}),
           moments("16 inch, 120 t", {kSixteen, kGentle, 9.0, 120.0 * kTonne, 0.0, true}),
           moments("20 inch, 100 t", {kTwenty, kGentle, 9.0, 100.0 * kTonne, 0.0, true}), with_weight(), strain()}};
}

}  // namespace overbend::validation
