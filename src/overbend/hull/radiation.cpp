#include "hull/radiation.h"

#include <cmath>

#include "hull/radiation_convolution.h"

namespace overbend {
namespace {

using Complex = std::complex<double>;

/// Coefficients of dz/dt = p z + v over a step with linear v: z1 = decay z0 + h (start v0 + end v1).
struct StepFactors {
  Complex decay, start, end;
};

StepFactors step_factors(Complex pole, double h) {
  const Complex x = pole * h;
  const Complex decay = std::exp(x);
  if (std::abs(x) < 1e-2) {  // the closed forms cancel; next terms x^4/720 and x^4/720 below 1e-11
    const Complex f1 = 1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0)));
    const Complex f2 = 0.5 * (1.0 + x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0)));
    return {decay, f1 - f2, f2};
  }
  const Complex f1 = (decay - 1.0) / x, f2 = (f1 - 1.0) / x;
  return {decay, f1 - f2, f2};
}

/// Memory state at `index`.
Complex state(const RadiationMemory& memory, std::size_t index) {
  return {memory.values[2 * index], memory.values[2 * index + 1]};
}

std::size_t state_count(const RadiationModel& model) {
  std::size_t count = 0;
  for (const RadiationPole& pole : model.poles) {
    count += model.groups[static_cast<std::size_t>(pole.group)].size();
  }
  return count;
}

/// Adds Re(column j of the residue times z) to the rows of the group.
void add_force(const RadiationPole& pole, const std::vector<int>& modes, int j, Complex z, Vec6& force) {
  for (const int i : modes) {
    const Complex c = pole.residue(i, j);
    force(i) += c.real() * z.real() - c.imag() * z.imag();
  }
}

}  // namespace

RadiationMemory make_bending_memory(const RadiationModel& model) {
  return model.kind == Radiation::convolution ? convolution::make_bending_memory(model)
                                              : RadiationMemory{std::vector<double>(2 * state_count(model), 0.0)};
}

RadiationStep radiation_step(const RadiationModel& model, const RadiationMemory& at_start, const Vec6& v0, double h) {
  RadiationStep result =
      model.kind == Radiation::convolution ? convolution::step(model, at_start, v0, h) : RadiationStep{};
  std::size_t index = 0;
  for (const RadiationPole& pole : model.poles) {
    const StepFactors f = step_factors(pole.pole, h);
    const std::vector<int>& modes = model.groups[static_cast<std::size_t>(pole.group)];
    for (const int j : modes) {
      add_force(pole, modes, j, f.decay * state(at_start, index++) + h * v0(j) * f.start, result.force_at_rest_end);
      for (const int i : modes) {
        result.slope(i, j) += h * (pole.residue(i, j) * f.end).real();
      }
    }
  }
  result.slope += model.constant_damping;
  return result;
}

void advance(const RadiationModel& model, RadiationMemory& memory, const Vec6& v0, const Vec6& v1, double h) {
  if (model.kind == Radiation::convolution) {
    return convolution::advance(model, memory, v0, v1, h);
  }
  std::size_t index = 0;
  for (const RadiationPole& pole : model.poles) {
    const StepFactors f = step_factors(pole.pole, h);
    for (const int j : model.groups[static_cast<std::size_t>(pole.group)]) {
      const Complex z = f.decay * state(memory, index) + h * (v0(j) * f.start + v1(j) * f.end);
      memory.values[2 * index] = z.real();
      memory.values[2 * index + 1] = z.imag();
      ++index;
    }
  }
}

Vec6 radiation_force(const RadiationModel& model, const RadiationMemory& memory, const Vec6& v) {
  Vec6 force = model.kind == Radiation::convolution ? convolution::force(model, memory, v) : Vec6(Vec6::Zero());
  std::size_t index = 0;
  for (const RadiationPole& pole : model.poles) {
    const std::vector<int>& modes = model.groups[static_cast<std::size_t>(pole.group)];
    for (const int j : modes) {
      add_force(pole, modes, j, state(memory, index++), force);
    }
  }
  return force + model.constant_damping * v;
}

}  // namespace overbend
