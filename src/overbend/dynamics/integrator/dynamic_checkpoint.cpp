#include "dynamics/integrator/dynamic_checkpoint.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace overbend {
namespace {

constexpr std::size_t kContactNumbers = 10;
constexpr std::size_t kWaterNumbers = 8;
constexpr std::size_t kBendingNumbers = 17 + kSliders * kDirections;

void put(DynamicCheckpoint& checkpoint, const std::string& name, std::vector<double> values) {
  checkpoint.arrays.push_back({name, std::move(values)});
}

std::vector<double> bending_numbers(const std::vector<BendingMemory>& memories) {
  std::vector<double> out;
  for (const BendingMemory& m : memories) {
    out.insert(out.end(), {m.tangent.x(), m.tangent.y(), m.tangent.z(), m.axis.x(), m.axis.y(), m.axis.z(),
                           m.center.x(), m.center.y(), m.slack, m.max_curvature, m.held.x(), m.held.y(),
                           static_cast<double>(m.held_mix.lower), m.held_mix.share, static_cast<double>(m.stamp >> 32U),
                           static_cast<double>(m.stamp & 0xffffffffU), m.stored});
    out.insert(out.end(), m.slip.begin(), m.slip.end());
  }
  return out;
}

BendingMemory bending_memory(const double* v) {
  BendingMemory m;
  m.tangent = Vec3(v[0], v[1], v[2]);
  m.axis = Vec3(v[3], v[4], v[5]);
  m.center = Vec2(v[6], v[7]);
  m.slack = v[8];
  m.max_curvature = v[9];
  m.held = Vec2(v[10], v[11]);
  m.held_mix = {static_cast<int>(v[12]), v[13]};
  m.stamp = (static_cast<std::uint64_t>(v[14]) << 32U) | static_cast<std::uint64_t>(v[15]);
  m.stored = v[16];
  std::copy_n(v + 17, m.slip.size(), m.slip.begin());
  return m;
}

Slip make_slip(double value) {
  return static_cast<Slip>(static_cast<int>(value));
}

}  // namespace

const std::vector<double>& checkpoint_array(const DynamicCheckpoint& checkpoint, const std::string& name) {
  const auto found = std::find_if(checkpoint.arrays.begin(), checkpoint.arrays.end(),
                                  [&](const DynamicCheckpoint::Array& a) { return a.name == name; });
  if (found == checkpoint.arrays.end()) {
    throw std::runtime_error("the checkpoint has no " + name);
  }
  return found->values;
}

namespace {

void save_line(DynamicCheckpoint& checkpoint, const std::string& name, const LineState& line) {
  put(checkpoint, name + "q", line.q);
  put(checkpoint, name + "v", line.v);
  put(checkpoint, name + "acc", line.acc);
  put(checkpoint, name + "alg", line.algorithmic_acceleration);
  put(checkpoint, name + "acceleration_extrapolation", {line.acceleration_extrapolation});
  put(checkpoint, name + "bed_slip", {line.bed_slip.begin(), line.bed_slip.end()});
  std::vector<double> contacts;
  for (const ContactMemory& c : line.contacts) {
    contacts.insert(contacts.end(), {c.slip_axial, c.slip_lateral, c.carries ? 1.0 : 0.0, static_cast<double>(c.axial),
                                     static_cast<double>(c.lateral), static_cast<double>(c.element), c.xi,
                                     static_cast<double>(c.passing), c.rate_axial, c.rate_lateral});
  }
  put(checkpoint, name + "contacts", std::move(contacts));
  if (!line.bending.empty()) {
    put(checkpoint, name + "bending", bending_numbers(line.bending.all()));
    put(checkpoint, name + "bending_heat", {line.bending_heat});
  }
}

void restore_line(const DynamicCheckpoint& checkpoint, const std::string& name, LineState& line) {
  line.q = checkpoint_array(checkpoint, name + "q");
  line.v = checkpoint_array(checkpoint, name + "v");
  line.acc = checkpoint_array(checkpoint, name + "acc");
  line.algorithmic_acceleration = checkpoint_array(checkpoint, name + "alg");
  line.acceleration_extrapolation = checkpoint_array(checkpoint, name + "acceleration_extrapolation").at(0);
  const std::vector<double>& slip = checkpoint_array(checkpoint, name + "bed_slip");
  line.bed_slip.assign(slip.begin(), slip.end());
  const std::vector<double>& contacts = checkpoint_array(checkpoint, name + "contacts");
  for (std::size_t i = 0; i < line.contacts.size(); ++i) {
    const double* v = &contacts.at(kContactNumbers * i);
    line.contacts[i] = {
        v[0], v[1], v[2] != 0.0, make_slip(v[3]), make_slip(v[4]), static_cast<int>(v[5]), v[6], static_cast<int>(v[7]),
        v[8], v[9]};
  }
  if (!line.bending.empty()) {
    const std::vector<double>& bending = checkpoint_array(checkpoint, name + "bending");
    std::vector<BendingMemory> memories;
    for (std::size_t i = 0; i < bending.size() / kBendingNumbers; ++i) {  // one memory per element
      memories.push_back(bending_memory(&bending.at(kBendingNumbers * i)));
    }
    line.bending = BendingMemories(memories);
    line.bending_heat = checkpoint_array(checkpoint, name + "bending_heat").at(0);
  }
}

std::vector<double> attachment_numbers(const AttachmentState& attachment) {
  const TensionerMachine& m = attachment.machine;
  return {attachment.guide.q,
          attachment.guide.v,
          attachment.guide.acc,
          attachment.guide.algorithmic_acceleration,
          attachment.travel.q,
          attachment.travel.v,
          attachment.travel.acc,
          attachment.travel.algorithmic_acceleration,
          static_cast<double>(m.state),
          static_cast<double>(m.drive),
          static_cast<double>(m.side),
          m.timer,
          m.tension,
          attachment.parted ? 1.0 : 0.0,
          attachment.payout.moved,
          attachment.payout.rate,
          attachment.payout.last_element,
          attachment.payout.dragged.x(),
          attachment.payout.dragged.y(),
          attachment.payout.dragged.z(),
          attachment.payout.drag_rate.x(),
          attachment.payout.drag_rate.y(),
          attachment.payout.drag_rate.z(),
          static_cast<double>(attachment.payout.mode),
          attachment.payout.stiffness,
          attachment.payout.rendered_length,
          attachment.payout.stalled_time,
          m.commanded ? 1.0 : 0.0,
          m.commanded.value_or(0.0),
          m.returning ? 1.0 : 0.0};
}

AttachmentState make_attachment(const std::vector<double>& v) {
  AttachmentState attachment;
  attachment.guide = {v.at(0), v.at(1), v.at(2), v.at(3)};
  attachment.travel = {v.at(4), v.at(5), v.at(6), v.at(7)};
  attachment.machine = {static_cast<TensionerState>(std::lround(v.at(8))),
                        static_cast<TensionerDrive>(std::lround(v.at(9))), static_cast<int>(std::lround(v.at(10))),
                        v.at(11), v.at(12)};
  attachment.parted = v.at(13) != 0.0;
  attachment.payout.moved = v.at(14);
  attachment.payout.rate = v.at(15);
  attachment.payout.last_element = v.at(16);
  attachment.payout.dragged = Vec3(v.at(17), v.at(18), v.at(19));
  attachment.payout.drag_rate = Vec3(v.at(20), v.at(21), v.at(22));
  attachment.payout.mode = static_cast<PayoutMode>(std::lround(v.at(23)));
  attachment.payout.stiffness = v.at(24);
  attachment.payout.rendered_length = v.at(25);
  attachment.payout.stalled_time = v.at(26);
  if (v.at(27) != 0.0) attachment.machine.commanded = v.at(28);
  attachment.machine.returning = v.at(29) != 0.0;
  return attachment;
}

std::vector<double> body_numbers(const HullState& body) {
  std::vector<double> out;
  for (const Vec6* part : {&body.h, &body.v, &body.acc, &body.algorithmic_acceleration}) {
    out.insert(out.end(), part->begin(), part->end());
  }
  for (const Vec3* part : {&body.slow.value, &body.slow.rate}) {
    out.insert(out.end(), part->begin(), part->end());
  }
  out.insert(out.end(), body.radiation.values.begin(), body.radiation.values.end());
  out.push_back(body.hinge_slip);
  for (const LineEndForces& line : body.lines) {
    out.insert(out.end(), {line.pull, line.sink, line.anchor_pull, line.anchor_uplift, line.length, line.on_bed,
                           line.anchor_rise});
  }
  return out;
}

/// Restores a body whose memory already has its size.
void restore_body(const std::vector<double>& in, HullState& body) {
  std::size_t next = 0;
  for (Vec6* part : {&body.h, &body.v, &body.acc, &body.algorithmic_acceleration}) {
    for (double& value : *part) value = in.at(next++);
  }
  for (Vec3* part : {&body.slow.value, &body.slow.rate}) {
    for (double& value : *part) value = in.at(next++);
  }
  for (double& value : body.radiation.values) value = in.at(next++);
  body.hinge_slip = in.at(next++);
  for (LineEndForces& line : body.lines) {
    for (double* value : {&line.pull, &line.sink, &line.anchor_pull, &line.anchor_uplift, &line.length, &line.on_bed,
                          &line.anchor_rise}) {
      *value = in.at(next++);
    }
  }
}

std::string numbered(const char* what, std::size_t index) {
  return "state/" + (what + std::to_string(index));
}

}  // namespace

void save_state(DynamicCheckpoint& checkpoint, const SystemState& state) {
  put(checkpoint, "state/time", {state.time, state.last_step});
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    save_line(checkpoint, numbered("line ", i) + "/", state.lines[i]);
  }
  for (std::size_t i = 0; i < state.attachments.size(); ++i) {
    put(checkpoint, numbered("attachment ", i), attachment_numbers(state.attachments[i]));
  }
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    put(checkpoint, numbered("body ", i), body_numbers(state.bodies[i]));
  }
}

void restore_state(const DynamicCheckpoint& checkpoint, SystemState& state) {
  const std::vector<double>& time = checkpoint_array(checkpoint, "state/time");
  state.time = time.at(0);
  state.last_step = time.at(1);
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    restore_line(checkpoint, numbered("line ", i) + "/", state.lines[i]);
  }
  for (std::size_t i = 0; i < state.attachments.size(); ++i) {
    state.attachments[i] = make_attachment(checkpoint_array(checkpoint, numbered("attachment ", i)));
  }
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    restore_body(checkpoint_array(checkpoint, numbered("body ", i)), state.bodies[i]);
  }
}

namespace {

void save_moments(DynamicCheckpoint& checkpoint, const std::string& name, const WaterMemory& memory) {
  std::vector<double> out{memory.time, static_cast<double>(memory.first.size())};
  for (const std::vector<WaterState>* moment : {&memory.first, &memory.second}) {
    for (const WaterState& w : *moment) {
      out.insert(out.end(), {w.velocity.x(), w.velocity.y(), w.velocity.z(), w.acceleration.x(), w.acceleration.y(),
                             w.acceleration.z(), w.elevation, w.pressure_head});
    }
  }
  put(checkpoint, name, std::move(out));
}

void restore_moments(const std::vector<double>& in, WaterMemory& memory) {
  memory.time = in.at(0);
  const std::size_t stations = static_cast<std::size_t>(in.at(1));
  std::size_t i = 2;
  for (std::vector<WaterState>* moment : {&memory.first, &memory.second}) {
    moment->resize(stations);
    for (WaterState& w : *moment) {
      const double* v = &in.at(i);
      w = {Vec3(v[0], v[1], v[2]), Vec3(v[3], v[4], v[5]), v[6], v[7]};
      i += kWaterNumbers;
    }
  }
}

std::string water_name(std::size_t line) {
  return line == 0 ? "water" : "water/" + std::to_string(line);
}

}  // namespace

void save_water(DynamicCheckpoint& checkpoint, const std::vector<WaterMemory>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    save_moments(checkpoint, water_name(i), lines[i]);
  }
}

void restore_water(const DynamicCheckpoint& checkpoint, std::vector<WaterMemory>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    restore_moments(checkpoint_array(checkpoint, water_name(i)), lines[i]);
  }
}

void save_report(DynamicCheckpoint& checkpoint, const DynamicRunReport& report) {
  put(checkpoint, "report",
      {static_cast<double>(report.steps), static_cast<double>(report.rejected_steps),
       static_cast<double>(report.newton_iterations), static_cast<double>(report.factorisations), report.min_step_taken,
       report.max_step_taken, report.wall_time});
}

void restore_report(const DynamicCheckpoint& checkpoint, DynamicRunReport& report) {
  const std::vector<double>& in = checkpoint_array(checkpoint, "report");
  report.steps = std::llround(in.at(0));
  report.rejected_steps = std::llround(in.at(1));
  report.newton_iterations = std::llround(in.at(2));
  report.factorisations = std::llround(in.at(3));
  report.min_step_taken = in.at(4);
  report.max_step_taken = in.at(5);
  report.wall_time = in.at(6);
}

}  // namespace overbend
