#include "recording/control_columns.h"

namespace overbend {
namespace {

const AttachmentState& attachment_state(const RowSource& row, std::size_t attachment) {
  return row.instant.state->attachments[attachment];
}

double machine_speed(const RowSource& row, std::size_t attachment) {
  const AttachmentState& machine = attachment_state(row, attachment);
  return row.instant.assembly->system().attachments[attachment].winch ? machine.payout.rate : machine.travel.v;
}

double set_tension(const RowSource& row, std::size_t attachment) {
  const Attachment& held = row.instant.assembly->system().attachments[attachment];
  return held.winch ? held.winch->tension.wanted : held.tensioner->wanted;
}

}  // namespace

void add_control_columns(const Controllers& controllers, std::vector<RecordedColumn>& columns) {
  for (const CommandedMachine& machine : controllers.machines()) {
    if (machine.controller == nullptr) continue;
    const std::size_t i = machine.attachment;
    const bool tensioner = machine.name == kTensionerMachine;
    const std::string prefix = tensioner ? "tensioner/" : "mooring/" + machine.name + "/winch_";
    columns.push_back({{prefix + "speed", "m/s", "Pay-out speed, negative when hauling in", false, false},
                       [i](const RowSource& row) { return machine_speed(row, i); }});
    columns.push_back({{prefix + "commanded_speed", "m/s",
                        "Speed commanded by the controller; the machine's own speed without a command", false, false},
                       [i](const RowSource& row) {
                         return attachment_state(row, i).machine.commanded.value_or(machine_speed(row, i));
                       }});
    columns.push_back({{prefix + "set_tension", "N", "Set tension of the machine's own control law", false, false},
                       [i](const RowSource& row) { return set_tension(row, i); }});
    if (!tensioner) {
      columns.push_back({{prefix + "paid_out", "m", "Payout since the start, negative when hauled in", false, false},
                         [i](const RowSource& row) { return attachment_state(row, i).payout.moved; }});
    }
  }
}

}  // namespace overbend
