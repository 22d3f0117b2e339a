#include "recording/control_columns.h"

namespace overbend {
namespace {

const AttachmentState& state_of(const RowSource& row, std::size_t attachment) {
  return row.now.state->attachments[attachment];
}

double machine_speed(const RowSource& row, std::size_t attachment) {
  const AttachmentState& at = state_of(row, attachment);
  return row.now.assembly->system().attachments[attachment].winch ? at.way.rate : at.travel.v;
}

double set_tension(const RowSource& row, std::size_t attachment) {
  const Attachment& held = row.now.assembly->system().attachments[attachment];
  return held.winch ? held.winch->tension.wanted : held.tensioner->wanted;
}

}  // namespace

void add_control_columns(const Controllers& controllers, std::vector<RecordedColumn>& columns) {
  for (const CommandedMachine& machine : controllers.machines()) {
    if (machine.controller == nullptr) continue;
    const std::size_t i = machine.attachment;
    const bool tensioner = machine.name == kTensionerMachine;
    const std::string of = tensioner ? "tensioner/" : "mooring/" + machine.name + "/winch_";
    columns.push_back({{of + "speed", "m/s", "Of paying out; hauling in negative", false, false},
                       [i](const RowSource& row) { return machine_speed(row, i); }});
    columns.push_back(
        {{of + "commanded_speed", "m/s", "That its controller asks for; the machine's own where it asks for none",
          false, false},
         [i](const RowSource& row) { return state_of(row, i).machine.commanded.value_or(machine_speed(row, i)); }});
    columns.push_back({{of + "set_tension", "N", "That the machine's own law restores", false, false},
                       [i](const RowSource& row) { return set_tension(row, i); }});
    if (!tensioner) {
      columns.push_back({{of + "paid_out", "m", "Since the start; hauled in negative", false, false},
                         [i](const RowSource& row) { return state_of(row, i).way.moved; }});
    }
  }
}

}  // namespace overbend
